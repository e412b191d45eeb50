"""A surrogate refined during its search: its minimum becomes the next design."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.found import Found, Objective


class NoAgreementError(ArithmeticError):
    """Surrogate and true model still differ after all rounds; all values were found."""


class Predicts(Protocol):
    """A model: points (n, d) to values (n,)."""

    def predict(self, x: Array) -> Array: ...


A = TypeVar("A")  # value of the true model
S = TypeVar("S", bound=Predicts)
SAME = 1e-9  # distance in the unit cube of two points that are one design


@dataclass(frozen=True, eq=False)
class Round:
    """The surrogate's smallest value and the true model's there."""

    x: Array  # (d,)
    predicted: float
    true: float
    on_design: bool  # whether x already was a design, so that agreement is only by interpolation

    @property
    def error(self) -> float:
        """|true/predicted - 1|, unlimited for a prediction of 0."""
        return abs(self.true / self.predicted - 1) if self.predicted else np.inf


@dataclass(frozen=True, eq=False, kw_only=True)
class Infilled(Generic[A, S]):
    """The last surrogate, all values of the true model, and the best of them."""

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
    """Fit, search the smallest value of the surrogate, evaluate the model there, until both agree.

    `answers` are the values of the true model at x (n, d), computed if not given; `value` selects
    the number from one of them. Agreement means |true/predicted - 1| <= agree in `in_a_row`
    successive rounds. If the smallest value is at an existing design, the design is evaluated
    again: a model that is a function returns the same value, and a surrogate that interpolates
    agrees. ArithmeticError if it does not, or for a value that is not finite; NoAgreementError (an
    ArithmeticError) after `rounds` without agreement.

    Agreement is local. It shows that the surrogate is correct at its smallest value, but not that
    no other point has a smaller value. One process over the largest of three planes, four positions
    of the kink, 6 x 6 designs, agreed on average 2.0 % above the smallest value, after three rounds
    `in_a_row` 0.5 %; with 4 x 4 designs 4.5 % and 1.9 %. `Largest` has no kink to approximate and
    agrees on the smallest value. `gate` finds other errors of a surrogate.
    """
    x = box.points(x)
    known = [true(point) for point in x] if answers is None else list(answers)
    if len(known) != len(x):
        raise ValueError(f"there must be as many values as designs, got {len(known)} and {len(x)}")
    if not 1 <= in_a_row <= rounds:
        raise ValueError(f"in_a_row must lie between 1 and rounds, got {in_a_row} of {rounds}")
    history: list[Round] = []
    agreed = 0
    while len(history) < rounds:
        surrogate = fit(x, known)
        found = search(surrogate.predict, box)
        answer = true(found.x)
        on_design = bool(np.any(_distance(x, found.x, box) < SAME))
        this = Round(found.x, found.value, value(answer), on_design)
        if not np.isfinite(this.true):
            raise ArithmeticError(f"the true model gives {this.true} at {this.x}")
        if on_design and this.error > agree:
            raise ArithmeticError(
                f"on a design already there, {this.x}, the surrogate has {this.predicted:.6g} and "
                f"the true model now {this.true:.6g}: one of the two does not repeat its values"
            )
        history.append(this)
        if not on_design:
            x, known = np.vstack([x, found.x]), [*known, answer]
        agreed = agreed + 1 if this.error <= agree else 0
        if agreed == in_a_row or (agreed and on_design):
            return _best(surrogate, x, known, value, history, box)
    raise NoAgreementError(
        f"surrogate and true model do not agree within {agree:.2%} after {rounds} rounds: the last "
        f"has {this.predicted:.6g} for {this.true:.6g} at {this.x}"
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
