"""Numbers of a reference that ignores the level fail their rows, and no others."""

from dataclasses import replace
from pathlib import Path
from typing import ClassVar

import pytest

from verify.case import Case, Quantity, given, identity, solved
from verify.core.results import Grid, Status
from verify.form.adapter import adapted
from verify.jobs.level import INDEPENDENT, Job, is_constant, judge_case, solve_level


class Bars(Case):
    """Two numbers, whose reference converges to them; a count, and a number that is zero."""

    title = "Bars"
    source = "a textbook"

    L: float = given("1 m", "m", "L", "length")
    error: ClassVar = 1e-4  # of the length at level 1, relative
    round_off: ClassVar = {}  # of numbers by name, relative

    @Quantity("x", "m", "length")
    def x(self) -> float:
        return self.L

    @Quantity("A", "m^2", "area")
    def area(self) -> float:
        return 0.3 * self.L * self.L

    @Quantity("n", "1", "number of bars")
    def n(self) -> float:
        return 12.0

    @Quantity("z", "m", "eccentricity")
    def z(self) -> float:
        return 0.0 * self.L

    def reference(self, level):
        x = self.L * (1 + self.error / level**2)
        return solved(1 / level, x=x, area=0.3 * self.L**2, n=12, z=0, iteration=self.round_off)

    def comparisons(self):
        yield identity(Bars.x, order=2)
        yield identity(Bars.area, order=2)
        yield identity(Bars.n, order=2)
        yield identity(Bars.z, order=2, scale={"length": self.L})


def without_level(form, file):
    """The quantities whose rows fail because the reference does not depend on the level."""
    case = replace(adapted(form, time_limit=60.0), file=file)
    inputs = case.inputs()
    levels = [solve_level(case, inputs, level, None) for level in case.levels]
    rows = judge_case(Job(case, inputs), levels).rows
    assert {row.status for row in rows if row.reason != INDEPENDENT} <= {Status.PASS}
    return [row.quantity for row in rows if row.reason == INDEPENDENT]


class Exact(Bars):
    """The area is exact, and its uncertainty is round-off."""

    round_off: ClassVar = {"area": 1e-12}


class Same(Bars):
    """No number depends on the level."""

    error: ClassVar = 0.0


ALL = ["length", "area", "number of bars", "eccentricity"]


@pytest.mark.parametrize(
    ("form", "file", "ignored"),
    [(Bars, Path("bars.py"), ["area"]), (Exact, Path("bars.py"), []), (Same, Path("bars.py"), ALL),
     (Bars, None, []), (Same, None, ALL)],
)  # fmt: skip
def test_rows_of_numbers_that_ignore_the_level_fail(form, file, ignored):
    found = without_level(form, file)
    assert found == [each for name in ignored for each in (name, f"{name}: convergence")]


@pytest.mark.parametrize(
    ("values", "unit", "constant"),
    [([1.5, 1.5, 1.5], "1", True), ([200.0, 200.0], "MPa", True), ([1.5], "1", False),
     ([12.0, 12.0], "1", False), ([0.0, 0.0], "mm", False), ([1.5, 1.5000001], "1", False)],
)  # fmt: skip
def test_one_value_on_all_levels_is_constant_unless_it_is_a_count_or_zero(values, unit, constant):
    levels = tuple((1 / (n + 1), value) for n, value in enumerate(values))
    grid = Grid(
        unit=unit, levels=levels, scale=1.0, allowed=1.0, behaviour="round-off", gci=0.0, u_it=0.0
    )
    assert is_constant(grid) is constant
