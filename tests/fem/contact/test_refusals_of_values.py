"""Values that contradict the mesh or each other are refused, not solved for something else."""

import pytest

from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.contact.block import block
from meshes.contact.disc import half_disc
from meshes.join import join

STEEL = Elastic(E=210e9, nu=0.3)
TOUCH = Pair(slave="a.bottom", master="b.top", friction=0.2)
LID = Flat((0, 2), (0, -1))


@pytest.fixture(scope="module")
def blocks():
    return join({"a": block(x=(0, 1), y=(1, 2), nx=4, ny=2),
                 "b": block(x=(0, 1), y=(0, 1), nx=5, ny=2)})  # fmt: skip


def problem(mesh, **changes):
    given = {"materials": STEEL, "assumption": "plane strain", "supports": {"b.bottom": "xy"},
             "contacts": [TOUCH]}  # fmt: skip
    return ContactProblem(mesh, **(given | changes))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"materials": {"a": STEEL, "b": 3.0}}, "material of 'b' is Elastic or Rigid, got 3.0"),
        ({"materials": Rigid()}, "materials are Elastic, or a mapping"),
        ({"materials": None}, "materials are Elastic, or a mapping"),
        ({"contacts": [TOUCH, TOUCH]}, "paired twice"),
        ({"contacts": [TOUCH, Pair(slave="b.top", master="a.bottom")]}, "paired twice"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top", slave_shape=Circle((0, 3), 1.0))]},
         "'a.bottom' is not of the shape"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top", slave_shape=Flat((0, 1), (0, 1)))]},
         "has its body beyond it"),
        ({"contacts": [Pair(slave="a.bottom", master="b.top", master_shape=Flat((0, 1.01)))]},
         "'b.top' is not of the shape"),
        ({"degree": 0}, "degree 1 or 2, got degree=0"),
    ],
)  # fmt: skip
def test_a_set_up_that_contradicts_itself_names_what_is_wrong(blocks, changes, message):
    with pytest.raises(ValueError, match=message):
        problem(blocks, **changes)


def test_an_obstacle_has_each_motion_once():
    with pytest.raises(ValueError, match="free motions are of x, y and r, got 'yy'"):
        Obstacle(LID, free="yy")


@pytest.mark.parametrize(("free", "force"), [("", (0, -1e3)), ("y", (5.0, -1e3))])
def test_a_force_on_a_motion_that_is_held_is_not_dropped(blocks, free, force):
    under = problem(
        blocks, contacts=[TOUCH, Pair(slave="a.top", master="lid", friction=0.2)],
        obstacles={"lid": Obstacle(LID, free=free)},
    )  # fmt: skip
    with pytest.raises(ValueError, match="which is not free: its free motions are"):
        under.solve(forces={"lid": force})


def test_a_step_comes_after_one_of_its_own_problem(blocks):
    first, second = problem(blocks), problem(blocks)
    step = first.solve(forces={"a.top": (0, -1e3)})
    with pytest.raises(ValueError, match="belongs to another contact problem"):
        second.solve(forces={"a.top": (0, -2e3)}, after=step)


def test_no_load_is_no_error(blocks):
    assert problem(blocks).solve().touches[0].normal_force == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("what", ["anchors", "point_forces"])
def test_a_point_that_two_bodies_share_is_ambiguous(blocks, what):
    given = {what: {(0.0, 1.0): "x" if what == "anchors" else (0.0, -1.0)}}
    with pytest.raises(ValueError, match=r"several nodes at \(0.0, 1.0\)"):
        solve_plane(
            blocks, materials=STEEL, assumption="plane strain",
            supports={"b.bottom": "xy", "a.top": "xy"}, **given,
        )  # fmt: skip


def test_the_motion_that_is_named_is_the_one_that_is_free(blocks):
    smooth = Pair(slave="a.bottom", master="b.top")
    with pytest.raises(ValueError, match=r"can move rigidly \(\+1 x\): neither supports"):
        problem(blocks, contacts=[smooth])


@pytest.mark.parametrize("friction", [0.3, 0.5])
def test_friction_that_makes_the_exchanges_circle_is_solved_all_the_same(friction):
    # pressed against a rigid flat, a disc's surface creeps inwards: slip outside, stick inside
    R = 10e-3
    disc = ContactProblem(
        half_disc(R=R, zone=0.28e-3, refine=2), materials=STEEL, assumption="plane strain",
        supports={"middle": "xy"}, obstacles={"flat": Obstacle(Flat(), free="xy")},
        contacts=[
            Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R), friction=friction)
        ],
    )  # fmt: skip
    step = disc.solve(forces={"flat": (0, 1e6)})
    touch = step.touches[0]
    assert len(step.changes) < 200
    assert touch.force == pytest.approx((0, -1e6), abs=1e-2)
    assert touch.sticks.any()
    assert (touch.closed & ~touch.sticks).any()
    assert touch.friction_force == pytest.approx(0, abs=1e-2)  # left and right pull alike
