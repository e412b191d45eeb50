"""References of contacts: their stated uncertainties, end faces, and wide contacts."""

from types import SimpleNamespace

import numpy as np
import pytest

from analytic.bounds.contact.roller import local_pressure
from tests.verify.cases.own import own
from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.reference import disc_fem
from verify.cases.contact.roller import end_fem, profiles
from verify.cases.contact.roller.crown_claims import RESOLVED, straight
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.end import END, EndFace
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.inputs import Crown, Tilt
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.slip.case import SLIP
from verify.cases.contact.slip.claims import HALF_PLANES, neglected
from verify.cases.contact.sphere import reference
from verify.cases.contact.sphere.case import Spheres
from verify.core.case import Context
from verify.core.results import Kind, Status

LEVEL = 20
SHARP = 1e-4  # of the value, that a row of the acceptance's 0.3 % can use


def test_the_peak_of_a_narrow_contact_is_rounded_as_stated():
    """Lengths times 1.03 round everywhere else: a/R = 1e-3, and the largest coordinate is R."""
    q, e, found = FLAT.inputs(), 1e-3, []
    for size in (1.0, 1.03):
        one = q.model_copy(update={"R": size * q.R})
        found.append(disc_fem(one, one.at_ratio(e).P, e * one.R, 3))
    difference = abs(found[1].peak - found[0].peak)
    stated = found[0].rounding("p_0", found[0].peak)
    assert 1e-10 * found[0].peak < difference < stated < 1e-6 * found[0].peak
    width = found[0].half_width
    assert abs(found[1].half_width / 1.03 - width) < found[0].rounding("a", width) < 1e-8 * width


def test_pressures_next_to_the_axis_of_a_sphere_are_even_however_small_the_contact():
    """Rows there weigh less than those at the equator by many orders of magnitude."""
    q = Spheres(P=1e-5).of("flat")
    a = q.width
    spheres = reference.problem(q, 2)
    down = {"upper.middle": {"y": -(a**2) / q.R_1}}
    touch = spheres.solve(displacements=down).touches[0]
    near = touch.x[0] < a / 3
    p = touch.pressure[near] / np.sqrt(1 - (touch.x[0][near] / a) ** 2)
    assert np.ptp(p) < 2e-3 * p.mean()


def test_the_reference_s_crown_and_tilt_are_those_of_the_inputs_as_small_angles_are():
    theta = np.pi / 180
    for q, bound in ((Crown(), 0.0), (Tilt(theta=theta), theta**3 / 4)):
        y = np.linspace(-q.L / 2, q.L / 2, 4001)
        A = q.K_1 * q.Q / (np.pi * q.L * q.E_star)
        assert np.abs(profiles.gap(q)(y) - q.gap(y)).max() <= bound * q.L + 1e-9 * A


def test_the_half_space_states_what_neighbouring_grids_differ_by():
    q = TILTED.inputs()
    found = TILTED.reference(q, LEVEL)
    beside = [pressed(q, LEVEL + step).values for step in (-1, 1)]
    for key in ("p_max", "p_mid", "delta", "F_low", "F_high", "F_d", "M"):
        apart = max(abs(values[key] - found.values[key]) for values in beside)
        assert found.u_it[key] >= apart, key
        sharp = key in ("p_max", "p_mid", "delta")
        assert not sharp or found.u_it[key] < SHARP * found.values[key], key
    assert 0 < found.u_it["p_best"] < 1e-3 * found.values["p_best"]


@pytest.mark.parametrize(("a_over_R", "status"), [(0.03, Status.PASS), (0.15, Status.SHOWN)])
def test_wide_contacts_are_judged_as_approximations(a_over_R, status):
    q = SLIP.inputs(P=SLIP.inputs().P * (a_over_R / 0.0099) ** 2)
    (check,) = [c for c in SLIP.checks if c.name == "cycle: energy lost, by the work of friction"]
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


COARSE = 1


@pytest.fixture(scope="module")
def bodies():
    """Race, roller with its end face and roller that goes on."""
    q = EndFace()
    race = end_fem.compliance_fem(q, COARSE, race=True, overhang=q.overhang)
    face = end_fem.compliance_fem(q, COARSE, race=False, overhang=0.0)
    beyond = end_fem.compliance_fem(q, COARSE, race=False, overhang=q.overhang)
    return q, race, face, beyond


def test_a_face_takes_load_off_the_ends_and_hertz_holds_at_mid_length(bodies):
    q, race, face, beyond = bodies
    contacts = [end_fem.contact_fem(q, COARSE, (roller, race), "flat") for roller in (face, beyond)]
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
    found = end_fem.contact_fem(q, COARSE, (beyond, race), "flat")
    assert found.across[-1] == pytest.approx(2.0 * q.b, rel=1e-3)
