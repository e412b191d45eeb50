"""Sectors of a ring between guides, and round guides, against closed forms of the whole ring."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, every_case, every_element, in_plane, ring

MATERIAL = Elastic(E=1000.0, nu=0.3)
R_I, R_O = 1.0, 1.5
SPREAD = 0.25  # of an order observed between two meshes


def sector(kind, start, angle, through):
    around = 2 * max(2, round(6 * through * angle / (pi / 2)))
    r, phi = np.linspace(R_I, R_O, through + 1), np.linspace(start, start + angle, around + 1)
    return ring(kind, r, phi)


def bore_movement(p, assumption):
    """Lame: under a pressure p in the bore."""
    E, nu = in_plane(MATERIAL, assumption)
    return p * R_I / E * ((R_O**2 + R_I**2) / (R_O**2 - R_I**2) + nu)


def observed_order(errors):
    return np.log2(abs(errors[0] / errors[1]))


@pytest.mark.parametrize(
    ("start", "angle"),
    [
        pytest.param(-110, 30, id="twelfth, turned by -110 deg"),
        pytest.param(37, 123, id="more than a quarter, turned by 37 deg"),
    ],
)
@every_case
def test_every_sector_between_guides_is_the_ring(kind, assumption, start, angle):
    p, angle = 10.0, radians(angle)
    energy = p * R_I * bore_movement(p, assumption) * angle / 2  # Clapeyron
    errors = []
    for through in (2, 4):
        s = solve_plane(
            sector(kind, radians(start), angle, through), materials=MATERIAL,
            assumption=assumption, supports={"first cut": "n", "last cut": "n"},
            pressures={"bore": p},
        )  # fmt: skip
        errors.append(s.strain_energy / energy - 1)
        # each cut pulls the sector along its normal with the pressure on half a ring, exactly:
        # two forces of known directions balance p times the bore's chord
        for cut, phi, out in (("first cut", start, -1), ("last cut", start + np.degrees(angle), 1)):
            pull = out * p * R_I * np.array([-sin(radians(phi)), cos(radians(phi))])
            assert s.reaction(cut)[:2] == pytest.approx(tuple(pull), abs=1e-9 * p)
    assert observed_order(errors) == pytest.approx(2 * degree(kind), abs=SPREAD), errors


def test_half_a_lobe_between_guides_is_the_ring_under_lobed_pressure():
    # Michell: phi = f(r) cos(n phi), f = r^n, r^-n, r^(n+2), r^(2-n); for each power m
    # radial (m - n^2) r^(m-2), hoop m (m-1) r^(m-2), shear n (m-1) r^(m-2); the walls fix the
    # factors: radial -1 at the rim, 0 in the bore, no shear
    n, start = 3, radians(10)
    m = np.array([n, -n, n + 2, 2 - n])
    walls = [
        [(m - n**2) * R_I ** (m - 2.0), (m - n**2) * R_O ** (m - 2.0)],
        [n * (m - 1) * R_I ** (m - 2.0), n * (m - 1) * R_O ** (m - 2.0)],
    ]
    factors = np.linalg.solve(np.reshape(walls, (4, 4)), [0, -1, 0, 0])

    def error(through):
        s = solve_plane(
            sector("quad9", start, pi / n, through), materials=MATERIAL,
            assumption="plane strain", supports={"first cut": "n", "last cut": "n"},
            pressures={"rim": lambda x: np.cos(n * (np.arctan2(x[1], x[0]) - start))},
        ).in_body()  # fmt: skip
        r, phi = np.hypot(*s.x), np.arctan2(s.x[1], s.x[0]) - start
        f = factors * r[:, None] ** (m - 2.0)
        cosine, sine = np.cos(n * phi), np.sin(n * phi)
        exact = f @ (m - n**2) * cosine, f @ (m * (m - 1)) * cosine, f @ (n * (m - 1)) * sine
        return np.sqrt(s.mean(((np.array(s.polar()[1:]) - exact) ** 2).sum(axis=0)))

    assert observed_order([error(4), error(8)]) == pytest.approx(2, abs=SPREAD)


@every_case
def test_a_rim_turned_against_the_bore_is_in_pure_torsion(kind, assumption):
    # u_phi = a r + b / r, zero in the bore and v at the rim; tau = -2 mu b / r^2
    v, mu = 1e-3, MATERIAL.E / (2 * (1 + MATERIAL.nu))
    b = v / (1 / R_O - R_O / R_I**2)
    couple = -2 * mu * b * pi / 2  # on a quarter
    errors: dict[str, list[float]] = {"energy": [], "couple of the rim": []}
    for through in (4, 8):
        s = solve_plane(
            sector(kind, radians(15), pi / 2, through), materials=MATERIAL, assumption=assumption,
            supports={"bore": "nt", "rim": {"t": v}, "first cut": "t", "last cut": "t"},
        )  # fmt: skip
        errors["energy"].append(s.strain_energy / (couple * v / R_O / 2) - 1)
        errors["couple of the rim"].append(s.reaction("rim")[2] / couple - 1)
    for quantity, pair in errors.items():
        assert observed_order(pair) == pytest.approx(2 * degree(kind), abs=SPREAD), quantity


@every_element
def test_a_round_guide_lets_its_ring_turn_however_many_names_it_has(kind):
    angle = 1e-3
    mesh = sector(kind, 0.0, pi / 2, 4)
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
