"""Closed forms that finer meshes approach at the elements' own rates.

u of degree k is off by h^(k+1) in itself, by h^k in its stresses and by h^(2k) in energies; chords
for arcs cost h^2.
"""

from functools import cache

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, every_case, in_plane, mapped, order, ring

R_I, R_O, P_I, P_O = 0.04, 0.06, 90e6, 20e6  # a sleeve [m, Pa]
STEEL = Elastic(E=210e9, nu=0.3)
# of observed orders between the meshes of a test
SLEEVE_SPREAD, PLATE_SPREAD = 0.25, 0.3
A, B = 1.0, 3.0  # hole and outer circle of a plate under the tension 1 along x
MATERIAL = Elastic(E=1000.0, nu=0.3)


@cache
def sleeve(kind, assumption, through):
    return solve_plane(
        ring(kind, np.linspace(R_I, R_O, through + 1), np.linspace(0, np.pi / 2, 4 * through + 1)),
        materials=STEEL, assumption=assumption, degree=degree(kind),
        supports={"last cut": "x", "first cut": "y"}, pressures={"bore": P_I, "rim": P_O},
    )  # fmt: skip


def outward(x):
    return x / np.hypot(*x)


@pytest.mark.parametrize(
    ("kind", "assumption", "rate"),
    [
        ("tri3", "plane strain", 2),
        ("quad4", "plane stress", 2),
        ("tri6", "plane stress", 4),
        ("quad9", "plane strain", 4),
        ("quad9, straight", "plane strain", 2),
    ],
)
def test_a_sleeve_under_pressure_moves_as_lame_has_it(kind, assumption, rate):
    E, nu = in_plane(STEEL, assumption)
    a = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    b = (P_I - P_O) * R_I**2 * R_O**2 / (R_O**2 - R_I**2)
    u_i, u_o = (((1 - nu) * a * r + (1 + nu) * b / r) / E for r in (R_I, R_O))
    energy = np.pi / 2 * (P_I * R_I * u_i - P_O * R_O * u_o) / 2  # half the pressures' work
    errors = (
        lambda s: s.strain_energy / energy - 1,
        lambda s: s.mean_displacement("bore", outward) / u_i - 1,
        lambda s: s.mean_displacement("rim", outward) / u_o - 1,
    )
    for error in errors:
        found = order(error, lambda n: sleeve(kind, assumption, n), (2, 4, 8))
        assert found == pytest.approx(rate, abs=SLEEVE_SPREAD)
    # radial and hoop stress add up to the same everywhere; the mean of zz is exact on any mesh
    inside = sleeve(kind, assumption, 8).in_body()
    zz = STEEL.nu * 2 * a * (assumption == "plane strain")
    if "straight" not in kind and degree(kind) == 2:
        assert inside.mean(inside.stress[3]) == pytest.approx(zz, rel=1e-12)


def stress(x):
    """Kirsch's xx, yy, xy (Timoshenko & Goodier, art. 35)."""
    phi, q = np.arctan2(x[1], x[0]), (A / np.hypot(*x)) ** 2
    c2, c4, s2, s4 = np.cos(2 * phi), np.cos(4 * phi), np.sin(2 * phi), np.sin(4 * phi)
    return np.array([
        1 - q * (1.5 * c2 + c4) + 1.5 * q**2 * c4,
        -q * (0.5 * c2 - c4) - 1.5 * q**2 * c4,
        -q * (0.5 * s2 + s4) + 1.5 * q**2 * s4,
    ])  # fmt: skip


def displacement(x, assumption):
    """Kolosov's and Muskhelishvili's."""
    nu = MATERIAL.nu
    kappa = (3 - nu) / (1 + nu) if assumption == "plane stress" else 3 - 4 * nu
    phi, r = np.arctan2(x[1], x[0]), np.hypot(*x) / A
    c, s, c3, s3 = np.cos(phi), np.sin(phi), np.cos(3 * phi), np.sin(3 * phi)
    scale = A / (8 * MATERIAL.E / (2 * (1 + nu)))
    return scale * np.array([
        r * (kappa + 1) * c + 2 / r * ((1 + kappa) * c + c3) - 2 / r**3 * c3,
        r * (kappa - 3) * s + 2 / r * ((1 - kappa) * s + s3) - 2 / r**3 * s3,
    ])  # fmt: skip


@cache
def plate(kind, assumption, fine):
    """A quarter, whose outer circle carries the tractions of the infinite plate."""

    def pull(x):
        xx, yy, xy = stress(x)
        n_x, n_y = outward(x)
        return np.array([xx * n_x + xy * n_y, xy * n_x + yy * n_y])

    r = A * (B / A) ** np.linspace(0, 1, 4 * fine + 1)
    return solve_plane(
        ring(kind, r, np.linspace(0, np.pi / 2, 6 * fine + 1)), materials=MATERIAL,
        assumption=assumption, supports={"last cut": "x", "first cut": "y"},
        tractions={"rim": pull},
    )  # fmt: skip


@every_case
def test_a_plate_with_a_hole_moves_and_is_stressed_as_kirsch_has_it(kind, assumption):
    def moved(s):
        inside = s.in_body()
        off = ((inside.u - displacement(inside.x, assumption)) ** 2).sum(axis=0)
        return np.sqrt(inside.mean(off))

    def stressed(s):
        inside = s.in_body()
        return np.sqrt(inside.mean(((inside.stress[:3] - stress(inside.x)) ** 2).sum(axis=0)))

    for error, rate in ((moved, degree(kind) + 1), (stressed, degree(kind))):
        found = order(error, lambda n: plate(kind, assumption, n), (4, 8))
        assert found == pytest.approx(rate, abs=PLATE_SPREAD)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_the_elliptic_membrane_le1_has_the_target_stress_of_nafems(kind):
    # NAFEMS R0015 (1990), LE1: ellipses 2 x 1 and 3.25 x 2.75 m, 10 MPa outwards on the outer one,
    # 0.1 m thick; yy at (2, 0) is 92.7 MPa
    def found(cells):
        s = np.linspace(0, 1, cells + 1) ** 2  # towards (2, 0)
        mesh = mapped(kind, s, np.linspace(0, 1, 2 * cells + 1) ** 2, lambda s, t: (
            (2 + 1.25 * s) * np.cos(t * np.pi / 2), (1 + 1.75 * s) * np.sin(t * np.pi / 2)
        ))  # fmt: skip
        inner = solve_plane(
            mesh, materials=Elastic(E=210e3, nu=0.3), assumption="plane stress", thickness=0.1,
            supports={"bottom": "y", "top": "x"}, pressures={"right": -10.0},
        ).on_boundary("left")  # fmt: skip
        return inner.stress[1, np.argsort(inner.x[1])[:4]].mean()  # the facet at (2, 0)

    coarse, fine = found(8), found(16)
    gci = 1.25 * abs(fine - coarse) / (2**2 - 1)
    assert fine == pytest.approx(92.7, abs=0.05 + gci)  # half the last printed digit
