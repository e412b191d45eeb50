"""Surrogate that is refined during the search: the minimum of the surrogate is the next design."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.found import Found, Objective


class NoAgreementError(ArithmeticError):
    """Raised if surrogate and true model still differ after all rounds."""


class Predicts(Protocol):
    """Model that returns values (n,) at points (n, d)."""

    def predict(self, x: Array) -> Array: ...


A = TypeVar("A")  # value of the true model
S = TypeVar("S", bound=Predicts)
SAME = 1e-9  # distance in the unit cube of two points that are one design


@dataclass(frozen=True, eq=False)
class Round:
    """Minimum of the surrogate in one round, and the true value there."""

    x: Array  # (d,)
    predicted: float
    true: float
    on_design: bool  # whether x already was a design, so that agreement is only by interpolation

    @property
    def error(self) -> float:
        """Relative error |true/predicted - 1|; infinite if the prediction is 0."""
        return abs(self.true / self.predicted - 1) if self.predicted else np.inf


@dataclass(frozen=True, eq=False, kw_only=True)
class Infilled(Generic[A, S]):
    """Last surrogate, all values of the true model, and the smallest of them."""

    surrogate: S  # fitted on every design but the last round's, which it was found to agree with
    designs: Array  # (n, d), those given first
    answers: tuple[A, ...]  # (n,)
    x: Array  # (d,) the design of smallest true value
    predicted: float  # of the last surrogate there
    true: float
    history: tuple[Round, ...]
    best_is_last: bool  # whether x is the last round's


def infill(
    fit: Callable[[Array, Sequence[A]], S],
    true: Callable[[Array], A],
    x: Array,
    *,
    box: Box,
    search: Callable[[Objective, Box], Found],
    value: Callable[[A], float],
    answers: Sequence[A] | None = None,
    agree: float = 0.005,
    in_a_row: int = 1,
    rounds: int = 20,
) -> Infilled[A, S]:
    """Fit a surrogate, find its minimum and evaluate the model there, until both values agree.

    The rounds end when surrogate and model agree: |true/predicted - 1| <= agree in `in_a_row`
    successive rounds. `answers` are the results of the true model at x (n, d); if they are not
    given, they are computed. `value` returns the number to be minimised from one result. If the
    minimum is at an existing design, this design is evaluated again. A deterministic model then
    returns the same value, which an interpolating surrogate reproduces; otherwise, ArithmeticError
    is raised. Raises ArithmeticError also for a value that is not finite, and NoAgreementError (an
    ArithmeticError) after `rounds` without agreement.

    Agreement is local. It shows that the surrogate is correct at its minimum, but not that no other
    point has a smaller value. Example: one Gaussian process was fitted to the largest of three
    planes, for four positions of the kink. With 6 x 6 designs, the agreed value was on average 2.0
    % above the minimum, and 0.5 % above it with `in_a_row` = 3. With 4 x 4 designs, these values
    were 4.5 % and 1.9 %. `Largest` has no kink to approximate and agrees at the minimum. `gate`
    detects other errors of a surrogate.
    """
    x = box.points(x)
    known = [true(point) for point in x] if answers is None else list(answers)
    if len(known) != len(x):
        raise ValueError(
            f"there must be one value per design, got {len(known)} values and {len(x)} designs"
        )
    if not 1 <= in_a_row <= rounds:
        raise ValueError(
            f"in_a_row must lie between 1 and the number of rounds, got {in_a_row} of {rounds}"
        )
    history: list[Round] = []
    agreed = 0
    while len(history) < rounds:
        surrogate = fit(x, known)
        found = search(surrogate.predict, box)
        answer = true(found.x)
        on_design = bool(np.any(_distance(x, found.x, box) < SAME))
        this = Round(found.x, found.value, value(answer), on_design)
        if not np.isfinite(this.true):
            raise ArithmeticError(
                f"the true model must return finite values, got {this.true} at {this.x}"
            )
        if on_design and this.error > agree:
            raise ArithmeticError(
                f"at the existing design {this.x}, the surrogate has {this.predicted:.6g} and the "
                f"true model now returns {this.true:.6g}: both must give the value stored for it"
            )
        history.append(this)
        if not on_design:
            x, known = np.vstack([x, found.x]), [*known, answer]
        agreed = agreed + 1 if this.error <= agree else 0
        if agreed == in_a_row or (agreed and on_design):
            return _best(surrogate, x, known, value, history, box)
    raise NoAgreementError(
        f"surrogate and true model do not agree within {agree:.2%} after {rounds} rounds: in the "
        f"last round, the surrogate has {this.predicted:.6g}, the model {this.true:.6g} at {this.x}"
    )


def _best(
    surrogate: S,
    x: Array,
    answers: list[A],
    value: Callable[[A], float],
    history: list[Round],
    box: Box,
) -> Infilled[A, S]:
    values = np.array([value(answer) for answer in answers])
    best = int(values.argmin())
    return Infilled(
        surrogate=surrogate,
        designs=x,
        answers=tuple(answers),
        x=x[best],
        predicted=float(surrogate.predict(x[best : best + 1])[0]),
        true=float(values[best]),
        history=tuple(history),
        best_is_last=bool(_distance(x[best : best + 1], history[-1].x, box)[0] < SAME),
    )


def _distance(x: Array, point: Array, box: Box) -> Array:
    return np.asarray(np.linalg.norm(box.to_unit(x) - box.to_unit(point[None]), axis=1))
