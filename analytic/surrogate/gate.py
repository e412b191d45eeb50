"""Whether a surrogate is good enough to be searched."""

from dataclasses import dataclass
from typing import Protocol, Self

import numpy as np

from analytic.contact.checks import Array


class PoorSurrogateError(ArithmeticError):
    """A surrogate misses the model by more than its use allows."""


class Surrogate(Protocol):
    """What can predict, and can be had without some of its designs."""

    def predict(self, x: Array) -> Array: ...

    def without(self, x: Array) -> Self: ...


@dataclass(frozen=True, kw_only=True)
class Quality:
    """Mean and largest of |predicted/true - 1| over `count` points."""

    mean: float
    largest: float
    count: int


def quality(predicted: Array, true: Array) -> Quality:
    """Relative errors of predicted values (n,) in two numbers.

    ValueError unless both are finite, of one shape and at least one, and no true value is 0.
    """
    predicted, true = np.asarray(predicted, np.float64), np.asarray(true, np.float64)
    if predicted.shape != true.shape or not true.size:
        raise ValueError(f"as many predicted values as true, got {predicted.shape}, {true.shape}")
    if not np.all(np.isfinite(predicted) & np.isfinite(true) & (true != 0)):
        raise ValueError("relative errors need finite values, and true ones other than 0")
    error = np.abs(predicted / true - 1)
    return Quality(mean=float(error.mean()), largest=float(error.max()), count=error.size)


def gate(quality: Quality, *, mean: float = 0.005, largest: float = 0.03, what: str) -> None:
    """PoorSurrogateError unless mean and largest relative error are within their limits."""
    if not (quality.mean <= mean and quality.largest <= largest):
        raise PoorSurrogateError(
            f"surrogate of {what} misses {quality.count} points by {quality.mean:.2%} in the mean "
            f"and {quality.largest:.2%} at most; allowed are {mean:.2%} and {largest:.2%}"
        )


def left_level_out(model: Surrogate, x: Array, true: Array) -> Array:
    """Relative errors (m,) where a whole level of one parameter is left out of a factorial.

    x (n, d) are the factorial's designs, true (n,) their values. Every inner level of every
    parameter is left out in turn, length scales kept, and predicted by what remains; errors follow
    each other by parameter, level and design. ValueError if no parameter has an inner level.
    """
    errors = []
    for column in x.T:
        for level in np.unique(column)[1:-1]:
            out = column == level
            errors.append(model.without(x[out]).predict(x[out]) / true[out] - 1)
    if not errors:
        raise ValueError("a level can be left out only between others: give at least 3")
    return np.concatenate(errors)
