"""Invalid boxes, designs, surrogates and searches are refused."""

import re

import numpy as np
import pytest

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from analytic.surrogate.gate import left_level_out, quality
from analytic.surrogate.genetic import genetic
from analytic.surrogate.infill import infill
from analytic.surrogate.kriging import fit
from analytic.surrogate.largest import fit_largest

BOX = Box((1.0, 0.4), (5.0, 0.7))
X = random_designs(BOX, 30, 1)
ONES = np.ones(30)


def smooth(x):
    return np.asarray(1 + x[:, 0] + x[:, 1] ** 2)


def filled(**options):
    return infill(None, smooth, X, box=BOX, search=evolve, value=float, **options)


REFUSED = [
    (lambda: Box((2.0,), (1.0,)), "less than the high one, got 2.0 and 1.0"),
    (
        lambda: Box((0.0, 0.0), (1.0,)),
        "as many low bounds as high bounds, at least one, got 2 and 1",
    ),
    (lambda: BOX.to_unit(np.ones((1, 3))), "points must have the shape (n, 2), got (1, 3)"),
    (lambda: full_factorial(BOX, 1), "at least 2 levels, got 1"),
    (lambda: fit(X[:7], ONES[:7], BOX), "a quadratic trend requires at least 8 designs, got 7"),
    (lambda: fit(np.vstack([X, X[4]]), np.ones(31), BOX), "designs 4 and 30 are the same point, ["),
    (lambda: fit(np.where([True, False], X, 0.5), smooth(X), BOX), "do not determine a quadratic"),
    (lambda: fit_largest(X, [], BOX), "at least one regime must be given"),
    (lambda: fit_largest(X, [ONES, -ONES], BOX), "must not be negative, got -1.0"),
    (lambda: fit_largest(X, [ONES, ONES], BOX, present=[ONES > 0]), "got 2 regimes and 1 entries"),
    (lambda: fit_largest(X, [ONES], BOX, power=0.0), "power must be positive and finite, got 0.0"),
    (lambda: quality(ONES, ONES[:3]), "and not be empty, got (30,), (3,)"),
    (lambda: quality(ONES, 0 * ONES), "true values must not be 0"),
    (lambda: left_level_out(fit(X, smooth(X), BOX), X[:2], ONES[:2]), "at least 3 levels"),
    (lambda: filled(answers=list(ONES), rounds=0), "in_a_row must lie between 1 and the number"),
    (lambda: filled(answers=[1.0]), "got 1 values and 30 designs"),
    (lambda: genetic(smooth, BOX, population=5), "even and at least 2, got 5"),
    (lambda: genetic(smooth, BOX, crossover=1.1), "crossover must lie in [0, 1], got 1.1"),
]


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_what_makes_no_sense_is_refused_in_words(call, message):
    with pytest.raises(ValueError, match=re.escape(message)):
        call()


@pytest.mark.parametrize("search", [genetic, evolve])
def test_an_objective_that_is_not_finite_is_named(search):
    with pytest.raises(ArithmeticError, match="the objective must be finite; it is not at"):
        search(lambda x: np.where(x[:, 0] > 4, np.nan, 1.0), BOX)


def test_evolution_that_does_not_converge_is_reported():
    rng = np.random.default_rng(6)
    with pytest.raises(ArithmeticError, match="differential evolution did not converge"):
        evolve(lambda x: rng.random(len(x)) - 0.5, BOX)
