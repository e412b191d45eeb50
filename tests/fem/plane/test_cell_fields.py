"""Evaluation of plane fields: cells and nodes, copies of a sector, a loaded patch."""

from types import SimpleNamespace

import numpy as np
import pytest

from analytic.ring.loaded_race import share
from fem.plane.cell_fields import at_nodes, cut_out, largest_shear
from fem.plane.material import Elastic
from fem.plane.patch import polar_nodes, solve_under_patch
from fem.plane.sectors import all_sectors, largest_hoop_stress, radial
from fem.plane.solve import solve_plane
from meshes.polyhedral.half_sector import half_sector
from meshes.ring.sector import half_sector as ring_sector


def test_values_at_nodes_are_means_of_the_cells_about_them_weighed_by_area():
    points = np.array([[0.0, 0], [1, 0], [4, 0], [0, 1], [1, 1], [4, 1]])
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])
    at = at_nodes(points, cells, np.array([[8.0, 1.0], [4.0, 1.0]]))
    assert at[:, 0].tolist() == [8.0, 5.0, 4.0, 8.0, 5.0, 4.0]  # areas 1 and 3
    assert np.all(at[:, 1] == 1)


def test_cells_are_cut_out_with_the_points_and_values_that_are_theirs():
    points = np.array([[0.0, 0], [1, 0], [4, 0], [0, 1], [1, 1], [4, 1]])
    whole = {"points": points, "cells": np.array([[0, 1, 4, 3], [1, 2, 5, 4]]),
             "displacement": 2 * points, "stress": np.array([[1.0] * 4, [2.0] * 4]),
             "von_mises": np.array([3.0, 4.0])}  # fmt: skip
    left = cut_out(whole, lambda centre: centre[:, 0] > 1)
    assert left["points"][left["cells"]].tolist() == points[[[1, 2, 5, 4]]].tolist()
    assert np.array_equal(left["displacement"], 2 * left["points"])
    assert left["stress"].tolist() == [[2.0] * 4]
    assert left["von_mises"].tolist() == [4.0]


def test_the_largest_shear_does_not_change_as_the_stress_is_turned():
    xx, yy, xy, t = 3.0, -1.0, 2.0, 0.7
    c, s = np.cos(2 * t), np.sin(2 * t)
    middle, half = (xx + yy) / 2, (xx - yy) / 2
    turned = [middle + half * c + xy * s, middle - half * c - xy * s, xy * c - half * s, 5.0]
    one, other = largest_shear(np.array([[xx, yy, xy, 5.0], turned]))
    assert abs(one - other) < 1e-14


Z = 6


@pytest.fixture(scope="module")
def body():
    return solve_plane(
        half_sector(z=Z, d_e=0.08, d_i=0.072, fillet=0.002, refine=1),
        materials=Elastic(E=210e9, nu=0.3), assumption="plane stress",
        supports={"mid": "n", "corner": "n"}, pressures={"bore": 1e6},
    )  # fmt: skip


def test_radial_displacements_at_cuts_are_those_of_their_nodes(body):
    corner = np.array([np.cos(np.pi / Z), np.sin(np.pi / Z)])
    expected = [body.displacement_at((0.04, 0.0))[0],
                float(corner @ body.displacement_at(tuple(0.04 * corner)))]  # fmt: skip
    assert radial(body, 0.04, np.array([0.0, np.pi / Z])) == pytest.approx(expected, rel=1e-9)


def test_all_copies_make_a_whole_ring_that_grows_equally(body):
    half = body.cells()
    points, moved, cells = all_sectors(half, Z)
    assert len(points) == 2 * Z * len(half["points"])
    assert cells.max() == len(points) - 1
    np.testing.assert_allclose(points.sum(axis=0), 0, atol=1e-12)
    np.testing.assert_allclose(moved.sum(axis=0), 0, atol=1e-15)
    outwards = (points * moved).sum(axis=1).reshape(2 * Z, -1)
    np.testing.assert_allclose(outwards, np.tile(outwards[0], (2 * Z, 1)), rtol=1e-9, atol=1e-18)


def test_a_polynomial_of_stress_along_a_fillet_is_found_again():
    turn = np.linspace(0, 0.5, 30)
    x = np.array([1.0, 2.0])[:, None] + 0.1 * np.array([np.cos(turn), np.sin(turn)])
    hoop = 5 - (turn / 0.5 - 0.3) ** 2  # largest at 0.3 of the fillet
    stress = np.array([hoop - 2.0, -1.0 + 0 * hoop, 0 * hoop, 0 * hoop])  # less pressure 3
    side = SimpleNamespace(x=x, stress=stress)
    found = largest_hoop_stress(side, np.array([1.0, 2.0]), 0.5, 3.0)
    assert found == pytest.approx(5.0, rel=1e-6)


SIZES = {"r_i": 1.0, "r_o": 1.5, "n": 6, "loaded": "bore", "patch": 0.05}


@pytest.fixture(scope="module")
def sector():
    return solve_under_patch(
        ring_sector(**SIZES, refine=1, cells=3), material=Elastic(E=1.0, nu=0.3),
        assumption="plane stress", supports={"load cut": "n", "free cut": "n"},
        radius=1.0, a=0.05, P=2.0,
    )  # fmt: skip


def test_half_of_the_load_is_on_half_of_the_patch_on_few_cells(sector):
    x, _ = sector.f[sector.basis.nodal_dofs].sum(axis=1) + sector.f[sector.basis.facet_dofs].sum(
        axis=1
    )
    assert x == pytest.approx(float(share(0.05)), rel=1e-4)  # the mean of cos over the ellipse


def test_nodes_go_by_angle_and_agree_with_displacements_at_points(sector):
    theta, u_r, u_theta = polar_nodes(sector, "rim")
    assert np.all(np.diff(theta) > 0)
    assert theta[[0, -1]] == pytest.approx([0.0, np.pi / 6], abs=1e-12)
    k = theta.size // 2
    x, y = sector.at(1.5 * np.array([[np.cos(theta[k])], [np.sin(theta[k])]])).u[:, 0]
    c, s = np.cos(theta[k]), np.sin(theta[k])
    assert (u_r[k], u_theta[k]) == pytest.approx((x * c + y * s, y * c - x * s), rel=1e-6)
