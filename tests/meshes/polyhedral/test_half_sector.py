"""The half sector of a polyhedral ring: fine zones, growth, refusals, and no folded cell."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from meshes.polyhedral.half_sector import half_sector
from tests.meshes.measures import assert_unfolded, lengths, nodes

D_E, D_I, FILLET = 0.08, 0.072, 0.002  # [m]
ZONE, HUB = 4e-4, (8.5e-3, 9.5e-3)  # [m]
ROUND_OFF = 1e-12  # relative


def ring(**changed):
    return half_sector(**{"z": 6, "d_e": D_E, "d_i": D_I, "fillet": FILLET, "refine": 1} | changed)


def test_the_fine_zone_and_the_hub_are_at_the_specified_places():
    mesh = ring(zone=ZONE, cells=8, hub=HUB, refine=2)
    y = np.sort(nodes(mesh, "zone")[1])
    assert (y[0], y[-1]) == pytest.approx((0, ZONE), abs=ROUND_OFF)
    assert len(mesh.boundaries["zone"]) == 16
    np.testing.assert_allclose(np.diff(np.arcsin(2 * y / D_E)), np.arcsin(2 * ZONE / D_E) / 32)
    y = nodes(mesh, "hub")[1]
    assert (y.min(), y.max()) == pytest.approx(HUB, abs=ROUND_OFF)
    for part, whole in (("zone", "rim"), ("hub", "flat"), ("hub", "bore")):
        assert set(mesh.boundaries[part]) < set(mesh.boundaries[whole])


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"z": 2}, "z >= 3"),
        ({"d_i": 0.08}, "0 < d_i < d_e"),
        ({"fillet": 0.0}, "sharp corner"),
        ({"fillet": 0.036}, "makes the bore round"),
        ({"refine": 0}, "refine must be at least 1"),
        ({"zone": 0.006}, "half of each of two lengths"),
        ({"hub": (2e-3, 1e-3)}, "0 < s_0 < s_1"),
        ({"hub": (16e-3, 17.1e-3)}, "half of the flat"),
    ],
)
def test_a_ring_that_cannot_be_is_refused_with_its_rule(changed, rule):
    with pytest.raises(ValueError, match=rule):
        ring(**changed)


share = st.floats(0.02, 0.98)


def wall_at_the_middle(*, z, d_i, fillet):
    angle = np.pi / z
    return 0.5 - d_i / 2 * np.cos(angle) - fillet * (1 - np.cos(angle))


@settings(max_examples=15, deadline=None)
@example(z=3, wall=-3.5, fillet=-0.55, zone=0.1, hub=None, cells=24)  # a thin core
@example(
    z=3, wall=-2.0, fillet=-0.5, zone=None, hub=(0.5, 0.97), cells=2
)  # a hub beside the fillet
@example(z=17, wall=-1.4, fillet=-5.0, zone=None, hub=(0.3, 0.95), cells=6)  # a narrow sector
@example(z=3, wall=-1.2, fillet=-1.5, zone=2e-3, hub=None, cells=12)  # wide lines
@given(
    z=st.sampled_from([3, 4, 5, 6, 8, 12, 17, 24, 48]),
    wall=st.floats(np.log(0.005), np.log(0.3)),
    fillet=st.floats(np.log(1e-3), np.log(0.9)),
    zone=st.none() | st.floats(1e-3, 0.4),
    hub=st.none() | st.tuples(share, share).filter(lambda ends: abs(ends[1] - ends[0]) > 0.01),
    cells=st.sampled_from([2, 6, 24]),
)
def test_no_cell_folds_whatever_the_ring(z, wall, fillet, zone, hub, cells):
    d_i = 1 - 2 * np.exp(wall)
    fillet = d_i / 2 * np.exp(fillet)
    flat = (d_i / 2 - fillet) * np.sin(np.pi / z)
    if zone is not None:
        room = min(wall_at_the_middle(z=z, d_i=d_i, fillet=fillet), flat * min(hub or (0.3,)))
        zone *= room
    hub = hub and tuple(sorted(flat * s for s in hub))
    mesh = half_sector(
        z=z, d_e=1.0, d_i=d_i, fillet=fillet, refine=1, zone=zone, hub=hub, cells=cells
    )
    assert_unfolded(mesh)


def along(mesh, name):
    """Lengths of the facets of a boundary, from the middle of the side to the corner."""
    middle = mesh.p[:, mesh.facets[:, np.asarray(mesh.boundaries[name])]].mean(axis=1)
    return lengths(mesh, name)[np.argsort(np.arctan2(middle[1], middle[0]))]


@pytest.mark.parametrize(("z", "fillet"), [(3, 0.1), (48, 0.003)])
def test_cells_grow_from_the_fillet_and_nowhere_by_more_than_four_times(z, fillet):
    mesh = half_sector(z=z, d_e=1.0, d_i=0.9, fillet=fillet, refine=4)
    arc = along(mesh, "fillet")
    np.testing.assert_allclose(arc, arc.mean(), rtol=1e-3)
    flat = along(mesh, "flat")
    assert flat[-1] < 1.1 * arc.mean()
    growth = flat[:-1] / flat[1:]
    assert max(growth[-7:]) < 1.15  # the fourth root of 1.6
    assert max(growth) < 4  # where the fan around the fillet ends
