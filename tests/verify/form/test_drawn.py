"""What a case draws: a part of an array along a line, room for labels."""

import numpy as np
import pytest

from verify.case import AlongLine, Case, converged, drawn_by, given, sketches, solved
from verify.core.case import Context
from verify.form.adapter import adapted
from verify.form.plots import dashes, dots, line, plot

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


def test_labels_have_room_on_both_sides():
    drawn = sketches.sketch("Ring", sketches.ring(1.0, 2.0), sketches.room(3.0, 5.0))
    x = np.concatenate([shape.points[:, 0] for shape in drawn.shapes])
    assert (x.min(), x.max()) == (-3.0, 5.0)
    assert [shape.label for shape in drawn.shapes if shape.style == "text"] == ["", ""]


def test_one_function_draws_all_figures_of_a_case_from_all_results():
    class Drawing(Lines):
        figures = drawn_by(lambda context: [context.case, len(context.fem)])

    found = adapted(Drawing).figures(Context("drawing", Drawing(), {}, [], True))
    assert found == ("drawing", 0)


def test_a_number_in_a_curve_stands_for_all_points():
    level, upright = dashes("p_lim", [0.0, 3.0], 7.0), dashes("T", 2.0, [0.0, 1.0], 4)
    assert level.y.tolist() == [7.0, 7.0]
    assert upright.x.tolist() == [2.0, 2.0]
    assert (upright.colour, upright.style) == (4, "dashes")
    assert dots("T", 2.0, 1.0).x.shape == (1,)


def test_a_plot_takes_curves_and_groups_of_them_in_their_order():
    x = np.linspace(0, 1, 3)
    groups = (line(name, x, x) for name in "bc")
    drawn = plot("N(t)", "t [s]", "N [N]", line("a", x, x), groups, y_bottom=0.0)
    assert [curve.name for curve in drawn.curves] == ["a", "b", "c"]
    assert (drawn.y_label, drawn.y_bottom) == ("N [N]", 0.0)


def test_texts_and_outlines_of_a_sketch_are_points_with_their_style():
    label, outline = sketches.text((1.0, 2.0), "A"), sketches.shape("body", [[0, 0], [1, 1]])
    assert (label.style, label.points.tolist(), label.label) == ("text", [[1.0, 2.0]], "A")
    assert (outline.style, outline.points.shape) == ("body", (2, 2))


@pytest.mark.parametrize("levels", [2, 3])
def test_what_needs_an_uncertainty_is_drawn_from_three_levels_on(levels):
    fem = [solved(1 / level) for level in range(1, 1 + levels)]
    found = converged(lambda context: len(context.fem)).drawn(Context("", Lines(), {}, fem, True))
    assert found == ((3,) if levels == 3 else ())
