"""States of a roller in a wedge: during removal of the pressing force, and at limiting friction."""

import math
from collections.abc import Callable

import numpy as np

from fem.contact.solution import Touch
from fem.contact.wedged import Wedge
from fem.plane.discretisation import Array

SWEEP, SWEPT = 50, 0.88  # steps of letting go, and T/(mu N) at their end
STIFFENS = 0.93  # d ln(approach)/d ln(N) of line contacts, about
BELOW, ABOVE = 2e-4, 4e-4  # of T/N: ends of the bracket in which the limit is searched
BISECTIONS = 5
HELD = 0.9  # relative to N: below this share, the roller is expelled


def let_go(wedge: Wedge, N: float, *, mu: float) -> tuple[Array, Array]:
    """Ratios T/(mu N) and (c/a)² (m,) of a roller while the force that presses it is reduced.

    This force acts at the middle of the roller. Initially, there is no friction, and the force
    alone balances the normal forces N. The force is then reduced in m steps; N is constant and
    T increases.
    """
    half = wedge.geometry.half
    push = N * math.sin(half)
    state, down = wedge.pressed(N, push=push, near=wedge.pressed(N)[1])
    found = []
    for k in np.linspace(0.0, SWEPT, SWEEP + 1)[1:]:
        less = push - k * mu * N * math.cos(half)
        trial = wedge.forces(wedge.at(down, push=less, after=state))[0]
        down *= (N / trial) ** STIFFENS
        state = wedge.at(down, push=less, after=state)
        normal, tangential = wedge.forces(state)
        found.append((tangential / (mu * normal), share_stuck(state.touches[0])))
    ratio, stuck = np.array(found).T
    return ratio, stuck


def share_stuck(touch: Touch) -> float:
    """Squared ratio (c/a)² of the half-widths of stick zone and contact, from a second moment.

    For Cattaneo's tractions, (c/a)² is 4 M_2/(M_0 a²) - 1, with the second moment M_2 of the
    tangential traction and its integral M_0. The moment is about the fixed middle of the contact.
    Therefore an odd part of the traction has no effect; pressing a round body on a flat leaves such
    a part.
    """
    middle = (0.0, 0.0)  # the roller's centre, below the place where it first touched
    s, load = touch.along(middle), touch.q * touch.weight
    return float(4 * (load @ s**2) / (load.sum() * touch.half_width(middle) ** 2) - 1)


def slipping(touch: Touch) -> float:
    """Fraction of the normal force that acts on slipping nodes."""
    load = touch.pressure * touch.mortar.size
    return float(load[touch.closed & ~touch.sticks].sum() / load.sum())


def uneven(touch: Touch, slope: float) -> float:
    """L2 norm of (traction - `slope` x pressure), divided by the norm of (`slope` x pressure)."""
    wanted = slope * touch.p
    return float(np.sqrt(((touch.q - wanted) ** 2 @ touch.weight) / (wanted**2 @ touch.weight)))


def least_friction(left: Callable[[float], float], share: float) -> tuple[float, float]:
    """Lowest friction coefficient that holds a roller, and its uncertainty, by bisection.

    `left` returns the remaining share of the normal force for a friction coefficient: nearly one,
    or nearly zero. The first bracket encloses `share`, the ratio T/N that friction must transmit.
    The uncertainty is half the width of the last bracket. The result is NaN if the roller is held
    at both ends of the bracket, or at neither end.

    >>> value, half = least_friction(lambda mu: 1.0 if mu > 0.05 else 0.0, 0.05)
    >>> abs(value - 0.05) <= half
    True
    """
    low, high = share * (1 - BELOW), share * (1 + ABOVE)
    if left(low) > HELD or left(high) < HELD:
        return math.nan, 0.0
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (low, middle) if left(middle) > HELD else (middle, high)
    return (low + high) / 2, (high - low) / 2
