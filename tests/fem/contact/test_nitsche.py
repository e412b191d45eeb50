"""Nitsche's method beside the mortar: one answer, nearer with every mesh."""

import numpy as np
import pytest

from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Flat
from fem.contact.traction import traction_rows
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.contact.block import block
from meshes.contact.disc import quarter_disc
from meshes.join import join
from tests.fem.contact.models import on_flat

STEEL, R = Elastic(E=210e9, nu=0.3), 10e-3
A = 0.01 * R  # half-width of the contact, by Hertz
FORCE = np.pi * STEEL.E / (1 - STEEL.nu**2) * A**2 / (4 * R)  # on a rigid flat
PATCH = 1e-8  # the residual that Newton's method may leave is 1e-10
ORDER_2 = 1.25  # grid convergence index at the formal order


def quantities(solution):
    touch = solution.touches[0]
    return np.array([touch.peak, touch.half_width((0.0, 0.0)), solution.strain_energy])


def grid_errors(coarse, fine, ratio):
    """Errors of the fine meshes' values at second order, both methods' together."""
    return ORDER_2 * sum(abs(f - c) for f, c in zip(fine, coarse, strict=True)) / (ratio**2 - 1)


@pytest.mark.parametrize(
    ("cells", "order", "slave", "friction", "assumption"),
    [
        ("quad", 2, "up.bottom", 0.3, "plane stress"),
        ("tri", 1, "low.top", 0.0, "axisymmetric"),
    ],
)
def test_constant_pressure_passes_between_meshes_that_do_not_match(
    cells, order, slave, friction, assumption
):
    meshes = {
        "up": block(x=(0, 1), y=(1, 1.6), nx=7, ny=4, cells=cells, order=order),
        "low": block(x=(0, 1), y=(0, 1), nx=5, ny=4, cells=cells, order=order),
    }
    master = {"up.bottom": "low.top", "low.top": "up.bottom"}[slave]
    # equal nu/E: free to widen alike, both blocks keep constant stress with friction, too
    problem = ContactProblem(
        join(meshes), materials={"up": Elastic(E=3.0, nu=0.3), "low": Elastic(E=1.0, nu=0.1)},
        assumption=assumption, supports={"low.bottom": "y"},
        anchors={} if assumption == "axisymmetric" else {(0.0, 0.0): "x", (0.0, 1.6): "x"},
        contacts=[Pair(slave=slave, master=master, friction=friction)],
    )  # fmt: skip
    found = solve_nitsche(problem, tractions={"up.top": (0.0, -0.01)})
    touch, stress = found.touches[0], found.plane.in_body().stress
    np.testing.assert_allclose(touch.p, 0.01, rtol=PATCH)
    np.testing.assert_allclose(touch.pressure, 0.01, rtol=PATCH)
    np.testing.assert_allclose(touch.q, 0.0, atol=0.01 * PATCH)
    np.testing.assert_allclose(stress[1], -0.01, rtol=PATCH)
    np.testing.assert_allclose(stress[[0, 2]], 0.0, atol=0.01 * PATCH)


def test_hertz_on_a_flat_is_the_mortars_to_second_order():
    values = []
    for refine in (1, 2, 4):
        problem = on_flat(quarter_disc(R=R, zone=1.5 * A, refine=refine), supports={"axis": "x"})
        load = {"middle": (0, -FORCE / 2)}
        solved = problem.solve(forces=load), solve_nitsche(problem, forces=load)
        values.append([quantities(s) for s in solved])
    values = np.array(values)
    apart = abs(values[:, 1] / values[:, 0] - 1)
    order = np.log2(apart[0] / apart[2]) / 2
    assert np.all(order > 1.5), f"peak, half-width, energy: {apart}, order {order}"
    *_, coarse, fine = values
    assert np.all(abs(fine[1] - fine[0]) <= grid_errors(coarse, fine, 2))


@pytest.mark.parametrize("assumption", ["plane strain", "axisymmetric"])
def test_tractions_are_those_of_the_stresses_on_curved_cells(assumption):
    disc = quarter_disc(R=1.0, zone=0.3, refine=1, cells=3)
    problem = ContactProblem(
        disc, materials=STEEL, assumption=assumption, supports={"axis": "x", "middle": "y"},
        obstacles={"flat": Obstacle(Flat())}, contacts=[Pair(slave="surface", master="flat")],
    )  # fmt: skip
    solved = solve_plane(
        disc, materials=STEEL, assumption=assumption, supports={"axis": "x", "middle": "y"},
        pressures={"surface": lambda x: 1e6 * (1 + 3 * x[0] - 2 * x[1] ** 2)},
    )  # fmt: skip
    points, side = problem.interface.mortars[0].points, solved.on_boundary("surface")
    distance = np.hypot(*(points.x[:, :, None] - side.x[:, None, :]))
    same = distance.argmin(axis=1)
    assert distance.min(axis=1).max() < 1e-12
    traction, u = side.traction()[:, same], np.pad(solved.u, (0, 3))  # the obstacle's
    for direction in (points.n, np.array([-points.n[1], points.n[0]])):
        own = traction_rows(problem.bodies, problem.surfaces.slaves[0], points, direction)
        expected = -(direction * traction).sum(axis=0)
        np.testing.assert_allclose(own @ u, expected, atol=1e-11 * abs(traction).max())
