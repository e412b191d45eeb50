"""Nitsche's method with friction, with rigid bodies and obstacles, and what it refuses."""

from functools import cache

import numpy as np
import pytest

from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block, half_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.join import join
from tests.fem.contact.models import on_flat

STEEL = Elastic(E=210e9, nu=0.3)
R, A, MU = 10e-3, 0.1e-3, 0.3
ZONE = 1.3 * A
UNSEEN_ORDER = 3.0  # grid convergence index where two meshes do not show the order
BALANCE = 1e-9


@cache
def sliding(refine):
    """A disc pressed on a block, pushed sideways and back: both solutions, step by step."""
    meshes = {
        "disc": half_disc(R=R, zone=ZONE, refine=refine, cells=4),
        "block": full_block(width=2 * R, depth=2 * R, zone=ZONE, refine=refine, cells=3),
    }
    pair = Pair(
        slave="disc.surface", master="block.surface", friction=MU, slave_shape=Circle((0, R), R)
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


def punched(refine, rigid):
    """An elastic block under a rigid disc, meshed and free in y, or an obstacle free in y."""
    width, shape = 20 * A, Circle((0.0, R), R)
    low = half_block(width=width, depth=width, zone=1.5 * A, refine=refine)
    supports, materials = {"low.bottom": "xy", "low.axis": "x"}, {"low": STEEL}
    meshes, obstacles, master, exact = {"low": low}, {"punch": Obstacle(shape, "y")}, "punch", None
    if rigid:
        meshes["up"] = quarter_disc(R=R, zone=1.5 * A, refine=1, cells=4)
        supports["up.axis"], materials["up"] = "x", Rigid()
        obstacles, master, exact = {}, "up.surface", shape
    problem = ContactProblem(
        join(meshes), materials=materials, assumption="plane strain", supports=supports,
        obstacles=obstacles,
        contacts=[Pair(slave="low.surface", master=master, master_shape=exact)],
    )  # fmt: skip
    loads = {"up.middle" if rigid else "punch": (0.0, -60e3)}
    return problem.solve(forces=loads), solve_nitsche(problem, forces=loads)


def test_partial_slip_and_its_history_are_the_mortars():
    def quantities(solution):
        (touch,) = solution.touches
        return np.array([touch.friction_force, touch.normal_force, solution.strain_energy])

    coarse, fine = (np.array([quantities(s) for s in sliding(refine)[-1]]) for refine in (1, 2))
    errors = UNSEEN_ORDER * abs(fine - coarse).sum(axis=0) / 3
    assert np.all(abs(fine[1] - fine[0]) <= errors)


@pytest.mark.parametrize("rigid", [True, False], ids=["rigid body", "obstacle"])
def test_a_rigid_punch_that_only_contact_holds_comes_to_rest(rigid):
    coarse, fine = (punched(refine, rigid) for refine in (1, 3))
    assert fine[1].touches[0].force[1] == pytest.approx(60e3, rel=BALANCE)
    assert fine[1].plane.reaction("low.bottom")[1] == pytest.approx(60e3, rel=BALANCE)
    for quantity in (lambda s: s.strain_energy, lambda s: s.touches[0].half_width((0, 0))):
        first, last = (abs(quantity(n) / quantity(m) - 1) for m, n in (coarse, fine))
        assert last < first / 3


def stack(**changed):
    """Two blocks, the upper one held in x alone."""
    meshes = {
        "up": block(x=(0, 1), y=(1, 2), nx=3, ny=3),
        "low": block(x=(0, 1), y=(0, 1), nx=2, ny=2),
    }
    return ContactProblem(**{
        "mesh": join(meshes), "materials": STEEL, "assumption": "plane strain",
        "supports": {"low.bottom": "xy", "up.left": "x"},
        "contacts": [Pair(slave="up.bottom", master="low.top")],
    } | changed)  # fmt: skip


DOWN, FLOOR = {"tractions": {"up.top": (0.0, -1e6)}}, {"floor": Obstacle(Flat((0.0, 0.5)))}
TOUCH = Pair(slave="up.bottom", master="low.top")


@pytest.mark.parametrize(
    ("changed", "given", "error", "message"),
    [
        ({}, {"alpha": 0.0}, ValueError, "alpha must be positive and finite"),
        ({}, {"alpha": np.nan}, ValueError, "alpha must be positive and finite"),
        ({}, {"alpha": 2.0}, ArithmeticError, "not positive definite: lower alpha"),
        ({}, {"pressures": {"up.bottom": 1e3}}, ValueError, "a load on 'up.bottom' acts there too"),
        ({"contacts": [TOUCH, Pair(slave="up.bottom", master="floor")], "obstacles": FLOOR}, {},
         ValueError, "the contact 'up.bottom' on 'floor' acts there too"),
        ({}, {"tractions": {"up.top": (0.0, 1e6)}}, ArithmeticError,
         "neither supports nor contact hold"),
    ],
)  # fmt: skip
def test_what_the_method_cannot_solve_is_named(changed, given, error, message):
    with pytest.raises(error, match=message):
        solve_nitsche(stack(**changed), **DOWN | given)
    disc = quarter_disc(R=1.0, zone=0.1, refine=1)
    apart = on_flat(disc, supports={"axis": "x"}, obstacles={"flat": Obstacle(Flat((0.0, -0.1)))})
    with pytest.raises(ValueError, match=r"the surfaces start 0\.1 apart"):
        solve_nitsche(apart, forces={"middle": (0.0, -1e6)})
