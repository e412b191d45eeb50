"""Torque of the clutch in an elastic race, which the verdicts of Belcin's Eqs. 16 to 21 state."""

from dataclasses import dataclass, replace

import pytest

from analytic.contact import hertz_line
from analytic.polyhedral.locking import RollerContact
from analytic.ring.loaded_race import LoadedRace
from verify.cases.polyhedral.clutch.case import PolyhedralClutch


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


@pytest.mark.parametrize(
    ("D_o", "torque", "pressure"), [(0.12, 0.41, 0.20), (0.14, 0.29, 0.12), (0.2, 0.24, 0.09)]
)
def test_an_elastic_race_lowers_the_torque_and_raises_the_pressure(D_o, torque, pressure):
    q = PolyhedralClutch()
    rigid = q.hub
    c = rigid.contact
    race = InElasticRace(c.sector, c.roller, c.E, c.nu, c.assumption, D_i=q.D_i, D_o=D_o)
    soft = replace(rigid, contact=race)
    print(D_o, soft.force(q.p_t) / q.line_load, q.M_20 / (q.M_el * soft.force(q.p_t) / q.line_load),
      q.M_21 / (q.M_el * soft.force(q.p_t) / q.line_load),
          soft.required_pressure(q.line_need) / q.p_need, q.p_20/soft.required_pressure(q.line_need),q.p_17/(soft.required_pressure(q.line_need)-q.touch))
    assert 1 - soft.force(q.p_t) / q.line_load == pytest.approx(torque, abs=0.005)
    assert soft.required_pressure(q.line_need) / q.p_need - 1 == pytest.approx(pressure, abs=0.005)
