"""Search for the optimal crown by kriging; the true model evaluates samples and the optimum."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from analytic.surrogate.found import Found, Objective
from analytic.surrogate.gate import PoorSurrogateError, Quality, gate, quality
from analytic.surrogate.genetic import genetic
from analytic.surrogate.infill import Infilled, infill
from verify.core.figures import Array
from verify.studies.design_sprag.corners import corners, reach
from verify.studies.design_sprag.inputs import Task
from verify.studies.design_sprag.model import Model
from verify.studies.design_sprag.surrogates import Surrogates, crowns_of, fitted_fem, logs

LEVELS = 5
FRESH, DRAWS = 20, 6  # random crowns that a surrogate is judged by; how often more are drawn
NEAR = 0.10  # of the least pressure: beyond, no crown is searched
FEW = 5  # near crowns that judge
AGREE, IN_A_ROW = 0.005, 2
DIGITS = 4  # of the crown that is handed over

Worth = Callable[[Array], Array]  # from pressures (n, m) to the objective, (n,)


@dataclass(eq=False)
class Search:
    """State of a search: evaluated crowns, the box of the search and the larger box of kriging."""

    task: Task
    model: Model
    levels: int = LEVELS
    box: Box = field(init=False)  # of the logarithms
    wide: Box = field(init=False)
    complete: list[tuple[Array, Array]] = field(default_factory=list)
    judged: list[tuple[Quality, Quality]] = field(default_factory=list)  # near the best, and all
    parity: list[tuple[Array, Array]] = field(default_factory=list)  # true, predicted (n, m) [Pa]
    surrogates: Surrogates = field(init=False)

    def __post_init__(self) -> None:
        self.box = _box(np.array(self.task.low), np.array(self.task.high))
        self.wide = _box(*reach(self.task))

    @property
    def single(self) -> bool:
        """Whether the task has no tolerances, so that only the nominal crown is judged."""
        return not (self.task.wishes.t_z or self.task.wishes.t_y)

    def fit(self, like: Surrogates | None = None) -> Surrogates:
        """Kriging model of all evaluated crowns; with the length scales of `like`, if given."""
        return fitted_fem(self.model.known, self.task.wishes.contacts, self.wide, like)

    def worst(self, crowns: Array) -> Array:
        """Largest pressures (n, m) [Pa] of crowns (n, 3) within their tolerance, by kriging."""
        every = corners(self.task, crowns)
        found = self.surrogates.predict(every.reshape(-1, 3))
        return np.asarray(found.reshape(*every.shape[:2], -1).max(axis=1))

    def true(self, crown: Array) -> Array:
        """Largest pressures (m,) [Pa] of one crown (3,) within its tolerance, by the true model."""
        found = self.model.ask(corners(self.task, crown[None])[0])
        p = np.asarray(found.largest(self.task.wishes.contacts).max(axis=0))
        self.complete.append((crown, p))
        return p

    def prepare(self) -> None:
        """Evaluate a factorial design of crowns, and fit kriging until the fit passes its test.

        The test uses new random crowns, which are added to the evaluated crowns afterwards. Raises
        PoorSurrogateError if kriging fails all tests.
        """
        contacts = self.task.wishes.contacts
        start = crowns_of(full_factorial(self.wide, self.levels))
        self.model.ask(start)
        if self.single:
            p = self.model.known.largest(contacts)
            self.complete += list(zip(self.model.known.crowns, p, strict=True))
        for draw in range(DRAWS):
            self.surrogates = self.fit()
            seed = self.task.wishes.seed * DRAWS + draw
            fresh = crowns_of(random_designs(self.wide, FRESH, seed))
            predicted = self.surrogates.predict(fresh)
            true = self.model.ask(fresh).largest(contacts)
            least = self.model.known.largest(contacts).min(axis=0)
            near = np.minimum(true, predicted) <= (1 + NEAR) * least
            self.parity.append((true, predicted))
            whole = quality(predicted.ravel(), true.ravel())
            if near.sum() < FEW:
                near = true <= np.sort(true, axis=0)[FEW - 1]
            self.judged.append((quality(predicted[near], true[near]), whole))
            try:
                gate(self.judged[-1][0], what="the largest pressure")
            except PoorSurrogateError:
                if draw == DRAWS - 1:
                    raise
                continue
            return

    def least(self, worth: Worth) -> "Infilled[Array, Worst]":
        """Crown with the least objective.

        The optimum of kriging is evaluated by the true model repeatedly until both models agree.
        """
        find = {"evolution": evolve, "genetic": genetic}[self.task.wishes.method]

        def search(objective: Objective, box: Box) -> Found:
            return find(objective, box, seed=self.task.wishes.seed)

        def fit(_x: Array, _known: Sequence[Array]) -> "Worst":
            self.surrogates = self.fit(self.surrogates)
            return Worst(self, worth)

        known = [(x, p) for x, p in self.complete if self._inside(x)]
        x = logs(np.array([c for c, _ in known])) if known else np.empty((0, 3))
        return infill(
            fit, lambda point: self.true(crowns_of(point[None])[0]), x, box=self.box,
            search=search, value=lambda p: float(worth(p[None])[0]),
            answers=[p for _, p in known], agree=AGREE, in_a_row=IN_A_ROW,
        )  # fmt: skip

    def _inside(self, crown: Array) -> bool:
        return bool(self.box.contains(logs(crown[None]))[0])


@dataclass(frozen=True, eq=False)
class Worst:
    """Objective by kriging, as a function of crowns in the coordinates of kriging."""

    search: Search
    worth: Worth

    def predict(self, x: Array) -> Array:
        return self.worth(self.search.worst(crowns_of(x)))


def rounded(task: Task, crown: Array) -> Array:
    """`crown` rounded to four digits, limited to the ranges."""
    step = 10.0 ** (np.floor(np.log10(crown)) - DIGITS + 1)
    return np.asarray(np.clip(np.round(crown / step) * step, task.low, task.high))


def _box(low: Array, high: Array) -> Box:
    ends = logs(np.vstack([low, high]))
    return Box(tuple(map(float, ends[0])), tuple(map(float, ends[1])))
