"""Largest pressures of an engagement, for all crowns of Eq. 19.

A crown changes the largest force by about 1 %. Only 27 engagements are computed. A quadratic
through their forces gives the force for every other crown, whose contact is then solved.
"""

import numpy as np

from analytic.sprag.peaks import Peaks
from analytic.surrogate.terms import trend_terms
from verify.cases.sprag.crown.formulas import box, factorial, gaps, radius
from verify.cases.sprag.engagement.model import in_slices, parts
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.figures import Array

FEW, MANY = 3, 5  # levels of the factorial: by engagements, and the paper's
SHARES = (0.4, 1.0, 1.2, 1.6)  # over T: 10, 25, 30 and 40 N m in the paper
FORCES = (0.08, 0.2, 0.4, 0.6, 0.8, 1.0)  # over the largest, for comparing both contacts


def forces(q: EngagementInputs, engaged: Peaks, crowns: Array) -> Array:
    """Largest forces [N] of engagements, (n, m): n crowns, m torques; by a fit to `engaged`."""
    low, high = box(q)
    known, asked = (trend_terms((x - low) / (high - low)) for x in (engaged.crowns, crowns))
    return np.asarray(asked @ np.linalg.lstsq(known, engaged.N_max, rcond=None)[0])


def largest(q: EngagementInputs, crowns: Array, N: Array) -> Array:
    """Largest pressures [Pa] on the inner race, (n, m), of crowns (n, 3) under N [N], (n, m)."""
    R = np.array([radius(q, float(x)) for x in N.mean(axis=0)])
    return np.asarray(in_slices(q, gaps(q, crowns)[:, None], R, N).peak_pressure.max(axis=-1))


def inner_over_outer(q: EngagementInputs, crowns: Array, N_max: float) -> Array:
    """Ratio of the largest pressure of the inner contact to that of the outer, (n, forces)."""
    whole, N = parts(q), N_max * np.array(FORCES)
    inner, outer = (
        in_slices(q, gaps(q, crowns)[:, None], float(R), N).peak_pressure.max(axis=-1)
        for R in (whole.R_contact_i, whole.R_contact_e)
    )
    return np.asarray(inner / outer)


def box_fem(q: EngagementInputs, engaged: Peaks) -> dict[str, Array]:
    """Arrays of the largest forces and pressures of many crowns of Eq. 19 under T, by name."""
    many = factorial(q, MANY)
    N = forces(q, engaged, many)
    return {
        "engaged p": engaged.largest[:, 0],
        "by contacts": largest(q, engaged.crowns, engaged.N_max)[:, 0],
        "box": many, "box N": N[:, 0], "box p": largest(q, many, N)[:, 0],
        "inner/outer": inner_over_outer(q, many, float(engaged.N_max.max())).min(axis=1),
    }  # fmt: skip
