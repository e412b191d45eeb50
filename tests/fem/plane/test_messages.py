"""An invalid problem is refused, and the message names the error."""

import re
from dataclasses import replace
from math import inf, nan, pi

import numpy as np
import pytest
from skfem import MeshQuad1, MeshTri1

from fem.plane.material import Elastic
from fem.plane.means import Mean
from fem.plane.solve import solve_plane
from fem.plane.ties import Tie
from tests.fem.cyclic_rings import ring, sector
from tests.fem.plane.models import mapped

STEEL = Elastic(E=210e9, nu=0.3)


def square(origin=(0.0, 0.0)):
    axis, (x, y) = np.linspace(0, 1, 5), origin
    return mapped("quad4", axis, axis, lambda s, t: (s + x, t + y), split=0.5)


def two_squares():
    """With a gap of 1 between them; only the first has names."""
    first = MeshQuad1.init_tensor(np.linspace(0, 1, 3), np.linspace(0, 1, 3))
    mesh = first + MeshQuad1.init_tensor(np.linspace(2, 3, 3), np.linspace(0, 1, 3))
    return mesh.with_boundaries({"left": lambda x: x[0] == 0, "far": lambda x: x[0] == 3})


def solve(mesh=None, **changed):
    """The unit square, clamped at its left, with something `changed`."""
    problem = {"materials": STEEL, "assumption": "plane strain", "supports": {"left": "xy"}}
    return solve_plane(square() if mesh is None else mesh, **(problem | changed))


KNOWN = r"no boundary 'bore'.*bottom, left, right, top"
BARE, RIGID = MeshTri1.init_refdom(), r"can move rigidly \(.*"


def welded():
    return square().with_boundaries({"weld": lambda x: x[0] == 0.5}, boundaries_only=False)


@pytest.mark.parametrize(
    ("mesh", "changed", "message"),
    [
        (square, {"supports": {"bore": "xy"}}, KNOWN),
        (square, {"materials": {"west": STEEL, "sleeve": STEEL}}, "no body 'sleeve'.*east, west"),
        (lambda: BARE, {}, "no boundary 'left'.*none"),
        (square, {"materials": {"west": STEEL}}, "8 of 16 cells have no material"),
        (square, {"supports": {"left": "x"}}, RIGID + "1 y"),
        (square, {"supports": {}, "anchors": {(0, 0): "xy"}}, "rotation"),
        (two_squares, {}, "body 2 of 2 can move rigidly"),
        (welded, {"supports": {"left": "xy", "weld": "n"}}, "'weld'.*inside"),
        (square, {"supports": {"left": {"x": 0.0}, "bottom": {"x": 1.0, "y": 0.0}}}, "contradict"),
        (square, {"assumption": "plain strain"},
         "'plane stress', 'axisymmetric', got 'plain strain'"),
        (square, {"thickness": 0.0}, "thickness must be positive, got 0"),
        (square, {"degree": 3}, "degree 1 or 2, got degree=3"),
        (square, {"supports": {"left": "z"}}, "support 'left': components must be x, y, n"),
        (square, {"anchors": {(1, 1): "n"}}, r"anchor at \(1, 1\): components must be x or"),
    ],
)  # fmt: skip
def test_a_problem_that_makes_no_sense_is_named(mesh, changed, message):
    with pytest.raises(ValueError, match=message):
        solve(mesh(), **changed)


@pytest.mark.parametrize(
    ("shape", "degree", "load"), [(MeshTri1, 1, (0.0, 0.0)), (MeshQuad1, 2, (1.0, 1.0))]
)
def test_two_squares_that_touch_in_one_corner_are_no_body(shape, degree, load):
    # the second can turn about the corner: a mechanism, whether or not the load turns it
    axis = np.linspace(0, 2, 5)
    grid = shape.init_tensor(axis, axis)
    east, north = grid.p[:, grid.t].mean(axis=1) > 1
    corner = grid.remove_elements(np.flatnonzero(east != north)).with_boundaries({
        "left": lambda x: x[0] == 0
    })  # fmt: skip
    with pytest.raises(ValueError, match=r"rigidly|turn|hinge|mechanism"):
        solve(corner, body_forces=load, degree=degree)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: solve().on_boundary("bore"), KNOWN),
        (lambda: solve().displacement_at((0.6, 0.5)), "distance to the nearest node is"),
        (lambda: solve(anchors={(0.6, 0.5): "x"}), "distance to the nearest node is"),
        (lambda: solve(square((1e6, 0.0)), point_forces={(1e6 + 0.6, 0.5): (1.0, 0.0)}),
         "distance to the nearest node is"),
        (lambda: Elastic(E=1.0, nu=0.5), r"\(-1, 0\.5\), got nu=0.5"),
        (lambda: Elastic(E=1.0, nu=-1.0), r"\(-1, 0\.5\), got nu=-1"),
        (lambda: Elastic(E=inf, nu=0.3), "positive and finite, got E=inf"),
    ],
)  # fmt: skip
def test_nothing_is_read_where_the_mesh_has_nothing_and_a_material_must_exist(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")
def test_a_load_that_is_no_number_has_no_answer():
    for changed in (
        {"pressures": {"right": nan}}, {"tractions": {"right": (inf, 0.0)}},
        {"body_forces": (0.0, nan)}, {"point_forces": {(1, 1): (nan, 0.0)}},
    ):  # fmt: skip
        with pytest.raises((ValueError, ArithmeticError)):
            solve(**changed)


def cyclic_body(mesh, **changed):
    return solve(mesh, **{"supports": {"bore": "xy"}} | changed)


FIFTH = Tie(leader="first cut", follower="last cut", angle=2 * pi / 5)


@pytest.mark.parametrize(
    ("tie", "words"),
    [
        ({"leader": "bore", "angle": 2 * pi / 5}, "got 7 for 13: use equal meshes"),
        ({"leader": "first cut", "angle": -2 * pi / 5}, "node at (0.92203, -1.3"),
        ({"leader": "cut"}, "no boundary 'cut'"),
        ({"leader": "first cut", "angle": np.nan}, "angle, about and shift must be finite"),
        ({"leader": "last cut"}, "leader and follower must be different"),
    ],
)
def test_a_wrong_tie_is_named_in_a_line(tie, words):
    with pytest.raises(ValueError, match=f"^[^\\n]*{re.escape(words)}[^\\n]*$"):
        cyclic_body(sector("tri6", 5), ties=[Tie(follower="last cut", **tie)])


def test_what_a_cyclic_tie_leaves_free_and_cannot_be_around_a_turn_is_refused():
    mesh = sector("tri6", 5)
    rough = np.random.default_rng(1).uniform(-3e-8, 3e-8, mesh.doflocs.shape)
    with pytest.raises(ValueError, match=r"\+1 rotation\): support this body against this motion"):
        cyclic_body(replace(mesh, doflocs=mesh.doflocs + rough), supports={}, ties=[FIFTH])
    mesh = sector("tri6", 12, start=0.1)
    with pytest.raises(ValueError, match="tie 'last cut' to 'first cut': in a body"):
        cyclic_body(mesh, assumption="axisymmetric", ties=[replace(FIFTH, angle=2 * pi / 12)])


HELD = "a prescribed mean motion must not also be fixed"


@pytest.mark.parametrize(
    ("supports", "means", "message"),
    [
        ({"bore": "xy"}, {"bore": Mean({"x": 0.0})}, HELD),
        ({"bore": "xy"}, {"rim": Mean({"r": 0.0}), "again": Mean({"r": 1.0})}, HELD),
        ({"bore": "t"}, {"bore": Mean({"r": 0.0})}, HELD),
        ({"bore": "xy"}, {"edge": Mean({"r": 0.0})}, "no boundary 'edge'"),
        ({}, {"rim": Mean({"x": 0.0, "y": 0.0})}, "rotation"),
    ],
)
def test_means_that_are_held_already_or_hold_too_little_are_refused(supports, means, message):
    mesh = ring("quad9", 4)
    mesh = mesh.with_boundaries({"again": mesh.boundaries["rim"]})
    with pytest.raises(ValueError, match=message):
        cyclic_body(mesh, supports=supports, means=means)


def test_wrong_means_are_named():
    for held, words in (
        ({"z": 0.0}, "mean motions must be named x, y or r, got z"), ({}, "got none"),
        ({"r": np.inf}, "must be finite"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            Mean(held)
    s = cyclic_body(ring("tri3", 4), means={"rim": Mean({"r": 0.0})})
    with pytest.raises(ValueError, match="must have a prescribed mean motion"):
        s.mean_reaction("bore")
