"""The sector of a sprag clutch: positions, names, fine zones of its bodies, and matching cuts."""

from dataclasses import replace
from math import asin, atan2, cos, hypot, nan, radians, sin, sqrt
from types import SimpleNamespace

import numpy as np
import pytest

from meshes.sprag.profile import Placed, Sprag
from meshes.sprag.sector import sprag_sector
from meshes.sprag.wedged import Place
from tests.meshes.measures import cuts_apart, nodes, vertices

R_ID, R_I, R_E, R_ED, R_SPIRAL, M, Z = 7.21e-3, 11.11e-3, 19.44e-3, 26.23e-3, 4.02e-3, 0.0892, 12
RHO = R_SPIRAL / sqrt(1 + M**2)
D = sqrt(R_I**2 + RHO**2 + 2 * R_I * RHO / sqrt(1 + M**2))  # from the axis to the pole
ETA = asin(M * R_I / (D * sqrt(1 + M**2)))
SPRAG = Sprag(RHO, ETA, M, R_E - D, 4e-3)
TURN, ZONES = radians(7), (1.2e-4, 1.8e-4)
GIVEN = {"R_id": R_ID, "R_i": R_I, "R_e": R_E, "R_ed": R_ED, "z": Z, "sprag": SPRAG,
         "pole": (0.0, D), "turn": TURN, "zones": ZONES}  # fmt: skip
PLACED = Placed(SPRAG, (0.0, D), TURN)
ROUND_OFF = 1e-12  # relative


def sector(**changed):
    return sprag_sector(**GIVEN | changed)


def in_own_frame(x):
    """Places in the frame of the sprag: the pole at the origin, not turned."""
    d = x - np.array([[0.0], [D]])
    c, s = cos(TURN), sin(TURN)
    return np.array([c * d[0] - s * d[1], s * d[0] + c * d[1]])


def test_every_node_of_the_outline_lies_on_it():
    mesh = sector(refine=2)
    races = {f"{race}.{name}" for race in ("inner", "outer")
             for name in ("bore", "rim", "left", "right")}  # fmt: skip
    assert set(mesh.boundaries) == races | {
        f"sprag.{n}" for n in ("inner", "outer", "left", "right")
    }
    named = np.sort(np.concatenate(list(mesh.boundaries.values())))
    np.testing.assert_array_equal(named, np.sort(mesh.boundary_facets()))
    assert max(cuts_apart(mesh, race, Z) for race in ("inner", "outer")) < ROUND_OFF * R_E
    tight = {"rtol": 0, "atol": ROUND_OFF * R_E}
    for name, radius in (("inner.bore", R_ID), ("inner.rim", R_I), ("outer.bore", R_E),
                         ("outer.rim", R_ED)):  # fmt: skip
        np.testing.assert_allclose(np.hypot(*nodes(mesh, name)), radius, **tight)
    x, y = in_own_frame(nodes(mesh, "sprag.inner"))
    spiral = RHO * np.exp(M * (np.arctan2(x, -y) - ETA))
    np.testing.assert_allclose(np.hypot(x, y), spiral, **tight)
    np.testing.assert_allclose(np.hypot(*in_own_frame(nodes(mesh, "sprag.outer"))),
                               R_E - D, **tight)  # fmt: skip
    low, high = np.array([RHO * sin(ETA), -RHO * cos(ETA)]), np.array([0.0, R_E - D])
    along = (high - low) / hypot(*(high - low))
    for name, side in (("sprag.left", -1), ("sprag.right", 1)):
        d = in_own_frame(nodes(mesh, name)) - low[:, None]
        np.testing.assert_allclose(along[1] * d[0] - along[0] * d[1], side * 2e-3, **tight)


@pytest.mark.parametrize(
    ("boundary", "contact", "zone", "uneven"),
    [
        # the sprag's cells are even except for the square of zone over distance to the flank
        ("inner.rim", PLACED.inner, ZONES[0], 1e-4),
        ("sprag.inner", PLACED.inner, ZONES[0], 6e-3),
        ("sprag.outer", PLACED.outer, ZONES[1], 2e-2),
        ("outer.bore", PLACED.outer, ZONES[1], 1e-4),
    ],
)
def test_even_cells_lie_on_both_sides_of_each_contact(boundary, contact, zone, uneven):
    n = 6
    mesh = sector(refine=2, cells=3)
    away = vertices(mesh, boundary)
    azimuth = np.arctan2(*away) - atan2(*contact)
    # of the race where the sprag overlaps it
    along = np.sort(np.abs(azimuth * np.hypot(*away)))[: 2 * n + 1]
    expected = zone / n * np.repeat(np.arange(n + 1), [1] + [2] * n)
    np.testing.assert_allclose(along, expected, rtol=uneven, atol=1e-9 * zone)


def test_a_compressed_sprag_has_its_arc_about_another_point():
    at = Placed(SPRAG, (0.0, D), 0.0)  # not turned it touches both races
    assert (hypot(*at.inner), hypot(*at.outer)) == pytest.approx((R_I, R_E), rel=ROUND_OFF)
    assert at.theta == pytest.approx(ETA)
    shorter = replace(SPRAG, centre=(1e-5, -2e-5))
    mesh = sector(sprag=shorter, turn=0.0)
    x, y = nodes(mesh, "sprag.outer") - np.array([[1e-5], [D - 2e-5]])
    np.testing.assert_allclose(np.hypot(x, y), SPRAG.r_e, rtol=0, atol=ROUND_OFF * R_E)
    assert Placed(shorter, (0.0, D), 0.0).outer == pytest.approx(
        tuple(np.array([1e-5, D - 2e-5]) * (1 + SPRAG.r_e / hypot(1e-5, D - 2e-5)))
    )


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"z": 2}, "the number of sprags must be whole and z >="),
        ({"R_id": R_I}, "R_id < R_i"),
        ({"R_i": R_I - 3e-3}, "the sprag must reach the inner race at"),
        ({"turn": nan}, "the pole of a sprag must be within 45"),
        ({"pole": (D, 0.5 * D)}, "within 45 degrees of"),
        ({"turn": radians(34)}, "the sprag, rotated by 34 degrees, touches"),
        ({"turn": radians(24)}, "the sprag touches the inner race"),
        ({"z": 20}, "at the radius 0.01215.* m, a sprag needs 19.05 degrees"),
        ({"zones": (1e-4, 1.3e-3)}, "of the distance to the flank"),
        ({"zones": (5e-4, 1e-4), "R_id": R_I - 4e-4}, "the thickness of the wall"),
        ({"cells": 0}, "cells >= 1"),
        ({"refine": 0}, "refine >= 1"),
    ],
)
def test_a_sector_that_cannot_be_is_refused_in_one_line(changed, rule):
    with pytest.raises(ValueError, match=rule) as refused:
        sector(**changed)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"rho_0": 0.0}, "rho_0 > 0"),
        ({"m": 0.0}, "0 < m < 1"),
        ({"theta_0": 0.9}, "theta_0 within 45 degrees"),
        ({"b": 8e-3}, "the width b=0.008 m of a sprag must not"),
        ({"b": 6e-3, "r_e": 3e-3}, "the width b=0.006 m of a sprag must not"),
    ],
)
def test_a_sprag_that_cannot_be_is_refused_in_one_line(changed, rule):
    with pytest.raises(ValueError, match=rule) as refused:
        replace(SPRAG, **changed)
    assert "\n" not in str(refused.value)


def test_beta_is_the_angle_between_the_contacts_seen_from_the_axis():
    place = Place(SimpleNamespace(sprag=SPRAG, R_i=R_I, R_e=R_E), TURN, D)
    inner, outer = (atan2(x, y) for x, y in (place.free.inner, place.free.outer))
    assert abs(inner) > 1e-3  # the contacts stand beside the middle of the pitch
    assert place.beta == pytest.approx(inner - outer, rel=1e-12)
