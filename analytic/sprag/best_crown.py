"""Kriging of the largest pressures over crowns (Eq. 20), and the optimal crown of the surrogate.

The pressure of the end slice and the largest pressure of all other slices are interpolated
separately, because the larger of both pressures has a kink where the ends begin to carry load.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import minimize

from analytic.contact.checks import Array
from analytic.sprag.peaks import Peaks
from analytic.surrogate.box import Box
from analytic.surrogate.evolution import evolve
from analytic.surrogate.infill import Infilled, infill

if TYPE_CHECKING:
    from analytic.surrogate.largest import Largest

POWER = 2.0  # a slice's pressure squared is proportional to its force
AGREE = 0.005  # relative difference of surrogate and true model at the optimal crown
DIRECT = 40  # engagements of the search without a surrogate


@dataclass(frozen=True)
class Answer:
    """Largest pressures [Pa] of the end slice and of all other slices of a sprag, and N_max [N].

    All values are for one engagement.

    >>> Answer(end=3e9, inside=2e9, N_max=6e3).largest
    3000000000.0
    """

    end: float
    inside: float
    N_max: float

    @property
    def largest(self) -> float:
        """Objective of the minimisation [Pa]: the larger of both pressures."""
        return max(self.end, self.inside)


def answers(peaks: Peaks, torque: int = 0) -> list[Answer]:
    """Pressures of all crowns under the torque with the index `torque`."""
    columns = (*peaks.regimes, peaks.N_max)
    return [Answer(*(float(c[k, torque]) for c in columns)) for k in range(len(peaks.crowns))]


def fit_regimes(x: Array, known: Sequence[Answer], box: Box) -> "Largest":
    """Kriging surrogates of the pressure of the end slice and of the largest other pressure.

    That of the end slice is fitted to crowns with loaded ends only. If these are too few, one
    surrogate is fitted to the larger of both pressures.
    """
    from analytic.surrogate.largest import fit_largest

    end, inside = (np.array([getattr(a, name) for a in known]) for name in ("end", "inside"))
    carries = end > 0
    try:
        return fit_largest(
            x, [end, inside], box, power=POWER, present=[carries, np.ones_like(carries)]
        )
    except ValueError:  # too few designs with loaded ends
        return fit_largest(x, [np.maximum(end, inside)], box, power=POWER)


def infilled(
    box: Box,
    x: Array,
    known: list[Answer],
    true: Callable[[Array], Answer],
    first: "Largest | None" = None,
) -> "Infilled[Answer, Largest]":
    """Result of an infill search for the optimal crown.

    It ends when the surrogate agrees with the true model at two successive optima.

    `known` are the true values of the initial designs x (n, 3); `first` is their surrogate if it
    already exists.
    """

    def fitted(designs: Array, found: Sequence[Answer]) -> "Largest":
        return first if first and len(designs) == len(x) else fit_regimes(designs, found, box)

    return infill(
        fitted, true, x, box=box, search=evolve, value=lambda answer: answer.largest,
        answers=known, agree=AGREE, in_a_row=2,
    )  # fmt: skip


def recorded(
    true: Callable[[Array], float], box: Box
) -> tuple[Callable[[Array], float], list[list[float]]]:
    """Function that returns the largest pressure [Pa] of a crown, and the list of its evaluations.

    The argument of the function is a crown in coordinates of the unit cube. `true` returns the
    pressure of a crown given as an array (1, 3). The list contains rows of K_1, K_2, z_m and
    pressure in the order of evaluation.
    """
    seen: list[list[float]] = []

    def pressure(u: Array) -> float:
        crown = box.from_unit(np.clip(u, 0, 1)[None])
        p = true(crown)
        seen.append([*crown[0], p])
        return p

    return pressure, seen


def simplex(true: Callable[[Array], float], box: Box, start: Array) -> Array:
    """Evaluations of the true model by Nelder and Mead's simplex method from `start` (3,).

    At most `DIRECT` engagements are computed. The rows (n, 4) contain K_1, K_2, z_m and the
    pressure [Pa].
    """
    pressure, seen = recorded(true, box)
    u = np.clip(box.to_unit(start[None])[0], 0, 1)
    corners = np.vstack([u, u + np.diag(np.where(u > 0.5, -0.15, 0.15))])
    minimize(
        pressure, u, method="Nelder-Mead", bounds=[(0, 1)] * 3,
        options={"initial_simplex": corners, "maxfev": DIRECT},
    )  # fmt: skip
    return np.array(seen)
