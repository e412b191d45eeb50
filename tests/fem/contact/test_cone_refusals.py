"""What cannot be along z is refused in one line that says where."""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.cone import State
from fem.contact.cone_descent import Descent
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.join import join

SOFT = Elastic(E=1.0, nu=0.3)
HELD = Along(supports={"low.bottom": 0.0})


def pair(along=HELD, assumption="plane strain", friction=0.3):
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=3, ny=2),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=4, ny=2)})  # fmt: skip
    return ContactProblem(
        mesh, materials=SOFT, assumption=assumption, along=along,
        supports={"low.bottom": "xy", "up.top": "x"}, obstacles={"wall": Obstacle(Flat((5, 0)))},
        contacts=[Pair(slave="up.bottom", master="low.top", friction=friction)],
    )  # fmt: skip


@pytest.mark.parametrize("assumption", ["plane stress"])
def test_only_plane_strain_moves_along_z(assumption):
    with pytest.raises(ValueError, match="plane strain, got 'plane stress'"):
        pair(assumption=assumption)


def test_a_body_that_nothing_holds_along_z_is_named():
    with pytest.raises(ValueError, match="body 'up' can move along z: neither"):
        pair(friction=0.0)
    with pytest.raises(ValueError, match=r"body '(up|low)' can move along z, and the loads"):
        pair(Along()).solve(forces={"up.top": (0.0, -1e-3)}, axial_forces={"up.top": 1e-5})


def test_unknown_names_are_refused():
    with pytest.raises(ValueError, match="no boundary 'nowhere'"):
        pair(Along(supports={"nowhere": 0.0}))
    with pytest.raises(ValueError, match="got 'nowhere'; there are: wall"):
        pair(Along(free=("nowhere",)))
    problem = pair()
    down = {"up.top": (0.0, -1e-3)}
    with pytest.raises(ValueError, match="no boundary 'nowhere'"):
        problem.solve(forces=down, axial_forces={"nowhere": 0.0})
    with pytest.raises(
        ValueError, match=r"no support holds 'up\.top' along z; there are: low\.bot"
    ):
        problem.solve(forces=down, axial_displacements={"up.top": 1e-6})
    with pytest.raises(
        ValueError, match=r"no support holds 'up\.top' along z; there are: low\.bot"
    ):
        problem.solve(forces=down).along.reaction("up.top")


@pytest.mark.parametrize("force", [np.nan, np.inf, "1", (1.0, 2.0)])
def test_a_force_along_z_is_a_finite_number(force):
    with pytest.raises(ValueError, match=r"the force along z on 'up\.top' is a finite number, got"):
        pair().solve(forces={"up.top": (0.0, -1e-3)}, axial_forces={"up.top": force})


def test_displacements_along_z_are_finite_and_do_not_contradict():
    with pytest.raises(ValueError, match=r"displacement along z of 'low\.bottom' is not finite"):
        pair(Along(supports={"low.bottom": np.nan}))
    with pytest.raises(ValueError, match=r"contradict each other at 'low\.left'"):
        pair(Along(supports={"low.bottom": 0.0, "low.left": 1e-3}))
    with pytest.raises(ValueError, match="motion along z of obstacle 'wall' is a number"):
        pair(Along(supports={"low.bottom": 0.0, "wall": lambda x: x[0]}))


def test_an_obstacle_that_is_held_takes_no_force_along_z():
    with pytest.raises(ValueError, match="obstacle 'wall': it is not free along z"):
        pair().solve(forces={"up.top": (0.0, -1e-3)}, axial_forces={"wall": 1e-3})


def test_loads_along_z_need_a_problem_along_z():
    problem = pair(None)
    down = {"up.top": (0.0, -1e-3)}
    with pytest.raises(ValueError, match="need a problem with along="):
        problem.solve(forces=down, axial_forces={"up.top": 1e-5})
    with pytest.raises(ValueError, match="need a problem with along="):
        problem.solve(forces=down, axial_displacements={"up.top": 1e-5})


def test_without_pressure_nothing_holds_along_z():
    with pytest.raises(ValueError, match="body 'up' can move along z, and the loads do move it"):
        pair().solve(axial_forces={"up.top": 1e-5})


def test_a_solution_that_misses_its_laws_is_no_solution(monkeypatch):
    problem = pair()
    load = {"forces": {"up.top": (0.0, -1e-3)}, "axial_forces": {"up.top": 1e-4}}
    good = problem.solve(**load)
    assert good.along.residual.largest < 1e-11
    solve = Descent.solve

    def astray(self, starts):
        at = solve(self, starts)
        return State(at.multipliers * (1 + 1e-8), at.motion)

    monkeypatch.setattr(Descent, "solve", astray)
    with pytest.raises(ArithmeticError, match="misses its laws"):
        problem.solve(**load)
