"""Closed forms that finer meshes approach at the elements' own rates.

u of degree k is off by h^(k+1) in itself, by h^k in its stresses and by h^(2k) in energies; chords
for arcs cost h^2.
"""

from functools import cache

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, in_plane, mapped, order, ring

R_I, R_O, P_I, P_O = 0.04, 0.06, 90e6, 20e6  # a sleeve [m, Pa]
STEEL = Elastic(E=210e9, nu=0.3)


SPREAD = 0.25  # of observed orders between the meshes of a test


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
        assert found == pytest.approx(rate, abs=SPREAD)
    # radial and hoop stress add up to the same everywhere; the mean of zz is exact on any mesh
    inside = sleeve(kind, assumption, 8).in_body()
    zz = STEEL.nu * 2 * a * (assumption == "plane strain")
    if "straight" not in kind and degree(kind) == 2:
        assert inside.mean(inside.stress[3]) == pytest.approx(zz, rel=1e-12)


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
