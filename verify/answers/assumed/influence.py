"""Influence of assumed inputs: each input is varied, and the formulas are evaluated again."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verify.answers.assumed.registry import ASSUMPTIONS, assumption_of
from verify.answers.assumed.rules import Assumed, Assumption, Given
from verify.answers.assumed.values import si_value
from verify.core import units
from verify.core.case import Case, Values
from verify.core.inputs import Inputs, is_table, kind_of

STEP = 0.1  # of the value, where no usual range is stated
UNCHANGED = 1e-9  # relative change of a value that an input does not enter
NO_SOLUTION = "no solution"
Result = Callable[[Any, Values], float | None]


@dataclass(frozen=True, kw_only=True)
class Influence:
    """Change of a result of the formulas if one assumed input is changed.

    `low` and `high` are the values used for the input, in its display unit; `at_low` and `at_high`
    are the relative changes of the result. A change is None if the formulas have no solution;
    `note` then states this.
    """

    assumed: Assumed
    low: float
    high: float
    at_low: float | None
    at_high: float | None
    note: str = ""

    @property
    def largest(self) -> float:
        """The larger of the magnitudes of `at_low` and `at_high`.

        It is infinite if the formulas have no solution at `low` or `high`.
        """
        if self.at_low is None or self.at_high is None:
            return float("inf")
        return max(abs(self.at_low), abs(self.at_high))

    @property
    def matters(self) -> bool:
        """Whether the result changes with the input."""
        return self.largest > UNCHANGED


def influence(
    case: Case, inputs: Inputs, assumed: Sequence[Assumed], result: str | Result
) -> tuple[Influence, ...]:
    """Influences of all assumed numbers on a result of the formulas, sorted by decreasing change.

    `result` is the key of a value, or a function that computes a number from inputs and values.
    Each input is varied alone over its usual range, or by 10 %. Assumed inputs that are derived
    from the varied input by a rule change with it. Texts, tables, and inputs that only --dynamic
    uses, are omitted. Raises ValueError if the formulas have no result at the given inputs.
    """
    of = result if callable(result) else _by_key(result)
    middle = _value(case, inputs, of)
    if middle is None:
        raise ValueError(f"case {case.id}: the formulas give no value {result} with these inputs")
    study = _Study(case, inputs, tuple(one.name for one in assumed), of, middle)
    found = [study.of(one) for one in assumed if _is_varied(case, one)]
    return tuple(sorted(found, key=lambda one: one.largest, reverse=True))


def _is_varied(case: Case, one: Assumed) -> bool:
    field, about = case.inputs.model_fields[one.name], assumption_of(case.id, one.name)
    numeric = not is_table(field) and kind_of(field) in (int, float)
    return numeric and about.varied and not about.dynamic


@dataclass(frozen=True)
class _Study:
    """Variation of the assumed inputs `names` of a case; `middle` is the result at `inputs`."""

    case: Case
    inputs: Inputs
    names: tuple[str, ...]
    of_result: Result
    middle: float

    def of(self, one: Assumed) -> Influence:
        ends = self._range(one)
        factor = units.factor(one.unit)
        low, high = (self._change(one.name, end) for end in ends)
        return Influence(
            assumed=one, low=ends[0] / factor, high=ends[1] / factor, at_low=low, at_high=high,
            note=NO_SOLUTION if None in (low, high) else "",
        )  # fmt: skip

    def _range(self, one: Assumed) -> tuple[float, float]:
        """Lowest and highest value [SI] to which an assumed input is changed."""
        model, value = self.case.inputs, getattr(self.inputs, one.name)
        about = assumption_of(self.case.id, one.name)
        if about.usual is not None:
            low, high = (si_value(model, about, end, self._given()) for end in about.usual)
            return low, high
        if kind_of(model.model_fields[one.name]) is int:
            step = max(1, round(STEP * value))
            return value - step, value + step
        return (1 - STEP) * value, (1 + STEP) * value

    def _derived(self, name: str) -> list[Assumption]:
        """Assumptions for numbers that rules compute, except `name`, in the order of evaluation."""
        fields = self.case.inputs.model_fields
        return [
            one for one in ASSUMPTIONS[self.case.id]
            if one.name in self.names and one.name != name
            and callable(one.value) and one.varied and not is_table(fields[one.name])
        ]  # fmt: skip

    def _given(self) -> Given:
        return Given({name: getattr(self.inputs, name) for name in type(self.inputs).model_fields})

    def _change(self, name: str, value: float) -> float | None:
        """Relative change of the result for one changed input.

        None if the formulas have no solution.
        """
        given = Given(self._given() | {name: value})
        try:
            for one in self._derived(name):
                given[one.name] = si_value(self.case.inputs, one, one.value, given)
            found = _value(self.case, type(self.inputs)(**given), self.of_result)
        except (ValueError, ArithmeticError):
            return None
        return None if found is None else _relative(found, self.middle)


def _relative(value: float, middle: float) -> float:
    if middle == 0:
        return 0.0 if value == 0 else float("inf")
    return (value - middle) / abs(middle)


def _by_key(key: str) -> Result:
    def value(_inputs: Any, values: Values) -> float | None:
        return values.get(key)

    return value


def _value(case: Case, inputs: Inputs, of: Result) -> float | None:
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        found = of(inputs, case.analytic(inputs))
    return None if found is None or not np.isfinite(found) else float(found)
