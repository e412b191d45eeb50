"""The sector of a freewheel: positions, names, fine zones of its bodies, and matching cuts."""

from math import acos, atan, atan2, cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector
from tests.meshes.measures import cuts_apart, measure, nodes, vertices

R, R_A, X, R_B, R_R, Z, ZONES = 16.5e-3, 21e-3, 11.39565e-3, 7.5e-3, 2.5e-3, 8, (1.5e-4, 2e-4)
CENTRE = sqrt((R - R_R) ** 2 - (X + R_R) ** 2), X + R_R  # just touching, [m]
PSI = acos((X + R_R) / (R - R_R))
INNER = {"R": R, "R_a": R_A, "X": X, "r_b": R_B, "r": R_R, "z": Z, "centre": CENTRE}
R_S, X_O = 10e-3, 14.9e-3  # shaft and cup around the same roller
AT_SHAFT = sqrt((R_S + R_R) ** 2 - (X_O - R_R) ** 2), X_O - R_R
OUTER = {"R_s": R_S, "X_o": X_O, "r_b": 4e-3, "R_a": R_A, "r": R_R, "z": Z, "centre": AT_SHAFT}
THIN_SHAFT = {"R_s": 1e-3, "r_b": 2e-4, "z": 3, "X_o": 6e-3, "centre": (2e-4, 3.5e-3)}
ROUND_OFF = 1e-12  # relative


def inner(**changed):
    return inner_cam_sector(**INNER | {"zones": ZONES} | changed)


def outer(**changed):
    return outer_cam_sector(**OUTER | {"zones": ZONES} | changed)


def ray(angle):
    return np.array([sin(angle), cos(angle)])


@pytest.mark.parametrize("z", [3, 5])
def test_a_tip_that_reaches_the_ring_is_cut_by_the_circle_that_leaves_the_clearance(z):
    corner, tip = X / cos(pi / z), R - 1e-3
    mesh = inner(z=z, clearance=1e-3)
    assert ("star.tip" in mesh.boundaries) == (corner > R - 0.5e-3) == (z < 5)
    if z < 5:
        np.testing.assert_allclose(np.hypot(*nodes(mesh, "star.tip")), tip, rtol=ROUND_OFF)
        assert np.abs(nodes(mesh, "star.flat")[0]).max() == pytest.approx(sqrt(tip**2 - X**2))
    reach = np.hypot(*mesh.p[:, np.unique(mesh.t[:, mesh.subdomains["star"]])]).max()
    assert reach == pytest.approx(min(corner, tip) if z < 5 else corner, rel=ROUND_OFF)
    flat = sqrt(tip**2 - X**2) if z < 5 else X * tan(pi / z)
    turn = pi / z - atan(flat / X)  # from the flat's end to the cut
    assert measure(mesh, "star.flat") == pytest.approx(2 * flat, rel=1e-6)
    area = X * flat + tip**2 * turn - R_B**2 * pi / z
    assert measure(mesh, "star") == pytest.approx(area, rel=1e-4)
    if z < 5:
        assert measure(mesh, "star.tip") == pytest.approx(2 * tip * turn, rel=1e-4)


def beside(angle, radius=R - R_R):
    return tuple(radius * ray(radians(angle)))


@pytest.mark.parametrize(
    ("sector", "changed", "rule"),
    [
        (inner, {"z": 2}, "the number of rollers must be whole and z"),
        (inner, {"r_b": X}, "r_b < X"),
        (inner, {"clearance": 0.0}, "the clearance of a star must be between 0"),
        (inner, {"centre": (-1e-6, CENTRE[1])}, "x >= 0"),
        (inner, {"centre": beside(46)}, "45 degrees"),
        (inner, {"centre": (0.0, 10e-3)}, "the roller's centre must be at the distance"),
        (inner, {"R": R + 2e-3}, "the roller's centre must be at the distance"),
        (inner, {"z": 20}, "neighbouring rollers must not overlap, got"),
        (inner, {"z": 16, "centre": beside(12)}, "the contact must be on the flat: it is at"),
        (
            inner,
            {"z": 14, "centre": beside(10.3), "zones": (6e-5, 1e-4)},
            "the fine zone on the flat must be positive",
        ),
        (inner, {"zones": (1.3e-3, 1e-4)}, "r/2"),
        (inner, {"zones": (5e-4, 1e-4), "r_b": X - 4e-4}, "the wall"),
        (inner, {"zones": (1e-4, 5e-4), "R_a": R + 4e-4}, "the wall"),
        (inner, {"cells": 0}, "cells >= 1"),
        (inner, {"refine": 0}, "refine >= 1"),
        (outer, {"R_a": X_O / cos(pi / Z)}, r"X_o < R_a cos\(pi/z\)"),
        (outer, {"r": float("nan")}, "the radius of a roller must be positive and"),
        (outer, {"zones": (1e-4, 1.3e-3)}, "zone on the flat"),
        (outer, THIN_SHAFT | {"zones": (6e-4, 1e-4)}, "the fine zone on the circle must be"),
    ],
)
def test_a_sector_that_cannot_be_is_refused_in_one_line(sector, changed, rule):
    with pytest.raises(ValueError, match=rule) as refused:
        sector(**changed)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("sector", "boundary", "contact", "zone", "uneven"),
    [
        # the roller's cells are even but for the fourth power of the zone over its radius
        (inner, "star.flat", (CENTRE[0], X), ZONES[0], 1e-9),
        (inner, "roller.inner", (CENTRE[0], X), ZONES[0], 1e-3),
        (inner, "roller.outer", R * ray(PSI), ZONES[1], 2e-3),
        (inner, "ring.bore", R * ray(PSI), ZONES[1], 1e-4),
        (outer, "shaft.rim", R_S * ray(atan2(*AT_SHAFT)), ZONES[0], 1e-4),
        (outer, "roller.inner", R_S * ray(atan2(*AT_SHAFT)), ZONES[0], 1e-3),
        (outer, "roller.outer", (AT_SHAFT[0], X_O), ZONES[1], 2e-3),
        (outer, "cup.flat", (AT_SHAFT[0], X_O), ZONES[1], 1e-9),
    ],
)
def test_even_cells_as_deep_as_wide_lie_on_both_sides_of_each_contact(
    sector, boundary, contact, zone, uneven
):
    n, body = 6, boundary.partition(".")[0]
    mesh = sector(cells=3, refine=2)
    away = vertices(mesh, boundary) - np.reshape(contact, (2, 1))
    order = np.argsort(np.hypot(*away))[: 2 * n + 1]
    expected = zone / n * np.repeat(np.arange(n + 1), [1] + [2] * n)
    found = np.hypot(*away)[order]
    np.testing.assert_allclose(found, expected, rtol=uneven, atol=1e-9 * zone)
    assert np.sign(away[0][order[1:]]).sum() == 0
    if body != "roller":
        cells = mesh.t[:, mesh.subdomains[body]]
        node = cells.flat[np.argmin(np.hypot(*(mesh.p[:, cells.ravel()].T - contact).T))]
        corner, cell = np.nonzero(cells == node)
        sides = [mesh.p[:, cells[(corner + k) % 4, cell]] - mesh.p[:, [node]] for k in (1, 3)]
        np.testing.assert_allclose([np.hypot(*side) for side in sides], zone / n, rtol=3e-3)


@pytest.mark.parametrize(
    ("sector", "z", "bodies"),
    [(inner, Z, ("star", "ring")), (inner, 3, ("star", "ring")), (outer, Z, ("cup", "shaft"))],
)
def test_the_right_cut_turned_by_a_pitch_lies_on_the_left_one(sector, z, bodies):
    mesh = sector(z=z, refine=3)
    for body in bodies:
        assert cuts_apart(mesh, body, z) < ROUND_OFF * R
