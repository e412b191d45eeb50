"""Test if a surrogate is accurate enough for a search.

If the model has a kink, leaving out one design of a factorial at a time is not a sufficient test,
because neighbours at the same level of the other parameters also contain the kink. Leaving out a
whole level is better and needs no new value of the model. The table gives results for the largest
pressure between sprag and race over three profile parameters (mean/largest relative error in %,
from 5^3 designs; "true": error at 200 additional random points):

    surrogate                     torque   true       one left out   level left out
    one process, with the kinks   25 N m   0.67/3.2   0.010/0.07     0.90/3.7
    one process, with the kinks   40 N m   0.48/2.3   0.025/0.20     0.99/6.6
    two regimes, squares kriged   25 N m   0.12/1.1   0.008/0.04     0.29/1.5
    two regimes, squares kriged   40 N m   0.12/0.65  0.013/0.10     0.31/2.4

With one design left out, the mean error is too small by a factor of 9 to 70, and the ranking of the
first two rows is wrong (25 N m seems better, although it is worse). With a level left out, the mean
error is too large by a factor of 1.3 to 2.7, because the spacing is doubled. Ten random points are
too few: with the default limits of `gate`, the first row passes in one of five samples (with twenty
points, in one of ten), the last two rows always.

A surrogate is therefore tested twice: with a level left out, before any new evaluation, and on at
least twenty new random points. Errors with one design left out are only used to find the design
that does not fit.
"""

from dataclasses import dataclass
from typing import Protocol, Self

import numpy as np

from analytic.contact.checks import Array


class PoorSurrogateError(ArithmeticError):
    """Raised if the difference between surrogate and model exceeds the permissible limits."""


class Surrogate(Protocol):
    """Surrogate that can also predict without some of its designs."""

    def predict(self, x: Array) -> Array: ...

    def without(self, x: Array) -> Self: ...


@dataclass(frozen=True, kw_only=True)
class Quality:
    """Mean and largest value of |predicted/true - 1| over `count` points."""

    mean: float
    largest: float
    count: int

    @classmethod
    def of(cls, errors: Array) -> "Quality":
        """Statistics of relative errors (n,).

        Raises ValueError if no error is given or an error is not finite.
        """
        errors = np.abs(np.asarray(errors, np.float64))
        if not errors.size or not np.all(np.isfinite(errors)):
            raise ValueError(
                f"at least one error must be given, and all must be finite, got {errors}"
            )
        return cls(mean=float(errors.mean()), largest=float(errors.max()), count=errors.size)


def quality(predicted: Array, true: Array) -> Quality:
    """Mean and largest relative error of predicted values (n,).

    Raises ValueError unless both arrays are finite, non-empty and of the same shape, and no true
    value is 0.
    """
    predicted, true = np.asarray(predicted, np.float64), np.asarray(true, np.float64)
    if predicted.shape != true.shape or not true.size:
        raise ValueError(
            "predicted and true values must have the same shape and not be empty, got "
            f"{predicted.shape}, {true.shape}"
        )
    if not np.all(np.isfinite(predicted) & np.isfinite(true) & (true != 0)):
        raise ValueError("predicted and true values must be finite, and true values must not be 0")
    return Quality.of(predicted / true - 1)


def gate(quality: Quality, *, mean: float = 0.005, largest: float = 0.03, what: str) -> None:
    """Raise PoorSurrogateError unless mean and largest relative error are within their limits."""
    if not (quality.mean <= mean and quality.largest <= largest):
        raise PoorSurrogateError(
            f"the errors of the surrogate of {what} at {quality.count} points are too large: mean "
            f"{quality.mean:.2%}, largest {quality.largest:.2%}; permissible are {mean:.2%} and "
            f"{largest:.2%}"
        )


def left_level_out(model: Surrogate, x: Array, true: Array) -> Array:
    """Relative errors (m,) of predictions if a whole level of one parameter is left out.

    x (n, d) are the designs of a full factorial, true (n,) their values. Every inner level of every
    parameter is left out in turn, at constant length scales, and predicted from the other levels.
    The errors are ordered by parameter, level and design. Raises ValueError if no parameter has an
    inner level.
    """
    errors = []
    for column in x.T:
        for level in np.unique(column)[1:-1]:
            out = column == level
            errors.append(model.without(x[out]).predict(x[out]) / true[out] - 1)
    if not errors:
        raise ValueError(
            "a parameter must have at least 3 levels, so that an inner level can be left out"
        )
    return np.concatenate(errors)
