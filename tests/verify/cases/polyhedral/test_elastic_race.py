"""Torque of the clutch in an elastic race, which the verdicts of Belcin's Eqs. 16 to 21 state."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from analytic.contact import hertz_line
from analytic.polyhedral.locking import RollerContact
from analytic.ring import lame
from analytic.ring.loaded_race import LoadedRace
from verify.cases.polyhedral.clutch.case import PolyhedralClutch
from verify.verdicts.declared import declared


@dataclass(frozen=True, kw_only=True)
class InElasticRace(RollerContact):
    """The roller in a race of the ring's material, free outside at the diameter D_o [m]."""

    D_i: float
    D_o: float

    def half_width_on_race(self, N: float) -> float:
        R = hertz_line.relative_radius(R_1=self.roller.d / 2, R_2=-self.D_i / 2)
        return float(hertz_line.half_width(P=N, R=R, E_star=self.E_plane / 2))

    def closure(self, N: float) -> float:
        race = LoadedRace(
            r_i=self.D_i / 2, r_o=self.D_o / 2, E=self.E, nu=self.nu, assumption=self.assumption,
            loaded="bore", n=self.sector.z, P=N, a=self.half_width_on_race(N),
        )  # fmt: skip
        return super().closure(N) + float(race.displacement(self.D_i / 2, 0.0))


def in_race(q, D_o):
    """The clutch's ring in an elastic race of the outside diameter `D_o` [m]."""
    c = q.hub.contact
    race = InElasticRace(c.sector, c.roller, c.E, c.nu, c.assumption, D_i=q.D_i, D_o=D_o)
    return replace(q.hub, contact=race)


def test_the_verdicts_state_the_torque_that_an_elastic_race_costs():
    q = PolyhedralClutch()
    thin, thick = (100 * (1 - in_race(q, D_o).force(q.p_t) / q.line_load) for D_o in (0.12, 0.2))
    words = (
        f"an elastic race lowers the torque by {thin:.0f} % (outer diameter of the race 120 mm) "
        f"or by {thick:.0f} % (200 mm)"
    )
    rigid = [f for f in declared()["belcin"].formulas if f.equation in (16, 17, 20, 21)]
    assert len(rigid) == 7
    assert all(words in f.limited_by for f in rigid)
    assert all("rigid race" in f.instead for f in rigid if f.instead)


@pytest.mark.parametrize(("D_o", "error"), [(0.12, 5.01), (0.2, 3.58)])
def test_the_torque_of_eq_20_errs_more_in_an_elastic_race(D_o, error):
    q = PolyhedralClutch()
    torque = q.M_el * in_race(q, D_o).force(q.p_t) / q.line_load
    assert q.M_20 / torque - 1 == pytest.approx(error, abs=0.02)
    assert q.M_20 / torque > q.M_20 / q.M_el


def test_a_race_under_even_pressure_widens_as_lame_s():
    q = PolyhedralClutch()
    race = LoadedRace(r_i=q.D_i / 2, r_o=0.1, E=q.E, nu=q.nu, assumption="plane stress",
                      loaded="bore", n=200, P=1e3, a=3e-4)  # fmt: skip
    even = lame.radial_displacement(
        q.D_i / 2, r_i=q.D_i / 2, r_o=0.1, p_i=race.mean_pressure, E=q.E, nu=q.nu,
        ends="plane stress",
    )  # fmt: skip
    angles = np.linspace(0, np.pi / 200, 400)
    assert np.mean(race.at(q.D_i / 2, angles).u_r) == pytest.approx(float(even), rel=2e-3)
