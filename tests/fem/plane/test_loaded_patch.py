"""A wall under Hertz's pressure on a patch bears the load asked for; its nodes by angle."""

import numpy as np
import pytest

from analytic.ring.loaded_race import share
from fem.plane.material import Elastic
from fem.plane.patch import polar_nodes, solve_under_patch
from meshes.ring.sector import half_sector

SIZES = {"r_i": 1.0, "r_o": 1.5, "n": 6, "loaded": "bore", "patch": 0.05}


@pytest.fixture(scope="module")
def sector():
    return solve_under_patch(
        half_sector(**SIZES, refine=1, cells=3), material=Elastic(E=1.0, nu=0.3),
        assumption="plane stress", supports={"load cut": "n", "free cut": "n"},
        radius=1.0, a=0.05, P=2.0,
    )  # fmt: skip


def test_half_of_the_load_is_on_half_of_the_patch_on_few_cells(sector):
    x, _ = sector.f[sector.basis.nodal_dofs].sum(axis=1) + sector.f[sector.basis.facet_dofs].sum(
        axis=1
    )
    assert x == pytest.approx(float(share(0.05)), rel=1e-4)  # the mean of cos over the ellipse


def test_nodes_go_by_angle_and_agree_with_displacements_at_points(sector):
    theta, u_r, u_theta = polar_nodes(sector, "rim")
    assert np.all(np.diff(theta) > 0)
    assert theta[[0, -1]] == pytest.approx([0.0, np.pi / 6], abs=1e-12)
    k = theta.size // 2
    x, y = sector.at(1.5 * np.array([[np.cos(theta[k])], [np.sin(theta[k])]])).u[:, 0]
    c, s = np.cos(theta[k]), np.sin(theta[k])
    assert (u_r[k], u_theta[k]) == pytest.approx((x * c + y * s, y * c - x * s), rel=1e-6)
