"""A body of revolution that makes no sense is refused, and the message names what is wrong."""

from dataclasses import replace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import mapped


def square(kind="quad4", left=0.0):
    """Two by one, four cells a unit, from r = `left` on."""
    return mapped(kind, np.linspace(0, 2, 9), np.linspace(0, 1, 5)).translated((left, 0.0))


def solve(mesh=None, **changed):
    problem = {"materials": Elastic(E=210e9, nu=0.3), "assumption": "axisymmetric"}
    problem["supports"] = {"bottom": "y"}
    return solve_plane(square() if mesh is None else mesh, **(problem | changed))


@pytest.mark.parametrize(("shape", "left"), [("tri3", -1e-6), ("quad9", -3.0)])
def test_a_cell_beyond_the_axis_is_named_with_its_place(shape, left):
    with pytest.raises(ValueError, match=r"^cell \d+ of \d+, about \(.*\), reaches r = -.*r >= 0"):
        solve(square(shape, left))


@pytest.mark.parametrize("shape", ["tri6", "quad9"])
def test_an_edge_that_bulges_beyond_the_axis_is_named(shape):
    mesh = square(shape)
    x = mesh.doflocs.copy()
    x[0, (x[0] == 0) & (x[1] == 0)] = 0.08  # nodes at r = 0.08, 0, 0: beyond r = 0 between the last
    with pytest.raises(ValueError, match=r"^cell .* reaches r = -0.01: "):
        solve(replace(mesh, doflocs=x))


@pytest.mark.parametrize(("shape", "off"), [("tri6", -1e-16), ("quad4", 1e-16)])
def test_nodes_off_the_axis_by_round_off_lie_on_it(shape, off):
    near, on = (solve(square(shape, left), pressures={"top": 1e6}) for left in (off, 0.0))
    np.testing.assert_allclose(near.u, on.u, rtol=0, atol=1e-12 * abs(on.u).max())
    assert near.on_boundary("left").weight.sum() == pytest.approx(1)
    with pytest.raises(ValueError, match="load on 'left' has no area"):
        solve(square(shape, off), pressures={"left": 1e6})
    with pytest.raises(ValueError, match="on the axis a force can only be axial"):
        solve(square(shape, off), point_forces={(off, 1.0): (1.0, 0.0)})


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"thickness": 2.0}, r"no thickness but its turn, got 2"),
        ({"point_forces": {(0.0, 1.0): (3.0, 1.0)}},
         r"point force at \(0.0, 1.0\) has the radial part 3: on the axis"),
        ({"forces": {"right": (3.0, 1.0)}}, r"force on 'right' has the radial part 3"),
        ({"forces": {"left": (0.0, 1.0)}}, r"load on 'left' has no area.*r = 0"),
        ({"pressures": {"left": 1.0}}, r"load on 'left' has no area"),
        ({"forces": {"top": (0.0, np.inf)}}, r"not finite"),
        ({"forces": {"rim": (0.0, 1.0)}}, r"no boundary 'rim'"),
        ({"supports": {}}, r"body 1 of 1 can move rigidly \(\+1 y\): support"),
        ({"supports": {"bottom": {"x": 1e-3, "y": 0.0}}},
         r"^at \(0, 0\), held by 'bottom', 'the axis': .* contradict each other"),
    ],
    ids=str,
)  # fmt: skip
def test_the_message_names_rule_and_place(changed, message):
    with pytest.raises(ValueError, match=message):
        solve(**changed)


def test_a_guide_keeps_its_slope_at_the_apex_of_a_cone():
    # a cup's cone rises by 1 to 2: moved by 1e-3 along its normal it lifts the body rigidly
    mesh = square()
    x, y = mesh.doflocs
    cup = replace(mesh, doflocs=np.array([x, 2 * y + x / 2 * (1 - y)]))
    s = solve(cup, supports={"bottom": {"n": -1e-3}})
    lift = 1e-3 * np.hypot(1, 0.5)
    np.testing.assert_allclose(s.in_body().u[1], lift, rtol=1e-9)


def test_a_cone_in_a_frictionless_seat_does_not_move():
    mesh = square()
    x, y = mesh.doflocs
    seat = replace(mesh, doflocs=np.array([x * (1 + y), y]))
    s = solve(seat, supports={"right": "n"}, pressures={"top": 1e6})
    assert s.reaction("right")[1] == pytest.approx(1e6 * np.pi * 4**2, rel=1e-9)
