"""Patch tests: polynomial states of stress in space are met exactly.

The oracles are polynomials and Hooke's law, written down here.
"""

from dataclasses import replace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.solid.cells import Cells
from fem.solid.solve import solve_solid
from meshes.solid.block import solid_block

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
