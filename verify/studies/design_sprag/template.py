"""Commented parameter file of a crown design, generated from the declared inputs."""

import json

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.assumed.registry import DESIGN_SPRAG_TASK as CASE
from verify.answers.assumed.sprags import SEED
from verify.answers.template_lines import aligned, commented, if_left_out, sections
from verify.cases.sprag.inputs import EngagementInputs
from verify.studies.design_sprag.inputs import TORQUES, Wishes
from verify.studies.design_sprag.ranges import RANGES

HEAD = f"""\
# A design task: the crown of a sprag clutch with the lowest pressures as it engages, after
# Huang et al. 2018 (Eqs. 1-20), checked against a half-space. The clutch is that of the paper.
# Replace the numbers with yours, then run:
#   freewheel design my.toml                  the optimal crown, compared with yours and with none
#   freewheel design my.toml --out crown/     and a page, the profile to grind, clutch.toml
# Every value has a unit; any other unit of the same dimension is accepted. K_1, K_2 and z_m are
# the present crown of the clutch; Q is the load that K_1 refers to, also for the optimal crown.

case = "{CASE}"
name = "my clutch"

[inputs]
"""
TASK = '# The task; a list of torques may also be a range "10 N m : 40 N m : 4" of 4 values'


def template() -> str:
    """Text of the template. Its lines without their comment signs state the default task."""
    clutch = sections(EngagementInputs, ASSUMPTIONS[CASE], "the paper's")
    wished = commented(Wishes)[len(EngagementInputs.model_fields) :]
    torques = json.dumps(TORQUES.default)
    text, about = wished.pop()  # the seed is the last one
    wished.append((text, f"{about}; {if_left_out(SEED)}"))
    task = [
        (f"{TORQUES.name} = {torques}", f"{TORQUES.what}; {TORQUES.rule}; optional, T if left out"),
        *((f'{r.name} = "{r.default}"', f"{r.what}, {r.symbol}; {r.rule}; Eq. 19") for r in RANGES),
        *wished,
    ]
    hidden = [(f"# {text.removeprefix('# ')}", about) for text, about in task]
    return f"{HEAD}{clutch}\n{TASK}\n{aligned(hidden)}"
