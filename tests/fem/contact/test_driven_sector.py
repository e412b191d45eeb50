"""A sector whose hub's force goes with its roller's: beside a ring whose force is linear."""

from dataclasses import dataclass

import numpy as np
import pytest

from fem.contact.driven import DrivenSector
from fem.contact.errors import NotFoundError
from fem.contact.locked import FlatSector, LockedSector, rigid_roller
from fem.plane.material import Elastic
from meshes.join import join
from meshes.polyhedral.half_sector import half_sector


@dataclass(frozen=True)
class Linear:
    """Force of a roller that pressure and the hub's normal force raise in proportion."""

    lift: float

    def force(self, p, hub=(0.0, 0.0)):
        return 2.0 * (p - 1.0) + self.lift * hub[0]


def driven(lift, meshes=None):
    def mesh(fine, p, hub):
        if meshes is not None:
            meshes.append((fine, p, hub))
        return Linear(lift)

    return DrivenSector(mesh, kappa=0.4, phi_1=0.1, p=3.0)


def test_roller_and_hub_share_what_pressure_brings():
    meshes = []
    one = driven(0.5, meshes)
    share = 0.5 * 0.4 * np.cos(0.1)
    assert pytest.approx(4.0 / (1 - share), rel=1e-9) == one.N
    assert [fine for fine, *_ in meshes] == [False, True]
    assert meshes[1][2] == pytest.approx(one.push(one.N), rel=1e-9)
    assert one.pressure(8.0) == pytest.approx(1 + 4.0 * (1 - share), rel=1e-9)
    assert one.push(2.0) == pytest.approx((0.8 * np.cos(0.1), -0.8 * np.sin(0.1)))


def test_a_hub_that_lifts_more_than_its_roller_bears_has_no_limit():
    assert np.inf == driven(3.0).N


def test_a_pressure_that_is_not_found_is_no_result():
    class Bent(Linear):
        def force(self, p, hub=(0.0, 0.0)):
            return 1 + p**2  # never as little as is asked for

    with pytest.raises(NotFoundError, match="missed by"):
        DrivenSector(lambda *_: Bent(0.0), kappa=0.1, phi_1=0.0, p=1.0).pressure(0.5)


def test_forces_on_half_a_sector_are_in_balance():
    z, d_e, d_i, rho = 6, 0.08, 0.072, 0.002
    apothem = (d_i / 2 - rho) * np.cos(np.pi / z) + rho
    sector = FlatSector(np.pi / z, d_i, d_e, apothem, 6e-5)
    mesh = join({"ring": half_sector(z=z, d_e=d_e, d_i=d_i, fillet=rho, refine=1, zone=2e-4,
                                     cells=4)})  # fmt: skip
    problem = rigid_roller(sector, mesh, d=0.01, material=Elastic(E=210e9, nu=0.3))
    ring = LockedSector(sector, problem, 0.01)
    rest_x, rest_y, hoop = ring.balance(30e6, (0.0, 0.0))
    side = 30e6 * d_i * np.sin(np.pi / z)
    assert max(abs(rest_x), abs(rest_y)) < 1e-8 * side
    assert abs(hoop) > 0.1 * side
    assert 0 < ring.force(30e6) < side
    assert ring.half_widths(30e6)[1] == 0.0
