"""Quality of a surrogate of crown pressures: errors, optima by two searches, maps.

All functions return arrays by name, as the study of the optimal crown stores them. Crowns are rows
of K_1, K_2, z_m.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from analytic.contact.checks import Array
from analytic.sprag.best_crown import Answer
from analytic.sprag.peaks import Peaks
from analytic.surrogate.box import Box
from analytic.surrogate.evolution import evolve
from analytic.surrogate.gate import left_level_out
from analytic.surrogate.genetic import genetic
from analytic.surrogate.infill import Infilled

if TYPE_CHECKING:
    from analytic.surrogate.largest import Largest

FINE = (33, 17, 33)  # points along K_1, K_2, z_m on which the surrogate is evaluated
HELD = {1: 0.5, 2: 10e-6}  # of K_2 and z_m [m] in Figs. 15 and 17


def tried(box: Box, x: Array, peaks: Peaks, extra: Array, surrogate: "Largest") -> dict[str, Array]:
    """Errors, by name, of one kriging surrogate (Eq. 20) and of `surrogate` for two regimes.

    `surrogate` is fitted to the designs x (n, 3) with their `peaks` under the first torque. `extra`
    (m, 3) are designs that were not used for fitting.
    """
    from analytic.surrogate.kriging import fit

    largest, regimes = peaks.largest[:, 0], [peaks.end[:, 0], peaks.inside[:, 0]]
    single = fit(x, largest, box)
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


def searched(
    surrogate: "Largest", box: Box, *, population: int, generations: int, crossover: float,
    mutation: float,
) -> dict[str, Array]:  # fmt: skip
    """Optima of the surrogate by the paper's genetic algorithm and by differential evolution."""
    ga = genetic(
        surrogate.predict, box, population=population, generations=generations,
        crossover=crossover, mutation=mutation,
    )  # fmt: skip
    de = evolve(surrogate.predict, box)
    return {
        f"{name} {what}": np.atleast_1d(np.asarray(value, dtype=np.float64))
        for name, one in (("GA", ga), ("DE", de))
        for what, value in (("x", one.x), ("value", one.value), ("history", one.history),
                            ("evaluations", one.evaluations))
    }  # fmt: skip


def mapped(last: "Infilled[Answer, Largest]", box: Box, at_hand: Array) -> Mapping[str, Array]:
    """Optimal crown, convergence of surrogate and true model, and maps of the surrogate, by name.

    The result also contains the value of the surrogate at the given crown `at_hand` (3,), or at the
    nearest crown of the box if `at_hand` is outside.
    """
    K_1, K_2, z_m = axes(box)
    best = last.answers[int(np.argmin([a.largest for a in last.answers]))]
    predict = last.surrogate.predict
    return {
        "best": last.x, "best true": np.array([best.largest, best.end, best.inside, best.N_max]),
        "best predicted": np.array([last.predicted]),
        "infill": np.array([[*r.x, r.predicted, r.true] for r in last.history]),
        "at hand predicted": predict(np.clip(at_hand, box.low, box.high)[None]),
        "K_1": K_1, "K_2": K_2, "z_m": z_m, "whole": over_box(last.surrogate, box),
        "map K_1, K_2": predict(_points(K_1, K_2, np.array([held(box, 2)])))
        .reshape(len(K_1), len(K_2)),
        "map K_1, z_m": predict(_points(K_1, np.array([held(box, 1)]), z_m))
        .reshape(len(K_1), len(z_m)),
    }  # fmt: skip


def over_box(surrogate: "Largest", box: Box) -> Array:
    """Pressures [Pa] of the surrogate on the grid of `axes`, shape FINE."""
    return np.asarray(surrogate.predict(_points(*axes(box))).reshape(FINE))


def axes(box: Box) -> list[Array]:
    """Values of K_1, K_2 and z_m at which the surrogate is evaluated."""
    return [np.linspace(a, b, n) for a, b, n in zip(box.low, box.high, FINE, strict=True)]


def held(box: Box, axis: int) -> float:
    """Constant value of K_2 (axis 1) or z_m (axis 2) in a map.

    The value is that of Figs. 15 and 17 if it lies within the box, otherwise the middle of the box.
    """
    low, high, value = box.low[axis], box.high[axis], HELD[axis]
    return value if low <= value <= high else (low + high) / 2


def _points(K_1: Array, K_2: Array, z_m: Array) -> Array:
    return np.column_stack([a.ravel() for a in np.meshgrid(K_1, K_2, z_m, indexing="ij")])
