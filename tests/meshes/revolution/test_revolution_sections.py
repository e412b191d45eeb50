"""Half-sections of cylinders: names, areas, and growth of cells away from fine zones."""

import numpy as np
import pytest

from meshes.revolution.cylinder import half_cylinder
from meshes.revolution.section import chain, section, stations
from tests.meshes.measures import lengths


@pytest.mark.parametrize(("bore", "inside"), [(0.0, "axis"), (0.5, "bore")])
def test_a_section_names_its_four_sides(bore, inside):
    mesh = section(r=[bore, 1.0, 2.0], z=[-1.0, 0.0, 2.0])
    assert set(mesh.boundaries) == {inside, "rim", "start", "end"}
    assert lengths(mesh, "rim").sum() == lengths(mesh, inside).sum() == 3
    assert lengths(mesh, "start").sum() == lengths(mesh, "end").sum() == 2 - bore
    assert np.all(mesh.p[0, mesh.facets[:, mesh.boundaries["rim"]]] == 2)
    assert np.all(mesh.p[1, mesh.facets[:, mesh.boundaries["end"]]] == 2)
    assert mesh.subdomains["body"].size == mesh.nelements == 4


@pytest.mark.parametrize(("start", "end"), [(4.5, 0.0), (4.5, 6.5)])
def test_stations_are_fine_at_their_start_and_grow_by_no_more_than_specified(start, end):
    s = stations(start=start, end=end, first=0.05, growth=1.6)
    size = np.diff(s) if end > start else np.diff(s)[::-1]
    assert (s[0], s[-1]) == (min(start, end), max(start, end))
    assert np.all(size > 0)
    assert np.all(size[1:] <= 1.6 * size[:-1])
    assert 0.8 * 0.05 < size[0] < 1.6 * 0.05
    fine = stations(start=start, end=end, first=0.05, growth=1.6, refine=3)
    np.testing.assert_allclose(fine[::3], s, atol=1e-12)


def test_a_cylinder_keeps_the_stations_of_contact_and_goes_on_beyond():
    z = stations(start=4.5, end=0.0, first=0.1, growth=1.6)
    mesh = half_cylinder(R=4.0, contact=z, overhang=2.0, bore=1.0, first=0.02)
    rim = np.unique(mesh.p[1, mesh.facets[:, mesh.boundaries["rim"]]])
    np.testing.assert_array_equal(rim[: z.size], z)
    assert rim[-1] == 6.5
    assert rim[z.size] - z[-1] == pytest.approx(z[-1] - z[-2], rel=0.5)
    assert mesh.p[0].min() == 1.0
    flush = half_cylinder(R=4.0, contact=z, first=0.02)
    assert flush.p[1].max() == 4.5
    assert "axis" in flush.boundaries


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: section(r=[0.0, 2.0, 1.0], z=[0.0, 1.0]),
            "stations r must have two or more ascending",
        ),
        (lambda: section(r=[0.0, 2.0], z=[0.0]), "stations z must have two or more ascending"),
        (
            lambda: section(r=[-1.0, 2.0], z=[0.0, 1.0]),
            "radii must not be negative, got r=-1 m",
        ),
        (lambda: stations(start=0.0, end=1.0, first=2.0, growth=1.5), "0 < first <= "),
        (lambda: stations(start=0.0, end=1.0, first=0.1, growth=1.0), "growth > 1"),
        (lambda: stations(start=0.0, end=1.0, first=0.1, growth=2.0, refine=0), "refine >= 1"),
        (lambda: half_cylinder(R=1.0, contact=[0, 1], bore=1.0, first=0.1), "0 <= bore < R"),
        (
            lambda: half_cylinder(R=1.0, contact=[0, 1], overhang=-1.0, first=0.1),
            "overhang must be finite and not negative",
        ),
        (
            lambda: half_cylinder(R=1.0, contact=[1, 2], first=0.1),
            "the stations of contact must ascend from 0",
        ),
        (
            lambda: chain([np.array([0.0, 1.0]), np.array([2.0, 3.0])]),
            "each part of stations must start at the end",
        ),
    ],
)
def test_what_makes_no_sense_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
