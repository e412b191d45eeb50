"""The commented file of a design task, made from its model; a spring much like the paper's."""

import json

from verify import template as case_template
from verify.design.inputs import CASE, SWEEPS, Demands
from verify.design.sweep import Sweep

HEAD = f"""\
# A design task: accordion springs by the rules of Wang et al. 2023 (Eqs. 11-13, Fig. 12) and more.
# The task is much like the paper's spring; put in your own numbers, and then
#   freewheel design my.toml                  the feasible springs and the best of them
#   freewheel design my.toml --out spring/    and a page, a table of all candidates, the chosen one
# A value keeps its unit; any other unit of the same kind will do.

case = "{CASE}"
name = "my spring"

[inputs]
"""
SWEPT = '# What may vary: a value, a list, or a range "first : last : number of values"'


def template() -> str:
    """A file that reads as the default task."""
    demanded = case_template.aligned(case_template.commented(Demands))
    swept = case_template.aligned([_line(sweep) for sweep in SWEEPS.values()])
    return f"{HEAD}{demanded}\n{SWEPT}\n{swept}"


def _line(sweep: Sweep) -> tuple[str, str]:
    symbol = f", {sweep.symbol}" if sweep.symbol else ""
    text = json.dumps(sweep.default, ensure_ascii=False)
    return f"{sweep.name} = {text}", f"{sweep.what}{symbol}; {sweep.rule}"
