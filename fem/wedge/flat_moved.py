"""Clamping angle of a wedged roller with slightly displaced flats."""

import math
from dataclasses import replace

from fem.wedge.flat_place import Pitch, Place
from fem.wedge.flat_start import Start, after
from fem.wedge.pulled import HARDER

NEAR, MOST = 2e-4, 6  # relative error of the torque, number of steps


def angle_with_flats(
    q: Pitch, start: Start, flat: float, cells: int, *, T: float, L: float
) -> float:
    """Clamping angle [rad] under the torque T [N m] with flats at `flat` [m] from the axis.

    `start` is the approximate state of the pitch `q` under this torque. `L` [m] is the length of
    the rollers.
    """
    other = replace(q, flat=flat)
    steeper = [math.tan(Place.overlapping(one, *start.d).psi / 2) for one in (other, q)]
    now = start.scaled((steeper[1] / steeper[0]) ** HARDER)
    for _ in range(MOST):
        state = now.state(other, cells)
        share = T / (state.torque * L)
        if abs(share - 1) < NEAR:
            break
        now = after(state).scaled(share**HARDER)
    alpha = state.place.psi / 2
    # the remaining error of the torque is NEAR: the angle depends on the overlap
    overlap = state.place.d_i + state.place.d_o
    return float(alpha + (share**HARDER - 1) * overlap / (2 * q.race * math.sin(2 * alpha)))
