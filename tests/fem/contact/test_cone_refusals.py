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


DOWN = {"forces": {"up.top": (0.0, -1e-3)}}
MOVES = "body 'up' can move along z, and the loads do move it"
UNHELD = r"no support holds 'up\.top' along z; there are: low\.bot"


@pytest.mark.parametrize(
    ("changed", "load", "message"),
    [
        ({"assumption": "plane stress"}, None, "plane strain, got 'plane stress'"),
        ({"friction": 0.0}, None, "body 'up' can move along z: neither"),
        ({"along": Along()}, DOWN | {"axial_forces": {"up.top": 1e-5}},
         r"body '(up|low)' can move along z, and the loads"),
        ({"along": Along(supports={"nowhere": 0.0})}, None, "no boundary 'nowhere'"),
        ({"along": Along(free=("nowhere",))}, None, "got 'nowhere'; there are: wall"),
        ({"along": Along(supports={"low.bottom": np.nan})}, None,
         r"displacement along z of 'low\.bottom' is not finite"),
        ({"along": Along(supports={"low.bottom": 0.0, "low.left": 1e-3})}, None,
         r"contradict each other at 'low\.left'"),
        ({"along": Along(supports={"low.bottom": 0.0, "wall": lambda x: x[0]})}, None,
         "motion along z of obstacle 'wall' is a number"),
        ({}, DOWN | {"axial_forces": {"nowhere": 0.0}}, "no boundary 'nowhere'"),
        ({}, DOWN | {"axial_displacements": {"up.top": 1e-6}}, UNHELD),
        ({}, DOWN | {"axial_forces": {"up.top": np.nan}},
         r"the force along z on 'up\.top' is a finite number, got"),
        ({}, DOWN | {"axial_forces": {"wall": 1e-3}}, "obstacle 'wall': it is not free along z"),
        ({}, {"axial_forces": {"up.top": 1e-5}}, MOVES),
        ({"along": None}, DOWN | {"axial_forces": {"up.top": 1e-5}}, "need a problem with along="),
    ],
)  # fmt: skip
def test_what_cannot_be_along_z_is_refused(changed, load, message):
    with pytest.raises(ValueError, match=message):
        pair(**changed).solve(**load or {})


def test_only_what_is_held_along_z_has_a_reaction():
    with pytest.raises(ValueError, match=UNHELD):
        pair().solve(**DOWN).along.reaction("up.top")


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
