"""A freewheel's sector: places, names and fine zones of its bodies, and cuts that match."""

from math import acos, atan, atan2, cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector
from tests.meshes.measures import measure, nodes, vertices

R, R_A, X, R_B, R_R, Z, ZONES = 16.5e-3, 21e-3, 11.39565e-3, 7.5e-3, 2.5e-3, 8, (1.5e-4, 2e-4)
CENTRE = sqrt((R - R_R) ** 2 - (X + R_R) ** 2), X + R_R  # just touching, [m]
PSI = acos((X + R_R) / (R - R_R))
INNER = {"R": R, "R_a": R_A, "X": X, "r_b": R_B, "r": R_R, "z": Z, "centre": CENTRE}
R_S, X_O = 10e-3, 14.9e-3  # shaft and cup around the same roller
AT_SHAFT = sqrt((R_S + R_R) ** 2 - (X_O - R_R) ** 2), X_O - R_R
OUTER = {"R_s": R_S, "X_o": X_O, "r_b": 4e-3, "R_a": R_A, "r": R_R, "z": Z, "centre": AT_SHAFT}
THIN_SHAFT = {"R_s": 1e-3, "r_b": 2e-4, "z": 3, "X_o": 6e-3, "centre": (2e-4, 3.5e-3)}
ROUND_OFF = 1e-12  # relative
BOTH = [(inner_cam_sector, INNER), (outer_cam_sector, OUTER)]


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


@pytest.mark.parametrize("refine", [3])
@pytest.mark.parametrize(
    ("sector", "given", "flat", "circle"),
    [(*BOTH[0], "star", "ring"), (*BOTH[1], "cup", "shaft"),
     (inner_cam_sector, INNER | {"z": 3}, "star", "ring")],
)  # fmt: skip
def test_the_right_cut_turned_by_a_pitch_lies_on_the_left_one(sector, given, flat, circle, refine):
    mesh = sector(**given, zones=ZONES, refine=refine)
    turn = 2 * pi / given["z"]
    back = np.array([[cos(turn), -sin(turn)], [sin(turn), cos(turn)]])
    for body in (flat, circle):
        left, right = nodes(mesh, f"{body}.left"), back @ nodes(mesh, f"{body}.right")
        for places in (left, right):
            places[:] = places[:, np.argsort(np.hypot(*places))]
        np.testing.assert_allclose(right, left, rtol=0, atol=ROUND_OFF * R)


@pytest.mark.parametrize(("cells", "refine"), [(3, 2)])
@pytest.mark.parametrize(
    ("sector", "given", "boundary", "contact", "zone", "uneven"),
    [
        # the roller's cells are even but for the fourth power of the zone over its radius
        (*BOTH[0], "star.flat", (CENTRE[0], X), ZONES[0], 1e-9),
        (*BOTH[0], "roller.inner", (CENTRE[0], X), ZONES[0], 1e-3),
        (*BOTH[0], "roller.outer", R * ray(PSI), ZONES[1], 2e-3),
        (*BOTH[0], "ring.bore", R * ray(PSI), ZONES[1], 1e-4),
        (*BOTH[1], "shaft.rim", R_S * ray(atan2(*AT_SHAFT)), ZONES[0], 1e-4),
        (*BOTH[1], "roller.inner", R_S * ray(atan2(*AT_SHAFT)), ZONES[0], 1e-3),
        (*BOTH[1], "roller.outer", (AT_SHAFT[0], X_O), ZONES[1], 2e-3),
        (*BOTH[1], "cup.flat", (AT_SHAFT[0], X_O), ZONES[1], 1e-9),
    ],
)
def test_even_cells_lie_on_both_sides_of_each_contact(
    sector, given, boundary, contact, zone, uneven, refine, cells
):
    mesh = sector(**given, zones=ZONES, refine=refine, cells=cells)
    away = vertices(mesh, boundary) - np.reshape(contact, (2, 1))
    n = cells * refine
    expected = zone / n * np.repeat(np.arange(n + 1), [1] + [2] * n)
    found = np.sort(np.hypot(*away))[: 2 * n + 1]
    np.testing.assert_allclose(found, expected, rtol=uneven, atol=1e-9 * zone)
    side = np.sign(away[0][np.argsort(np.hypot(*away))[1 : 2 * n + 1]])
    assert side.sum() == 0


def test_cells_may_be_straight_or_linear():
    straight, linear = inner(straight=True), inner(order=1)
    np.testing.assert_allclose(straight.p, linear.p, rtol=0, atol=1e-9 * R)
    assert measure(straight, "roller") < pi * R_R**2 * (1 - 1e-4)


def beside(angle, radius=R - R_R):
    return tuple(radius * ray(radians(angle)))


@pytest.mark.parametrize(
    ("sector", "changed", "rule"),
    [
        (inner, {"z": 2}, "whole number z >= 3 of rollers, got z=2"),
        (inner, {"r_b": 0.0}, r"0 < r_b < X < R < R_a, got 0, "),
        (inner, {"r_b": X}, "r_b < X"),
        (inner, {"R_a": R}, "R < R_a"),
        (inner, {"r": 0.0}, "clearance"),
        (inner, {"clearance": 0.0}, "0 < clearance < R - X"),
        (inner, {"centre": (-1e-6, CENTRE[1])}, "x >= 0"),
        (inner, {"centre": beside(46)}, "45 degrees"),
        (inner, {"centre": (0.0, 10e-3)}, "from the flat it touches"),
        (inner, {"R": R + 2e-3}, "from the circle it touches"),
        (inner, {"z": 20}, "rollers of r=0.0025 m overlap each other"),
        (inner, {"z": 16, "centre": beside(12)}, "beyond the end of the flat"),
        (
            inner,
            {"z": 14, "centre": beside(10.3), "zones": (6e-5, 1e-4)},
            "half of what is left to the end of the flat",
        ),
        (inner, {"zones": (0.0, 1e-4)}, "zone on the flat needs 0 < zone"),
        (inner, {"zones": (1.3e-3, 1e-4)}, "r/2"),
        (inner, {"zones": (5e-4, 1e-4), "r_b": X - 4e-4}, "the wall"),
        (inner, {"zones": (1e-4, 0.0)}, "zone on the circle needs 0 < zone"),
        (inner, {"zones": (1e-4, 5e-4), "R_a": R + 4e-4}, "the wall"),
        (inner, {"cells": 0}, "cells >= 1"),
        (inner, {"refine": 0}, "refine >= 1"),
        (outer, {"r_b": 0.0}, "0 < r_b < R_s"),
        (outer, {"R_a": X_O / cos(pi / Z)}, r"X_o < R_a cos\(pi/z\)"),
        (outer, {"r": float("nan")}, "a roller needs r > 0"),
        (outer, {"zones": (1e-4, 1.3e-3)}, "zone on the flat"),
        (outer, THIN_SHAFT | {"zones": (6e-4, 1e-4)}, "a quarter of the pitch, here 0.000523599"),
    ],
)
def test_a_sector_that_cannot_be_is_refused_in_one_line(sector, changed, rule):
    with pytest.raises(ValueError, match=rule) as refused:
        sector(**changed)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("sector", "body", "contact", "zone"),
    [
        (inner, "star", (CENTRE[0], X), ZONES[0]),
        (inner, "ring", R * ray(PSI), ZONES[1]),
        (outer, "shaft", R_S * ray(atan2(*AT_SHAFT)), ZONES[0]),
        (outer, "cup", (AT_SHAFT[0], X_O), ZONES[1]),
    ],
)
def test_cells_at_a_contact_are_as_deep_as_they_are_wide(sector, body, contact, zone):
    mesh = sector(cells=4, refine=2)
    cells = mesh.t[:, mesh.subdomains[body]]
    own = np.unique(cells)
    node = own[np.argmin(np.hypot(*(mesh.p[:, own] - np.reshape(contact, (2, 1)))))]
    column, cell = np.nonzero(cells == node)
    sides = [mesh.p[:, cells[(column + k) % 4, cell]] - mesh.p[:, [node]] for k in (1, 3)]
    np.testing.assert_allclose([np.hypot(*side) for side in sides], zone / 8, rtol=2e-3)
