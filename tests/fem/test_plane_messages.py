"""A problem that makes no sense is refused, and the message names what is wrong with it."""

from dataclasses import replace
from math import inf, nan

import numpy as np
import pytest
from skfem import MeshQuad1, MeshTri1

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

STEEL = Elastic(E=210e9, nu=0.3)


def square(shape=MeshQuad1, cells=4, origin=(0.0, 0.0)):
    grid = shape.init_tensor(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1))
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


@pytest.mark.parametrize(
    "changed",
    [
        {"supports": {"bore": "xy"}},
        {"pressures": {"bore": 1.0}},
        {"tractions": {"bore": (1.0, 0.0)}},
    ],
    ids=lambda c: next(iter(c)),
)
def test_an_unknown_boundary_is_named_beside_the_known_ones(changed):
    with pytest.raises(ValueError, match=r"no boundary 'bore'.*bottom, left, right, top"):
        solve(**changed)


@pytest.mark.parametrize(
    "read",
    [
        pytest.param(lambda s: s.on_boundary("bore"), id="on_boundary"),
        pytest.param(lambda s: s.reaction("bore"), id="reaction"),
        pytest.param(lambda s: s.mean_displacement("bore", (1, 0)), id="mean_displacement"),
    ],
)
def test_a_solution_has_no_boundary_that_the_mesh_has_not(read):
    with pytest.raises(ValueError, match=r"no boundary 'bore'.*bottom, left, right, top"):
        read(solve())


@pytest.mark.parametrize(
    "changed",
    [
        {"materials": {"west": STEEL, "sleeve": STEEL}},
        {"body_forces": {"sleeve": (0.0, -1.0)}},
    ],
    ids=lambda c: next(iter(c)),
)
def test_an_unknown_body_is_named_beside_the_known_ones(changed):
    with pytest.raises(ValueError, match=r"no body 'sleeve'.*east, west"):
        solve(**changed)


def test_a_mesh_without_names_says_so():
    bare = MeshTri1.init_refdom()
    with pytest.raises(ValueError, match=r"no boundary 'left'.*none"):
        solve(bare)
    with pytest.raises(ValueError, match=r"no body 'west'.*none"):
        solve(bare, materials={"west": STEEL})


def test_cells_without_a_material_are_counted():
    with pytest.raises(ValueError, match="8 of 16 cells have no material"):
        solve(materials={"west": STEEL})


@pytest.mark.parametrize(
    ("supports", "free"),
    [
        pytest.param({}, "body 1 of 1", id="none at all"),
        pytest.param({"left": "x"}, r"\+1 y|-1 y", id="free to slide along y"),
        pytest.param({"bottom": "n", "top": "n"}, r"\+1 x|-1 x", id="free to slide along x"),
    ],
)
def test_the_motion_that_the_supports_leave_is_named(supports, free):
    with pytest.raises(ValueError, match=rf"can move rigidly \(.*({free}).*|{free}"):
        solve(supports=supports)


def test_a_body_that_may_turn_about_its_anchor_is_refused():
    with pytest.raises(ValueError, match="rotation"):
        solve(supports={}, anchors={(0, 0): "xy"})


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


def test_the_second_of_two_bodies_needs_a_support_of_its_own():
    with pytest.raises(ValueError, match="body 2 of 2 can move rigidly"):
        solve(two_squares())
    solved = solve(two_squares(), supports={"left": "xy", "far": "xy"})
    assert not solved.u.any()


@pytest.mark.parametrize("load", [(0.0, -1.0), (1.0, 1.0), (0.0, 0.0)], ids=str)
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("shape", [MeshTri1, MeshQuad1])
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
    "changed",
    [{"supports": {"left": "xy", "weld": "n"}}, {"pressures": {"weld": 1.0}}],
    ids=lambda c: next(iter(c)),
)
def test_a_boundary_inside_the_mesh_has_no_normal(changed):
    mesh = square().with_boundaries({"weld": lambda x: x[0] == 0.5}, boundaries_only=False)
    with pytest.raises(ValueError, match=r"'weld'.*inside"):
        solve(mesh, **changed)


@pytest.mark.parametrize(
    "supports",
    [
        pytest.param({"left": {"x": 0.0}, "bottom": {"x": 1.0, "y": 0.0}}, id="at a corner"),
        pytest.param({"left": {"x": 0.0, "n": 1.0, "y": 0.0}}, id="along a side"),
    ],
)
def test_supports_that_contradict_each_other_are_refused(supports):
    with pytest.raises(ValueError, match="contradict"):
        solve(supports=supports)


def test_supports_that_agree_may_overlap():
    solved = solve(supports={"left": {"x": 0.5, "y": 0.0, "n": -0.5}, "bottom": {"y": 0.0}})
    assert solved.displacement_at((0, 0)) == pytest.approx((0.5, 0.0), abs=1e-15)


@pytest.mark.parametrize("nu", [0.5, 0.7, -1.0, nan, inf])
def test_poissons_ratio_is_refused_outside_its_interval(nu):
    with pytest.raises(ValueError, match=rf"\(-1, 0\.5\), got nu={nu:g}"):
        Elastic(E=1.0, nu=nu)


@pytest.mark.parametrize("E", [0.0, -1.0, nan, inf])
def test_youngs_modulus_is_refused_unless_positive_and_finite(E):
    with pytest.raises(ValueError, match=rf"positive and finite, got E={E:g}"):
        Elastic(E=E, nu=0.3)


def test_an_unknown_assumption_is_refused_beside_the_known_ones():
    with pytest.raises(ValueError, match=r"'plane stress', 'axisymmetric', got 'plain strain'"):
        solve(assumption="plain strain")


@pytest.mark.parametrize("thickness", [0.0, -1.0, nan])
def test_a_thickness_that_is_not_positive_is_refused(thickness):
    with pytest.raises(ValueError, match=f"thickness must be positive, got {thickness:g}"):
        solve(thickness=thickness)


@pytest.mark.parametrize("degree", [3, -1])
def test_a_degree_without_element_is_refused(degree):
    with pytest.raises(ValueError, match=f"degree 1 or 2, got degree={degree}"):
        solve(degree=degree)


@pytest.mark.parametrize("support", ["z", {"r": 0.0}, "x y"], ids=str)
def test_an_unknown_component_is_named_with_its_boundary(support):
    with pytest.raises(ValueError, match=r"'left'.*x, y, n, t, got"):
        solve(supports={"left": support})


def test_an_anchor_has_no_normal():
    with pytest.raises(ValueError, match=r"\(1, 1\).*no normal"):
        solve(anchors={(1, 1): "n"})


@pytest.mark.parametrize(
    "changed",
    [{"anchors": {(0.6, 0.5): "x"}}, {"point_forces": {(0.6, 0.5): (1.0, 0.0)}}],
    ids=lambda c: next(iter(c)),
)
@pytest.mark.parametrize(
    "origin",
    [(0, 0), (1e3, 1e3), (1e6, 0), (0, -1e6)],
    ids=lambda o: f"square at ({o[0]:g}, {o[1]:g})",
)
def test_a_point_beside_the_nodes_is_refused_with_its_distance(changed, origin):
    # the nodes lie 0.25 apart, the nearest at (0.5, 0.5)
    load, values = next(iter(changed.items()))
    moved = {load: {tuple(np.add(point, origin)): v for point, v in values.items()}}
    with pytest.raises(ValueError, match=r"no node at .* nearest is 0\.1 away"):
        solve(square(origin=origin), **moved)


@pytest.mark.parametrize(
    "read",
    [
        pytest.param(lambda s: s.displacement_at((0.6, 0.5)), id="displacement_at"),
        pytest.param(lambda s: s.reaction_at((0.6, 0.5)), id="reaction_at"),
    ],
)
def test_nothing_is_read_beside_the_nodes(read):
    with pytest.raises(ValueError, match=r"no node at .* nearest is 0\.1 away"):
        read(solve())


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
