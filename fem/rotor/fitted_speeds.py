"""Parameters of a rotor that give prescribed critical speeds, from many initial values at once.

Positions x (m, k) are the logarithms of the parameters, scaled to 0 to 1 in the given ranges. Steps
have the least norm in x. The gradients are those of the Rayleigh quotient
Omega^2 = (v K v)/(v (M - G_1) v) at constant v.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from fem.rotor.elements import Array
from fem.rotor.whirl_systems import WhirlSystems

STEPS = 14
HIT = 1e-8  # relative to each critical speed
LONGEST = 0.25  # length of a step over the width of a range
SMALL = 1e-5  # of a range, for differences
Systems = Callable[[Array], WhirlSystems]  # at places (m, k)


def fitted(
    start: Array, wanted: tuple[float, ...], systems: Systems
) -> tuple[Array, NDArray[np.bool_]]:
    """Relative positions (m, k) of fitted parameters, and a mask (m,) of the converged sets.

    The iteration begins at the positions `start` (m, k). `wanted` are the prescribed lowest
    forward critical speeds [rad/s].
    """
    x, hit = start.copy(), np.zeros(len(start), bool)
    active = np.arange(len(start))
    for _ in range(STEPS):
        speeds, shapes = systems(x[active]).critical_speeds(len(wanted))
        gap = np.log(speeds / np.array(wanted))
        near = np.abs(gap).max(axis=1) <= HIT
        hit[active[near]] = True
        on = np.isfinite(gap).all(axis=1) & ~near
        active, gap, shapes = active[on], gap[on], shapes[on]
        if not active.size:
            break
        J = gradients(x[active], shapes, systems)
        step = -(np.linalg.pinv(J) @ gap[:, :, None])[:, :, 0]
        longest = np.abs(step).max(axis=1, keepdims=True)
        x[active] += step * np.minimum(1, LONGEST / longest)
    return x, hit


def gradients(x: Array, v: Array, systems: Systems) -> Array:
    """Derivatives (m, modes, k) of the logarithms of the critical speeds.

    The derivatives are with respect to the positions x, and are calculated from the energies of the
    mode shapes v.
    """
    made = []
    for change in SMALL * np.eye(x.shape[1]):
        K_up, N_up = systems(x + change).energies(v)
        K_down, N_down = systems(x - change).energies(v)
        made.append((np.log(K_up / K_down) - np.log(N_up / N_down)) / (4 * SMALL))
    return np.stack(made, axis=-1)
