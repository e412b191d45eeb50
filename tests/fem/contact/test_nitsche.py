"""Nitsche's method against the mortar method: the difference decreases with the mesh; refusals."""

from functools import cache

import numpy as np
import pytest

from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.contact.traction import traction_rows
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.contact.block import block, full_block, half_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.join import join
from tests.fem.contact.models import on_flat, tower

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
    # equal nu/E: both blocks widen equally, and have constant stress with friction, too
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


MU = 0.3
ZONE = 1.3 * A
UNSEEN_ORDER = 3.0  # grid convergence index where two meshes do not show the order


@cache
def sliding(refine):
    """A disc pressed on a block, pushed sideways and back: both solutions, step by step."""
    meshes = {
        "disc": half_disc(R=R, zone=ZONE, refine=refine, cells=4),
        "block": full_block(width=2 * R, depth=2 * R, zone=ZONE, refine=refine, cells=3),
    }
    pair = Pair(
        slave="disc.surface",
        master="block.surface",
        friction=MU,
        slave_shape=Circle((0, R), R),
    )
    problem = ContactProblem(
        join(meshes), materials=STEEL, assumption="plane strain", contacts=[pair],
        supports={"block.bottom": "xy", "disc.middle": "xy"},
    )  # fmt: skip
    mortar = nitsche = None
    steps = []
    for x in (0.0, 0.6e-6, 0.4e-6):
        moved = {"disc.middle": {"x": x, "y": -3e-6}}
        mortar = problem.solve(displacements=moved, after=mortar)
        nitsche = solve_nitsche(problem, displacements=moved, after=nitsche)
        steps.append((mortar, nitsche))
    return steps


def punched(refine):
    """An elastic block under a rigid disc that is free in y."""
    meshes = {"low": half_block(width=20 * A, depth=20 * A, zone=1.5 * A, refine=refine),
              "up": quarter_disc(R=R, zone=1.5 * A, refine=1, cells=4)}  # fmt: skip
    problem = ContactProblem(
        join(meshes), materials={"low": STEEL, "up": Rigid()}, assumption="plane strain",
        supports={"low.bottom": "xy", "low.axis": "x", "up.axis": "x"},
        contacts=[
            Pair(slave="low.surface", master="up.surface", master_shape=Circle((0.0, R), R))
        ],
    )  # fmt: skip
    loads = {"up.middle": (0.0, -60e3)}
    return problem.solve(forces=loads), solve_nitsche(problem, forces=loads)


def test_partial_slip_and_its_history_are_the_mortars():
    def quantities(solution):
        (touch,) = solution.touches
        return np.array([touch.friction_force, touch.normal_force, solution.strain_energy])

    coarse, fine = (np.array([quantities(s) for s in sliding(refine)[-1]]) for refine in (1, 2))
    errors = UNSEEN_ORDER * abs(fine - coarse).sum(axis=0) / 3
    assert np.all(abs(fine[1] - fine[0]) <= errors)


def test_a_rigid_punch_that_only_contact_holds_comes_to_rest():
    coarse, fine = (punched(refine) for refine in (1, 3))
    assert fine[1].touches[0].force[1] == pytest.approx(60e3, rel=1e-9)
    assert fine[1].plane.reaction("low.bottom")[1] == pytest.approx(60e3, rel=1e-9)
    for quantity in (lambda s: s.strain_energy, lambda s: s.touches[0].half_width((0, 0))):
        first, last = (abs(quantity(n) / quantity(m) - 1) for m, n in (coarse, fine))
        assert last < first / 3


DOWN, FLOOR = {"tractions": {"up.top": (0.0, -1e6)}}, {"floor": Obstacle(Flat((0.0, 0.5)))}
TOUCH = Pair(slave="up.bottom", master="low.top")
HELD = {
    "materials": STEEL,
    "supports": {"low.bottom": "xy", "up.left": "x"},
}  # the upper in x alone


@pytest.mark.parametrize(
    ("changed", "given", "error", "message"),
    [
        ({}, {"alpha": 0.0}, ValueError, "alpha must be positive and finite"),
        ({}, {"alpha": np.nan}, ValueError, "alpha must be positive and finite"),
        ({}, {"alpha": 2.0}, ArithmeticError, "must be positive definite: reduce alpha"),
        ({}, {"pressures": {"up.bottom": 1e3}}, ValueError, "a load on 'up.bottom' acts on it"),
        ({"contacts": [TOUCH, Pair(slave="up.bottom", master="floor")], "obstacles": FLOOR}, {},
         ValueError, "the contact 'up.bottom' on 'floor' acts on it"),
        ({}, {"tractions": {"up.top": (0.0, 1e6)}}, ArithmeticError,
         "neither supports nor contact hold"),
        ({"materials": Elastic(E=1.0, nu=0.4999)}, {}, ValueError,
         r"Nitsche.*: nu <= 0.45 is required, got nu=0.4999 in "),
    ],
)  # fmt: skip
def test_what_the_method_cannot_solve_is_named(changed, given, error, message):
    with pytest.raises(error, match=message):
        solve_nitsche(tower(0.0, **HELD | changed), **DOWN | given)
    disc = quarter_disc(R=1.0, zone=0.1, refine=1)
    apart = on_flat(disc, supports={"axis": "x"}, obstacles={"flat": Obstacle(Flat((0.0, -0.1)))})
    with pytest.raises(ValueError, match=r"the initial gap of 0\.1 is too large"):
        solve_nitsche(apart, forces={"middle": (0.0, -1e6)})
