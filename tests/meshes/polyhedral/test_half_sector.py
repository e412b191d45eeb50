"""The half sector of a polyhedral ring has the places, names, lengths and area of its outline."""

from math import cos, pi, sin, tan

import numpy as np
import pytest
from skfem import Basis, ElementQuad1, FacetBasis, Functional

from meshes.polyhedral.half_sector import half_sector

D_E, D_I, FILLET = 0.08, 0.072, 0.002  # [m]
ZONE, HUB = 4e-4, (8.5e-3, 9.5e-3)  # [m]
ROUND_OFF = 1e-12  # relative


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def ring(**changed):
    return half_sector(**{"z": 6, "d_e": D_E, "d_i": D_I, "fillet": FILLET, "refine": 1} | changed)


def nodes(mesh, name):
    return mesh.doflocs[:, mesh.dofs.get_facet_dofs(np.asarray(mesh.boundaries[name])).flatten()]


def measure(mesh, name):
    """Length of a boundary, or the "area"."""
    if name == "area":
        return one.assemble(Basis(mesh, ElementQuad1(), intorder=6))
    facets = np.asarray(mesh.boundaries[name])
    return one.assemble(FacetBasis(mesh, ElementQuad1(), intorder=6, facets=facets))


def outline(z, fillet):
    """Apothem and half of the flat from the corner that the sides would have without a fillet."""
    R_u = D_I / 2 + fillet * (1 / cos(pi / z) - 1)
    return R_u * cos(pi / z), R_u * sin(pi / z) - fillet * tan(pi / z)


def half_area(z, fillet):
    apothem, flat = outline(z, fillet)
    hole = (apothem * flat + fillet * flat + fillet**2 * pi / z) / 2
    return D_E**2 / 8 * pi / z - hole


@pytest.mark.parametrize("z", [3, 6, 48])
@pytest.mark.parametrize("zone", [None, ZONE])
def test_its_boundaries_are_its_outline_and_its_body_the_whole(z, zone):
    mesh = ring(z=z, zone=zone)
    parts = ["mid", "rim", "corner", "flat", "fillet"]
    around = np.concatenate([mesh.boundaries[name] for name in parts])
    np.testing.assert_array_equal(np.sort(around), mesh.boundary_facets())
    bore = np.concatenate([mesh.boundaries[name] for name in ("flat", "fillet")])
    np.testing.assert_array_equal(np.sort(mesh.boundaries["bore"]), np.sort(bore))
    assert set(mesh.boundaries) - {*parts, "bore"} == ({"zone"} if zone else set())
    assert set(mesh.subdomains) == {"ring"}
    assert mesh.subdomains["ring"].size == mesh.nelements


@pytest.mark.parametrize("z", [3, 6, 48])
@pytest.mark.parametrize("fillet", [2.5e-4, 2e-3, 0.03])
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


@pytest.mark.parametrize("z", [3, 6, 48])
def test_its_wall_is_thinnest_at_the_real_corner(z):
    mesh = ring(z=z)
    assert measure(mesh, "corner") == pytest.approx((D_E - D_I) / 2, rel=ROUND_OFF)
    assert np.hypot(*nodes(mesh, "bore")).max() == pytest.approx(D_I / 2, rel=ROUND_OFF)


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


@pytest.mark.parametrize("z", [3, 6, 48])
def test_its_area_and_its_arcs_converge_with_the_fourth_power_of_its_cells(z):
    fillet = 0.02  # whose error is above round-off
    exact = {"area": half_area(z, fillet), "rim": D_E / 2 * pi / z, "fillet": fillet * pi / z}
    meshes = [ring(z=z, fillet=fillet, refine=refine) for refine in (1, 2)]
    for name, value in exact.items():
        coarse, fine = (measure(mesh, name) / value - 1 for mesh in meshes)
        assert abs(coarse) < 1e-4
        if abs(fine) > 1e-11:
            assert np.log2(coarse / fine) == pytest.approx(4, abs=0.1), (name, coarse, fine)


@pytest.mark.parametrize("extra", [{}, {"zone": ZONE}, {"zone": ZONE, "hub": HUB}])
def test_halving_keeps_the_places_on_the_outline_and_nearly_those_inside(extra):
    coarse, fine = ring(**extra), ring(**extra, refine=2)
    assert fine.nelements == 4 * coarse.nelements
    distance = np.hypot(*(fine.p[:, :, None] - coarse.p[:, None])).min(axis=0)
    around = np.unique(coarse.facets[:, coarse.boundary_facets()])
    assert distance[around].max() < ROUND_OFF * D_E
    # inside, places follow chords of the outline, not its arcs
    assert distance.max() < 1e-3 * D_E


def test_straight_cells_cut_the_corners_of_the_curved_ones():
    mesh = ring(straight=True)
    assert mesh.doflocs.shape[1] == mesh.nvertices
    assert measure(mesh, "rim") < D_E / 2 * pi / 6 * (1 - 1e-5)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"z": 2}, "z >= 3"),
        ({"z": 6.5}, "z >= 3"),
        ({"z": float("nan")}, "z >= 3"),
        ({"d_i": 0.08}, "0 < d_i < d_e"),
        ({"d_i": -0.01}, "0 < d_i < d_e"),
        ({"d_e": float("nan")}, "0 < d_i < d_e"),
        ({"fillet": 0.0}, "sharp corner"),
        ({"fillet": 0.036}, "the bore is round"),
        ({"refine": 0}, "refine >= 1"),
        ({"zone": 0.0}, "0 < zone"),
        ({"zone": 0.006}, "half of the wall"),
        ({"hub": (0.0, 1e-3)}, "0 < s_0 < s_1"),
        ({"hub": (2e-3, 1e-3)}, "0 < s_0 < s_1"),
        ({"hub": (16e-3, 17.1e-3)}, "half of the flat"),
    ],
)
def test_a_ring_that_cannot_be_is_refused_with_its_rule(changed, rule):
    with pytest.raises(ValueError, match=rule):
        ring(**changed)
