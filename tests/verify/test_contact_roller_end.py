"""The end face: what its finite elements are told, and faults that its rows must see."""

import pytest
from pydantic import ValidationError

from analytic.bounds.contact.roller import local_pressure
from verify.cases.contact.roller import end_fem
from verify.cases.contact.roller.end import END, EndFace
from verify.cases.contact.roller.inputs import Roller
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


def read(q, roller, race, crown="flat"):
    return end_fem.read(q, end_fem.contact_fem(q, LEVEL, (roller, race), crown))


def test_the_whole_load_is_carried_by_both_halves(bodies):
    q, race, face, _ = bodies
    found = end_fem.contact_fem(q, LEVEL, (face, race), "flat")
    assert 2 * found.load_between(0.0, q.L / 2) == pytest.approx(q.F, rel=1e-10)


def test_a_face_takes_load_off_the_ends_and_more_than_the_bodies_size_does(bodies):
    q, race, face, beyond = bodies
    on = END.analytic(q)["F_d_flat"]
    with_face, without = (read(q, roller, race)["F_d"] for roller in (face, beyond))
    assert with_face < 0.8 * on
    assert 0.9 * on < without < on


def test_hertz_holds_at_mid_length_and_a_wrong_modulus_would_be_seen(bodies, monkeypatch):
    q, race, face, _ = bodies
    low, high = local_pressure(b=q.b, R=q.R_1, length=q.L)
    assert 0.5 * low < read(q, face, race)["local"] - 1 < 5 * high  # coarse: 2e-3 of cells more
    monkeypatch.setattr(Roller, "E_star", property(lambda q: q.E_1 / 2))  # without 1 - nu²
    assert abs(read(q, face, race)["local"] - 1) > 0.02


def judged(context, name):
    return [
        row for check in END.checks for row in check.rows(context) if row.quantity.startswith(name)
    ]


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
def test_a_wrong_value_turns_its_row_red(key, factor, name):
    states = {row.status for row in judged(made_up(), name)}
    assert states == {Status.PASS}
    wrong = {row.status for row in judged(made_up(**{key: factor}), name)}
    assert Status.FAIL in wrong


def test_what_a_half_space_costs_is_shown_and_not_judged():
    rows = judged(made_up(), "load within d")
    assert {row.status for row in rows if not row.quantity.endswith("convergence")} == {
        Status.SHOWN
    }


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R_2": -0.02}, "R_2 must be positive here"),
        ({"R_2": 0.2}, "radii may differ by a factor of 5 to 20"),
        ({"overhang": 1e-5}, "the overhang must be 0.05 to 3 lengths"),
        ({"L": 0.1, "overhang": 0.02}, "length must be 0.2 to 20 radii"),
    ],
)
def test_bodies_that_it_cannot_mesh_are_refused(change, message):
    with pytest.raises(ValidationError, match=message):
        EndFace(**change)


def test_a_wider_patch_is_taken_where_the_contact_needs_it(bodies, monkeypatch):
    q, race, _, beyond = bodies
    monkeypatch.setattr(end_fem, "WIDE", (0.5, 2.0))
    found = end_fem.contact_fem(q, LEVEL, (beyond, race), "flat")
    assert found.across[-1] == pytest.approx(2.0 * q.b, rel=1e-3)
