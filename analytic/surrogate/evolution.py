"""Differential evolution, for the minimum of an objective in a box.

Source: R. Storn and K. Price, J. of Global Optimization 11 (1997) 341; implementation of scipy. The
result is not refined by a gradient method, because the largest of several regimes has kinks, often
at its minimum, where no gradient exists. Instead, the search ends only at a small spread of the
values of the population (1e-8 of their mean).
"""

import numpy as np
from scipy.optimize import OptimizeResult, differential_evolution

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.found import Found, Objective, asked

POPULATION = 15  # a parameter
GENERATIONS = 500
SPREAD = 1e-8  # spread of the population's values over their mean at which the search ends


def evolve(objective: Objective, box: Box, *, seed: int = 0) -> Found:
    """Minimum found by differential evolution; the objective takes a whole population (n, d).

    Raises ArithmeticError if the population has not converged after 500 generations.
    """
    history: list[float] = []
    count = 0

    def of_columns(u: Array) -> Array:
        nonlocal count
        count += u.shape[1]
        values = asked(objective, box.from_unit(u.T))
        history.append(min([values.min(), *history[-1:]]))
        return values

    result: OptimizeResult = differential_evolution(
        of_columns,
        [(0.0, 1.0)] * box.dimension,
        popsize=POPULATION,
        maxiter=GENERATIONS,
        tol=SPREAD,
        rng=seed,
        polish=False,
        updating="deferred",
        vectorized=True,
    )
    if not result.success:
        raise ArithmeticError(f"differential evolution did not converge: {result.message}")
    return Found(box.from_unit(result.x[None])[0], float(result.fun), count, np.array(history))
