"""The optimisation of the paper (Eqs. 17-22, Fig. 9) with computed engagements.

The steps are a full factorial design, kriging of the largest pressures, searches on the surrogate,
computed engagements at the optima, and a search without a surrogate.
"""

import numpy as np

from analytic.sprag import best_crown
from analytic.sprag.best_crown import Answer, answers
from analytic.sprag.crown_surrogate import mapped, over_box, searched, tried
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.cases.sprag.peaks import peaks_fem
from verify.core.figures import Array

EXTRA_SEED = 1  # random seed of the extra designs


def study_fem(q: OptimumInputs) -> dict[str, Array]:
    """Arrays of all results of the optimisation, by name."""
    box = q.box
    x = full_factorial(box, q.levels)
    peaks = peaks_fem(q, x, q.torques)
    extra = random_designs(box, q.extra, EXTRA_SEED)
    fresh = peaks_fem(q, extra, q.torques)
    known, at_hand = answers(peaks), np.array([q.K_1, q.K_2, q.z_m])
    surrogate = best_crown.fit_regimes(x, known, box)
    found = {
        "X": x, "end": peaks.end, "inside": peaks.inside, "N_max": peaks.N_max,
        "extra": extra, "extra largest": fresh.largest, "extra N_max": fresh.N_max,
    }  # fmt: skip
    found |= tried(box, x, peaks, extra, surrogate)
    found |= searched(surrogate, box, population=q.population, generations=q.generations,
                      crossover=q.crossover, mutation=q.mutation)  # fmt: skip
    last = best_crown.infilled(
        box, x, known, lambda crown: answers(peaks_fem(q, crown[None], [q.T]))[0], surrogate
    )
    found |= mapped(last, box, at_hand)
    found["direct"] = best_crown.simplex(lambda crown: largest_fem(q, crown), box, at_hand)
    return found | (less_fem(q, x, answers(peaks, 1)) if q.T_less is not None else {})


def largest_fem(q: OptimumInputs, crowns: Array) -> float:
    """Largest pressure [Pa] with the first of `crowns` in an engagement under T."""
    return float(peaks_fem(q, crowns, [q.T]).largest[0, 0])


def less_fem(q: OptimumInputs, x: Array, known: list[Answer]) -> dict[str, Array]:
    """Optimal crown for the second torque by a surrogate, and its pressures at both torques."""
    assert q.T_less is not None
    surrogate = best_crown.fit_regimes(x, known, q.box)
    crown = evolve(surrogate.predict, q.box).x
    return {
        "less": np.array([*crown, *peaks_fem(q, crown[None], q.torques).largest[0]]),
        "less over K_1": over_box(surrogate, q.box).min(axis=(1, 2)),
    }
