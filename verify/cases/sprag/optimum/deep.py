"""Long studies of the optimisation: 200 designs, long searches, several random seeds.

A long study has three parts: errors at validation designs; a search by scipy's DIRECT on
computed engagements, without a surrogate; genetic algorithm and differential evolution with
several seeds.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import direct

from analytic.sprag.best_crown import answers, fit_regimes, recorded
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from analytic.surrogate.genetic import genetic
from verify.case import Case, Level
from verify.cases.sprag.optimum.inputs import Optimum25Inputs, Optimum40Inputs, OptimumInputs
from verify.cases.sprag.optimum.study_fem import largest_fem
from verify.cases.sprag.peaks import peaks_fem
from verify.core.figures import Array
from verify.form.adapter import adapted

DESIGNS, SEED = 200, 3
PARTS = (0, 1, 2)  # parts of the measurement
ENGAGEMENTS = 400  # number of engagements that DIRECT computes
SEEDS = 10


def deep_fem(q: OptimumInputs, level: int) -> Level:
    arrays = (validated_fem, direct_fem, seeds_fem)[level](q)
    return Level(h=1.0, values={}, arrays=arrays)


def validated_fem(q: OptimumInputs) -> dict[str, Array]:
    """Relative errors of both surrogates at new designs, and computed pressures [Pa]."""
    from analytic.surrogate.kriging import fit

    x = full_factorial(q.box, q.levels)
    peaks = peaks_fem(q, x, [q.T])
    fresh = random_designs(q.box, DESIGNS, SEED)
    true = peaks_fem(q, fresh, [q.T]).largest[:, 0]
    single = fit(x, peaks.largest[:, 0], q.box).predict(fresh)
    two = fit_regimes(x, answers(peaks), q.box).predict(fresh)
    return {"true": true, "single": single / true - 1, "two": two / true - 1}


def direct_fem(q: OptimumInputs) -> dict[str, Array]:
    """Array (n, 4): crowns and their pressures [Pa], in the order of evaluation by DIRECT."""
    pressure, seen = recorded(lambda crown: largest_fem(q, crown), q.box)
    direct(pressure, [(0.0, 1.0)] * 3, maxfun=ENGAGEMENTS, maxiter=ENGAGEMENTS)
    return {"direct": np.array(seen)}


def seeds_fem(q: OptimumInputs) -> dict[str, Array]:
    """Minima [Pa] of the surrogate by each of both searches, for several random seeds."""
    x = full_factorial(q.box, q.levels)
    surrogate = fit_regimes(x, answers(peaks_fem(q, x, [q.T])), q.box)
    ga = [
        genetic(surrogate.predict, q.box, population=q.population, generations=q.generations,
                crossover=q.crossover, mutation=q.mutation, seed=seed).value
        for seed in range(SEEDS)
    ]  # fmt: skip
    de = [evolve(surrogate.predict, q.box, seed=seed).value for seed in range(SEEDS)]
    return {"GA": np.array(ga), "DE": np.array(de)}


class Deep(OptimumInputs, Case):  # type: ignore[misc]  # `levels` is an input
    """Errors of kriging at 200 designs, and results of longer searches."""

    source = "huang2018"
    place = "Sec. 3, Table 2"

    def reference(self, level: int) -> Level:
        """Results of part `level`: errors at new designs, DIRECT, or several random seeds."""
        return deep_fem(self, level)


class Deep25(Optimum25Inputs, Deep):  # type: ignore[misc]
    """Errors of kriging at 200 designs, and results of longer searches."""

    id = "sprag-optimum-deep"
    title = "Optimal crown of a sprag clutch, 25 N m, long study"


class Deep40(Optimum40Inputs, Deep):  # type: ignore[misc]
    """Errors of kriging at 200 designs, and results of longer searches."""

    id = "sprag-optimum-40-deep"
    title = "Optimal crown of a sprag clutch, 40 N m, long study"


DEEP_25 = replace(adapted(Deep25), levels=PARTS)
DEEP_40 = replace(adapted(Deep40), levels=PARTS)
