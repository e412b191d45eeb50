"""Solids: exact polynomial stresses, Lamé's cylinder, no locking with one cell."""

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.solid.cells import Cells
from fem.solid.solve import solve_solid
from meshes.solid.block import solid_block
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

E, NU = 200.0, 0.3  # any
LAM, MU = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
STEEL = Elastic(E=E, nu=NU)
SHEAR = np.array([[1, 0.2, 0.1], [0.3, 1, 0.2], [-0.1, 0.2, 1]])  # blocks to parallelepipeds
ROUND_OFF = 1e-11
RULES = [None, (2, 3, 3), (3, 2, 3), (3, 3, 2)]
rules = pytest.mark.parametrize("points", RULES, ids=str)


def distorted(x):
    """Moves the inside of the unit cube and leaves its sides plane."""
    bump = np.prod(np.sin(np.pi * x), axis=0)
    return x + bump * np.array([[0.1], [-0.06], [0.08]])


def cube(place, order=2):
    mesh = solid_block(x=(0, 1), y=(0, 1), z=(0, 1), cells=(2, 3, 2), order=order)
    return replace(mesh, doflocs=place(mesh.doflocs))


def held(mesh, field):
    """Supports that prescribe `field` on all sides."""
    moved = {c: (lambda x, i=i: field(x)[i]) for i, c in enumerate("xyz")}
    return dict.fromkeys(mesh.boundaries, moved)


@pytest.mark.parametrize("order", [1, 2])
def test_a_constant_strain_is_met_on_distorted_cells(order):
    mesh = cube(distorted, order)
    grad = np.array([[1.0, 0.4, -0.2], [0.3, -2.0, 0.5], [0.1, 0.6, 0.7]])  # du_i/dx_j
    solved = solve_solid(mesh, materials=STEEL, supports=held(mesh, lambda x: grad @ x))
    assert solved.displacement == pytest.approx((grad @ mesh.doflocs).T, abs=ROUND_OFF)
    stress = LAM * np.trace(grad) * np.eye(3) + MU * (grad + grad.T)
    found = solved.stresses().stress
    assert found == pytest.approx(np.broadcast_to(stress, found.shape), abs=E * ROUND_OFF)
    energy = 0.5 * np.sum(stress * grad)  # in the unit cube
    assert solved.strain_energy == pytest.approx(energy, rel=ROUND_OFF)


@rules
def test_a_quadratic_displacement_is_met_on_parallelepipeds(points):
    a = np.random.default_rng(7).uniform(-1, 1, (3, 3, 3))
    a += a.swapaxes(1, 2)  # u_i = a_ijk x_j x_k / 2, so that u_i,jk = a_ijk

    def field(x):
        return np.einsum("ijk,jm,km->im", a, x, x) / 2

    force = -(LAM + MU) * np.einsum("jji->i", a) - MU * np.einsum("ijj->i", a)
    mesh = cube(lambda x: SHEAR @ x)
    solved = solve_solid(
        mesh, materials=STEEL, supports=held(mesh, field), body_force=tuple(force), points=points
    )
    assert solved.displacement == pytest.approx(field(mesh.doflocs).T, abs=ROUND_OFF)


# (2, 2, 2): 8 points bind 48 of 81 unknowns. (2, 3, 2): the three free fields of the nine-node
# square, P2(x) P2(z) e_x, P2(x) P2(z) e_z and (x (3 z^2 - 1), -z (3 x^2 - 1)), and P2(x) P2(z) e_y,
# each times 1, y or y^2.
@pytest.mark.parametrize(
    ("points", "modes"), [*((rule, 6) for rule in RULES), ((2, 3, 2), 18), ((2, 2, 2), 33)], ids=str
)
def test_a_free_cell_has_six_motions_without_energy_unless_two_directions_are_reduced(
    points, modes
):
    mesh = solid_block(x=(0, 1), y=(0, 1), z=(0, 1), cells=(1, 1, 1))
    one = np.ones(1)
    K = Cells.of(mesh, LAM * one, MU * one, points or (3, 3, 3)).stiffness().toarray()
    values = np.linalg.eigvalsh(K)
    assert np.count_nonzero(values < 1e-9 * values[-1]) == modes


def test_two_points_along_one_long_cell_do_not_lock():
    """A leaf with a guided head, its tail moved, of nu = 0: 12 E I / L^3 but for shear."""
    L, b = 100.0, 1.0
    mesh = solid_strip(
        [Piece("leaf", 0.0, 0.0, 0.0, L, 0.0, 1)], b=b, width=1.0, through=1, per_arc=1,
        per_leaf=1, across=1,
    )  # fmt: skip
    solved = solve_solid(
        mesh, materials=Elastic(E=E, nu=0.0), points=(2, 3, 3),
        supports={"head": "x", "tail": "x", "middle": "z", (L, 0.0, None): "y",
                  (0.0, 0.0, None): {"y": 1.0}},
    )  # fmt: skip
    found = 2 * solved.strain_energy / (E / L**3)  # I = 1/12
    # faces that stay plane hold back what shear does to the thickness there, by 0.5 (b/L)^3
    assert found == pytest.approx(1 / (1 + 2 / L**2), rel=1e-6 + 0.5 / L**3)


PRESSURE = 4.0
A, B, WIDTH = 1.0, 2.0, 0.5  # inner and outer radius
MIDDLE = (A + B) / 2
WIDE = E / (1 - NU**2)
HELD = {"middle": "z", "edge": "z"}
SPREAD = 0.15  # of an order observed between 4 x 12 and 8 x 24 cells


def quarter(through, **changed):
    """From (0, 0) around the centre (MIDDLE, 0) to (MIDDLE, MIDDLE)."""
    piece = Piece("arc", 0.0, 0.0, pi / 2, MIDDLE * pi / 2, -pi / 2, 1)
    cells = {"through": through, "per_arc": 3 * through, "per_leaf": 1, "across": 1}
    return solid_strip([piece], b=B - A, width=WIDTH, **cells | changed)


@cache
def cylinder(through, **changed):
    return solve_solid(
        quarter(through, **changed), materials=STEEL, pressures={"right": PRESSURE},
        supports={"head": "y", "tail": "x"} | HELD,
    )  # fmt: skip


def bore_movement():
    """Of the bore under a pressure in it, plane strain."""
    nu = NU / (1 - NU)
    return PRESSURE * A / WIDE * ((A**2 + B**2) / (B**2 - A**2) + nu)


def energy_error(solved):
    work = PRESSURE * A * pi / 2 * WIDTH * bore_movement()
    return abs(-2 * solved.potential_energy / work - 1)


def test_a_cylinder_expands_as_lame_has_it():
    solved = cylinder(8)
    r = np.hypot(solved.mesh.doflocs[0] - MIDDLE, solved.mesh.doflocs[1])
    bore = solved.displacement[abs(r - A) < 1e-6]
    assert np.hypot(bore[:, 0], bore[:, 1]) == pytest.approx(bore_movement(), rel=1e-4)
    s = solved.stresses()
    radial = np.stack([s.x[:, 0] - MIDDLE, s.x[:, 1], 0 * s.x[:, 0]], axis=1)
    r = np.linalg.norm(radial, axis=1)
    across = np.einsum("mi,mij,mj->m", radial, s.stress, radial) / r**2
    scale = PRESSURE * A**2 / (B**2 - A**2)
    assert across == pytest.approx(scale * (1 - (B / r) ** 2), abs=0.02 * PRESSURE)
    assert s.stress[:, 2, 2] == pytest.approx(2 * NU * scale, abs=0.02 * PRESSURE)


@pytest.mark.parametrize(("straight", "order"), [(False, 4), (True, 2)])
def test_the_cylinders_energy_has_order_4_on_curved_cells_and_2_on_straight_ones(straight, order):
    error = [energy_error(cylinder(through, straight=straight)) for through in (4, 8)]
    assert np.log2(error[0] / error[1]) == pytest.approx(order, abs=SPREAD)


def sphere(nu, order, n=4):
    """Errors of the bore's growth and, root mean square over p, of the radial stress.

    A sixth of the octant a < r < b between planes through the centre: u = A r + B/r^2.
    """
    a, b, p = 1.0, 2.0, 1.0
    block = solid_block(x=(0, 1), y=(0, 1), z=(a, b), cells=(n, n, n), order=order)
    x, y, r = block.doflocs
    ray = np.array([np.tan(x * pi / 4), np.tan(y * pi / 4), np.ones_like(x)])
    mesh = replace(block, doflocs=r * ray / np.linalg.norm(ray, axis=0))
    A = p * a**3 * (1 - 2 * nu) / (E * (b**3 - a**3))
    B = p * a**3 * b**3 * (1 + nu) / (2 * E * (b**3 - a**3))

    def growth(x):
        r = np.linalg.norm(x, axis=0)
        return (A + B / r**3) * x

    moved = {c: (lambda x, i=i: growth(x)[i]) for i, c in enumerate("xyz")}
    solved = solve_solid(
        mesh, materials=Elastic(E=E, nu=nu), pressures={"z=0": p},
        supports={"x=0": "x", "y=0": "y", "x=1": moved, "y=1": moved},
    )  # fmt: skip
    bore = np.isclose(np.linalg.norm(mesh.doflocs, axis=0), a)
    error = np.linalg.norm(solved.displacement.T - growth(mesh.doflocs), axis=0)[bore].max()
    found = solved.stresses()
    r = np.linalg.norm(found.x, axis=1)
    n = found.x / r[:, None]
    missed = np.einsum("mi,mij,mj->m", n, found.stress, n)
    missed -= p * a**3 / (b**3 - a**3) * (1 - b**3 / r**3)
    return error / (A + B), np.sqrt((found.weight * missed**2).sum() / found.weight.sum()) / p


def test_a_thick_sphere_is_accurate_up_to_nu_045():
    """Errors of degree 1 halve (stress) or quarter with the cells, those of degree 2 faster."""
    for nu, order, growth, stress in (
        (0.3, 1, 0.031, 0.13), (0.3, 2, 4e-4, 0.014), (0.45, 1, 0.09, 0.38), (0.45, 2, 2e-3, 0.042),
    ):  # fmt: skip
        u, s = sphere(nu, order)
        assert (u < growth, s < stress) == (True, True), (nu, order, u, s)
        coarse_u, coarse_s = sphere(nu, order, n=2)
        assert coarse_u > 2.5 * u
        assert coarse_s > 1.8 * s
