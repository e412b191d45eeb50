"""No cell of a freewheel's sector folds, however odd the clutch, and none is needlessly many."""

from math import cos, pi, radians, sin, tan

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from fem.plane.geometry import check_unfolded, jacobians
from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector

GAUSS = np.stack(np.meshgrid(*[(0.5 + np.array([-1, 0, 1]) * np.sqrt(0.15))] * 2)).reshape(2, -1)
X = 1.0  # from the axis to the flat, the unit of length
pitches = st.integers(3, 30)
angles = st.floats(0, 30)  # [degrees]
walls = st.floats(np.log(0.02), np.log(2))
rollers = st.floats(np.log(0.02), np.log(0.9))
zones = st.tuples(*[st.floats(np.log(0.0075), np.log(0.25))] * 2)
overlaps = st.tuples(*[st.floats(-0.05, 0.05)] * 2)  # over the roller's radius
cells = st.sampled_from([2, 6, 10])


def check(mesh):
    check_unfolded(mesh, GAUSS)
    assert jacobians(mesh, GAUSS)[1].min() > 0
    sizes = mesh.nelements, mesh.boundaries["roller.inner"].size
    assert max(sizes) < 8000, sizes


def fits(z, psi, centre, r, zone, half_flat, wall):
    """The rules of the sector's own limits, with a margin."""
    return (
        np.hypot(*centre) * sin(pi / z) > 1.01 * r
        and centre[0] + 2.02 * zone[0] < half_flat
        and max(zone) < 0.99 * wall
    )


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
    check(
        inner_cam_sector(
            R=R,
            R_a=R * (1 + np.exp(wall)),
            X=X,
            r_b=bore,
            r=r,
            z=z,
            centre=centre,
            zones=zone,
            cells=cells,
            clearance=clearance,
        )
    )


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
    check(
        outer_cam_sector(
            R_s=R_s,
            r_b=bore * R_s,
            X_o=X,
            R_a=R_a,
            r=r,
            z=z,
            centre=centre,
            zones=zone,
            cells=cells,
        )
    )


@pytest.mark.parametrize(("psi", "share"), [(2, 0.22), (8, 0.06), (30, 0.0075)])
def test_cells_of_usual_clutches_are_neither_slivers_nor_needles(psi, share):
    z, r = (8 if psi < 16 else 4), 0.22
    centre = (X + r) * tan(radians(psi)), X + r
    R = np.hypot(*centre) + r
    mesh = inner_cam_sector(
        R=R, R_a=1.25 * R, X=X, r_b=0.6, r=r, z=z, centre=centre, zones=(share * r, share * r)
    )
    check_shapes(mesh)


def check_shapes(mesh):
    corners = mesh.p[:, mesh.t]
    ahead, behind = (np.roll(corners, turn, axis=1) - corners for turn in (-1, 1))
    corner = np.arctan2(
        abs(ahead[0] * behind[1] - ahead[1] * behind[0]), (ahead * behind).sum(axis=0)
    )
    assert np.degrees(corner.min()) > 25
    assert np.degrees(corner.max()) < 160
    length = np.hypot(*ahead)
    assert (length.max(axis=0) / length.min(axis=0)).max() < 10
