"""Readings of the papers on polyhedral rings: another reading fails against finite elements."""

import math

import pytest

from analytic.bounds.polyhedral.flat import filleted
from analytic.contact import partial_slip
from analytic.polyhedral import expansion, torque, wedging
from tests.verify.cases.own import own
from tests.verify.cases.readings import given
from verify.cases.polyhedral.clutch.case import CLUTCH
from verify.cases.polyhedral.ring import case as polyhedral_ring
from verify.cases.polyhedral.ring.case import RING
from verify.cases.polyhedral.wedge.case import WEDGE, WedgedRoller

OTHER = {"plane stress": "plane strain", "plane strain": "plane stress"}
EQ_20 = "torque, Eq. 20"
EQ_21 = "torque of the first design, Eq. 21"


READINGS = [
    pytest.param(RING, expansion, "mean_hoop_stress", given(p=lambda k: 1.0999 * k["p"]),
                 "mean hoop stress in the corners, Eq. 12", id="Eq. 12 as printed"),
    pytest.param(RING, polyhedral_ring, "hub_force", given(along=lambda k: -k["along"]),
                 "displacement of the outer surface at the middle of the flats under the hub "
                 "force at e",
                 id="the hub's friction reversed"),
    pytest.param(CLUTCH, torque, "hub_share", given(gamma=lambda _: 0.0), EQ_21,
                 id="gamma = 0 in the first design"),
    pytest.param(CLUTCH, torque, "hub_share", given(gamma=lambda k: k["psi"]), EQ_20,
                 id="gamma = psi in Eq. 20"),
    pytest.param(WEDGE, wedging, "least_normal_force", lambda _: lambda *, M_t, mu, z, D_i: M_t / (
        z * D_i / 2 * math.tan(WedgedRoller().half)),
                 "normal force per torque of caged rollers (Eq. 4)",
                 id="a free roller's force in Eq. 4"),
    pytest.param(WEDGE, partial_slip, "stick_half_width", lambda _: lambda *, Q, P, mu, a: a * (
        1 - Q / (mu * P)),
                 "stick half-width at T/(μN) = 0.4 (roller pressed without friction, then loaded "
                 "tangentially)",
                 id="c/a = 1 - T/(μN)"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)


@pytest.mark.parametrize("change", [{}, {"tan_phi": 0.2, "mu": 0.05}])
def test_eqs_17_to_21_are_the_statics_of_vectors(change):
    q = own(CLUTCH, **change)
    v = CLUTCH.analytic(q)
    flat = filleted(q.flat, q.touch)
    assert flat.torque(q.p_t) == pytest.approx(v["M_20"], rel=1e-9)
    assert flat.pressure(q.M_t) == pytest.approx(v["p_20"], rel=1e-9)
    assert q.torque_of_first_design() == pytest.approx(v["M_21"], rel=1e-12)
