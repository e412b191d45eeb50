"""Half a pitch and a quarter of a ring: cells, names, sizes, for thin to thick rings."""

import numpy as np
import pytest

from meshes.ring.quarter import quarter_ring
from meshes.ring.sector import half_sector
from tests.meshes.measures import areas, lengths

RACE = {"r_i": 1.0, "r_o": 1.5, "n": 12, "loaded": "bore", "patch": 0.01}


@pytest.mark.parametrize("loaded", ["bore", "rim"])
@pytest.mark.parametrize(
    ("n", "ratio", "alpha"), [(2, 4.0, 1e-4), (12, 1.35, 0.1), (48, 1.05, 8e-3)]
)
def test_cells_fill_the_sector_without_folds(n, ratio, alpha, loaded):
    r = 1.0 if loaded == "bore" else ratio
    mesh = half_sector(r_i=1.0, r_o=ratio, n=n, loaded=loaded, patch=alpha * r, refine=1)
    area = areas(mesh)
    assert np.all(area > 0)
    assert area.sum() == pytest.approx(np.pi / n * (ratio**2 - 1) / 2, rel=0.02)  # chords
    assert mesh.nelements < 2500
    flat = half_sector(r_i=1.0, r_o=ratio, n=n, loaded=loaded, patch=alpha * r, refine=1,
                       straight=True)  # fmt: skip
    assert flat.doflocs.shape[1] == flat.nvertices == mesh.nvertices
    sides = lengths(mesh, np.arange(mesh.nfacets))[mesh.t2f]
    assert (sides.max(axis=0) / sides.min(axis=0)).max() < 8
    radius, angle = np.hypot(*mesh.p), np.arctan2(mesh.p[1], mesh.p[0])
    assert radius.min() == pytest.approx(1.0, rel=1e-12)
    assert radius.max() == pytest.approx(ratio, rel=1e-12)
    assert angle.min() == pytest.approx(0, abs=1e-12)
    assert angle.max() == pytest.approx(np.pi / n, rel=1e-12)
    patch = np.unique(mesh.facets[:, mesh.boundaries["patch"]])
    np.testing.assert_allclose(radius[patch], r, rtol=1e-12)
    assert angle[patch].max() * r == pytest.approx(alpha * r, rel=1e-12)
    assert patch.size == 9  # eight cells
    assert set(mesh.boundaries["patch"]) < set(mesh.boundaries[loaded])


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"r_o": 0.9}, "0 < r_i < r_o"),
        ({"n": 1}, "balanced, evenly spaced loads require n >="),
        ({"loaded": "side"}, "'bore' or 'rim'"),
        ({"patch": 0.2}, "a quarter of the pitch"),
        ({"r_o": 1.005}, "the patch must be positive, at most a quarter"),
        ({"refine": 0}, "refine >= 1"),
    ],
)
def test_a_sector_without_sense_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        half_sector(**RACE | {"refine": 1} | wrong)
    for r_i, r_o in ((0.0, 1.0), (2.0, 1.0), (float("nan"), 1.0)):
        with pytest.raises(ValueError, match="0 < r_i < r_o"):
            quarter_ring(r_i=r_i, r_o=r_o, refine=1)
