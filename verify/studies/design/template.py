"""The commented file of a design task, made from its model; a spring much like the paper's."""

import json

from verify.answers.assumed.registry import ASSUMPTIONS, assumption_of
from verify.answers.assumed.registry import DESIGN_SPRING_TASK as CASE
from verify.answers.template_lines import aligned, if_left_out, sections
from verify.studies.design.inputs import SWEEPS, Demands
from verify.studies.design.sweep import Sweep

HEAD = f"""\
# A design task: accordion springs by the rules of Wang et al. 2023 (Eqs. 11-13, Fig. 12) and more.
# The task is similar to the paper's spring. Replace the numbers by yours, then run
#   freewheel design my.toml                  the feasible springs and the best of them
#   freewheel design my.toml --out spring/    and a page, a table of all candidates, the chosen one
# A value keeps its unit; any other unit of the same kind will do.

case = "{CASE}"
name = "my spring"

[inputs]
"""
SWEPT = '# What may vary: a value, a list, or a range "first : last : number of values"'


def template() -> str:
    """A file that, with the lines behind a #, reads as the default task."""
    demanded = sections(Demands, ASSUMPTIONS[CASE], "this task's", also=("L_w",))
    swept = aligned([_line(sweep) for sweep in SWEEPS.values()])
    return f"{HEAD}{demanded}\n{SWEPT}\n{swept}"


def _line(sweep: Sweep) -> tuple[str, str]:
    symbol = f", {sweep.symbol}" if sweep.symbol else ""
    text = json.dumps(sweep.default, ensure_ascii=False)
    about = if_left_out(assumption_of(CASE, sweep.name))
    return f"# {sweep.name} = {text}", f"{sweep.what}{symbol}; {sweep.rule}; {about}"
