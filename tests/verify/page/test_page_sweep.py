"""A sweep of the page has every point, and its figure too."""

import pytest

from tests.verify.page.answered import RING, answered, quietly
from verify.app.page.sweep_figure import options
from verify.app.page.tasks import DESIGN, MARGIN, sweep
from verify.core.inputs import InputError


def test_a_sweep_has_results_and_gaps_where_inputs_are_refused() -> None:
    found = sweep("ring-lame", "my", RING, ["r_i=70mm:90mm:3"], MARGIN, quietly)
    assert found.axes == (("r_i [mm]", (70.0, 80.0, 90.0)),)
    first, *rest = found.values[0]
    assert first == float(f"{float(first or 0):.6g}")
    assert rest == [None, None]
    assert found.problem


def test_a_sweep_over_two_inputs_is_a_grid() -> None:
    found = sweep(
        "ring-lame", "my", RING, ["r_i=50mm:60mm:3", "p_i=10MPa:20MPa:2"], DESIGN, quietly
    )
    assert [len(row) for row in found.values] == [3, 3]
    ratio = float(found.values[1][0] or 0) / float(found.values[0][0] or 1)
    assert ratio == pytest.approx(2, rel=1e-5)  # linear in the pressure


def test_the_figure_of_a_sweep_has_every_point() -> None:
    line = sweep("ring-lame", "my", RING, ["p_i=10MPa:30MPa:3"], "hoop_bore", quietly)
    drawn = options(line, dark=False)["series"][0]["data"]
    assert [x for x, _ in drawn] == pytest.approx([10, 20, 30])
    assert tuple(y for _, y in drawn) == line.values[0]
    last = answered("ring-lame", RING | {"p_i": "30 MPa"})
    assert f"{line.values[0][-1]:.6g}" in {v[1] for v in last.values if v[0] == "σ_θ(r_i)"}
    grid = sweep("ring-lame", "my", RING, ["p_i=10MPa:30MPa:3", "r_o=75mm:80mm:2"], MARGIN, quietly)
    cells = options(grid, dark=True)["series"][0]["data"]
    assert {(i, j): value for i, j, value in cells} == {
        (i, j): grid.values[j][i] for i in range(3) for j in range(2)
    }


def test_a_sweep_that_is_too_large_or_of_a_word_is_refused() -> None:
    with pytest.raises(InputError, match="at most 1000 points"):
        sweep("ring-lame", "my", RING, ["r_i=1mm:2mm:500", "p_i=1MPa:2MPa:3"], MARGIN, quietly)
    with pytest.raises(InputError, match="unknown input"):
        sweep("ring-lame", "my", RING, ["x=1:2:3"], MARGIN, quietly)
