"""Rings turned by their rim, and round guides, against closed forms of the whole ring."""

from math import pi, radians

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, every_case, every_element, ring

MATERIAL = Elastic(E=1000.0, nu=0.3)
R_I, R_O = 1.0, 1.5
SPREAD = 0.2  # of an order observed between two meshes


def quarter(kind, start, through):
    r = np.linspace(R_I, R_O, through + 1)
    return ring(kind, r, start + pi / 2 * np.linspace(0, 1, 12 * through + 1))


@every_case
def test_a_rim_turned_against_the_bore_is_in_pure_torsion(kind, assumption):
    # u_phi = a r + b / r, zero in the bore and v at the rim; tau = -2 mu b / r^2
    v, mu = 1e-3, MATERIAL.E / (2 * (1 + MATERIAL.nu))
    b = v / (1 / R_O - R_O / R_I**2)
    couple = -2 * mu * b * pi / 2  # on a quarter
    errors: dict[str, list[float]] = {"energy": [], "couple of the rim": []}
    for through in (4, 8):
        s = solve_plane(
            quarter(kind, radians(15), through), materials=MATERIAL, assumption=assumption,
            supports={"bore": "nt", "rim": {"t": v}, "first cut": "t", "last cut": "t"},
        )  # fmt: skip
        errors["energy"].append(s.strain_energy / (couple * v / R_O / 2) - 1)
        errors["couple of the rim"].append(s.reaction("rim")[2] / couple - 1)
    for quantity, pair in errors.items():
        found = np.log2(abs(pair[0] / pair[1]))
        assert found == pytest.approx(2 * degree(kind), abs=SPREAD), quantity


@every_element
def test_a_round_guide_lets_its_ring_turn_however_many_names_it_has(kind):
    angle = 1e-3
    mesh = quarter(kind, 0.0, 4)
    middle = mesh.p[:, mesh.facets[:, mesh.boundaries["rim"]]].mean(axis=1)
    low = middle[1] < middle[0]
    mesh = mesh.with_boundaries({"low": mesh.boundaries["rim"][low],
                                 "high": mesh.boundaries["rim"][~low]})  # fmt: skip
    s = solve_plane(
        mesh, materials=MATERIAL, assumption="plane strain",
        supports={"bore": {"n": 0.0, "t": -angle * R_I}, "low": "n", "high": "n"},
    )  # fmt: skip
    # were the rim held, it would take this couple of pure torsion (see above). Half a cell is
    # pi/96, and by that the normals at the rim's two ends miss the radius on linear elements:
    # (pi/96)^2 = 1e-3 of the couple is left, on quadratic ones (pi/96)^6 / 16 = 1e-10
    mu, b = MATERIAL.E / (2 * (1 + MATERIAL.nu)), angle * R_O / (1 / R_O - R_O / R_I**2)
    held = -2 * mu * b * pi / 2
    assert s.reaction("bore")[2] == pytest.approx(0, abs=held * [0, 1e-3, 1e-10][degree(kind)])
