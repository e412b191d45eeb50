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
both = pytest.mark.parametrize(("sector", "given"), BOTH)


def inner(**changed):
    return inner_cam_sector(**INNER | {"zones": ZONES} | changed)


def outer(**changed):
    return outer_cam_sector(**OUTER | {"zones": ZONES} | changed)


def angles(places, centre=(0.0, 0.0)):
    """Clockwise from the y axis [rad]."""
    return np.arctan2(places[0] - centre[0], places[1] - centre[1])


def ray(angle):
    return np.array([sin(angle), cos(angle)])


def three_flats(**changed):
    """Three flats reach beyond the ring: their corners are cut."""
    return inner(**{"z": 3} | changed)


@both
def test_bodies_and_boundaries_have_their_names(sector, given):
    mesh = sector(**given, zones=ZONES)
    bodies, walls = {
        inner_cam_sector: (("star", "ring"), {"star.flat", "star.bore", "ring.bore", "ring.rim"}),
        outer_cam_sector: (("shaft", "cup"), {"shaft.rim", "shaft.bore", "cup.flat", "cup.rim"}),
    }[sector]
    cuts = {f"{body}.{side}" for body in bodies for side in ("left", "right")}
    assert set(mesh.boundaries) == walls | cuts | {"roller.inner", "roller.outer"}
    assert {*bodies, "roller"} <= set(mesh.subdomains)
    named = np.sort(np.concatenate(list(mesh.boundaries.values())))
    np.testing.assert_array_equal(named, np.sort(mesh.boundary_facets()))


def test_every_node_of_the_outline_lies_on_it():
    mesh = inner(refine=2)
    tight = {"rtol": 0, "atol": ROUND_OFF * R}
    for name, radius in (("star.bore", R_B), ("ring.bore", R), ("ring.rim", R_A)):
        np.testing.assert_allclose(np.hypot(*nodes(mesh, name)), radius, **tight)
    x, y = nodes(mesh, "star.flat")
    np.testing.assert_allclose(y, X, **tight)
    assert (x.min(), x.max()) == pytest.approx((-X * tan(pi / Z), X * tan(pi / Z)), rel=ROUND_OFF)
    for name in ("roller.inner", "roller.outer"):
        distance = np.hypot(*(nodes(mesh, name) - np.reshape(CENTRE, (2, 1))))
        np.testing.assert_allclose(distance, R_R, **tight)
    for body, middle in (("star", 0.0), ("ring", PSI)):
        for side, sign in (("left", -1), ("right", 1)):
            found = angles(nodes(mesh, f"{body}.{side}"))
            np.testing.assert_allclose(found, middle + sign * pi / Z, rtol=0, atol=ROUND_OFF)


def test_the_outline_of_shaft_and_cup_is_that_of_the_clutch():
    mesh = outer(refine=2)
    tight = {"rtol": 0, "atol": ROUND_OFF * R}
    for name, radius in (("shaft.bore", 4e-3), ("shaft.rim", R_S), ("cup.rim", R_A)):
        np.testing.assert_allclose(np.hypot(*nodes(mesh, name)), radius, **tight)
    x, y = nodes(mesh, "cup.flat")
    np.testing.assert_allclose(y, X_O, **tight)
    assert np.abs(x).max() == pytest.approx(X_O * tan(pi / Z), rel=ROUND_OFF)
    low = AT_SHAFT - R_R * ray(atan2(*AT_SHAFT))  # the roller's contacts
    assert np.hypot(*low) == pytest.approx(R_S)
    for place, name in ((low, "inner"), ((AT_SHAFT[0], X_O), "outer")):
        distance = np.hypot(*(vertices(mesh, f"roller.{name}") - np.reshape(place, (2, 1))))
        assert distance.min() < ROUND_OFF * R


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


def star_with_tips():
    tip = R - 0.2 * R_R
    flat = sqrt(tip**2 - X**2)
    turn = pi / 3 - atan(flat / X)
    area = X * flat + tip**2 * turn - R_B**2 * pi / 3
    return {"star": area, "star.flat": 2 * flat, "star.tip": 2 * tip * turn}


@pytest.mark.parametrize(
    ("sector", "exact"),
    [
        (
            inner,
            {
                "star": X**2 * tan(pi / Z) - R_B**2 * pi / Z,
                "star.flat": 2 * X * tan(pi / Z),
                "star.bore": 2 * R_B * pi / Z,
                "star.left": X / cos(pi / Z) - R_B,
                "roller": pi * R_R**2,
                "ring": pi / Z * (R_A**2 - R**2),
                "ring.bore": 2 * pi / Z * R,
                "ring.rim": 2 * pi / Z * R_A,
                "ring.right": R_A - R,
            },
        ),
        (
            outer,
            {
                "shaft": pi / Z * (R_S**2 - 16e-6),
                "shaft.rim": 2 * pi / Z * R_S,
                "cup": R_A**2 * pi / Z - X_O**2 * tan(pi / Z),
                "cup.flat": 2 * X_O * tan(pi / Z),
                "cup.right": R_A - X_O / cos(pi / Z),
            },
        ),
        (three_flats, star_with_tips()),
    ],
)
def test_areas_and_lengths_converge_to_the_closed_forms_with_the_fourth_power(sector, exact):
    coarse, fine = (sector(refine=refine) for refine in (2, 4))
    for name, value in exact.items():
        errors = [measure(mesh, name) / value - 1 for mesh in (coarse, fine)]
        assert abs(errors[0]) < 3e-6, (name, errors)
        if abs(errors[1]) > 1e-11:  # round-off
            assert np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.15), (name, errors)


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
