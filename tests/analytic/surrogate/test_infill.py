from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial
from analytic.surrogate.evolution import evolve
from analytic.surrogate.found import Found
from analytic.surrogate.infill import Infilled, NoAgreementError, infill
from analytic.surrogate.kriging import Kriging, fit

Array = NDArray[np.float64]
BOX = Box((0.0, 10.0), (1.0, 20.0))
X = full_factorial(BOX, 4)


@dataclass(frozen=True)
class Answer:
    value: float
    x: Array


def kinked(x: Array) -> Answer:
    """The largest of three planes, smallest 1 at (0.55, 14)."""
    u, v = x[0] - 0.55, (x[1] - 14) / 10
    return Answer(1 + max(2 * u + v, -u + v, -v), x)


def number(answer: Answer) -> float:
    return answer.value


def kriged(x: Array, answers: Sequence[Answer]) -> Kriging:
    return fit(x, np.array([number(answer) for answer in answers]), BOX)


@pytest.fixture(scope="module")
def filled() -> Infilled[Answer, Kriging]:
    x = full_factorial(BOX, 6)
    return infill(kriged, kinked, x, box=BOX, search=evolve, value=number)


def test_a_kink_first_missed_is_met_within_three_per_cent(
    filled: Infilled[Answer, Kriging],
) -> None:
    first, *_, last = filled.history
    assert first.error > 0.03
    assert last.error <= 0.005
    assert 2 < len(filled.history) < 20
    assert first.predicted > 1.05
    assert 1 <= filled.true < 1.03


class Flat:
    """A surrogate that is 1 everywhere."""

    def predict(self, x: Array) -> Array:
        return np.ones(len(x))


def played(points: list[tuple[float, float]], values: dict[float, float], **options: Any) -> Any:
    """Infill of `Flat` where the search names `points` and the model has `values` by x_1."""
    todo = iter(points)

    def search(objective: Any, box: Box) -> Found:
        x = np.array(next(todo))
        return Found(x, float(objective(x[None])[0]), 1, np.ones(1))

    return infill(
        lambda x, answers: Flat(),
        lambda x: values.get(float(x[0]), 9.0),
        X,
        box=BOX,
        search=search,
        value=float,
        **options,
    )


def test_no_agreement_on_a_design_or_in_the_given_rounds_is_reported() -> None:
    with pytest.raises(NoAgreementError, match=r"surrogate has 1, the model 9 at"):
        played([(0.1, 15.0), (0.2, 15.0)], {}, rounds=2)
    with pytest.raises(ArithmeticError, match=r"at the existing design .* has 1 and .*") as own:
        played([(1.0, 20.0)], {})
    assert not isinstance(own.value, NoAgreementError)
    with pytest.raises(
        ArithmeticError, match=r"must return finite values, got inf at \[ *0.1 +15"
    ) as own:
        played([(0.1, 15.0)], {0.1: np.inf})
    assert not isinstance(own.value, NoAgreementError)
