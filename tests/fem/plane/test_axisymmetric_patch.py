"""Bodies of revolution: constant stress is exact; loads and reactions are those of 360°."""

from dataclasses import replace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, degree, mapped, tube

STEEL = Elastic(E=210e9, nu=0.3)
E, NU = STEEL.E, STEEL.nu
ROUND_OFF = 1e-12  # relative
BORES = dict(zip(KINDS, (0.0, 0.5, 0.0, 0.5, 0.0, 0.5), strict=True))  # solid and hollow in turn
every_body = pytest.mark.parametrize(("kind", "bore"), BORES.items())


@every_body
def test_constant_stress_is_exact_on_wavy_cells(kind, bore):
    pressure, pull = 70e6, 40e6
    s = solve_plane(
        tube(kind, bore), materials=STEEL, assumption="axisymmetric",
        degree=degree(kind), supports={"bottom": "y"}, tractions={"top": (0.0, pull)},
        pressures={"rim": pressure} | ({"bore": pressure} if bore else {}),
    )  # fmt: skip
    expected = np.array([[-pressure], [pull], [0.0], [-pressure]])
    strains = (-(1 - NU) * pressure - NU * pull) / E, (pull + 2 * NU * pressure) / E
    for some in (s.in_body(), *(s.on_boundary(name) for name in ("bore", "rim", "top"))):
        np.testing.assert_allclose(
            some.stress, np.broadcast_to(expected, some.stress.shape), atol=ROUND_OFF * E * 1e-3
        )
        np.testing.assert_allclose(some.u, some.x * np.reshape(strains, (2, 1)), atol=1e-15)
    # energy is half the stress times strain on the volume 2 pi, less that of the bore
    density = (-2 * pressure * strains[0] + pull * strains[1]) / 2
    volume = np.pi * (2**2 - bore**2)
    assert s.strain_energy == pytest.approx(density * volume, rel=ROUND_OFF)
    assert s.in_body().weight.sum() == pytest.approx(volume, rel=ROUND_OFF)


EXACT = 1e-10  # relative; solver and rounding


def cone(kind):
    """A solid truncated cone of height 1, radius 2 below and 1 above."""
    unit, names = np.linspace(0, 1, 5), ("bore", "flank", "bottom", "top")
    mesh = mapped(kind, unit, unit, names=names, split=0.5)
    mesh = mesh.with_boundaries({"inner": lambda x: x[0] == 0.5}, boundaries_only=False)
    s, t = mesh.doflocs
    return replace(mesh, doflocs=np.array([(2 - t) * s, t]))


def solve(mesh, **loads):
    problem = {"materials": STEEL, "assumption": "axisymmetric", "supports": {"bottom": "xy"}}
    return solve_plane(mesh, **(problem | loads))


@pytest.mark.parametrize(
    ("loads", "axial"),
    [
        pytest.param({"forces": {"top": (0.0, 5.0)}}, 5.0, id="a total force"),
        pytest.param({"forces": {"inner": (0.0, 5.0)}}, 5.0, id="a total force inside"),
        pytest.param({"tractions": {"top": (0.0, 5.0)}}, 5 * np.pi, id="a traction"),
        # the flank shows the ring between radii 1 and 2 from above
        pytest.param({"pressures": {"flank": 5.0}}, -5 * 3 * np.pi, id="a pressure"),
        pytest.param({"body_forces": (0.0, -5.0)}, -5 * 7 / 3 * np.pi, id="a weight"),
        pytest.param({"point_forces": {(1.0, 1.0): (3.0, 5.0)}}, 5.0, id="a force on a ring"),
        pytest.param({"point_forces": {(0.0, 1.0): (0.0, 5.0)}}, 5.0, id="a force on the axis"),
    ],
)
def test_the_support_carries_the_axial_loads_of_the_full_turn(loads, axial):
    s = solve(cone("tri6"), **loads)
    _, y, moment = s.reaction("bottom")
    assert y == pytest.approx(-axial, rel=EXACT)
    assert moment == 0
    assert s.strain_energy == pytest.approx(s.f @ s.u / 2, rel=EXACT)
    assert s.potential_energy == pytest.approx(-s.strain_energy, rel=EXACT)


def test_a_smooth_wall_has_an_axial_normal_at_the_pole():
    # half a hollow ball, held by a guide around it or against sliding along its wall
    mesh = mapped(
        "tri6", np.linspace(0.5, 1, 5), np.linspace(0, 1, 9),
        lambda R, t: (R * np.sin(np.pi / 2 * t), R * np.cos(np.pi / 2 * t)),
        ("bore", "rim", "pole", "equator"),
    )  # fmt: skip
    pushed = solve(mesh, supports={"equator": "y", "rim": {"n": -1e-3}})
    assert pushed.displacement_at((0.0, 1.0)) == pytest.approx((0.0, -1e-3), rel=1e-12)
    held = solve(mesh, supports={"equator": "y", "rim": "t"}, pressures={"rim": 1e6})
    assert held.displacement_at((0.0, 1.0))[1] < -1e-7


def square(kind="quad4", left=0.0):
    """Two by one, four cells a unit, from r = `left` on."""
    return mapped(kind, np.linspace(0, 2, 9), np.linspace(0, 1, 5)).translated((left, 0.0))


def bulging(kind):
    """An edge bulges beyond the axis: nodes at r = 0.08, 0, 0, and r < 0 between the last."""
    mesh = square(kind)
    x = mesh.doflocs.copy()
    x[0, (x[0] == 0) & (x[1] == 0)] = 0.08
    return replace(mesh, doflocs=x)


def solve_square(mesh=None, **changed):
    problem = {"materials": STEEL, "assumption": "axisymmetric"}
    problem["supports"] = {"bottom": "y"}
    return solve_plane(square() if mesh is None else mesh, **(problem | changed))


@pytest.mark.parametrize(("shape", "off"), [("tri6", -1e-16), ("quad4", 1e-16)])
def test_nodes_off_the_axis_by_round_off_lie_on_it(shape, off):
    near, on = (solve_square(square(shape, left), pressures={"top": 1e6}) for left in (off, 0.0))
    np.testing.assert_allclose(near.u, on.u, rtol=0, atol=1e-12 * abs(on.u).max())
    assert near.on_boundary("left").weight.sum() == pytest.approx(1)
    with pytest.raises(ValueError, match="boundary 'left' has no area for a load"):
        solve_square(square(shape, off), pressures={"left": 1e6})
    with pytest.raises(ValueError, match="must be axial, because the point is on the axis"):
        solve_square(square(shape, off), point_forces={(off, 1.0): (1.0, 0.0)})


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"thickness": 2.0}, r"the thickness of a body of revolution must"),
        ({"point_forces": {(0.0, 1.0): (3.0, 1.0)}},
         r"the point force at \(0.0, 1.0\) must be"),
        ({"forces": {"right": (3.0, 1.0)}}, r"the force on 'right' has the radial"),
        ({"forces": {"left": (0.0, 1.0)}}, r"boundary 'left' has no area for a load.*r = 0"),
        ({"mesh": square("tri3", -1e-6)}, r"^cell \d+ of \d+, about \(.*\), reaches r = -.*r >= 0"),
        ({"mesh": bulging("tri6")}, r"^cell .* reaches r = -0.01: "),
        ({"mesh": bulging("quad9")}, r"^cell .* reaches r = -0.01: "),
        ({"supports": {}}, r"body 1 of 1 can move rigidly \(\+1 y\): support"),
        ({"supports": {"bottom": {"x": 1e-3, "y": 0.0}}},
         r"at the node \(0, 0\), the supports 'bottom', 'the axis'"),
    ],
    ids=str,
)  # fmt: skip
def test_the_message_names_rule_and_place(changed, message):
    with pytest.raises(ValueError, match=message):
        solve_square(**changed)
