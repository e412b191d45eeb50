"""Loads applied through the motion of sections: discs, a sector and its hub, a wedged roller."""

import math
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.driven import DrivenSector
from fem.contact.driven_discs import HIT, DrivenDiscs
from fem.contact.errors import NotFoundError
from fem.contact.locked import FlatSector, LockedSector, rigid_roller
from fem.contact.pressed_line import PressedLine
from fem.contact.wedged import Geometry, Wedge
from fem.contact.wedged_states import least_friction, slipping, uneven
from fem.plane.material import Elastic
from meshes.contact.block import full_block
from meshes.contact.disc import quarter_disc
from meshes.contact.tilted import placed, tilted_half_disc
from meshes.join import join
from meshes.polyhedral.half_sector import half_sector
from tests.fem.contact.models import on_flat, rollers

STEEL = Elastic(E=2.0, nu=0.3)
SOFT = (1 - 0.3**2) / 2.0


def pressed(a):
    """A disc on a flat under Hertz's load for the half-width `a`."""

    def mesh(zone, cells, refine):
        disc = quarter_disc(R=1.0, zone=zone, cells=cells, refine=refine)
        return on_flat(disc, materials=STEEL, supports={"axis": "x", "middle": "y"})

    P = np.pi / 4 * a**2 / SOFT
    return PressedLine(mesh, 2, P=P, guess=a, arc=1.0, softness=SOFT, cut="middle")


def test_a_disc_on_a_flat_carries_its_load_with_hertz_s_pressure():
    one, narrow = pressed(0.02), pressed(0.002)
    assert 2 * abs(one.touch.force[1]) == pytest.approx(one.P, rel=1e-11)
    assert one.half_width == pytest.approx(0.02, rel=5e-3)
    assert one.peak == pytest.approx(2 * one.P / (np.pi * 0.02), rel=5e-3)
    shear, depth = one.shear()
    assert shear / one.peak == pytest.approx(0.3003, rel=0.05)
    assert depth / one.half_width == pytest.approx(0.786, rel=0.05)
    assert max(map(abs, one.balance(("axis", "middle")).values())) < 1e-9 * one.P
    # round-off grows as the contact shrinks
    shares = [some.rounding("p_0", some.peak) / some.peak for some in (one, narrow)]
    assert shares[1] > 5 * shares[0]
    assert one.rounding("a", 1.0) < one.rounding("p_0", 1.0)


def test_two_discs_are_driven_until_both_loads_are_met():
    fine = {"zone": 0.06, "cells": 8, "refine": 1}
    problem = rollers(0.3, R=1.0, fine=fine, materials=STEEL)
    P = np.pi / 4 * 0.05**2 / SOFT
    discs = DrivenDiscs(problem, P=P, approach=0.05**2)
    state, cut = discs.pressed
    assert np.abs(np.array(state.touches[0].force) - (0.0, -P)).max() <= HIT * P
    pushed, moved = discs.loaded(0.1 * P, cut, state)
    assert np.abs(np.array(pushed.touches[0].force) - (0.1 * P, -P)).max() <= HIT * P
    assert moved[0] > cut[0]
    assert 0 < pushed.touches[0].sticking_share <= 1


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
    assert np.inf == driven(3.0).N  # a hub that lifts more than its roller carries


def test_a_pressure_that_is_not_found_is_no_result():
    never = SimpleNamespace(force=lambda p, hub=(0.0, 0.0): 1 + p**2)  # as little as is asked for
    with pytest.raises(NotFoundError, match="did not converge"):
        DrivenSector(lambda *_: never, kappa=0.1, phi_1=0.0, p=1.0).pressure(0.5)


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


HALF, WIDTH = math.radians(3), 0.05
N = math.pi * WIDTH**2 / (8 * (1 - 0.3**2))  # Hertz, E = 1, two equal bodies


def wedge(*, caged):
    geometry = Geometry(1.0, HALF, WIDTH)
    fine = {"zone": 1.15 * WIDTH, "cells": 7, "refine": 1}
    x, y = geometry.normal
    race = full_block(width=1.0, depth=1.0, above=True, **fine)
    roller = tilted_half_disc(R=1.0, tilt=HALF, **fine)
    mesh = join({"roller": roller, "race": placed(race, turn=-HALF, shift=(float(x), float(y)))})
    return Wedge(geometry, mesh, E=1.0, nu=0.3, mu=0.2, caged=caged)


@pytest.fixture(scope="module")
def free():
    return wedge(caged=False)


def test_a_cage_holds_the_middle_and_the_cut_stays_straight():
    state = wedge(caged=True).at(0.1 * WIDTH, along=0.05 * WIDTH)
    inner, outer = (state.plane.on_boundary(f"roller.{name}").u for name in ("inner", "outer"))
    assert not np.any(inner)
    assert not np.any(outer[1])
    assert np.any(outer[0])  # along the cut


def test_a_free_roller_uses_the_friction_of_its_balance(free):
    state, down = free.pressed(N)
    found, tangential = free.forces(state)
    assert found == pytest.approx(N, rel=1e-11)
    assert tangential / found == pytest.approx(math.tan(HALF), rel=1e-8)
    assert 0 < down < WIDTH


def test_what_grows_in_proportion_sticks(free):
    """All in one step a part slips, in many steps next to nothing: q is tan(alpha/2) p then."""
    state, down = free.pressed(N)
    at_once, grown = (one.touches[0] for one in (state, free.at(down, steps=20)))
    assert slipping(grown) < 0.03 < slipping(at_once)
    assert uneven(grown, math.tan(HALF)) < 0.2 < uneven(at_once, math.tan(HALF))


def test_a_push_that_balances_the_normal_force_leaves_no_friction(free):
    state, _ = free.pressed(N, push=N * math.sin(HALF))
    found, tangential = free.forces(state)
    assert abs(tangential) < 1e-8 * found


def test_a_bracket_that_misses_the_limit_finds_none():
    value, half = least_friction(lambda mu: float(mu > 0.05), 0.0505)
    assert math.isnan(value)
    assert half == 0.0
