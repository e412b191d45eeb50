"""What a case draws: a part of an array along a line, room for labels."""

import numpy as np
import pytest

from verify.case import AlongLine, Case, converged, given, solved
from verify.core.case import Context
from verify.form.adapter import adapted
from verify.form.plots import dashes, dots

STATIONS = np.linspace(0.0, 1e-3, 5)


class Lines(Case):
    """Two lines, one after the other in one array."""

    title = "Lines"
    source = "belcin"

    p: float = given("2 MPa", "MPa", "p", "pressure at the end of the first line")

    def along_first(self, x):
        return self.p * x / STATIONS[-1]

    def reference(self, level):
        first = self.along_first(STATIONS) * (1 + 1e-3 / level**2)
        return solved(1 / level, both=np.concatenate([first, 10 * first]))

    def figures(self):
        for part, factor in (((None, 5), 1.0), ((5, None), 10.0)):
            yield AlongLine(
                title="Pressure", x=("x", "mm"), y=("p", "MPa"), at=STATIONS, order=2, part=part,
                curve=lambda x, factor=factor: factor * self.along_first(x), reference="both",
                scale=self.p,
            )  # fmt: skip


def profiles(levels):
    case, q = adapted(Lines), Lines()
    solutions = [case.reference(q, level) for level in case.levels[:levels]]
    return case.figures(Context(case.id, q, {}, solutions, True))


def test_a_line_takes_its_part_of_an_array_that_has_several():
    first, second = profiles(4)
    assert first.y_fem[-1] == pytest.approx(2 * (1 + 1e-3 / 16))
    assert second.y_fem == pytest.approx(10 * first.y_fem)
    assert first.y_ref == pytest.approx(first.y_fem, rel=1e-3)
    assert second.y_ref == pytest.approx(second.y_fem, rel=1e-3)
    assert len(first.x_fem) == len(first.y_fem) == len(first.u) == len(STATIONS)


def test_a_line_without_levels_enough_for_its_uncertainty_is_not_drawn():
    assert profiles(2) == ()


def test_a_number_in_a_curve_stands_for_all_points():
    level, upright = dashes("p_lim", [0.0, 3.0], 7.0), dashes("T", 2.0, [0.0, 1.0], 4)
    assert level.y.tolist() == [7.0, 7.0]
    assert upright.x.tolist() == [2.0, 2.0]
    assert (upright.colour, upright.style) == (4, "dashes")
    assert dots("T", 2.0, 1.0).x.shape == (1,)


@pytest.mark.parametrize("levels", [2, 3])
def test_what_needs_an_uncertainty_is_drawn_from_three_levels_on(levels):
    fem = [solved(1 / level) for level in range(1, 1 + levels)]
    found = converged(lambda context: len(context.fem)).drawn(Context("", Lines(), {}, fem, True))
    assert found == ((3,) if levels == 3 else ())
