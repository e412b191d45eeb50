"""A problem that makes no sense is refused, and the message names what is wrong with it."""

from dataclasses import replace
from math import inf, nan

import numpy as np
import pytest
from skfem import MeshQuad1, MeshTri1

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

STEEL = Elastic(E=210e9, nu=0.3)


def square(origin=(0.0, 0.0)):
    grid = MeshQuad1.init_tensor(np.linspace(0, 1, 5), np.linspace(0, 1, 5))
    mesh = grid.with_boundaries({
        "left": lambda x: x[0] == 0,
        "right": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0,
        "top": lambda x: x[1] == 1,
    }).with_subdomains({"west": lambda x: x[0] < 0.5, "east": lambda x: x[0] > 0.5})  # fmt: skip
    return replace(mesh, doflocs=mesh.doflocs + np.reshape(origin, (2, 1)))


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
        (square, {"pressures": {"bore": 1.0}}, KNOWN),
        (square, {"tractions": {"bore": (1.0, 0.0)}}, KNOWN),
        (square, {"materials": {"west": STEEL, "sleeve": STEEL}}, "no body 'sleeve'.*east, west"),
        (square, {"body_forces": {"sleeve": (0.0, -1.0)}}, "no body 'sleeve'.*east, west"),
        (lambda: BARE, {}, "no boundary 'left'.*none"),
        (lambda: BARE, {"materials": {"west": STEEL}}, "no body 'west'.*none"),
        (square, {"materials": {"west": STEEL}}, "8 of 16 cells have no material"),
        (square, {"supports": {}}, "body 1 of 1"),
        (square, {"supports": {"left": "x"}}, RIGID + "1 y"),
        (square, {"supports": {}, "anchors": {(0, 0): "xy"}}, "rotation"),
        (two_squares, {}, "body 2 of 2 can move rigidly"),
        (welded, {"supports": {"left": "xy", "weld": "n"}}, "'weld'.*inside"),
        (welded, {"pressures": {"weld": 1.0}}, "'weld'.*inside"),
        (square, {"supports": {"left": {"x": 0.0}, "bottom": {"x": 1.0, "y": 0.0}}}, "contradict"),
        (square, {"supports": {"left": {"x": 0.0, "n": 1.0, "y": 0.0}}}, "contradict"),
        (square, {"assumption": "plain strain"},
         "'plane stress', 'axisymmetric', got 'plain strain'"),
        (square, {"thickness": 0.0}, "thickness must be positive, got 0"),
        (square, {"thickness": nan}, "thickness must be positive, got nan"),
        (square, {"degree": 3}, "degree 1 or 2, got degree=3"),
        (square, {"supports": {"left": "z"}}, "'left'.*x, y, n, t, got"),
        (square, {"anchors": {(1, 1): "n"}}, r"\(1, 1\).*no normal"),
    ],
)  # fmt: skip
def test_a_problem_that_makes_no_sense_is_named(mesh, changed, message):
    with pytest.raises(ValueError, match=message):
        solve(mesh(), **changed)


@pytest.mark.parametrize(
    ("read", "message"),
    [
        (lambda s: s.on_boundary("bore"), KNOWN),
        (lambda s: s.reaction("bore"), KNOWN),
        (lambda s: s.mean_displacement("bore", (1, 0)), KNOWN),
        (lambda s: s.displacement_at((0.6, 0.5)), r"no node at .* nearest is 0\.1 away"),
        (lambda s: s.reaction_at((0.6, 0.5)), r"no node at .* nearest is 0\.1 away"),
    ],
)
def test_nothing_is_read_where_the_mesh_has_nothing(read, message):
    with pytest.raises(ValueError, match=message):
        read(solve())


def test_a_ring_free_to_turn_in_its_round_guide_is_refused():
    # four quarters of a ring of 24 cells around, every rim vertex with a radial mean normal
    grid = MeshQuad1.init_tensor(np.linspace(1, 2, 3), np.linspace(0, 2 * np.pi, 25))
    r, phi = grid.doflocs
    p = np.array([r * np.cos(phi), r * np.sin(phi)])
    p, number = np.unique(p.round(12), axis=1, return_inverse=True)  # joins 0 and 360 deg
    ring = MeshQuad1(p, number.ravel()[grid.t]).with_boundaries({
        "rim": lambda x: np.hypot(*x) > 1.9
    })  # fmt: skip
    with pytest.raises(ValueError, match="rotation"):
        solve(ring, supports={"rim": "n"})


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


def test_supports_that_agree_may_overlap():
    solved = solve(supports={"left": {"x": 0.5, "y": 0.0, "n": -0.5}, "bottom": {"y": 0.0}})
    assert solved.displacement_at((0, 0)) == pytest.approx((0.5, 0.0), abs=1e-15)


@pytest.mark.parametrize("nu", [0.5, -1.0, nan])
def test_poissons_ratio_is_refused_outside_its_interval(nu):
    with pytest.raises(ValueError, match=rf"\(-1, 0\.5\), got nu={nu:g}"):
        Elastic(E=1.0, nu=nu)


@pytest.mark.parametrize("E", [0.0, inf])
def test_youngs_modulus_is_refused_unless_positive_and_finite(E):
    with pytest.raises(ValueError, match=rf"positive and finite, got E={E:g}"):
        Elastic(E=E, nu=0.3)


@pytest.mark.parametrize(
    "changed",
    [{"anchors": {(0.6, 0.5): "x"}}, {"point_forces": {(0.6, 0.5): (1.0, 0.0)}}],
    ids=lambda c: next(iter(c)),
)
def test_a_point_beside_the_nodes_is_refused_with_its_distance(changed):
    origin = (1e6, 0)
    # the nodes lie 0.25 apart, the nearest at (0.5, 0.5)
    load, values = next(iter(changed.items()))
    moved = {load: {tuple(np.add(point, origin)): v for point, v in values.items()}}
    with pytest.raises(ValueError, match=r"no node at .* nearest is 0\.1 away"):
        solve(square(origin=origin), **moved)


@pytest.mark.parametrize(
    "changed",
    [
        {"pressures": {"right": nan}},
        {"tractions": {"right": (inf, 0.0)}},
        {"body_forces": (0.0, nan)},
        {"point_forces": {(1, 1): (nan, 0.0)}},
    ],
    ids=lambda c: next(iter(c)),
)
@pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")
def test_a_load_that_is_no_number_has_no_answer(changed):
    with pytest.raises((ValueError, ArithmeticError)):
        solve(**changed)
