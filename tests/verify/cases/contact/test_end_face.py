"""Case contact-roller-end: what an end face takes off the ends, and statements that can fail."""

import pytest

from analytic.bounds.contact.roller import local_pressure
from verify.cases.contact.roller import end_fem
from verify.cases.contact.roller.end import END, EndFace
from verify.core.case import Context
from verify.core.results import Status

LEVEL = 1


@pytest.fixture(scope="module")
def bodies():
    """Race, roller with its end face and roller that goes on, coarse."""
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


def statuses(context, name):
    rows = [row for check in END.checks for row in check.rows(context)]
    return {row.quantity: row.status for row in rows if row.quantity.startswith(name)}


def made_up(**changes):
    """A run whose levels all have the values of a good one, but for `changes` (key: factor)."""
    good = {
        "local_end_flat": 1.0001, "local_end_crowned": 1.0002, "F_d_end_flat": 407.0,
        "F_d_end_crowned": 184.3, "F_d_control_flat": 534.0, "F_d_control_crowned": 225.1,
        "sharpness": -0.2261,
    }  # fmt: skip
    values = {key: value * changes.get(key, 1.0) for key, value in good.items()}
    q = EndFace()
    levels = [
        end_fem.Level(h=1 / n, values={k: v * (1 + 1e-5 / n**2) for k, v in values.items()})
        for n in (2, 3, 4)
    ]
    return Context("contact-roller-end", q, END.analytic(q), levels, is_paper=True)


@pytest.mark.parametrize(
    ("key", "factor", "name"),
    [
        ("local_end_flat", 1.005, "pressure at mid-length"),
        ("F_d_end_flat", 1.3, "the end face takes"),
        ("F_d_control_crowned", 0.9, "most of it"),
        ("sharpness", 0.99, "sharpness"),
        ("sharpness", 0.5 / 0.226, "sharpness"),  # a half-space's
    ],
)
def test_a_wrong_result_of_finite_elements_fails(key, factor, name):
    assert set(statuses(made_up(), name).values()) == {Status.PASS}
    assert Status.FAIL in statuses(made_up(**{key: factor}), name).values()


def test_what_a_half_space_leaves_out_is_measured_and_not_judged():
    found = statuses(made_up(), "load within d")
    measured = {s for quantity, s in found.items() if not quantity.endswith("convergence")}
    assert measured == {Status.SHOWN}
