"""States of the sector of a roller freewheel over its load, by finite elements.

The smallest approaches of the contacts are nearly zero. The largest exceed those under the torque T
and those under the normal force N_0 = T/(z R tan(alpha_0)) of a rigid clutch.
"""

from functools import lru_cache

from fem.wedge import flat_start
from fem.wedge.flat_course import FlatCourse
from fem.wedge.flat_place import Pitch
from fem.wedge.flat_start import COARSE, Start, after, guessed_inside, loaded
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import overlapping, pitch

SHARES = (0.012, 0.045, 0.15, 0.42, 0.82, 1.06)  # overlaps of the states over the overlap under N_0
NEAR = 2e-3  # how near N_0 the end of the sweep is
GIVEN = 10.0  # N_0/(L E'): approaches at an angle that is given


def rigid_force(q: OneClutch) -> float:
    """Normal force N_0 = T/(z R tan(alpha_0)) [N] of a rigid clutch."""
    return flat_start.rigid_force(pitch(q), q.T)


def given_angle(q: OneClutch) -> float:
    """Angle psi [rad] at which the sum of both approaches is `GIVEN` N_0/(L E').

    This angle lies beyond the angle at N_0.
    """
    d = GIVEN * rigid_force(q) / q.L * (1 - q.nu**2) / q.E
    return overlapping(q, d / 2, d / 2).psi


def sweep(q: OneClutch, cells: int) -> FlatCourse:
    """States of one pitch, stored for all cases of a clutch; half a fine zone has `cells` cells."""
    return _sweep(pitch(q), q.L, rigid_force(q), cells)


@lru_cache(maxsize=4)
def _sweep(one: Pitch, L: float, N_0: float, cells: int) -> FlatCourse:
    states = [start.state(one, cells) for start in reversed(starts(one, N_0 / L))]
    return FlatCourse(one, L, states)


@lru_cache(maxsize=16)
def starts(one: Pitch, P: float) -> tuple[Start, ...]:
    """Initial states of the sweep up to the load `P` = N_0/L [N/m], computed on coarse meshes."""
    now = loaded(
        one, guessed_inside(one, P), lambda state: P / state.on_flat[0],
        power=0.95,  # approaches grow a little slower than forces
        near=NEAR, what="the normal force of a rigid clutch",
    )  # fmt: skip
    found, before = [], 1.0
    for share in sorted(SHARES, reverse=True):
        now = after(now.scaled(share / before).state(one, COARSE))
        found.append(now)
        before = share
    return tuple(found)
