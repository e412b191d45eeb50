"""Case contact-roller-end: what an end face takes off the ends, on coarse meshes."""

import pytest

from analytic.bounds.contact.roller import local_pressure
from verify.cases.contact.roller import end_fem
from verify.cases.contact.roller.end import END, EndFace

LEVEL = 1


@pytest.fixture(scope="module")
def bodies():
    """Race, roller with its end face and roller that goes on."""
    q = EndFace()
    race = end_fem.compliance_fem(q, LEVEL, race=True, overhang=q.overhang)
    face = end_fem.compliance_fem(q, LEVEL, race=False, overhang=0.0)
    beyond = end_fem.compliance_fem(q, LEVEL, race=False, overhang=q.overhang)
    return q, race, face, beyond


def test_a_face_takes_load_off_the_ends_and_hertz_holds_at_mid_length(bodies):
    q, race, face, beyond = bodies
    contacts = [end_fem.contact_fem(q, LEVEL, (roller, race), "flat") for roller in (face, beyond)]
    assert 2 * contacts[0].load_between(0.0, q.L / 2) == pytest.approx(q.F, rel=1e-10)
    with_face, without = (end_fem.read(q, contact) for contact in contacts)
    on = END.analytic(q)["F_d_flat"]
    assert with_face["F_d"] < 0.8 * on
    assert 0.9 * on < without["F_d"] < on
    low, high = local_pressure(b=q.b, R=q.R_1, length=q.L)
    # coarse: 2e-3 of cells more; without 1 - nu² it would be 4 % off
    assert 0.5 * low < with_face["local"] - 1 < 5 * high


def test_a_wider_patch_is_taken_where_the_contact_needs_it(bodies, monkeypatch):
    q, race, _, beyond = bodies
    monkeypatch.setattr(end_fem, "WIDE", (0.5, 2.0))
    found = end_fem.contact_fem(q, LEVEL, (beyond, race), "flat")
    assert found.across[-1] == pytest.approx(2.0 * q.b, rel=1e-3)
