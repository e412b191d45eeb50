"""Patch tests: a state of constant stress is met exactly by every element, however distorted.

The oracle is Hooke's law in three dimensions, which doesn't know the two assumptions apart.
"""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, degree, every_case, mapped

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


def bulge(x, y):
    """The square with curved sides."""
    x, y = shift(x, y)
    return np.array([x + 0.2 * y * y, y + 0.3 * np.sin(2 * x)])


def patch(kind, place=shift):
    return mapped(kind, np.linspace(0, 1, 4), np.linspace(0, 1, 5), place, split=0.6)


def zz(assumption):
    return 0.0 if assumption == "plane stress" else NU * (XX + YY)


def strains(assumption):
    """Hooke: eps_xx = (xx - nu (yy + zz)) / E, eps_yy alike, eps_xy = (1 + nu) xy / E."""
    z = zz(assumption)
    return (XX - NU * (YY + z)) / E, (YY - NU * (XX + z)) / E, (1 + NU) * XY / E


def assert_constant_stress(solution, assumption):
    stress = solution.in_body().stress
    expected = np.reshape([XX, YY, XY, zz(assumption)], (4, 1))
    np.testing.assert_allclose(stress, np.broadcast_to(expected, stress.shape), atol=ROUND_OFF * E)


@every_case
def test_imposed_linear_displacements_give_constant_stress_in_two_bodies_alike(kind, assumption):
    e_xx, e_yy, e_xy = strains(assumption)  # and a rotation of 0.001 that must not be noticed
    moved = {
        "x": lambda x: e_xx * x[0] + (e_xy - 1e-3) * x[1] + 5e-3,
        "y": lambda x: (e_xy + 1e-3) * x[0] + e_yy * x[1] - 2e-3,
    }
    solution = solve_plane(
        patch(kind, bulge), materials={"west": MATERIAL, "east": MATERIAL}, degree=degree(kind),
        assumption=assumption, supports=dict.fromkeys(SIDES, moved),
    )  # fmt: skip
    assert_constant_stress(solution, assumption)
    inside = solution.in_body()
    expected = [moved["x"](inside.x), moved["y"](inside.x)]
    np.testing.assert_allclose(inside.u, expected, atol=ROUND_OFF)


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
