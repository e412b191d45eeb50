"""Whole rings and discs close, have even cells on their circles and cover their areas once."""

from math import pi, sin

import numpy as np
import pytest

from fem.plane.geometry import check_unfolded, jacobians
from meshes.contact.round import full_disc, full_ring

R_I, R_O = 0.02, 0.03  # [m]
ROUND_OFF = 1e-12  # relative
GAUSS = np.stack(np.meshgrid(*[(0.5 + np.array([-1, 0, 1]) * np.sqrt(0.15))] * 2)).reshape(2, -1)


def ring(around, **changed):
    return full_ring(**{"r_i": R_I, "r_o": R_O, "around": around, "across": 3} | changed)


def disc(around, **changed):
    return full_disc(**{"R": R_O, "around": around} | changed)


SHAPES = {
    "ring": (ring, {"bore": (R_I, -1), "rim": (R_O, 1)}, pi * (R_O**2 - R_I**2)),
    "disc": (disc, {"rim": (R_O, 1)}, pi * R_O**2),
}  # circles by name: radius and outward direction; area
shapes = pytest.mark.parametrize(("make", "circles", "exact"), SHAPES.values(), ids=SHAPES)


@shapes
@pytest.mark.parametrize("around", [8, 80])
def test_cells_are_even_around_and_their_nodes_lie_on_the_circle(make, circles, exact, around):
    mesh = make(around)
    for name, (radius, _) in circles.items():
        facets = np.asarray(mesh.boundaries[name])
        assert facets.size == around
        nodes = mesh.doflocs[:, mesh.dofs.get_facet_dofs(facets).flatten()]
        np.testing.assert_allclose(np.hypot(*nodes), radius, rtol=ROUND_OFF)
        a, b = mesh.p[:, mesh.facets[:, facets]].swapaxes(0, 1)
        np.testing.assert_allclose(np.hypot(*(b - a)), 2 * radius * sin(pi / around), rtol=1e-7)
        corners = {tuple(p) for p in (mesh.p[:, mesh.facets[:, facets]] / radius).reshape(2, -1).T}
        assert {(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)} <= corners


@shapes
@pytest.mark.parametrize("around", [8, 40])
def test_no_cell_is_folded_or_turned_over(make, circles, exact, around):
    mesh = make(around)
    check_unfolded(mesh, GAUSS)
    assert jacobians(mesh, GAUSS)[1].min() > 0


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"r_i": 0.0}, "0 < r_i < r_o"),
        ({"r_o": float("nan")}, "0 < r_i < r_o"),
        ({"around": 10}, "multiple of 4 .* around=10"),
        ({"across": 0}, "one across.* across=0"),
    ],
)
def test_a_ring_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        full_ring(**{"r_i": R_I, "r_o": R_O, "around": 8, "across": 1} | changed)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"R": 0.0}, "R > 0"),
        ({"R": float("inf")}, "R > 0"),
        ({"around": 12}, "multiple of 8 .* around=12"),
    ],
)
def test_a_disc_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        full_disc(**{"R": R_O, "around": 8} | changed)
