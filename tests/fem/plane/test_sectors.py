"""Sectors of a ring: radial displacements, stresses along a fillet, and the whole of its copies."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.sectors import all_sectors, largest_hoop_stress, radial
from fem.plane.solve import solve_plane
from meshes.polyhedral.half_sector import half_sector

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


def test_all_copies_make_a_whole_ring_that_grows_alike(body):
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
