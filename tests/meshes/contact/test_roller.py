"""The half roller is a half disc, fine at both ends of the diameter across which it is pressed."""

from math import pi

import numpy as np
import pytest
from skfem import Basis, ElementQuad1

from meshes.contact.roller import half_roller
from tests.meshes.measures import measure

R, ZONES = 0.005, (1e-4, 3e-4)  # [m]


@pytest.mark.parametrize("zones", [(R / 2, 1e-5), (1e-5, R / 2)])
def test_cells_are_not_folded_and_fill_half_a_disc(zones):
    mesh = half_roller(R=R, zones=zones, refine=2)
    assert Basis(mesh, ElementQuad1(), intorder=6).dx.min() > 0
    assert measure(mesh) == pytest.approx(pi / 2 * R**2, rel=1e-4)


@pytest.mark.parametrize(("name", "zone"), [("near", ZONES[0]), ("far", ZONES[1])])
def test_each_end_has_its_even_cells_on_its_own_zone(name, zone):
    cells, refine = 4, 3
    mesh = half_roller(R=R, zones=ZONES, refine=refine, cells=cells)
    y = np.unique(mesh.p[1, mesh.facets[:, mesh.boundaries[name]]])
    fine = y[y < zone * (1 + 1e-9)]
    assert fine.size == cells * refine + 1
    np.testing.assert_allclose(np.diff(np.arcsin(fine / R)), np.arcsin(zone / R) / fine[1:].size,
                               rtol=1e-6)  # fmt: skip


@pytest.mark.parametrize("zones", [(0.0, 1e-4), (1e-4, 0.51 * R), (float("nan"), 1e-4)])
def test_zones_that_do_not_fit_are_refused(zones):
    with pytest.raises(ValueError, match=r"fine zones of a roller need 0 < zone <= R/2, got zone="):
        half_roller(R=R, zones=zones, refine=1)
