"""Patch tests: a uniform pressure passes a contact of meshes that do not match, to round-off."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.join import join

P = 0.01  # pressure, any
EXACT = 1e-8  # relative
TILT = np.deg2rad(33)
two_meshes = pytest.mark.parametrize(
    ("cells", "order", "swap"), [("quad", 2, False), ("tri", 1, True)], ids=["quad", "swapped tri"]
)


def turned(mesh, angle):
    c, s = np.cos(angle), np.sin(angle)
    return replace(mesh, doflocs=np.array([[c, -s], [s, c]]) @ mesh.doflocs)


def pair(slave, master, swap, friction=0.0):
    if swap:
        slave, master = master, slave
    return Pair(slave=slave, master=master, friction=friction)


def normal_stress(solution, angle=0.0):
    """Stress across a layer that is turned by `angle`."""
    x, y = -np.sin(angle), np.cos(angle)
    xx, yy, xy, _ = solution.plane.in_body().stress
    return xx * x * x + yy * y * y + 2 * xy * x * y


def assert_uniform(solution, angle=0.0):
    np.testing.assert_allclose(normal_stress(solution, angle), -P, rtol=EXACT)
    for touch in solution.touches:
        np.testing.assert_allclose(touch.pressure, P, rtol=EXACT)
        np.testing.assert_allclose(touch.traction, 0.0, atol=EXACT * P)
        assert np.all(touch.closed)


def stack(cells, order):
    """Three blocks one above the other, whose nodes do not meet."""
    make = {"cells": cells, "order": order}
    return join(
        {
            "top": block(x=(0, 1), y=(2, 2.6), nx=6, ny=3, **make),
            "middle": block(x=(0, 1), y=(1, 2), nx=7, ny=2, **make),
            "low": block(x=(0, 1), y=(0, 1), nx=5, ny=3, **make),
        }
    )


@pytest.mark.parametrize(
    ("cells", "order", "swap", "assumption"),
    [
        ("quad", 1, False, "plane strain"),
        ("quad", 2, True, "plane stress"),
        ("tri", 1, True, "plane stress"),
        ("tri", 2, False, "plane strain"),
    ],
)
def test_three_materials_in_a_stack_pass_a_pressure_on(cells, order, swap, assumption):
    sides = [f"{body}.left" for body in ("low", "middle", "top")]
    problem = ContactProblem(
        turned(stack(cells, order), TILT), assumption=assumption, thickness=0.7,
        materials={"top": Elastic(E=5.0, nu=0.2), "middle": Elastic(E=3.0, nu=0.3),
                   "low": Elastic(E=1.0, nu=0.0)},
        supports={"low.bottom": "n"} | dict.fromkeys(sides, "n"),
        contacts=[pair("middle.bottom", "low.top", swap), pair("top.bottom", "middle.top", swap)],
    )  # fmt: skip
    s = problem.solve(pressures={"top.top": P})
    assert_uniform(s, TILT)
    for touch in s.touches:
        assert np.hypot(*touch.force) == pytest.approx(0.7 * P, rel=EXACT)


@two_meshes
def test_plates_around_an_axis_pass_a_pressure_on(cells, order, swap):
    bore = 0.5 if swap else 0.0
    make = {"cells": cells, "order": order}
    mesh = join({
        "up": block(x=(bore, 1), y=(1, 2), nx=7, ny=3, **make),
        "low": block(x=(bore, 1), y=(0, 1), nx=5, ny=3, **make),
    })  # fmt: skip
    s = ContactProblem(
        mesh, materials={"up": Elastic(E=3.0, nu=0.3), "low": Elastic(E=1.0, nu=0.2)},
        assumption="axisymmetric", supports={"low.bottom": "y"},
        contacts=[pair("up.bottom", "low.top", swap)],
    ).solve(pressures={"up.top": P})  # fmt: skip
    assert_uniform(s)
    assert abs(s.touches[0].force[1]) == pytest.approx(P * np.pi * (1 - bore**2), rel=EXACT)
    np.testing.assert_allclose(s.plane.in_body().stress[[0, 3]], 0.0, atol=EXACT * P)


def foundation(cells, order):
    """One by half, its top named "top", the part of it beside the punch "free"."""
    straight, curved = (MeshQuad1, MeshQuad2) if cells == "quad" else (MeshTri1, MeshTri2)
    mesh = straight.init_tensor(np.linspace(0, 1, 11), np.linspace(0, 0.5, 6))
    mesh = mesh if order == 1 else curved.from_mesh(mesh)
    return mesh.with_boundaries({
        "bottom": lambda x: x[1] == 0,
        "left": lambda x: x[0] == 0,
        "top": lambda x: x[1] == 0.5,
        "free": lambda x: (x[1] == 0.5) & ((x[0] < 0.3) | (x[0] > 0.7)),
    })  # fmt: skip


@two_meshes
def test_a_punch_on_a_foundation_under_the_same_pressure(cells, order, swap):
    # Taylor and Papadopoulos 1991: the larger surface goes on beyond the smaller one
    punch = block(x=(0.3, 0.7), y=(0.5, 0.8), nx=7, ny=3, cells=cells, order=order)
    mesh = turned(join({"punch": punch, "low": foundation(cells, order)}), TILT)
    corner = tuple(np.array([[np.cos(TILT), -np.sin(TILT)], [np.sin(TILT), np.cos(TILT)]])
                   @ (0.3, 0.8))  # fmt: skip
    s = ContactProblem(
        mesh, materials={"punch": Elastic(E=3.0, nu=0.3), "low": Elastic(E=1.0, nu=0.2)},
        assumption="plane strain", supports={"low.bottom": "n", "low.left": "n"},
        anchors={corner: "x"}, contacts=[pair("punch.bottom", "low.top", swap)],
    ).solve(pressures={"punch.top": P, "low.free": P})  # fmt: skip
    assert_uniform(s, TILT)
