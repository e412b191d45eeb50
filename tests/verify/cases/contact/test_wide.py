"""Contacts too wide for half planes and half-spaces, and crowns of rollers of every length."""

from types import SimpleNamespace

import pytest

from tests.verify.cases.own import own
from verify.cases.contact.roller.crown_claims import RESOLVED, straight
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.slip.case import SLIP
from verify.cases.contact.slip.claims import HALF_PLANES, neglected
from verify.core.case import Context
from verify.core.results import Kind, Status


@pytest.mark.parametrize(("a_over_R", "status"), [(0.03, Status.PASS), (0.15, Status.SHOWN)])
def test_wide_contacts_are_judged_as_approximations(a_over_R, status):
    q = SLIP.inputs(P=SLIP.inputs().P * (a_over_R / 0.0099) ** 2)
    (check,) = [c for c in SLIP.checks if c.name == "cycle: energy lost, work of friction"]
    exact = q.W * (1 + 1.3 * a_over_R**2)  # what discs were found to lose
    fem = [SimpleNamespace(h=h, values={"work": exact}, u_it={}) for h in (1.0, 0.5, 0.25)]
    row, _ = check.rows(Context("contact-slip", q, SLIP.analytic(q), fem, is_paper=False))
    assert (row.kind, row.status) == (Kind.APPROXIMATION, status)
    assert (row.interval is None) == (status is Status.SHOWN)
    assert neglected(SLIP.inputs()) < HALF_PLANES


@pytest.mark.parametrize("length", ["1 mm", "1000 mm"])
def test_the_straight_middle_of_rollers_of_every_length_is_that_of_k_2(length):
    q = own(CROWNS, L=length, F="120 N", d="0.2 mm")
    moved, U, _ = straight(Context(CROWNS.id, q, {}, [], False))
    assert moved + U < RESOLVED
