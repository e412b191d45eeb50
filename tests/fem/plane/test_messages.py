"""A problem that makes no sense is refused, and the message names what is wrong with it."""

from math import inf, nan

import numpy as np
import pytest
from skfem import MeshQuad1, MeshTri1

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
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
        (square, {"supports": {"left": "z"}}, "'left'.*x, y, n, t, got"),
        (square, {"anchors": {(1, 1): "n"}}, r"\(1, 1\).*no normal"),
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
        (lambda: solve().displacement_at((0.6, 0.5)), r"no node at .* nearest is 0\.1 away"),
        (lambda: solve(anchors={(0.6, 0.5): "x"}), r"no node at .* nearest is 0\.1 away"),
        (lambda: solve(square((1e6, 0.0)), point_forces={(1e6 + 0.6, 0.5): (1.0, 0.0)}),
         r"no node at .* nearest is 0\.1 away"),
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
