"""Bodies that the page displays in space: positions, values, edges, and the figure made of them."""

import base64
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.verify.page.answered import RING, quietly
from verify.app.page import tasks
from verify.app.page.described import describe
from verify.app.page.shape_figure import VIEWS, camera, figure
from verify.app.page.shape_view import about
from verify.app.page.shapes import Shape, shapes
from verify.app.page.toml_text import as_values
from verify.core.figures import Field, Picture
from verify.core.inputs import InputError

SQUARES = Field(
    name="squares",
    points=np.array([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1.0]]),
    cells=np.array([[0, 1, 4, 3], [1, 2, 5, 4]]),
    point_data={"displacement": np.array([[0, 0], [0, 0], [1, 0], [0, 0], [0, 0], [1, 0.0]]) / 10},
    cell_data={"stress": np.array([2e6, 4e6])},
)
LINE = Field(name="line", points=np.array([[0, 0], [0, 1.0]]), cells=np.array([[0, 1]]))
PICTURE = Picture(field="squares", data="stress", symbol="σ_v", unit="MPa", factor=1e6, caption="a")


def shape_of(field: Field, **changes: Any) -> Shape:
    (found,) = shapes([field], [replace(PICTURE, field=field.name, **changes)])
    return found


def decoded(packed: dict[str, str]) -> Any:
    return np.frombuffer(base64.b64decode(packed["bdata"]), "<" + packed["dtype"])


def test_a_ring_under_pressure_has_lame_s_radius_and_hoop_stress() -> None:
    hoop, _ = tasks.fields("ring-lame", "my", RING, quietly)
    a, b, p, E, nu = 60, 80, 100, 210e3, 0.3
    ratio = p * a**2 / (b**2 - a**2)
    u = (1 + nu) / E * ratio * (a * (1 - 2 * nu) + b**2 / a)  # plane strain
    radius = np.hypot(*hoop.deformed(50)[:, :2].T)
    assert radius.min() == pytest.approx(a + 50 * u, rel=1e-6)
    assert hoop.values is not None
    first = hoop.cells[hoop.values.argmax() // 4]
    inner, outer = np.unique(np.hypot(*hoop.points[first, :2].T).round(6))
    mean = 1 + 2 * b**2 * np.log(outer / inner) / (outer**2 - inner**2)  # of 1 + b²/r²
    assert inner == a
    assert hoop.values.max() == pytest.approx(ratio * mean, rel=1e-5)
    assert hoop.label == "σ_θ [MPa]"
    ends = np.hypot(*hoop.points[hoop.edges.ravel(), :2].T)
    assert set(np.unique(ends.round(6))) == {60, 80}


def test_each_vertex_has_the_value_of_its_cell() -> None:
    found = shape_of(SQUARES)
    assert found.values is not None
    assert found.values.tolist() == [2] * 4 + [4] * 4
    assert found.points[found.cells[1], 0].tolist() == [1000, 2000, 2000, 1000]
    assert len(found.edges) == 6
    assert found.factor == 1  # 5 % of the body: to scale


def test_a_window_contains_its_cells_with_displacements_relative_to_their_mean() -> None:
    found = shape_of(SQUARES, window=(1.5, 0.2, 1.9, 0.8))
    assert len(found.cells) == 1
    assert found.displacement.mean(axis=0) == pytest.approx(0)
    assert np.ptp(found.displacement[:, 0]) == pytest.approx(100)


def test_lengths_magnified_along_y_are_drawn_larger_with_their_true_values() -> None:
    plain, tall = (
        shape_of(SQUARES, displacement=""),
        shape_of(SQUARES, displacement="", stretch=4.0),
    )
    assert np.array_equal(tall.points, plain.points)
    scene = figure(tall, 0, view="front")["layout"]["scene"]
    (x_low, x_high), (y_low, y_high) = scene["xaxis"]["range"], scene["yaxis"]["range"]
    drawn = scene["aspectratio"]
    magnified = drawn["y"] / (y_high - y_low) * (x_high - x_low) / drawn["x"]
    assert magnified == pytest.approx(4)
    assert y_low > -50
    assert scene["yaxis"]["title"]["text"] == "y [mm], magnified 4 times"


def test_edges_at_which_a_window_cuts_the_body_are_not_edges_of_the_body() -> None:
    found = shape_of(SQUARES, window=(1.5, 0.2, 1.9, 0.8))
    ends = found.points[found.edges]
    assert len(ends) == 3
    assert not (ends[:, :, 0] == 1000).all(axis=1).any()


def test_the_proposed_scale_is_that_of_the_picture() -> None:
    assert shape_of(SQUARES, share=0.5).factor == 1  # displacements are to scale
    small = replace(SQUARES, point_data={"displacement": SQUARES.point_data["displacement"] / 100})
    assert [shape_of(small).factor, shape_of(small, share=0.5).factor] == [100, 1000]


def test_a_line_with_a_width_is_a_ribbon() -> None:
    found = shape_of(LINE, data="", width=0.5)
    assert found.points[found.cells[0]].tolist() == [
        [0, 0, -250], [0, 1000, -250], [0, 1000, 250], [0, 0, 250],
    ]  # fmt: skip
    assert found.values is None
    assert not found.is_plane


def test_a_line_without_a_width_is_refused() -> None:
    with pytest.raises(ValueError, match="needs a width"):
        shape_of(LINE, data="")


def test_the_figure_has_all_cells_the_colours_and_the_scale() -> None:
    shape = shape_of(SQUARES)
    surface, edges, before = figure(shape, 3, view="front")["data"]
    assert decoded(surface["x"]).max() == pytest.approx(2300)
    assert decoded(before["x"])[::3].max() == pytest.approx(2000)
    triangles = np.column_stack([decoded(surface[k]) for k in "ijk"])
    assert sorted(triangles.tolist()) == [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]
    assert decoded(surface["intensity"]).tolist() == [2] * 4 + [4] * 4
    assert (surface["cmin"], surface["cmax"]) == (2, 4)
    assert np.isnan(decoded(edges["x"])).sum() == len(shape.edges)
    assert len(figure(shape, 0, view="front")["data"]) == 2
    assert surface["colorbar"]["title"]["text"] == "σ<sub>v</sub> [MPa]"


def test_values_as_heights_are_means_at_points_in_proportion_to_the_extent() -> None:
    surface = figure(shape_of(SQUARES), 0, view="front", as_height=True)["data"][0]
    heights = dict(zip(decoded(surface["x"]), decoded(surface["z"]), strict=True))
    assert heights == pytest.approx({0: 0, 1000: 300, 2000: 600})


def test_values_as_heights_change_nothing_of_a_body_in_space() -> None:
    ribbon = replace(shape_of(LINE, data="", width=0.5), factor=1.0)
    as_height, usual = (figure(ribbon, 1, view="front", as_height=k) for k in (True, False))
    assert as_height == usual


def test_logarithms_have_powers_of_ten_at_the_colour_bar() -> None:
    shape = shape_of(replace(SQUARES, cell_data={"stress": np.array([0.5, 2.2])}), factor=1.0,
                     decades=True)  # fmt: skip
    surface = figure(shape, 0, view="front")["data"][0]
    assert surface["colorbar"]["tickvals"] == [1, 2]
    assert surface["colorbar"]["ticktext"][1] == "10<sup>2</sup>"
    assert "10<sup>%{intensity" in surface["hovertemplate"]


def test_the_box_has_the_proportions_of_the_body() -> None:
    scene = figure(shape_of(SQUARES), 0, view="oblique")["layout"]["scene"]
    (x, y), (low, high) = (scene["aspectratio"][k] for k in "xy"), scene["xaxis"]["range"]
    assert (low, high) == pytest.approx((-40, 2040))
    assert x / y == pytest.approx(2080 / 1080)
    for view in VIEWS:
        assert np.linalg.norm(list(camera(view)["eye"].values())) == pytest.approx(1)


def test_the_box_contains_the_undeformed_edges_of_a_body_that_shrinks() -> None:
    shape = shape_of(SQUARES)
    small = replace(shape, displacement=-shape.points / 2)
    scene = figure(small, 1, view="front")["layout"]["scene"]
    assert scene["xaxis"]["range"] == pytest.approx((-40, 2040))


def test_the_title_and_the_label_below_the_figure_are_escaped() -> None:
    shape = shape_of(SQUARES, symbol="<i>", caption="a < b")
    assert about(shape) == "a &lt; b<br>&lt;i&gt; [MPa]: smallest 2, largest 4"


def test_a_case_without_fields_is_refused_before_it_is_solved() -> None:
    case = describe("spring-curve")
    with pytest.raises(InputError, match="no field to display"):
        tasks.fields("spring-curve", "my", as_values(case.raw, case.whole), _never)


def _never(_state: Any) -> None:
    raise AssertionError("a mesh is solved")
