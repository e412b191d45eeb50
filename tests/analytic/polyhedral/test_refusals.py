"""Impossible polyhedral clutches are refused in one line that names the error."""

from dataclasses import replace
from math import atan

import numpy as np
import pytest

from analytic.polyhedral import forces, wedging
from analytic.polyhedral.bore_pressure import rim_displacement
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, RollerContact
from analytic.polyhedral.parts import PolyhedralParts
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress

nan = np.nan
PARTS = PolyhedralParts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)
LOADS = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": atan(0.05)}
STEEL = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
SIZES = {"z": 6, "d_e": 80.0, "d_i": 72.0, "rho": 2.0}
HEXAGON = Sector(**SIZES)
ROLLER = Roller(d=10.0, j_D=0.06)
SOFT = Roller(d=10.0, j_D=0.06, E=210e3, nu=0.3)
GROWTH = {"j_D": 6e-5, "d_i": 0.072, "d_e": 0.08, "E": 210e9}
UNIT = {"E": 1.0, "nu": 0.3, "assumption": "plane stress"}


def driven(roller=ROLLER, **change):
    contact = RollerContact(HEXAGON, roller, 210e3, 0.3, "plane stress")
    return Driven(contact, **{"grip": 0.08, "D_i": 100.06, "e": 9.0, "tan_phi": 0.05} | change)


def radial(**change):
    return forces.radial_force(
        **{"M_t": 1.0, "z": 6, "lever": 0.03, "psi": 0.3, "phi_1": 0.1} | change
    )


REFUSED = [
    *[(lambda change=change: replace(PARTS, **change), message) for change, message in (
        ({"z": 2}, "at least 3, got z=2"),
        ({"d_i": 0.08}, "must satisfy 0 < d_i < d_e, got d_i=0.08 m"),
        ({"rho": 0.036}, "it leaves no flat"),
        ({"d": 0.01003}, r"do not fit: d must be below \(D_i - d_e\)/2=0.01003 m, got"),
        ({"z": 29}, r"overlap: d must be below \(D_i - d\) sin\(pi/z\)=0.0097\d* m with z=29"),
        ({"e": 0.0181}, "hub must touch the flat: e must be at most 0.018 m, half the"),
        ({"D": 0.1}, "D of the race must exceed D_i=0.10006 m, got D=0.1 m"),
    )],
    *[(lambda change=change: PolyhedralClutch(PARTS, **LOADS | change), message)
      for change, message in (
        ({"p_t": -1.0}, "total pressure p_t must be finite and not negative, got -1.0 Pa"),
        ({"phi_1": 0.29}, "hub locks: psi must exceed the friction angle, got psi=16.10"),
        ({"alpha": 0.0}, "wedge angle must lie in"),
        ({"lever": "long"}, "lever must be one of exact, d_i/2, got 'long'"),
        ({"gamma": "up"}, "gamma must be one of normal, radius, got 'up'"),
    )],
    *[(lambda change=change: Sector(**SIZES | change), message) for change, message in (
        ({"z": 6.5}, "an integer of at least 3"),
        ({"d_i": 80.0}, "the wall vanishes: d_i must be below d_e, got d_i=80.0 m, d_e=80.0 m"),
        ({"rho": 36.0}, "rho must be less than d_i/2, got rho=36.0 m, d_i=72.0 m"),
    )],
    (lambda: forces.pressure_force(p_2=1.0, b=1.0, d_i=1.0, z=3.5), "at least 3, got z="),
    (lambda: forces.apothem(d_i=0.072, z=6, rho=0.036), "less than d_i/2=0.036 m, got 0.0"),
    (lambda: forces.contact_radius(apothem=0.03, psi=0.0), r"psi > 0, .* got psi=0.0 deg"),
    (lambda: radial(psi=1.5), r"psi \+ phi_1 < 90 deg, got psi=85.9\d* deg, phi_1=5.7\d* deg"),
    (lambda: forces.contact_force(F_s=1.0, psi=0.3, phi_1=-0.1), "phi_1 >= 0 and"),
    (lambda: wedging.cage_force(N=1.0, alpha=0.0, mu=0.1), r"\(0, 180\) deg, got 0.0 deg"),
    (lambda: wedging.cage_force(N=1.0, alpha=0.1, mu=1.2), r"in \(0, 1\), got mu=1.2"),
    (lambda: rim_displacement(0.0, sector=HEXAGON, p=1.0, **STEEL | {"assumption": "thin"}),
     "assumption must be one of"),
    (lambda: roller_load(sector=HEXAGON, a=21.0), "patches must not overlap: a must be less"),
    (lambda: roller_load(sector=HEXAGON, a=0.1).rim_displacement(1.0, **UNIT), "between 0 and pi"),
    (lambda: roller_load(sector=HEXAGON, a=0.1)(np.array([40.0 + 0j])), r"zeta. <= 0\.999 d_e/2"),
    (lambda: bore_stress(19.0, sector=HEXAGON, field=roller_load(sector=HEXAGON, a=0.1)),
     "arc lengths must lie between 0 and"),
    (lambda: bore_stress(9.0, sector=HEXAGON, field=hub_force(sector=HEXAGON, e=9.0, normal=1.0)),
     "infinite at the point force of the hub"),
    (lambda: hub_force(sector=HEXAGON, e=18.1, normal=1.0), "between mid-flat and corner"),
    (lambda: driven().pressure(0.0), "the roller's force N must be positive"),
    (lambda: driven(SOFT).pressure(1e6), "too large for a roller of d=10 m"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_clutches_that_make_no_sense_are_refused_in_one_line(call, message):
    with pytest.raises(ValueError, match=message) as refused:
        call()
    assert "\n" not in str(refused.value)
