"""Commented parameter file of a design task, generated from the declared inputs."""

import json

from verify.answers.assumed.registry import ASSUMPTIONS, assumption_of
from verify.answers.assumed.registry import DESIGN_SPRING_TASK as CASE
from verify.answers.template_lines import aligned, if_left_out, sections
from verify.studies.design.inputs import SWEEPS, Demands
from verify.studies.design.sweep import Sweep

HEAD = f"""\
# A design task: accordion springs by the rules of Wang et al. 2023 (Eqs. 11-13, Fig. 12) and more.
# The task is similar to the paper's spring. Replace the numbers with yours, then run:
#   freewheel design my.toml                  the feasible springs and the best of them
#   freewheel design my.toml --out spring/    also a page, a table of candidates, a file
# Each value can have any unit of the same dimension.

case = "{CASE}"
name = "my spring"

[inputs]
"""
SWEPT = '# Varied parameters: a value, a list, or a range "first : last : number of values"'


def template() -> str:
    """Text of the template. If its commented-out lines are active, it states the default task."""
    demanded = sections(Demands, ASSUMPTIONS[CASE], "this task's", also=("L_w",))
    swept = aligned([_line(sweep) for sweep in SWEEPS.values()])
    return f"{HEAD}{demanded}\n{SWEPT}\n{swept}"


def _line(sweep: Sweep) -> tuple[str, str]:
    symbol = f", {sweep.symbol}" if sweep.symbol else ""
    text = json.dumps(sweep.default, ensure_ascii=False)
    about = if_left_out(assumption_of(CASE, sweep.name))
    return f"# {sweep.name} = {text}", f"{sweep.what}{symbol}; {sweep.rule}; {about}"
