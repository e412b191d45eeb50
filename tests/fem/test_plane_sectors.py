"""Sectors of a ring between guides, and round guides, against closed forms of the whole ring."""

from dataclasses import replace
from math import cos, pi, radians, sin

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

MATERIAL = Elastic(E=1000.0, nu=0.3)
R_I, R_O = 1.0, 1.5
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
DEGREE = {"tri3": 1, "tri6": 2, "quad4": 1, "quad9": 2}
SPREAD = 0.2  # of an order observed between 4 and 8 cells through the wall
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def sector(kind, start, angle, through):
    """Ring from `start` over `angle` [rad]; the rim also in two halves."""
    straight, shape = KINDS[kind]
    around = max(2, round(6 * through * angle / (pi / 2)))
    grid = straight.init_tensor(
        np.linspace(R_I, R_O, through + 1), angle * np.linspace(0, 1, 2 * around + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == R_I,
        "rim": lambda x: x[0] == R_O,
        "rim's first half": lambda x: (x[0] == R_O) & (x[1] < angle / 2),
        "rim's second half": lambda x: (x[0] == R_O) & (x[1] > angle / 2),
        "first cut": lambda x: x[1] == 0,
        "last cut": lambda x: x[1] == angle,
    })  # fmt: skip
    r, phi = mesh.doflocs[0], mesh.doflocs[1] + start
    return replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)]))


def in_plane(assumption):
    E, nu = MATERIAL.E, MATERIAL.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


def bore_movement(p, assumption):
    """Lame: under a pressure p in the bore."""
    E, nu = in_plane(assumption)
    return p * R_I / E * ((R_O**2 + R_I**2) / (R_O**2 - R_I**2) + nu)


def observed_order(errors):
    return np.log2(abs(errors[0] / errors[1]))


@both_assumptions
@pytest.mark.parametrize(
    ("start", "angle"),
    [
        pytest.param(0, 90, id="quarter"),
        pytest.param(20, 45, id="eighth, turned by 20 deg"),
        pytest.param(-110, 30, id="twelfth, turned by -110 deg"),
        pytest.param(37, 123, id="more than a quarter, turned by 37 deg"),
    ],
)
@every_element
def test_every_sector_between_guides_is_the_ring(kind, start, angle, assumption):
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
    assert observed_order(errors) == pytest.approx(2 * DEGREE[kind], abs=SPREAD), errors


@both_assumptions
@pytest.mark.parametrize("kind", ["tri6", "quad9"])
@pytest.mark.parametrize("lobes", [2, 3, 5])
def test_half_a_lobe_between_guides_is_the_ring_under_lobed_pressure(lobes, kind, assumption):
    # Michell: phi = f(r) cos(n phi), f = r^n, r^-n, r^(n+2), r^(2-n); for each power m
    # radial (m - n^2) r^(m-2), hoop m (m-1) r^(m-2), shear n (m-1) r^(m-2); the walls fix the
    # factors: radial -1 at the rim, 0 in the bore, no shear
    n = lobes
    m = np.array([n, -n, n + 2, 2 - n])
    walls = [
        [(m - n**2) * R_I ** (m - 2.0), (m - n**2) * R_O ** (m - 2.0)],
        [n * (m - 1) * R_I ** (m - 2.0), n * (m - 1) * R_O ** (m - 2.0)],
    ]
    factors = np.linalg.solve(np.reshape(walls, (4, 4)), [0, -1, 0, 0])

    def error(through):
        s = solve_plane(
            sector(kind, radians(10), pi / n, through), materials=MATERIAL, assumption=assumption,
            supports={"first cut": "n", "last cut": "n"},
            pressures={"rim": lambda x: np.cos(n * (np.arctan2(x[1], x[0]) - radians(10)))},
        ).in_body()  # fmt: skip
        r, phi = np.hypot(*s.x), np.arctan2(s.x[1], s.x[0]) - radians(10)
        f = factors * r[:, None] ** (m - 2.0)
        cosine, sine = np.cos(n * phi), np.sin(n * phi)
        exact = f @ (m - n**2) * cosine, f @ (m * (m - 1)) * cosine, f @ (n * (m - 1)) * sine
        return np.sqrt(s.mean(((np.array(s.polar()[1:]) - exact) ** 2).sum(axis=0)))

    assert observed_order([error(4), error(8)]) == pytest.approx(2, abs=SPREAD)


@both_assumptions
@every_element
def test_a_bore_pressed_out_by_a_given_amount_answers_with_lames_pressure(kind, assumption):
    delta = 1e-3
    p = delta / bore_movement(1.0, assumption)
    energy = p * R_I * delta * (pi / 2) / 2
    errors = []
    for through in (4, 8):
        s = solve_plane(
            sector(kind, 0.0, pi / 2, through), materials=MATERIAL, assumption=assumption,
            supports={"bore": {"n": -delta}, "first cut": "n", "last cut": "n"},
        )  # fmt: skip
        errors.append(s.strain_energy / energy - 1)
    assert observed_order(errors) == pytest.approx(2 * DEGREE[kind], abs=SPREAD), errors


@both_assumptions
@every_element
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
        assert observed_order(pair) == pytest.approx(2 * DEGREE[kind], abs=SPREAD), (quantity, pair)


@pytest.mark.parametrize(
    "rim",
    [
        pytest.param(["rim"], id="one piece"),
        pytest.param(["rim's first half", "rim's second half"], id="two pieces"),
    ],
)
@every_element
def test_a_round_guide_lets_its_ring_turn_however_many_names_it_has(kind, rim):
    angle = 1e-3
    s = solve_plane(
        sector(kind, 0.0, pi / 2, 4), materials=MATERIAL, assumption="plane strain",
        supports={"bore": {"n": 0.0, "t": -angle * R_I}} | dict.fromkeys(rim, "n"),
    )  # fmt: skip
    # were the rim held, it would take this couple of pure torsion (see above). Half a cell is
    # pi/96, and by that the normals at the rim's two ends miss the radius on linear elements:
    # (pi/96)^2 = 1e-3 of the couple is left, on quadratic ones (pi/96)^6 / 16 = 1e-10
    mu, b = MATERIAL.E / (2 * (1 + MATERIAL.nu)), angle * R_O / (1 / R_O - R_O / R_I**2)
    held = -2 * mu * b * pi / 2
    assert s.reaction("bore")[2] == pytest.approx(0, abs=held * [0, 1e-3, 1e-10][DEGREE[kind]])
