"""The sector of an extreme clutch has no folded cell, and no needlessly large number of cells."""

from math import asin, cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector
from meshes.sprag.profile import Placed, Sprag
from meshes.sprag.sector import sprag_sector
from tests.meshes.measures import assert_unfolded

X = 1.0  # from the axis to the flat, the unit of length
pitches = st.integers(3, 30)
angles = st.floats(0, 30)  # [degrees]
walls = st.floats(np.log(0.02), np.log(2))
rollers = st.floats(np.log(0.02), np.log(0.9))
zones = st.tuples(*[st.floats(np.log(0.0075), np.log(0.25))] * 2)
overlaps = st.tuples(*[st.floats(-0.05, 0.05)] * 2)  # over the roller's radius
cells = st.sampled_from([2, 6, 10])


def check_freewheel(mesh):
    assert_unfolded(mesh)
    sizes = mesh.nelements, mesh.boundaries["roller.inner"].size
    assert max(sizes) < 8000, sizes


def fits(z, psi, centre, r, zone, half_flat, wall):
    """The rules of the limits of the sector, with a margin."""
    return (
        np.hypot(*centre) * sin(pi / z) > 1.01 * r
        and centre[0] + 2.02 * zone[0] < half_flat
        and max(zone) < 0.99 * wall
    )


@pytest.mark.slow("meshes of many odd clutches")
@settings(max_examples=10, deadline=None)
@example(z=8, psi=7.0, wall=-1.3, bore=0.66, r=-1.5, zone=(-2.8, -2.8), over=(0.0, 0.0), cells=6)
@example(z=30, psi=2.0, wall=-3.9, bore=0.1, r=-3.5, zone=(-4.8, -4.8), over=(0.0, 0.0), cells=6)
@example(z=3, psi=30.0, wall=0.6, bore=0.1, r=-0.2, zone=(-1.4, -1.4), over=(0.0, 0.0), cells=6)
@example(z=4, psi=4.0, wall=0.6, bore=0.96, r=-0.7, zone=(-3.5, -3.0), over=(0.0, -0.02), cells=6)
@given(
    z=pitches, psi=angles, wall=walls, bore=st.floats(0.02, 0.97), r=rollers, zone=zones,
    over=overlaps, cells=cells,
)  # fmt: skip
def test_no_cell_of_an_inner_cam_folds(z, psi, wall, bore, r, zone, over, cells):
    r = np.exp(r)
    zone = tuple(r * np.exp(zone))
    y = X + r * (1 - over[0])
    centre = y * tan(radians(psi)), y
    R = y / cos(radians(psi)) + r * (1 - over[1])
    clearance = min(0.2 * r, 0.9 * (R - X))
    half_flat = min(X * tan(pi / z), np.sqrt((R - clearance) ** 2 - X**2))
    assume(fits(z, psi, centre, r, zone, half_flat, min(X - bore, R * np.log1p(np.exp(wall)))))
    assume(zone[1] < R * pi / z / 2)
    assume(not (z == 3 and cells == 2 and bore < 0.25))  # see the test below
    check_freewheel(inner_cam_sector(
        R=R, R_a=R * (1 + np.exp(wall)), X=X, r_b=bore, r=r, z=z, centre=centre, zones=zone,
        cells=cells, clearance=clearance,
    ))  # fmt: skip


@settings(max_examples=10, deadline=None)
@example(z=8, psi=7.0, wall=-2.0, bore=0.5, r=-1.9, zone=(-2.8, -2.8), over=(0.0, 0.0), cells=6)
@given(
    z=pitches, psi=angles, wall=walls, bore=st.floats(0.02, 0.97), r=rollers, zone=zones,
    over=overlaps, cells=cells,
)  # fmt: skip
def test_no_cell_of_an_outer_cam_folds(z, psi, wall, bore, r, zone, over, cells):
    r = np.exp(r) / 2
    zone = tuple(r * np.exp(zone))
    y = X - r * (1 - over[1])
    centre = y * tan(radians(psi)), y
    R_s = y / cos(radians(psi)) - r * (1 - over[0])
    assume(0.01 < R_s < X)
    R_a = X / cos(pi / z) * (1 + np.exp(wall))
    assume(fits(z, psi, centre, r, zone[::-1], X * tan(pi / z), R_a - X))
    assume(zone[0] < 0.99 * R_s * min(-np.log(bore), pi / z / 2))
    check_freewheel(outer_cam_sector(
        R_s=R_s, r_b=bore * R_s, X_o=X, R_a=R_a, r=r, z=z, centre=centre, zones=zone, cells=cells,
    ))  # fmt: skip


R_I = 1.0  # the unit of length


def drawn(m, gap, r_i, b):
    """The sprag that touches both races, r_i and b as shares of their gap; its pole's distance."""
    rho = r_i * gap / sqrt(1 + m**2)
    D = sqrt(R_I**2 + rho**2 + 2 * R_I * rho / sqrt(1 + m**2))
    eta = asin(m * R_I / (D * sqrt(1 + m**2)))
    return Sprag(rho, eta, m, R_I + gap - D, b * gap), D


def ways(sprag, at):
    """From each contact to the nearer flank."""
    low = min(abs(sprag.spiral_length(at.theta, end)) for end in sprag.below)
    return low, min(abs(end - at.phi) for end in sprag.above) * sprag.r_e


@settings(max_examples=12, deadline=None)
@example(m=0.25, gap=-1.9, r_i=0.5, b=-0.3, z=3, walls=(0.5, 0.3), turn=25.0, zone=(0.5, 0.7),
         cells=6)  # fmt: skip
@example(m=0.02, gap=-1.9, r_i=0.35, b=-2.5, z=40, walls=(0.02, 0.02), turn=-3.0, zone=(0.1, 0.1),
         cells=10)  # fmt: skip
@given(
    m=st.floats(0.01, 0.25), gap=st.floats(np.log(0.1), np.log(1.5)), r_i=st.floats(0.3, 0.7),
    b=st.floats(np.log(0.08), np.log(0.9)), z=st.integers(3, 40),
    walls=st.tuples(st.floats(0.02, 0.9), st.floats(0.02, 0.8)), turn=st.floats(-15, 30),
    zone=st.tuples(*[st.floats(0.02, 0.74)] * 2), cells=st.sampled_from([2, 6, 10]),
)  # fmt: skip
def test_no_cell_of_a_sector_folds(m, gap, r_i, b, z, walls, turn, zone, cells):
    gap = np.exp(gap)
    try:
        sprag, D = drawn(m, gap, r_i, np.exp(b))
        at = Placed(sprag, (0.0, D), radians(turn))
        low, high = ways(sprag, at)
    except ValueError:
        assume(False)
    R_id, R_ed = R_I - walls[0], (R_I + gap) * (1 + walls[1])
    try:
        mesh = sprag_sector(
            R_id=R_id, R_i=R_I, R_e=R_I + gap, R_ed=R_ed, z=z, sprag=sprag, pole=(0.0, D),
            turn=radians(turn), zones=(zone[0] * low, zone[1] * high), cells=cells,
        )  # fmt: skip
    except ValueError:
        assume(False)
    assert_unfolded(mesh)
    assert mesh.nelements < 8000
