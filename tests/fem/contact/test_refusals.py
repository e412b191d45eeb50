"""An invalid contact problem is refused in one line that names the error."""

from dataclasses import replace

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.cone import State
from fem.contact.cone_descent import Descent
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.join import join
from tests.fem.contact.models import tower

NAN = float("nan")
STEEL = Elastic(E=210e9, nu=0.3)
TOUCH = Pair(slave="a.bottom", master="b.top", friction=0.2)
LID = Obstacle(Flat((0, 2), (0, -1)))
UNDER_LID = [TOUCH, Pair(slave="a.top", master="lid")]


def blocks(x=0.0, y=1.0):
    return join({"a": block(x=(x, x + 1), y=(y, y + 1), nx=4, ny=2),
                 "b": block(x=(0, 1), y=(0, 1), nx=5, ny=2)})  # fmt: skip


def problem(mesh=None, **changes):
    given = {"materials": STEEL, "assumption": "plane strain", "supports": {"b.bottom": "xy"},
             "contacts": [TOUCH]}  # fmt: skip
    return ContactProblem(mesh or blocks(), **(given | changes))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"contacts": []}, "needs at least one pair"),
        ({"contacts": [Pair(slave="a.bot", master="b.top")]}, "no boundary 'a.bot'"),
        ({"contacts": [Pair(slave="a.bottom", master="tpo")]}, "no boundary or obstacle 'tpo'"),
        ({"contacts": [Pair(slave="a.left", master="b.left")]}, "no parts of the surfaces face"),
        ({"supports": {"b.bot": "xy"}}, "no boundary 'b.bot'"),
        ({"materials": {"a": STEEL, "c": STEEL}}, "no body 'c'"),
        ({"materials": {"a": STEEL}}, "have no material"),
        ({"assumption": "plane"}, "assumption must be one of"),
        ({"assumption": "axisymmetric", "thickness": 2.0}, "finite, and 1 if axisymmetric"),
        ({"degree": 3}, "degree 1 or 2"),
        ({"obstacles": {"b.top": LID}}, "must not have the name of a boundary"),
        ({"obstacles": {"lid": replace(LID, free="y")}}, "obstacle 'lid' can move"),
        ({"contacts": [TOUCH, Pair(slave="lid", master="b.top")], "obstacles": {"lid": LID}},
         "an obstacle must be the master"),
        ({"assumption": "axisymmetric", "contacts": UNDER_LID,
          "obstacles": {"lid": replace(LID, free="x")}}, "if axisymmetric, only y can be free"),
        ({"materials": {"a": STEEL, "b": Rigid()},
          "supports": {"b.bottom": {"x": 0.0, "y": lambda x: x[0] ** 2}}}, "contradict"),
        ({"anchors": {(0.0, 1.0): "x"}}, r"several nodes at \(0.0, 1.0\)"),
        ({"materials": {"a": STEEL, "b": 3.0}}, "material of 'b' must be Elastic or Rigid"),
        ({"materials": Rigid()}, "materials must be Elastic, or a mapping"),
        ({"contacts": [TOUCH, Pair(slave="b.top", master="a.bottom")]}, "paired only once"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top", slave_shape=Circle((0, 3), 1.0))]},
         "'a.bottom' must have the shape"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top", slave_shape=Flat((0, 1), (0, 1)))]},
         "has its body beyond it"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top")]},
         r"can move rigidly \(\+1 x\): neither supports"),
    ],
)  # fmt: skip
def test_a_problem_is_refused(changes, message):
    with pytest.raises(ValueError, match=message):
        problem(**changes)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Pair(slave="a", master="a"), "cannot touch itself"),
        (lambda: Pair(slave="a", master="b", friction=-0.1), "friction must be 0 or more"),
        (lambda: Pair(slave="a", master="b", interference=NAN), "interference must be finite"),
        (lambda: Obstacle(Flat(), free="z"), "must be different letters"),
        (lambda: Circle((0, 0), -1.0), "the radius of a circle must be positive"),
        (lambda: Circle((0, NAN), 1.0), "the centre of a circle must be finite"),
        (lambda: Flat((0, 0), (0, 0)), "needs a finite point"),
        (lambda: problem().solve(steps=0), "steps must be 1 or more, got 0"),
        (lambda: problem(blocks(y=0.5)), "'a.bottom' on 'b.top': the surfaces overlap by 0.5"),
        (
            lambda: problem(blocks(x=-0.5), assumption="axisymmetric", supports={"b.bottom": "y"}),
            "r >= 0",
        ),
    ],
)
def test_a_part_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    ("loads", "message"),
    [
        ({"forces": {"a.top": (0, NAN)}}, "finite"),
        ({"pressures": {"a.top": NAN}}, "finite"),
        ({"point_forces": {(0, 2): (0, NAN)}}, "finite"),
        ({"forces": {"a.top": (0, -1.0, 1.0)}}, "components x and y"),
        ({"point_forces": {(0.3, 7): (0, -1)}}, "no node at"),
        ({"displacements": {"a.top": {"y": -1e-3}}}, "prescribed components: none"),
        ({"displacements": {"b.bottom": {"x": 0, "y": NAN}}}, "must be finite"),
        ({"displacements": {"lid": {"n": 1.0}}}, "prescribed components: x, y, r"),
        ({"displacements": {"lid": {"y": lambda x: x[0]}}}, "must be a number"),
        ({"forces": {"lid": (0, -1, 0, 0)}}, "components"),
        ({"forces": {"lid": (0, -1e3)}}, "but only free motions can be loaded"),
    ],
)
def test_loads_are_refused(loads, message):
    sound = problem(obstacles={"lid": LID}, contacts=UNDER_LID)
    with pytest.raises(ValueError, match=message):
        sound.solve(**loads)


def test_a_prescribed_overlap_is_pressed_out():
    fit = replace(TOUCH, press_fit=True)
    mesh = blocks(y=1 - 1e-6)
    s = problem(mesh, contacts=[fit]).solve(forces={"a.top": (0, -1e3)})
    assert s.touches[0].force == pytest.approx((0, -1e3), abs=1e-5)


def test_a_step_follows_one_of_the_same_problem():
    step = problem().solve(forces={"a.top": (0, -1e3)})
    with pytest.raises(ValueError, match="must belong to the same contact problem"):
        problem().solve(forces={"a.top": (0, -2e3)}, after=step)
    with pytest.raises(ValueError, match="'master' or 'slave'"):
        step.touches[0].moment(on="both")


HELD = Along(supports={"low.bottom": 0.0})


def pair(along=HELD, assumption="plane strain", friction=0.3):
    return tower(
        friction, materials=STEEL, assumption=assumption, along=along,
        supports={"low.bottom": "xy", "up.top": "x"}, obstacles={"wall": Obstacle(Flat((5, 0)))},
    )  # fmt: skip


DOWN = {"forces": {"up.top": (0.0, -1e-3)}}
MOVES = "body 'up' can move along z, and no admissible contact forces"
UNHELD = r"no support along z on 'up\.top'; supports along z are on: low\.bot"


@pytest.mark.parametrize(
    ("changed", "load", "message"),
    [
        ({"assumption": "plane stress"}, None, "'plane strain', got 'plane stress'"),
        ({"friction": 0.0}, None, "body 'up' can move along z: neither"),
        ({"along": Along()}, DOWN | {"axial_forces": {"up.top": 1e-5}},
         r"body '(up|low)' can move along z, and no admissible"),
        ({"along": Along(supports={"nowhere": 0.0})}, None, "no boundary 'nowhere'"),
        ({"along": Along(free=("nowhere",))}, None, "got 'nowhere'; obstacles: wall"),
        ({"along": Along(supports={"low.bottom": np.nan})}, None,
         r"displacement along z of 'low\.bottom' must be finite"),
        ({"along": Along(supports={"low.bottom": 0.0, "low.left": 1e-3})}, None,
         r"contradict each other at 'low\.left'"),
        ({"along": Along(supports={"low.bottom": 0.0, "wall": lambda x: x[0]})}, None,
         "motion along z of obstacle 'wall' must be a number"),
        ({}, DOWN | {"axial_forces": {"nowhere": 0.0}}, "no boundary 'nowhere'"),
        ({}, DOWN | {"axial_displacements": {"up.top": 1e-6}}, UNHELD),
        ({}, DOWN | {"axial_forces": {"up.top": np.nan}},
         r"the force along z on 'up\.top' must be a finite number, got"),
        ({}, DOWN | {"axial_forces": {"wall": 1e-3}}, "obstacle 'wall': the obstacle must be free"),
        ({}, {"axial_forces": {"up.top": 1e-5}}, MOVES),
        ({"along": None}, DOWN | {"axial_forces": {"up.top": 1e-5}}, "need a problem with along="),
    ],
)  # fmt: skip
def test_what_cannot_be_along_z_is_refused(changed, load, message):
    with pytest.raises(ValueError, match=message):
        pair(**changed).solve(**load or {})


def test_what_is_not_held_has_no_reaction_and_what_misses_its_laws_is_no_solution(monkeypatch):
    problem = pair()
    load = {"forces": {"up.top": (0.0, -1e-3)}, "axial_forces": {"up.top": 1e-4}}
    good = problem.solve(**load)
    with pytest.raises(ValueError, match=UNHELD):
        good.along.reaction("up.top")
    assert good.along.residual.largest < 1e-11
    solve = Descent.solve

    def astray(self, starts):
        at = solve(self, starts)
        return State(at.multipliers * (1 + 1e-8), at.motion)

    monkeypatch.setattr(Descent, "solve", astray)
    with pytest.raises(ArithmeticError, match="violates the contact laws"):
        problem.solve(**load)
