"""Distorted elements reproduce constant stress exactly; other solutions converge.

u of degree k is off by h^(k+1) in itself, by h^k in its stresses and by h^(2k) in energies; chords
for arcs cost h^2.
"""

from functools import cache

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, degree, in_plane, mapped, order, ring

E, NU, THICKNESS = 200.0, 0.3, 0.7  # any
XX, YY, XY = 3.0, -2.0, 1.5  # any stress
ROUND_OFF = 1e-12  # relative; some hundred operations on numbers with an error of 1e-16
MATERIAL = Elastic(E=E, nu=NU)
SIDES = {"left": (-1, 0), "right": (1, 0), "bottom": (0, -1), "top": (0, 1)}
every_element = pytest.mark.parametrize("kind", KINDS)


def shift(x, y):
    """Distorts the cells of the unit square and keeps its sides straight."""
    return np.array([
        x + 0.06 * np.sin(np.pi * x) * np.sin(2 * np.pi * y + 1),
        y - 0.08 * np.sin(2 * np.pi * x + 1) * np.sin(np.pi * y),
    ])  # fmt: skip


def patch(kind, place=shift):
    return mapped(kind, np.linspace(0, 1, 4), np.linspace(0, 1, 5), place, split=0.6)


def zz(assumption):
    return 0.0 if assumption == "plane stress" else NU * (XX + YY)


def strains(assumption):
    """Hooke: eps_xx = (xx - nu (yy + zz)) / E, eps_yy likewise, eps_xy = (1 + nu) xy / E."""
    z = zz(assumption)
    return (XX - NU * (YY + z)) / E, (YY - NU * (XX + z)) / E, (1 + NU) * XY / E


def assert_constant_stress(solution, assumption):
    stress = solution.in_body().stress
    expected = np.reshape([XX, YY, XY, zz(assumption)], (4, 1))
    np.testing.assert_allclose(stress, np.broadcast_to(expected, stress.shape), atol=ROUND_OFF * E)


@every_element
def test_imposed_tractions_give_constant_stress_and_its_energy(kind):
    assumption = "plane strain" if "tri" in kind else "plane stress"
    solution = solve_plane(
        patch(kind), materials=MATERIAL, assumption=assumption, degree=degree(kind),
        thickness=THICKNESS, supports={}, anchors={(0, 0): "xy", (1, 0): "y"},
        tractions={
            side: (XX * n_x + XY * n_y, XY * n_x + YY * n_y) for side, (n_x, n_y) in SIDES.items()
        },
    )  # fmt: skip
    assert_constant_stress(solution, assumption)
    e_xx, e_yy, e_xy = strains(assumption)
    energy = (XX * e_xx + YY * e_yy + 2 * XY * e_xy) / 2 * THICKNESS  # on the unit square
    assert solution.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert solution.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)
    # anchors keep (0, 0) and the height of (1, 0), so that the top corner moves by the strain alone
    assert solution.displacement_at((1, 1)) == pytest.approx((e_xx + 2 * e_xy, e_yy), abs=ROUND_OFF)


@every_element
def test_one_cell_resists_every_motion_but_the_three_rigid_ones(kind):
    straight, shape, own = KINDS[kind]
    cell = straight.init_refdom()
    mesh = shape.from_mesh(cell) if shape is not straight else cell
    middles = cell.p[:, cell.facets].mean(axis=1) if own == 2 else np.zeros((2, 0))
    nodes = [tuple(p) for p in np.hstack([cell.p, middles]).T]  # a node inside the cell stays free

    def forces(moved, component):
        """On every node of the outline, where one moves by 1 and the others stay."""
        solution = solve_plane(
            mesh, materials=MATERIAL, assumption="plane strain", degree=own, supports={},
            anchors=dict.fromkeys(nodes, "xy") | {moved: {"x": 0.0, "y": 0.0, component: 1.0}},
        )  # fmt: skip
        return np.concatenate([solution.reaction_at(n) for n in nodes])

    stiffness = np.array([forces(node, component) for node in nodes for component in "xy"])
    modes = np.linalg.eigvalsh(stiffness)
    assert np.count_nonzero(modes < ROUND_OFF * modes.max()) == 3
    assert modes[3] > 1e-3 * modes.max()  # and the softest of the others is none by chance


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
