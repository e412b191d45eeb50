"""The direction of contact weighs both bodies by their moduli, and finds what Hertz is off by.

The excesses over Hertz are those of a solver of another kind (discs by Fourier modes, plane
stress); they are of first order in a/R here, as the materials couple both directions.
"""

import numpy as np
import pytest
from scipy.optimize import newton

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import full_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.join import join

# R_1, R_2, E_1, nu_1, E_2, nu_2; Hertz's half-width; excess of peak pressure and moments' width
SMALL_STIFF = (2.0, 1.0, 1.0, 0.1, 4.0, 0.4), 0.0993, -6.64e-3, 5.73e-3
LARGE_SOFT = (1.0, 3.0, 20.0, 0.0, 1.0, 0.0), 0.0992, -1.505e-2, 1.370e-2
SHARP = 3e-4  # 16 cells on the half-width leave 1.4e-4 of a disc on a flat; 1e-5 is print


def excesses(discs, a, *, swap=False):
    """Relative excess over Hertz of the peak pressure and of 2 sqrt(int q x² / int q)."""
    R_1, R_2, E_1, nu_1, E_2, nu_2 = discs
    fine = {"zone": 1.5 * a, "cells": 6, "refine": 4}
    sides = [("up.surface", Circle((0, R_1), R_1)), ("low.surface", Circle((0, -R_2), R_2))]
    (slave, one), (master, other) = sides[::-1] if swap else sides
    problem = ContactProblem(
        join({"up": quarter_disc(R=R_1, **fine), "low": quarter_disc(R=R_2, below=True, **fine)}),
        materials={"up": Elastic(E=E_1, nu=nu_1), "low": Elastic(E=E_2, nu=nu_2)},
        assumption="plane stress",
        supports={"up.axis": "x", "low.axis": "x", "low.middle": "y", "up.middle": "y"},
        contacts=[Pair(slave=slave, master=master, slave_shape=one, master_shape=other)],
    )
    load = np.pi * a**2 * (1 / R_1 + 1 / R_2) / (4 * (1 / E_1 + 1 / E_2))

    def pressed(d):
        return problem.solve(displacements={"up.middle": {"y": -d}}).touches[0]

    soft = load * (1 / E_1 + 1 / E_2)
    touch = pressed(newton(lambda d: 2 * abs(pressed(d).force[1]) / load - 1, soft, x1=2 * soft))
    points = touch.mortar.points
    x, q = (points.x[0] + points.y[0]) / 2, touch.p * np.abs(points.n[1]) * points.weight
    peak = touch.pressure[np.argmin(np.abs(touch.x[0]))]
    width = 2 * np.sqrt(q @ x**2 / q.sum())
    return peak / (2 * load / (np.pi * a)) - 1, width / a - 1


@pytest.mark.parametrize(
    ("solved", "swap"),
    [(SMALL_STIFF, False), (LARGE_SOFT, True)],
    ids=["small stiff", "large soft"],
)
def test_unlike_discs_are_off_hertz_as_another_solver_says(solved, swap):
    discs, a, *excess = solved
    assert excesses(discs, a, swap=swap) == pytest.approx(excess, abs=SHARP)


R, MU = 1.0, 0.2
FINE = {"zone": 0.06, "refine": 1}
UP = np.array([[0.0], [1.0]])


def slid(normal, along=0.02):
    """A disc of E = 1 pressed on a block and slid until nothing sticks."""
    problem = ContactProblem(
        join({"disc": half_disc(R=R, **FINE), "block": full_block(width=R, depth=R, **FINE)}),
        materials=Elastic(E=1.0, nu=0.3),
        assumption="plane strain",
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[
            Pair(slave="disc.surface", master="block.surface", friction=MU, normal=normal,
                 slave_shape=Circle((0.0, R), R), master_shape=Flat())
        ],
    )  # fmt: skip
    pressed = problem.solve(displacements={"disc.middle": {"y": -0.004}})
    return problem.solve(displacements={"disc.middle": {"x": along, "y": -0.004}}, after=pressed)


def test_pressure_keeps_one_direction_along_a_flat_master_and_turns_between_two_bodies():
    touch = slid("master").touches[0]
    np.testing.assert_allclose(touch.mortar.points.n, -UP * np.ones(touch.p.size), atol=1e-14)
    x, y = touch.force
    assert x == pytest.approx(-MU * y, rel=1e-12)
    touch = slid("between").touches[0]
    # half of the disc's slope, both moduli being alike
    near = np.abs(touch.mortar.points.x[0]) < 0.1 * R
    n = touch.mortar.points.n[:, near]
    expected = touch.mortar.points.x[0, near] / (2 * R)
    np.testing.assert_allclose(n[0] / -n[1], expected, rtol=0.01, atol=1e-6)
    x, y = touch.force
    assert abs(x / (MU * y) + 1) > 1e-4  # the contact has moved to where the surface is inclined
    with pytest.raises(ValueError, match="'between' or that of the 'master', got 'slave'"):
        Pair(slave="a", master="b", normal="slave")
