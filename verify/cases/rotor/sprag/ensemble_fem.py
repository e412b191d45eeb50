"""Sets of parameters with the paper's three critical speeds: many, as three hold few of twelve.

Starts are Sobol's points in the ranges (log-uniform). From each, steps in the logarithms, least in
the measure of the ranges, lead to a system of the paper's 20 elements with those speeds. Gradients
are those of the Rayleigh quotient Omega^2 = v K v / v (M - G_1) v at fixed shapes v.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.cases.rotor.sprag.inputs import PRINTED
from verify.cases.rotor.sprag.layout import HIGH, LOW, PARAMETERS
from verify.cases.rotor.sprag.system_fem import systems_fem
from verify.core.figures import Array

BATCH = 64  # starts solved together
MOST_BATCHES = 32
STEPS = 14
HIT = 1e-8  # of each critical speed
LONGEST = 0.25  # of a step, over the width of a range
SMALL = 1e-5  # of a range, for differences
WIDTH = np.log(HIGH / LOW)
COUNT = len(PRINTED)


@dataclass(frozen=True)
class Ensemble:
    """Parameters (members, 12) [SI]; which starts met all speeds, and which were kept (starts,)."""

    members: Array
    met: NDArray[np.bool_]
    kept: NDArray[np.bool_]


def ensemble_fem(members: int) -> Ensemble:
    """At least `members` sets, unless 32 batches of starts give fewer."""
    from scipy.stats import qmc

    sobol = qmc.Sobol(len(PARAMETERS), scramble=True, rng=np.random.default_rng(2022))
    x = np.zeros((0, len(PARAMETERS)))
    met = kept = np.zeros(0, bool)
    while kept.sum() < members and len(x) < BATCH * MOST_BATCHES:
        found, hit = calibrated_fem(sobol.random(BATCH))
        inside = hit & np.all((found >= 0) & (found <= 1), axis=1)
        x = np.concatenate([x, found])
        met, kept = np.concatenate([met, hit]), np.concatenate([kept, inside])
    return Ensemble(parameters(x[kept]), met, kept)


def parameters(x: Array) -> Array:
    """Parameters (m, 12) [SI] at places x (m, 12) in the ranges, from 0 to 1 by logarithms."""
    return np.asarray(LOW * np.exp(x * WIDTH))


def calibrated_fem(start: Array) -> tuple[Array, Array]:
    """Places (m, 12) that least-norm steps from `start` lead to, and whether they hit (m,)."""
    x, hit = start.copy(), np.zeros(len(start), bool)
    active = np.arange(len(start))
    for _ in range(STEPS):
        speeds, shapes = systems_fem(parameters(x[active])).critical_speeds(COUNT)
        gap = np.log(speeds / np.array(PRINTED))
        near = np.abs(gap).max(axis=1) <= HIT
        hit[active[near]] = True
        on = np.isfinite(gap).all(axis=1) & ~near
        active, gap, shapes = active[on], gap[on], shapes[on]
        if not active.size:
            break
        J = gradients_fem(x[active], shapes)
        step = -(np.linalg.pinv(J) @ gap[:, :, None])[:, :, 0]
        longest = np.abs(step).max(axis=1, keepdims=True)
        x[active] += step * np.minimum(1, LONGEST / longest)
    return x, hit


def elasticities_fem(p: Array) -> Array:
    """Relative change (m, 3, 12) of each critical speed over that of each parameter (m, 12)."""
    _, shapes = systems_fem(p).critical_speeds(COUNT)
    return np.asarray(gradients_fem(np.log(p / LOW) / WIDTH, shapes) / WIDTH)


def gradients_fem(x: Array, v: Array) -> Array:
    """Derivatives (m, 3, 12) of the logarithms of the speeds by the places x, at shapes v."""
    made = []
    for change in SMALL * np.eye(len(PARAMETERS)):
        K_up, N_up = systems_fem(parameters(x + change)).energies(v)
        K_down, N_down = systems_fem(parameters(x - change)).energies(v)
        made.append((np.log(K_up / K_down) - np.log(N_up / N_down)) / (4 * SMALL))
    return np.stack(made, axis=-1)
