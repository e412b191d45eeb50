"""The half sector of a polyhedral ring has the places, names, lengths and area of its outline."""

from math import cos, pi, sin, tan

import numpy as np
import pytest

from meshes.polyhedral.half_sector import half_sector
from tests.meshes.measures import nodes

D_E, D_I, FILLET = 0.08, 0.072, 0.002  # [m]
ZONE, HUB = 4e-4, (8.5e-3, 9.5e-3)  # [m]
ROUND_OFF = 1e-12  # relative


def ring(**changed):
    return half_sector(**{"z": 6, "d_e": D_E, "d_i": D_I, "fillet": FILLET, "refine": 1} | changed)


def outline(z, fillet):
    """Apothem and half of the flat from the corner that the sides would have without a fillet."""
    R_u = D_I / 2 + fillet * (1 / cos(pi / z) - 1)
    return R_u * cos(pi / z), R_u * sin(pi / z) - fillet * tan(pi / z)


@pytest.mark.parametrize(("z", "fillet"), [(3, 0.03), (48, 2.5e-4)])
def test_every_node_of_a_boundary_lies_on_it(z, fillet):
    mesh = ring(z=z, fillet=fillet)
    apothem, flat = outline(z, fillet)
    c, s = cos(pi / z), sin(pi / z)
    centre = (D_I / 2 - fillet) * np.array([[c], [s]])
    tight = {"rtol": 0, "atol": ROUND_OFF * D_E}
    np.testing.assert_allclose(np.hypot(*nodes(mesh, "rim")), D_E / 2, **tight)
    np.testing.assert_allclose(np.hypot(*(nodes(mesh, "fillet") - centre)), fillet, **tight)
    np.testing.assert_allclose(nodes(mesh, "flat")[0], apothem, **tight)
    np.testing.assert_allclose(np.ptp(nodes(mesh, "flat")[1]), flat, **tight)
    np.testing.assert_allclose(nodes(mesh, "mid")[1], 0, **tight)
    x, y = nodes(mesh, "corner")
    np.testing.assert_allclose(y * c - x * s, 0, **tight)


def test_the_fine_zone_and_the_hub_are_where_they_were_asked_for():
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
        ({"fillet": 0.036}, "the bore is round"),
        ({"refine": 0}, "refine >= 1"),
        ({"zone": 0.0}, "0 < zone"),
        ({"zone": 0.006}, "half of the wall"),
        ({"hub": (2e-3, 1e-3)}, "0 < s_0 < s_1"),
        ({"hub": (16e-3, 17.1e-3)}, "half of the flat"),
    ],
)
def test_a_ring_that_cannot_be_is_refused_with_its_rule(changed, rule):
    with pytest.raises(ValueError, match=rule):
        ring(**changed)
