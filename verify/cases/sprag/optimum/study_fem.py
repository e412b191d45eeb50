"""The paper's optimisation (Eqs. 17-22, Fig. 9) on compiled engagements: everything it measures.

A full factorial, kriging of its largest pressures, searches on the surrogate, the true model where
they end. Beside it, searches that know no surrogate.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import minimize

from analytic.sprag.peaks import Peaks
from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from analytic.surrogate.gate import left_level_out
from analytic.surrogate.genetic import genetic
from analytic.surrogate.infill import Infilled, infill
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.cases.sprag.peaks import peaks_fem
from verify.core.figures import Array

if TYPE_CHECKING:
    from analytic.surrogate.kriging import Kriging
    from analytic.surrogate.largest import Largest

EXTRA_SEED = 1  # of the extra designs
POWER = 2.0  # a slice's pressure squared goes with its force
AGREE = 0.005  # of surrogate and true model where the best crown is
DIRECT = 40  # engagements of the search that knows no surrogate
FINE = (33, 17, 33)  # points along K_1, K_2, z_m on which the surrogate is told
HELD = {1: 0.5, 2: 10e-6}  # of K_2 and z_m [m] in Figs. 15 and 17


@dataclass(frozen=True)
class Answer:
    """What one engagement's end and the rest of it count for [Pa], and its N_max [N]."""

    end: float
    inside: float
    N_max: float

    @property
    def largest(self) -> float:
        return max(self.end, self.inside)


def answers(peaks: Peaks, torque: int = 0) -> list[Answer]:
    """Under one of the torques, by its number."""
    columns = (*peaks.regimes, peaks.N_max)
    return [Answer(*(float(c[k, torque]) for c in columns)) for k in range(len(peaks.crowns))]


def fit_fem(x: Array, known: Sequence[Answer], box: Box) -> "Largest":
    """Kriging of both regimes: the end slice where it carries, and all others."""
    from analytic.surrogate.largest import fit_largest

    end, inside = (np.array([getattr(a, name) for a in known]) for name in ("end", "inside"))
    carries = end > 0
    try:
        return fit_largest(
            x, [end, inside], box, power=POWER, present=[carries, np.ones_like(carries)]
        )
    except ValueError:  # too few designs whose ends carry: of all
        return fit_largest(x, [np.maximum(end, inside)], box, power=POWER)


def single_fem(x: Array, largest: Array, box: Box) -> "Kriging":
    """One kriging of the largest pressure, as the paper has it (Eq. 20)."""
    from analytic.surrogate.kriging import fit

    return fit(x, largest, box)


def infilled_fem(
    q: OptimumInputs,
    x: Array,
    known: list[Answer],
    true: Callable[[Array], Answer],
    first: "Largest | None" = None,
) -> "Infilled[Answer, Largest]":
    """Designs added at the surrogate's best crown until the true model agrees, twice in a row.

    `first` is the surrogate of the designs x, where it is known.
    """

    def fitted(designs: Array, found: Sequence[Answer]) -> "Largest":
        return first if first and len(designs) == len(x) else fit_fem(designs, found, q.box)

    return infill(
        fitted, true, x, box=q.box, search=evolve, value=lambda answer: answer.largest,
        answers=known, agree=AGREE, in_a_row=2,
    )  # fmt: skip


def recorded_fem(q: OptimumInputs) -> tuple[Callable[[Array], float], list[list[float]]]:
    """The largest pressure [Pa] of a crown of the unit cube, and all that was asked for, in order.

    That are rows of K_1, K_2, z_m and the pressure.
    """
    seen: list[list[float]] = []

    def pressure(u: Array) -> float:
        crown = q.box.from_unit(np.clip(u, 0, 1)[None])
        p = float(peaks_fem(q, crown, [q.T]).largest[0, 0])
        seen.append([*crown[0], p])
        return p

    return pressure, seen


def direct_fem(q: OptimumInputs, start: Array) -> dict[str, Array]:
    """Nelder and Mead's simplex on the true model, from a crown, in DIRECT engagements."""
    pressure, seen = recorded_fem(q)
    u = np.clip(q.box.to_unit(start[None])[0], 0, 1)
    simplex = np.vstack([u, u + np.diag(np.where(u > 0.5, -0.15, 0.15))])
    minimize(
        pressure, u, method="Nelder-Mead", bounds=[(0, 1)] * 3,
        options={"initial_simplex": simplex, "maxfev": DIRECT},
    )  # fmt: skip
    return {"direct": np.array(seen)}


def study_fem(q: OptimumInputs) -> dict[str, Array]:
    """All arrays of the optimisation, by name."""
    box = q.box
    x = full_factorial(box, q.levels)
    peaks = peaks_fem(q, x, q.torques)
    extra = random_designs(box, q.extra, EXTRA_SEED)
    fresh = peaks_fem(q, extra, q.torques)
    known = answers(peaks)
    surrogate = fit_fem(x, known, box)
    found = {
        "X": x, "end": peaks.end, "inside": peaks.inside, "N_max": peaks.N_max,
        "extra": extra, "extra largest": fresh.largest, "extra N_max": fresh.N_max,
    }  # fmt: skip
    found |= tried_fem(q, x, peaks, extra, surrogate)
    found |= searched_fem(q, surrogate)
    found |= told_fem(q, infilled_fem(
        q, x, known, lambda crown: answers(peaks_fem(q, crown[None], [q.T]))[0], surrogate
    ))  # fmt: skip
    found |= direct_fem(q, np.array([q.K_1, q.K_2, q.z_m]))
    return found | (less_fem(q, x, answers(peaks, 1)) if q.T_less is not None else {})


def less_fem(q: OptimumInputs, x: Array, known: list[Answer]) -> dict[str, Array]:
    """The best crown under the other torque, by its surrogate, and what it bears under both."""
    assert q.T_less is not None
    surrogate = fit_fem(x, known, q.box)
    crown = evolve(surrogate.predict, q.box).x
    K_1, K_2, z_m = axes(q)
    return {
        "less": np.array([*crown, *peaks_fem(q, crown[None], q.torques).largest[0]]),
        "less over K_1": surrogate.predict(_points(K_1, K_2, z_m)).reshape(FINE).min(axis=(1, 2)),
    }


def tried_fem(
    q: OptimumInputs, x: Array, peaks: Peaks, extra: Array, surrogate: "Largest"
) -> dict[str, Array]:
    """Errors of one kriging and of that of both regimes, and what the partner needs to repeat."""
    largest, regimes = peaks.largest[:, 0], [peaks.end[:, 0], peaks.inside[:, 0]]
    single = single_fem(x, largest, q.box)
    found = {
        "extra single": single.predict(extra), "extra two": surrogate.predict(extra),
        "left out single": -single.left_out() / largest,
        "left out two": surrogate.left_out(x, regimes),
        "level out single": left_level_out(single, x, largest),
        "level out two": left_level_out(surrogate, x, largest),
    }  # fmt: skip
    for name, model in zip(("end", "inside"), surrogate.models[-2:], strict=False):
        found |= {
            f"{name} designs": model.designs, f"{name} values": model.values,
            f"{name} scales": model.length_scales, f"{name} left out": model.left_out(),
            f"{name} predicted": model.predict(extra), f"{name} deviation": model.deviation(extra),
        }  # fmt: skip
    return found


def searched_fem(q: OptimumInputs, surrogate: "Largest") -> dict[str, Array]:
    """The paper's genetic algorithm and differential evolution on the surrogate."""
    ga = genetic(
        surrogate.predict, q.box, population=q.population, generations=q.generations,
        crossover=q.crossover, mutation=q.mutation,
    )  # fmt: skip
    de = evolve(surrogate.predict, q.box)
    return {
        f"{name} {what}": np.atleast_1d(np.asarray(value, dtype=np.float64))
        for name, one in (("GA", ga), ("DE", de))
        for what, value in (("x", one.x), ("value", one.value), ("history", one.history),
                            ("evaluations", one.evaluations))
    }  # fmt: skip


def told_fem(q: OptimumInputs, last: "Infilled[Answer, Largest]") -> dict[str, Array]:
    """The best crown, how surrogate and true model came together, and the surrogate's maps."""
    K_1, K_2, z_m = axes(q)
    whole = last.surrogate.predict(_points(K_1, K_2, z_m)).reshape(FINE)
    best = last.answers[int(np.argmin([a.largest for a in last.answers]))]
    at = np.array([q.K_1, q.K_2, q.z_m])
    return {
        "best": last.x, "best true": np.array([best.largest, best.end, best.inside, best.N_max]),
        "best predicted": np.array([last.predicted]),
        "infill": np.array([[*r.x, r.predicted, r.true] for r in last.history]),
        "at hand predicted": last.surrogate.predict(np.clip(at, q.box.low, q.box.high)[None]),
        "K_1": K_1, "K_2": K_2, "z_m": z_m, "whole": whole,
        "map K_1, K_2": last.surrogate.predict(_points(K_1, K_2, np.array([held(q, 2)])))
        .reshape(len(K_1), len(K_2)),
        "map K_1, z_m": last.surrogate.predict(_points(K_1, np.array([held(q, 1)]), z_m))
        .reshape(len(K_1), len(z_m)),
    }  # fmt: skip


def axes(q: OptimumInputs) -> list[Array]:
    """Where the surrogate is told, along each parameter."""
    return [np.linspace(a, b, n) for a, b, n in zip(q.box.low, q.box.high, FINE, strict=True)]


def held(q: OptimumInputs, axis: int) -> float:
    """What a map holds of K_2 (1) or z_m (2); the box's middle where the box lacks it."""
    low, high, value = q.box.low[axis], q.box.high[axis], HELD[axis]
    return value if low <= value <= high else (low + high) / 2


def _points(K_1: Array, K_2: Array, z_m: Array) -> Array:
    return np.column_stack([a.ravel() for a in np.meshgrid(K_1, K_2, z_m, indexing="ij")])
