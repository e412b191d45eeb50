"""States of one pitch of a drawn-cup clutch for increasing load, also beyond the largest torque.

Approaches of the contacts are prescribed, not torques. They range from nearly zero to beyond the
approaches under the torque T, and on towards pop-through of the rollers. The normal force increases
from state to state; the torque increases only up to its maximum.
"""

import math
from functools import lru_cache

import numpy as np

from fem.contact.errors import NotFoundError
from fem.wedge.flat_start import COARSE, MOST, Start, after, overlap
from fem.wedge.flat_summit import SummitCourse
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import overlapping, pitch
from verify.cases.freewheel.sweep import rigid_force

SHARES = (0.03, 0.09, 0.22, 0.45, 0.75, 1.04)  # overlaps of the states over the overlap under T
# overlaps over the overlap at pop-through
ONWARD = (0.018, 0.045, 0.1, 0.22, 0.36, 0.5, 0.6, 0.68, 0.76)
APART = 1.1  # over the largest of SHARES: states of ONWARD are used above it
INNER = 0.37  # approximate part of the overlap at the shaft
NEAR = 2e-2  # relative tolerance of T in the search
GIVEN = 0.25  # overlap at the given angle over the overlap at pop-through
STEEP, FLAT = 1.1, 0.25  # d ln(T)/d ln(overlap) of a rigid angle; and no less


def through(q: OneClutch) -> float:
    """Sum of the approaches [m] at pop-through of the rollers."""
    return q.race + 2 * q.r - q.flat


def given_angle(q: OneClutch) -> float:
    """Angle psi [rad] at which d_i + d_o is `GIVEN` times its value at pop-through."""
    d = GIVEN * through(q) / 2
    return overlapping(q, d, d).psi


@lru_cache(maxsize=16)
def starts(q: OneClutch) -> tuple[Start, ...]:
    """Initial states for all loads of the sweep, from coarse meshes; the lightest load first."""
    under = under_torque(q)
    d = sum(under.d)
    onward = [share * through(q) for share in ONWARD]
    wanted = [share * d for share in SHARES] + [D for D in onward if APART * SHARES[-1] * d < D]
    found, now = [], under
    for D in sorted(wanted, reverse=True):
        now = after(now.scaled(D / sum(now.d)).state(pitch(q), COARSE))
        found.append(now)
    return tuple(reversed(found))


def under_torque(q: OneClutch) -> Start:
    """Initial state at about the torque T; raises NotFoundError if T is near the maximum."""
    one, most = pitch(q), through(q)
    D = min(overlap(one, rigid_force(q) / q.L), 0.3 * most)
    now = Start.guessed(one, D, inner=INNER, flatter=3)
    for _ in range(MOST):
        state = now.state(one, COARSE)
        now, D = after(state), sum(now.d)
        miss = math.log(q.T / (state.torque * q.L))
        if abs(miss) < NEAR:
            return now
        steepness = max(STEEP - D / (2 * (most - D)), FLAT)
        share = math.exp(float(np.clip(miss / steepness, -1.5, 0.5)))
        now = now.scaled(min(share, (D + 0.5 * (most - D)) / D))
    raise NotFoundError(
        f"no state with T = {q.T:g} N m was found (the torque of the last iteration differs from T "
        f"by {miss:.1%}): T is too close to the largest torque; reduce T"
    )


class CupSweep(SummitCourse):
    """States of one pitch, interpolated over the load; half a fine zone has `cells` cells."""

    def __init__(self, q: OneClutch, cells: int) -> None:
        one = pitch(q)
        super().__init__(one, q.L, [start.state(one, cells) for start in starts(q)])
