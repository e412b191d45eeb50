"""The permissible torque of a clutch: the largest torque at which every criterion is met."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from verify.answers.answer import Answer, Quantity
from verify.answers.assessment import Assessment
from verify.core.case import Values

TORQUE_TOLERANCE = 1e-5  # relative
SEARCHED = (0.95, 0.9, 0.8, 0.7, 0.5, 0.3, 0.1, 0.03)  # shares of a limit


class Limit(Protocol):
    """Description of a limit, and the torque [N m] at which it is reached."""

    @property
    def at(self) -> float: ...

    @property
    def words(self) -> str: ...


@dataclass(frozen=True)
class Reached:
    """Description of a criterion, and the torque [N m] at which it reaches its limit."""

    at: float
    words: str


def criteria_under(
    q: Any, analytic: Callable[[Any], Values], assess: Callable[[Any, Values, Assessment], None]
) -> Callable[[float], Answer]:
    """Function of a torque [N m] that returns the answer for the part `q` under this torque."""

    def under(T: float) -> Answer:
        other = q.model_copy(update={"T": T})
        part = Assessment(with_design=False)
        assess(other, analytic(other), part)
        return part.answer()

    return under


def permissible(
    limits: Sequence[Limit], T: float, condition: str, under: Callable[[float], Answer]
) -> Quantity | None:
    """Largest torque at which all criteria are met; None if there is none.

    `condition` follows the words "permissible torque" in the description of the result. `limits`
    are the limits that the formulas give, sorted by torque. `T` [N m] is the torque of the part.
    `under` gives the criteria of the part at another torque [N m].
    """
    if not limits:
        return None
    largest = _first(limits[0], under)
    if largest is None:
        return None
    known = ", of the criteria whose limits are known" if under(largest.at).unknowns else ""
    times = f", {largest.at / T:.3g} times T" if T > 0 else ""
    what = f"permissible torque{condition}{times}{known}; beyond it {largest.words}"
    return Quantity(key="permissible_torque", symbol="T_max", value=largest.at, unit="N m",
                    what=what)  # fmt: skip


def _first(limit: Limit, under: Callable[[float], Answer]) -> Limit | None:
    """The limit of the formulas, or a criterion that reaches its limit at a smaller torque."""
    if _excess(under(limit.at * (1 - TORQUE_TOLERANCE))) >= -TORQUE_TOLERANCE:
        return limit
    high = limit.at
    for share in SEARCHED:
        low = share * limit.at
        if _excess(under(low)) >= 0:
            break
        high = low
    else:
        return None
    from scipy.optimize import brentq  # half of the time of a check that needs none

    at = float(brentq(lambda T: _excess(under(T)), low, high, rtol=TORQUE_TOLERANCE))
    worst = under(low + (at - low) * (1 - TORQUE_TOLERANCE)).limiting
    assert worst is not None
    return Reached(
        at, f"the {worst.what} {'is below its minimum' if worst.minimum else 'exceeds its limit'}"
    )


def _excess(answer: Answer) -> float:
    """Smallest margin minus 1; -1 if the part fails for a reason other than a criterion."""
    if answer.failures:
        return -1.0
    return min(c.margin for c in answer.criteria) - 1
