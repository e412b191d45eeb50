"""Totals around the turn: loads, reactions, work; each of them without any mesh's error."""

from dataclasses import replace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import mapped

STEEL = Elastic(E=210e9, nu=0.3)
EXACT = 1e-10  # relative; solver and rounding


def cone(kind, bore=0.0):
    """A truncated cone of height 1, radius 2 below and 1 above, solid or with a bore."""
    unit, names = np.linspace(0, 1, 5), ("bore", "flank", "bottom", "top")
    mesh = mapped(kind, unit, unit, names=names, split=0.5)
    mesh = mesh.with_boundaries({"inner": lambda x: x[0] == 0.5}, boundaries_only=False)
    s, t = mesh.doflocs
    return replace(mesh, doflocs=np.array([bore + (2 - t - bore) * s, t]))


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
        pytest.param(
            {"body_forces": {"west": (0.0, -5.0)}}, -5 * 7 / 12 * np.pi, id="the core's weight"
        ),
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


def test_radial_forces_do_the_virtual_work_of_the_stresses():
    # for the virtual displacement u_r = r, whose strains are radial 1 and hoop 1
    s = solve(
        cone("tri3", bore=0.5), supports={"bottom": "y", "flank": "xy"}, pressures={"bore": 9}
    )
    inside = s.in_body()
    virtual = inside.mean(inside.stress[0] + inside.stress[3]) * inside.weight.sum()
    held = s.conditions.forces(s.internal - s.f) * s.conditions.direction[0]
    radii = s.basis.doflocs[0, s.conditions.dofs[0]]
    load = 9 * 2 * np.pi * 0.5 * 0.5  # pressure on the bore's area 2 pi 0.5, moved by 0.5
    assert held @ radii + load == pytest.approx(virtual, rel=1e-8)


def test_reactions_on_the_axis_count_axial_forces_alone():
    s = solve(cone("tri6"), supports={"bore": "xy"}, pressures={"flank": 5.0})
    x, y, _ = s.reaction("bore")
    assert x == 0
    assert y == pytest.approx(5 * 3 * np.pi, rel=EXACT)
    again = solve(cone("tri6"), supports={"bore": "y"}, pressures={"flank": 5.0})
    np.testing.assert_allclose(again.u, s.u, atol=1e-12 * abs(s.u).max())


def test_a_spread_force_in_the_plane_is_a_total_for_any_thickness():
    grid = cone("quad9")
    for thickness in (1.0, 0.25):
        s = solve_plane(
            grid, materials=STEEL, assumption="plane stress", thickness=thickness,
            supports={"bottom": "xy"}, forces={"flank": (3.0, -4.0), "inner": (1.0, 0.0)},
        )  # fmt: skip
        assert s.reaction("bottom")[:2] == pytest.approx((-4.0, 4.0), rel=1e-9)
    flank, inner = 0.25 * np.sqrt(2), 0.25 * np.sqrt(1.25)  # areas: the slant heights times 0.25
    same = solve_plane(
        grid, materials=STEEL, assumption="plane stress", thickness=0.25,
        supports={"bottom": "xy"},
        tractions={"flank": (3 / flank, -4 / flank), "inner": (1 / inner, 0.0)},
    )  # fmt: skip
    np.testing.assert_allclose(s.f, same.f, atol=1e-12)


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
