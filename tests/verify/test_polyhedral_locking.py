"""The locked ring: readings and faults turn rows red; rings of one's own; what is refused."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import hertz_line
from analytic.polyhedral import bore_pressure, fillet_stress, forces
from analytic.polyhedral.locking import RollerContact
from verify.cases.polyhedral.locking import formulas
from verify.cases.polyhedral.locking.case import LOCKING, LockedPolyhedralRing
from verify.cases.polyhedral.locking.fem import locked_fem
from verify.core.inputs import InputError, build
from verify.core.results import Status

pytestmark = pytest.mark.xdist_group("polyhedral-locking")

PAPER = {"d_e": "80 mm", "delta_1": "4 mm", "j_D": "0.06 mm", "E": "210 GPa", "nu": 0.3, "z": 6,
         "rho": "2 mm", "e": "9 mm", "R_b": "200 N/mm", "tan_phi": 0.05, "d": "10 mm",
         "p_t": "30 MPa"}  # fmt: skip
ALONE, PUSHED = (
    "force of a roller under pressure, series",
    "force of a roller under pressure and hub, series",
)
EQ_13, EQ_16 = (
    "force of a roller, Eqs. 13 and 16 without the hub",
    "force of a roller, Eqs. 13 and 16 with the hub",
)
SIDE, WIDTH = (
    "resultant of the pressure on a side, Eq. 13",
    "half-width of the roller's contact, Hertz",
)
FILLET = "largest hoop stress in the fillets, locked"


def own(**changes):
    return build(LockedPolyhedralRing, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(LOCKING))


def mean_for_middle(right):
    def wrong(**k):
        K = right(**k)
        return replace(K, mid=K.mean)

    return wrong


def arc(right):
    return lambda **k: right(**k) * (math.pi / k["z"]) / math.sin(math.pi / k["z"])


FAULTS = [
    pytest.param(forces, "pressure_force", arc, SIDE, id="arc for the side"),
    pytest.param(forces, "pressure_force", arc, EQ_13, id="arc for the side, force"),
    pytest.param(forces, "normal_force", lambda f: lambda **k: f(**k | {"R": k["R"] / 2}), EQ_16,
                 id="half of the hub's force, Eq. 16"),
    pytest.param(forces, "normal_force", lambda f: lambda **k: f(**k | {"gamma": 0.28}), EQ_16,
                 id="gamma = psi in Eq. 16"),
    pytest.param(bore_pressure, "stiffness_factors", mean_for_middle, EQ_13,
                 id="K of the mean in Eq. 19"),
    pytest.param(hertz_line, "relative_radius", lambda f: lambda **k: f(
        R_1=2 * k["R_1"], R_2=2 * k["R_2"]), WIDTH, id="diameters for radii"),
    pytest.param(formulas, "Roller", lambda f: lambda **k: f(**k | {"j_D": 2 * k["j_D"]}),
                 ALONE, id="clearance on the radius"),
    pytest.param(formulas, "hub_force", lambda f: lambda **k: f(
        **k | {"along": -k["along"]}), PUSHED, id="the hub's friction the other way"),
    pytest.param(formulas, "hub_force", lambda f: lambda **k: f(
        **k | {"normal": k["normal"] / 2}), PUSHED, id="half of the hub's force"),
    pytest.param(RollerContact, "growth", lambda f: property(lambda self: 0.99 * f.fget(self)),
                 ALONE, id="the ring gives way 1 % less"),
    pytest.param(fillet_stress, "bore_stress", lambda f: lambda *a, **k: 1.01 * f(*a, **k),
                 FILLET, id="fillet 1 % off"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, without_fault, red, monkeypatch
):
    without_fault(LOCKING)
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(LOCKING, drawn=False)))


def test_forces_on_half_a_sector_are_in_balance_with_the_ring_s_hoop_force_alone():
    q = LockedPolyhedralRing()
    hub = (2e5, 1e4)
    ring = locked_fem(q, 1, d=q.d, e=q.e, p=q.p_t, hub=hub)
    rest_x, rest_y, hoop = ring.balance(q.p_t, hub)
    side = q.p_t * q.d_i * np.sin(q.half_angle)
    assert max(abs(rest_x), abs(rest_y)) < 1e-8 * side
    assert abs(hoop) > 0.1 * side  # what Eq. 16 leaves out


ODD = [
    pytest.param({"z": 3}, "give R_p", id="three rollers"),
    pytest.param({"z": 48, "rho": "0.5 mm", "e": "1 mm", "d": "4 mm"}, "", id="48 rollers"),
    pytest.param(
        {"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "2 mm", "p_t": "5 MPa"},
        "",
        id="thin, 24 rollers",
    ),
    pytest.param({"delta_1": "20 mm", "e": "5 mm", "p_t": "300 MPa"}, "give R_p", id="thick"),
    pytest.param(
        {"z": 3, "delta_1": "20 mm", "rho": "5 mm", "p_t": "500 MPa"}, "ISO 76", id="thick triangle"
    ),
    pytest.param({"rho": "30 mm", "e": "2 mm"}, "", id="nearly round"),
    pytest.param({"e": "0.1 mm"}, "give R_p", id="hub in the middle"),
    pytest.param({"e": "16.1 mm"}, "give R_p", id="hub at the flat's end"),
    pytest.param({"p_t": "20 MPa"}, "pressure alone does not lock", id="not touched"),
    pytest.param({"p_t": "5 MPa", "R_b": "5000 N/mm"}, "pressure alone", id="by the hub alone"),
    pytest.param({"p_t": "200 MPa", "R_p": "900 MPa"}, "exceeds R_p", id="yields"),
    pytest.param({"d": "1 mm"}, "ISO 76", id="needles"),
    pytest.param({"d": "75 mm"}, "give R_p", id="large rollers"),
    pytest.param({"R_b": "1e-6 N/mm", "tan_phi": 1.0}, "give R_p", id="hardly a hub"),
    pytest.param({"E": "0.07 GPa", "p_t": "0.01 MPa", "R_b": "0.05 N/mm"}, "give R_p", id="soft"),
]


@pytest.mark.parametrize(("change", "said"), ODD)
def test_values_of_odd_rings_are_finite_and_their_state_is_told(change, said):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = LOCKING.analytic(q)
    assert all(np.isfinite(x) for x in v.values())
    warned = LOCKING.warnings(q, v)
    assert any(said in line for line in warned) if said else not warned
    assert LOCKING.equations(q, v)
    assert LOCKING.sketch(q).shapes


def test_a_ring_that_hardly_reaches_its_rollers_is_refused_before_finite_elements():
    said = own(p_t="20.5 MPa").refusal()
    assert "p_t = 20.5 MPa hardly presses the rollers" in said
    assert "reaches them at 20.26 MPa and is compared from 20.67 MPa on" in said
    assert "\n" not in said
    assert not own().refusal()
    assert not own(p_t="20.7 MPa").refusal()


# Rings of one's own on the coarser meshes, without figures: seconds each. That of 12 rollers, which
# a test below solves too, is judged in every run.
SOAK = pytest.mark.soak
COARSE = replace(LOCKING, levels=LOCKING.levels[:3], figures=lambda _: ())
OWN = [
    pytest.param({"z": 3}, id="triangle", marks=SOAK),
    pytest.param({"delta_1": "16 mm", "p_t": "200 MPa"}, id="thick", marks=SOAK),
    pytest.param({"p_t": "21 MPa"}, id="hardly pressed", marks=SOAK),
    pytest.param({"rho": "0.3 mm"}, id="sharp corners", marks=SOAK),
    pytest.param({"p_t": "200 MPa"}, id="much pressure", marks=SOAK),
    pytest.param({"R_b": "1e5 N/mm"}, id="much hub", marks=SOAK),
    pytest.param(
        {"z": 48, "rho": "0.5 mm", "e": "0.2 mm", "d": "4 mm"}, id="48 rollers", marks=SOAK
    ),
    pytest.param({"z": 12, "e": "5 mm", "d": "8 mm"}, id="12 rollers"),
    pytest.param(
        {"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "2 mm", "p_t": "5 MPa"},
        id="thin, 24 rollers",
        marks=SOAK,
    ),
    pytest.param({"E": "70 GPa"}, id="light metal", marks=SOAK),
]


def test_hertz_fails_where_the_hub_pushes_right_under_the_roller(judged, red):
    found = {row.quantity for row in red(judged(COARSE, own(e="0.1 mm")))}
    assert found
    assert found <= {"half-width of the roller's contact, Hertz",
                     "pressure between roller and ring, Hertz"}  # fmt: skip


@pytest.mark.parametrize("change", OWN)
def test_rows_of_a_ring_of_one_s_own_pass_or_say_why_they_are_shown(change, judged, red):
    result = judged(COARSE, own(**change))
    assert not red(result)
    assert not result.errors
    told = [row.reason for row in result.rows if row.status is Status.SHOWN]
    assert all("meshes" in line or "no longer small" in line for line in told)
    assert sum(row.status is Status.PASS for row in result.rows) >= len(result.rows) / 2


def test_a_ring_of_one_s_own_with_a_wrong_formula_still_turns_its_row_red(judged, red, monkeypatch):
    q = own(z=12, e="5 mm", d="8 mm")
    judged(COARSE, q)
    right = RollerContact.growth.fget
    monkeypatch.setattr(RollerContact, "growth", property(lambda self: 0.98 * right(self)))
    assert ALONE in names(red(judged(COARSE, q.model_copy())))  # computes anew


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"d": "81 mm"}, r"neighbouring rollers overlap: d must be below 80.06 mm for z = 6"),
        (
            {"z": 48, "e": "1 mm"},
            r"neighbouring rollers overlap: d must be below 5.60.* mm for z = 48",
        ),
        ({"e": "17 mm"}, r"the hub must touch the flat: e must be at most 0.95 of half a flat"),
        ({"p_t": "0 MPa"}, r"inputs.p_t = 0 MPa: must be greater than 0 MPa"),
        ({"p_t": "30 N"}, r"inputs.p_t: "),
    ],
)
def test_a_locked_ring_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)
