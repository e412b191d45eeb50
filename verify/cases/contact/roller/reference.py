"""The half-space under a roller's own crown and under the best one, whose parameters are given."""

from collections.abc import Mapping

import numpy as np

from verify.cases.contact.roller import half_space, profiles
from verify.cases.contact.roller.inputs import Crown, Design
from verify.core.case import FemResult
from verify.core.figures import Array


def solve_crowns(
    q: Crown, level: int, best: Design, tilt: float, *, more: Mapping[str, float],
    arrays: Mapping[str, Array],
) -> FemResult:  # fmt: skip
    """One level, with `more` values and `arrays`; the best crown is made for F."""
    found = half_space.pressed(q, level)
    crown = profiles.tilted(profiles.logarithmic(q, best, q.F), np.tan(tilt))
    pressed = half_space.pressed(q, level, crown=crown)
    u_best = half_space.stair(q, pressed, level, crown=crown)["p_top"]
    u_it = half_space.stair(q, found, level) | {"p_best": u_best}
    values = {"p_best": pressed.values["p_top"], **more}
    return half_space.result(found, level, u_it, values, arrays)
