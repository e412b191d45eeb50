"""No cell of a sprag clutch's sector folds, however odd the clutch, and none is needlessly many."""

from math import asin, degrees, radians, sqrt

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from fem.plane.geometry import check_unfolded, jacobians
from meshes.sprag.profile import Placed, Sprag
from meshes.sprag.sector import sprag_sector

GAUSS = np.stack(np.meshgrid(*[(0.5 + np.array([-1, 0, 1]) * np.sqrt(0.15))] * 2)).reshape(2, -1)
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


def check(mesh):
    check_unfolded(mesh, GAUSS)
    assert jacobians(mesh, GAUSS)[1].min() > 0
    assert mesh.nelements < 8000


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
    check(mesh)


@pytest.mark.parametrize(("turn", "b", "z"), [(0, 0.3, 10), (10, 0.65, 3)])
def test_cells_of_usual_clutches_are_neither_slivers_nor_needles(turn, b, z):
    gap = 0.75
    sprag, D = drawn(0.09, gap, 0.48, b)
    at = Placed(sprag, (0.0, D), radians(turn))
    zone = 0.1 * min(ways(sprag, at))
    mesh = sprag_sector(
        R_id=0.65, R_i=R_I, R_e=R_I + gap, R_ed=2.4, z=z, sprag=sprag, pole=(0.0, D),
        turn=radians(turn), zones=(zone, zone),
    )  # fmt: skip
    corners = mesh.p[:, mesh.t]
    ahead, behind = (np.roll(corners, way, axis=1) - corners for way in (-1, 1))
    corner = np.arctan2(
        abs(ahead[0] * behind[1] - ahead[1] * behind[0]), (ahead * behind).sum(axis=0)
    )
    length = np.hypot(*ahead)
    assert degrees(corner.min()) > 16
    assert degrees(corner.max()) < 160
    assert (length.max(axis=0) / length.min(axis=0)).max() < 10
