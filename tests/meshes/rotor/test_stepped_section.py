"""Half-sections of stepped shafts: areas, boundaries, fine corners, refusals."""

import numpy as np
import pytest

from meshes.rotor.stepped import stepped_section
from tests.meshes.measures import areas, lengths

PARTS = [(0.1, 0.04, 0.0), (0.2, 0.08, 0.02), (0.15, 0.05, 0.02)]


def test_areas_and_boundaries_are_those_of_the_parts():
    refine = 3
    mesh = stepped_section(PARTS, bands={"seat": (0.02, 0.05)}, first=2e-3, refine=refine)
    assert abs(areas(mesh)).sum() == pytest.approx(0.1 * 0.02 + 0.2 * 0.03 + 0.15 * 0.015)
    expected = {
        "axis": 0.1, "rim": 0.45, "bore": 0.35, "seat": 0.03, "start": 0.02, "end": 0.015,
    }  # fmt: skip
    assert {name: lengths(mesh, name).sum() for name in expected} == pytest.approx(expected)
    assert np.all(mesh.subdomains["body"] == np.arange(mesh.nelements))
    places = {name: mesh.p[:, mesh.facets[:, f]] for name, f in mesh.boundaries.items()}
    assert np.allclose(places["seat"][0], 0.02)
    assert [places["seat"][1].min(), places["seat"][1].max()] == pytest.approx([0.02, 0.05])
    assert np.allclose(places["bore"][0], 0.01)
    assert np.allclose(places["end"][1], 0.45)


def test_cells_are_fine_at_the_corners_and_halve():
    coarse, fine = (stepped_section(PARTS, first=1e-3, refine=n) for n in (1, 2))
    assert fine.nelements == 4 * coarse.nelements
    for corner in ([0.02, 0.1], [0.025, 0.3], [0.04, 0.3]):
        node = np.argmin(np.linalg.norm(coarse.p - np.array(corner)[:, None], axis=0))
        assert np.allclose(coarse.p[:, node], corner)
        beside = abs(areas(coarse))[np.any(coarse.t == node, axis=0)]
        assert np.sqrt(beside.max()) < 1.5e-3


@pytest.mark.parametrize(
    ("parts", "bands", "message"),
    [
        ([], {}, "a shaft must have at least one part, got"),
        ([(0.1, 0.04, 0.04)], {}, "0 <= d_i < d_o"),
        ([(-0.1, 0.04, 0.0)], {}, "length > 0"),
        ([(0.1, 0.04, 0.0), (0.1, 0.08, 0.04)], {}, "d_o=0.04, d_i=0 m and d_o=0.08"),
        (PARTS, {"seat": (0.4, 0.5)}, "must lie on the shaft"),
        (PARTS, {"seat": (0.2, 0.1)}, "0 <= low < high <="),
    ],
)
def test_what_makes_no_sense_is_refused(parts, bands, message):
    with pytest.raises(ValueError, match=message):
        stepped_section(parts, bands=bands, first=2e-3)
