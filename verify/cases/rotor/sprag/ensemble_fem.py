"""Sets of parameters with the paper's three critical speeds: many, as three hold few of twelve.

Starts are Sobol's points in the ranges (log-uniform). From each, least-norm steps lead to a system
of the paper's 20 elements with those speeds.
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
WIDTH = np.log(HIGH / LOW)


@dataclass(frozen=True)
class Ensemble:
    """Parameters (members, 12) [SI]; which starts met all speeds, and which were kept (starts,)."""

    members: Array
    met: NDArray[np.bool_]
    kept: NDArray[np.bool_]


def ensemble_fem(members: int) -> Ensemble:
    """At least `members` sets, unless 32 batches of starts give fewer."""
    from scipy.stats import qmc

    from fem.rotor.fitted_speeds import fitted

    sobol = qmc.Sobol(len(PARAMETERS), scramble=True, rng=np.random.default_rng(2022))
    x = np.zeros((0, len(PARAMETERS)))
    met = kept = np.zeros(0, bool)
    while kept.sum() < members and len(x) < BATCH * MOST_BATCHES:
        found, hit = fitted(sobol.random(BATCH), PRINTED, lambda x: systems_fem(parameters(x)))
        inside = hit & np.all((found >= 0) & (found <= 1), axis=1)
        x = np.concatenate([x, found])
        met, kept = np.concatenate([met, hit]), np.concatenate([kept, inside])
    return Ensemble(parameters(x[kept]), met, kept)


def parameters(x: Array) -> Array:
    """Parameters (m, 12) [SI] at places x (m, 12) in the ranges, from 0 to 1 by logarithms."""
    return np.asarray(LOW * np.exp(x * WIDTH))


def elasticities_fem(p: Array) -> Array:
    """Relative change (m, 3, 12) of each critical speed over that of each parameter (m, 12)."""
    from fem.rotor.fitted_speeds import gradients

    _, shapes = systems_fem(p).critical_speeds(len(PRINTED))
    x = np.log(p / LOW) / WIDTH
    return np.asarray(gradients(x, shapes, lambda x: systems_fem(parameters(x))) / WIDTH)
