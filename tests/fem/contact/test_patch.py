"""Patch tests: contact between non-matching meshes transmits a uniform pressure exactly.

To round-off between straight sides; as near as the facets between circles.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.round import full_disc, full_ring
from meshes.join import join

P = 0.01  # pressure, any
EXACT = 1e-8  # relative
TILT = np.deg2rad(33)


def turned(mesh, angle):
    c, s = np.cos(angle), np.sin(angle)
    return replace(mesh, doflocs=np.array([[c, -s], [s, c]]) @ mesh.doflocs)


def pair(slave, master, swap):
    return Pair(slave=master, master=slave) if swap else Pair(slave=slave, master=master)


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
        ("tri", 2, True, "plane stress"),
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
    pressure = P if cells == "quad" else lambda x: P + 0 * x[0]
    s = problem.solve(pressures={"top.top": pressure})
    assert_uniform(s, TILT)
    for touch in s.touches:
        assert np.hypot(*touch.force) == pytest.approx(0.7 * P, rel=EXACT)


R = 1.0  # P/E = 1/300 is what gaps between facets count against
SHAPES = {"disc.rim": Circle((0, 0), R), "ring.bore": Circle((0, 0), R, hollow=True)}


@cache
def nested(refine, *, swap, shapes, friction=0.3, order=2):
    mesh = join({
        "disc": full_disc(R=R, around=24 * refine, order=order),
        "ring": full_ring(
            r_i=R, r_o=1.6, around=32 * refine, across=4 * refine, order=order
        ),
    })  # fmt: skip
    slave, master = list(SHAPES)[::-1] if swap else list(SHAPES)
    exact = {"slave_shape": SHAPES[slave], "master_shape": SHAPES[master]} if shapes else {}
    problem = ContactProblem(
        mesh, materials=Elastic(E=3.0, nu=0.3), assumption="plane strain",
        anchors={(0, 0): "xy", (1.6, 0): "y"},
        contacts=[Pair(slave=slave, master=master, friction=friction, **exact)],
    )  # fmt: skip
    return problem.solve(pressures={"ring.rim": P})


def stress_error(solution):
    xx, yy, xy, _ = solution.plane.in_body().stress
    return np.abs(np.array([xx + P, yy + P, xy])).max() / P


@pytest.mark.parametrize(
    ("shapes", "swap", "coarse"),
    # parabolas miss the circle by R phi^4/384 = 1e-5 R at most, R P/E is 3e-3 R: parts in 300 at
    # the vertices, a tenth of it or less where gaps come from the circles themselves
    [(False, True, 3e-2), (True, False, 1e-4)],
    ids=["facets, swapped", "circles"],
)
def test_parabolic_facets_fall_away_with_the_third_order_at_least(shapes, swap, coarse):
    errors = [stress_error(nested(k, swap=swap, shapes=shapes)) for k in (1, 2)]
    assert errors[0] < coarse
    assert np.log2(errors[0] / errors[1]) > 2.7, errors


def test_circles_that_turn_freely_are_closed_all_around_without_friction():
    solved = nested(1, swap=False, shapes=True, friction=0.0)
    assert stress_error(solved) < 1e-4
    touch = nested(1, swap=False, shapes=True, friction=0.1).touches[0]
    assert np.all(touch.closed)
    assert np.all(touch.sticks)
    assert np.abs(touch.traction).max() < 1e-4 * P  # the error of the stresses
    half = np.sin(np.pi / 24)  # of a chord of the circle of radius 1
    assert touch.arc.min() == 0  # the curve is closed: its last node is its first
    np.testing.assert_allclose(np.diff(np.sort(touch.arc)), half, rtol=1e-6)
    # straight cells: gaps of their polygons are 0.9 % of R, three times the displacement
    assert stress_error(nested(1, swap=False, shapes=True, order=1)) < 3e-3


RUBBER = Elastic(E=1.0, nu=0.4999)


@pytest.mark.parametrize("cells", ["quad", "tri"])
def test_a_uniform_pressure_passes_a_contact_of_rubber_and_steel(cells):
    p, nu = 0.01, {"up": RUBBER.nu, "low": 0.2}
    mesh = join({"up": block(x=(0, 1), y=(1, 2), nx=6, ny=3, cells=cells),
                 "low": block(x=(0, 1), y=(0, 1), nx=5, ny=3, cells=cells)})  # fmt: skip
    s = ContactProblem(
        mesh, materials={"up": RUBBER, "low": Elastic(E=4.0, nu=0.2)}, assumption="plane strain",
        supports={"low.bottom": "y", "low.left": "x", "up.left": "x"},
        contacts=[Pair(slave="up.bottom", master="low.top")],
    ).solve(pressures={"up.top": p})  # fmt: skip
    np.testing.assert_allclose(s.touches[0].pressure, p, rtol=1e-8)
    for body in nu:
        stress = s.plane.in_body(body).stress.T
        np.testing.assert_allclose(stress - [0, -p, 0, -nu[body] * p], 0.0, atol=1e-8 * p)
