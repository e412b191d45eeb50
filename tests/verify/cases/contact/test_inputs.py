"""Contacts of a user's own: what is warned of, not compared and refused."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.verify.cases.own import assert_refused, own, printed, state
from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.pair import PAIR
from verify.cases.contact.line.ring import RING
from verify.cases.contact.press_fit.case import PRESS_FIT
from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crown_claims import RESOLVED, straight
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.end import END
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.slip.case import SLIP
from verify.cases.contact.slip.claims import HALF_PLANES, neglected
from verify.cases.contact.sphere.case import SPHERE
from verify.core.case import Context
from verify.core.inputs import build
from verify.core.results import Kind, Status

REFUSED = [
    (FLAT, {"F": "1 MN"}, "flattens a = "),
    (PAIR, {"R_2": "50 m"}, "radii may differ"),
    (RING, {"R": "19 mm"}, "smaller than 0.9 of the bore"),
    (RING, {"r_o": "19 mm"}, "r_i < r_o"),
    (RING, {"r_o": "19.45 mm"}, "a wall of"),
    (PRESS_FIT, {"r_f": "19 mm"}, "r_i < r_f < r_o"),
    (PRESS_FIT, {"r_i": "25.99 mm", "r_f": "26 mm"}, "below a thousandth"),
    (PRESS_FIT, {"delta": "1 mm"}, "strains are not small"),
    (SLIP, {"P": "80000 N/mm"}, r"a/R of at most 0.3, got a/R = 0\.3\d+ with P = 80000 N/mm"),
    (SPHERE, {"P": "1 MN"}, "a/R from 1e-05 to 0.15"),
    (SPHERE, {"P": "1e-15 N"}, "a/R from 1e-05"),
    (SPHERE, {"R_2": "100 m"}, "take the larger one as flat"),
    (SPHERE, {"E_2": "0.1 GPa"}, "take the stiffer body as rigid"),
    (TILTED, {"K_2": float("nan")}, "inputs.K_2: nan is not finite"),
    (TILTED, {"F": 3407}, "inputs.F: 3407 has no unit"),
    (TILTED, {"R_2": "-4 mm"}, "the roller does not fit"),
    (TILTED, {"R_1": "300 mm", "R_2": "1e6 mm", "L": "1 mm"}, "touches as a plate"),
    (TILTED, {"F": "1 MN"}, "no line contact"),
    (TILTED, {"d": "3 mm"}, "at most a quarter of l = 9 mm"),
    (TILTED, {"theta": "2 deg"}, "inputs.theta = 2 deg: must be at most 1 deg"),
    (END, {"R_2": "-20 mm"}, "R_2 must be positive here"),
    (END, {"R_2": "200 mm"}, "radii may differ by a factor of 5 to 20"),
    (END, {"overhang": "0.01 mm"}, "the overhang must be 0.05 to 3 lengths"),
    (END, {"L": "100 mm", "overhang": "20 mm"}, "length must be 0.2 to 20 radii"),
]


@pytest.mark.parametrize(("case", "change", "message"), REFUSED)
def test_bodies_that_cannot_be_are_refused_in_one_line(case, change, message):
    assert_refused(case, change, message)


RIM = {"F": "1 N", "Q": "1 N", "z_m": "0.1 µm"}
WARNED = [
    (FLAT, {}, ""),
    (PAIR, {}, ""),
    (RING, {}, ""),
    (SLIP, {}, ""),
    (FLAT, {"F": "60 kN"}, "of the smallest body"),
    (FLAT, {"R_p": "600 MPa"}, "yields"),
    (FLAT, {"F": "20 kN"}, "ISO 76"),
    (FLAT, {"L": "0.3 mm", "F": "21.4 N"}, "times a"),
    (RING, {"r_o": "20 mm"}, "the race's wall of 0.56 mm"),
    (PRESS_FIT, {"R_p": "20 MPa"}, "loses pressure"),
    (PRESS_FIT, {"delta": "120 µm"}, "most metals yield before"),
    (SLIP, {"P": "1500 N/mm"}, "no half planes"),
    (SLIP, {"hardness": "1000 MPa"}, "exceeds p_lim = 1000 MPa"),
    (SLIP, {"mu": 0.6}, "friction this high"),
    (SPHERE, {"P": "2 kN"}, "Hertz's approach is off"),
    (SPHERE, {"R_p": "100 MPa"}, "it yields below the surface"),
    (ROLLER, {"F": "1 N"}, "are in contact"),
    (ROLLER, {"F": "30 kN"}, "ISO 76"),
    (ROLLER, {"R_2": "-4.3 mm"}, "of the roller's radius"),
    (ROLLER, {"E_1": "70 GPa", "nu_1": 0.0, "nu_2": 0.49}, "steel on steel"),
    (ROLLER, {"z_m": "1e-6 mm"}, "an end carries"),
    (ROLLER, {"n": 41, "slices": 10}, ""),
    (TILTED, {"theta": "0.3 deg"}, "only 5.087 mm"),
    (TILTED, RIM, "are in contact"),
    (CROWNS, {"L": "100 mm", "F": "30 kN"}, ""),
    (UNCROWNED, {"L": "1 mm", "F": "150 N", "d": "0.25 mm"}, "an end"),
]


@pytest.mark.parametrize(("case", "change", "words"), WARNED)
def test_the_state_of_a_contact_is_warned_of(case, change, words):
    *_, warned = state(case, **change)
    assert any(words in line for line in warned) if words else not warned


NANOMETRE = {"delta": "1 nm", "E_o": "2 GPa", "p_i": "0 MPa", "p_o": "0 MPa"}


@pytest.mark.parametrize(
    ("case", "change", "words"),
    [
        (RING, {"r_o": "20 mm"}, "a wall of 0.56 mm"),
        (PRESS_FIT, {"r_i": "25.8 mm", "r_f": "26 mm", "delta": "1 µm"}, "without --fem"),
        (PRESS_FIT, NANOMETRE | {"delta": "0.001 nm"}, "rounded positions"),
        (SLIP, {"share": 0.49}, "check it without --fem"),
        (SLIP, {"share": 0.91}, "check it without --fem"),
        (SPHERE, {"P": "4e-8 N"}, "round-off"),
        (ROLLER, {"d": "0.1 mm"}, "d = 0.1 mm is shorter than 0.141 mm"),
    ],
)
def test_what_meshes_do_not_resolve_is_checked_by_formulas_alone(case, change, words):
    said = case.too_large(own(case, **change))
    assert words in said
    assert "\n" not in said
    assert not case.too_large(own(case))


def test_the_printed_slip_is_a_contact_of_a_hundredth_of_the_radius():
    q = own(SLIP)
    # a = sqrt(4 P (R/2) / (pi E*)), E* = 206 GPa / (2 * 0.91)
    assert q.a * 1e3 == pytest.approx(np.sqrt(2 * 70 * 4.02 / (np.pi * 206e3 / 1.82)), rel=1e-12)
    assert q.a / q.R == pytest.approx(0.01, rel=0.02)
    assert neglected(q) < HALF_PLANES


@pytest.mark.parametrize(("a_over_R", "status"), [(0.03, Status.PASS), (0.15, Status.SHOWN)])
def test_wide_contacts_are_judged_as_approximations(a_over_R, status):
    q = SLIP.inputs(P=SLIP.inputs().P * (a_over_R / 0.0099) ** 2)
    (check,) = [c for c in SLIP.checks if c.name == "cycle: energy lost, work of friction"]
    exact = q.W * (1 + 1.3 * a_over_R**2)  # what discs were found to lose
    fem = [SimpleNamespace(h=h, values={"work": exact}, u_it={}) for h in (1.0, 0.5, 0.25)]
    row, _ = check.rows(Context("contact-slip", q, SLIP.analytic(q), fem, is_paper=False))
    assert (row.kind, row.status) == (Kind.APPROXIMATION, status)
    assert (row.interval is None) == (status is Status.SHOWN)


def test_a_wide_contact_of_spheres_has_no_expected_interval():
    q = own(SPHERE, P="1 kN")
    claim = next(c for c in SPHERE.checks if c.name == "contact radius on a sphere")
    assert claim.interval(q, SPHERE.analytic(q)) is None


@pytest.mark.parametrize("length", ["1 mm", "1000 mm"])
def test_the_straight_middle_of_rollers_of_every_length_is_that_of_k_2(length):
    q = own(CROWNS, L=length, F="120 N", d="0.2 mm")
    moved, U, _ = straight(Context(CROWNS.id, q, {}, [], False))
    assert moved + U < RESOLVED


@pytest.mark.parametrize(("case", "changes"), [(TILTED, RIM), (ROLLER, {"R_2": "-12 mm"})])
def test_figures_of_odd_rollers_are_drawn(case, changes):
    q, values, _ = state(case, **changes)
    assert case.figures(Context(case.id, q, values, [], False))


def test_the_length_of_the_ends_may_be_left_out():
    known = {k: v for k, v in printed(TILTED).items() if k != "d"}
    assert build(TILTED.inputs, known, "my.toml").d == TILTED.inputs().d


@pytest.mark.parametrize(
    ("case", "changes"),
    [
        pytest.param(PRESS_FIT, NANOMETRE, id="a nanometre of interference, within round-off"),
        pytest.param(UNCROWNED, {"F": "3000 N", "R_2": "-40 mm"}, id="roller in a bore"),
        pytest.param(TILTED, RIM, id="on the rim", marks=pytest.mark.soak),
        pytest.param(TILTED, {"d": "2.25 mm"}, id="long ends", marks=pytest.mark.soak),
    ],
)
def test_a_contact_of_a_user_s_own_has_no_failure(case, changes, judged, red):
    coarse = replace(case, levels=case.levels[:3])
    result = judged(coarse, own(case, **changes), drawn=False)
    assert not red(result)
    assert any(row.status is Status.PASS for row in result.rows)
