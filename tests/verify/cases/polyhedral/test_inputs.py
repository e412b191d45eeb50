"""Polyhedral rings and clutches of a user's own: what is warned of, left out and refused."""

import json
import math
from dataclasses import replace

import pytest

from tests.verify.cases.own import assert_refused, own, printed, state
from verify.app.cli import main
from verify.cases.polyhedral.clutch.case import CLUTCH
from verify.cases.polyhedral.locking.case import LOCKING
from verify.cases.polyhedral.map.case import MAP
from verify.cases.polyhedral.pressure.case import PRESSURE
from verify.cases.polyhedral.ring.case import RING
from verify.cases.polyhedral.wedge.case import WEDGE
from verify.core.case import Context
from verify.core.results import Status

THIN = {"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "2 mm"}
REFUSED = [
    (PRESSURE, {"delta_1": "39.5 mm"}, r"wall leaves no bore: δ_1 must be below 0.49 d_e = 39.2"),
    (PRESSURE, {"delta_1": "0.3 mm"}, r"wall vanishes: δ_1 must be at least 0.005 d_e = 0.4 mm"),
    (PRESSURE, {"j_D": "2 mm"}, r"strains the ring by 2.6%: .*, at most 0.02 d_e = 1.6 mm"),
    (RING, {"z": 2}, r"inputs.z = 2: must be at least 3"),
    (RING, {"rho": "35 mm"}, r"fillets leave no flat: ρ must be at most 34.2 mm .* got 35 mm"),
    (RING, {"e": "16.2 mm"}, r"hub must touch the flat: e must be at most 0.95 .*, 16.15 mm"),
    (LOCKING, {"d": "81 mm"}, r"neighbouring rollers overlap: d must be below 80.06 mm for z = 6"),
    (MAP, {"delta_1": "13 mm"}, r"fillets leave no flat: δ_1 must be at most 0.15 d_e = 12 mm"),
    (MAP, {"rho": "22 mm"}, r"thickest walls of the map: ρ must be at most 21.6 mm"),
    (CLUTCH, {"d": "10.1 mm"}, r"rollers do not fit between the rings: d must be below .* = 10.03"),
    (CLUTCH, {"d": "9 mm"}, r"rollers are too small: .* = 2.06 mm, at most 0.02 d_e = 1.6 mm"),
    (CLUTCH, {"e": "1.5 mm"}, r"hub locks itself: ψ = 2.731° must exceed φ_1 = 2.862°; e must be"),
    (CLUTCH, {"M_t": "1e6 N m"}, r"M_t = 1e\+06 N m presses"),
    (CLUTCH, {"p_t": "1000 MPa"}, r"p_t = 1000 MPa presses"),
    (WEDGE, {"N": "1e8 N"}, r"a/R of at most 0.15, got a/R = .* N = 1e\+08 N on b = 30 mm"),
    (WEDGE, {"D_i": "15 mm"}, r"D_i > 2 d, got D_i = 15 mm, d = 10 mm"),
]


@pytest.mark.parametrize(("case", "change", "message"), REFUSED)
def test_a_ring_that_cannot_be_is_refused_in_one_line(case, change, message):
    assert_refused(case, change, message)


WARNED = [
    (PRESSURE, {}, ""),
    (PRESSURE, {"j_D": "1.6 mm"}, "give R_p"),
    (PRESSURE, {"R_p": "1 MPa"}, "exceeds R_p = 1 MPa"),
    (RING, {"z": 3}, "draw in"),
    (RING, {"rho": "0.1 mm", "R_p": "900 MPa"}, "exceeds R_p"),
    (RING, THIN, ""),
    (LOCKING, {"p_t": "20 MPa"}, "pressure alone does not lock"),
    (LOCKING, {"d": "1 mm"}, "ISO 76"),
    (LOCKING, {"p_t": "200 MPa", "R_p": "900 MPa"}, "exceeds R_p"),
    (LOCKING, THIN | {"p_t": "5 MPa"}, ""),
    (WEDGE, {}, ""),
    (WEDGE, {"alpha": "9 deg"}, "friction a tenth lower"),
    (WEDGE, {"N": "3e5 N"}, "give p_lim"),
    (WEDGE, {"p_lim": "500 MPa"}, "exceeds p_lim = 500 MPa"),
]


@pytest.mark.parametrize(("case", "change", "words"), WARNED)
def test_the_state_of_a_ring_is_warned_of(case, change, words):
    *_, warned = state(case, **change)
    assert any(words in line for line in warned) if words else not warned


LOCKS = {"M_20", "T", "F_s", "R", "N_16"}
ENDLESS = LOCKS | {"M_21", "N_el", "M_el", "M_rigid", "M_wide", "margin"}


@pytest.mark.parametrize(
    ("change", "left_out", "words"),
    [
        pytest.param({"z": 12, "e": "5 mm"}, set(), "", id="twelve rollers"),
        pytest.param({"mu": 0.22}, LOCKS, "Eqs. 17 to 20 set no limit", id="locks by Eq. 20"),
        pytest.param({"mu": 0.3}, LOCKS | {"M_21"}, "share of N is 1.42", id="and by Eq. 21"),
        pytest.param({"mu": 0.6}, ENDLESS, "strength limits", id="all lock"),
        pytest.param({"alpha": "10 deg"}, {"p_20", "p_need", "N_need", "fillet_need"},
                     "expelled", id="expelled rollers"),
        pytest.param({"p_t": "15 MPa"}, set(), "no torque", id="not touched"),
        pytest.param({"p_t": "20.4 MPa"}, set(), "p_t must be ", id="hardly touched"),
        pytest.param({"p_t": "100 MPa", "R_p": "900 MPa"}, set(), "the ring yields", id="crushed"),
        pytest.param({"M_t": "5000 N m"}, set(), "ISO 76", id="too much required"),
    ],
)  # fmt: skip
def test_a_clutch_leaves_out_what_has_no_value_and_warns_of_its_state(change, left_out, words):
    q, v, warned = state(CLUTCH, **change)
    assert {output.key for output in CLUTCH.outputs} - set(v) == left_out
    always = ("a wedge angle is required", "b/δ_1 = ")  # true of nearly every clutch of this kind
    others = [line for line in warned if not any(part in line for part in always)]
    assert any(words in line for line in others) if words else not others
    known = {"M_el", "M_20", "M_21", "M_rigid"} & set(v)
    assert bool(CLUTCH.figures(Context(CLUTCH.id, q, v, [], False))) == bool(known)


def test_the_wedge_angle_that_rollers_need_is_compared_with_that_of_a_narrow_ring():
    q, v, warned = state(CLUTCH, b="5 mm")
    assert v["alpha_need"] == pytest.approx(2 * math.atan(q.mu))
    assert v["M_ring"] < 0.02 * v["M_el"]
    assert any("a wedge angle is required of 9.15°" in line for line in warned)
    assert not any("b/δ_1" in line for line in warned)
    *_, warned = state(CLUTCH)
    assert any("b/δ_1" in line for line in warned)


@pytest.mark.parametrize(
    ("case", "change", "words"),
    [
        (LOCKING, {"p_t": "20.5 MPa"}, "reaches them at 20.26 MPa and is compared from 20.67 MPa"),
        (CLUTCH, {"mu": 0.6}, "pressure does not limit the torque"),
        (CLUTCH, {"alpha": "10 deg"}, "the rollers are expelled"),
        (CLUTCH, {"p_t": "15 MPa"}, "p_t = 15 MPa hardly reaches the rollers"),
        (WEDGE, {"alpha": "12 deg"}, "no equilibrium to compute; check it without --fem"),
    ],
)
def test_what_has_nothing_to_compare_is_refused_before_finite_elements(case, change, words):
    assert words in own(case, **change).refusal()
    assert not own(case).refusal()


def test_a_roller_that_is_squeezed_out_has_no_torque():
    _, v, warned = state(WEDGE, alpha="12 deg")
    assert "M_free" not in v
    assert "T" not in v
    assert v["C"] < 0
    assert "squeezed out of the wedge" in " ".join(warned)


def test_json_of_a_clutch_without_a_torque_has_numbers_alone(tmp_path, capsys):
    given = printed(CLUTCH) | {"mu": 0.6}
    lines = [f"{k} = {json.dumps(v)}" for k, v in given.items()]
    file = tmp_path / "my.toml"
    file.write_text("\n".join(['case = "polyhedral-clutch"', "[inputs]", *lines]), "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["check", "--json", str(file)])
    assert ended.value.code == 1  # the clutch fails: pressure does not decide
    assert json.loads(capsys.readouterr().out, parse_constant=pytest.fail)["values"]


def test_a_map_has_no_dimension_and_is_drawn_for_a_tiny_ring():
    hundredth = {
        "d_e": "0.8 mm", "delta_1": "0.04 mm", "j_D": "6e-4 mm", "rho": "0.02 mm", "d": "0.1 mm",
    }  # fmt: skip
    q, v, _ = state(MAP, **hundredth)
    assert len(MAP.figures(Context(MAP.id, q, v, [], False))) == 4
    assert q.K_many == pytest.approx(own(MAP).K_many, rel=1e-7)


SOAK = pytest.mark.soak


@pytest.mark.parametrize(
    ("case", "change"),
    [
        pytest.param(PRESSURE, {"delta_1": "0.4 mm"}, id="thin round ring"),
        pytest.param(RING, {"rho": "34 mm", "e": "0.5 mm"}, id="hardly any flat"),
        pytest.param(RING, {"z": 48, "rho": "0.5 mm", "e": "1 mm"}, id="48 flats", marks=SOAK),
        pytest.param(RING, {"delta_1": "20 mm", "e": "5 mm"}, id="thick", marks=SOAK),
        pytest.param(LOCKING, {"z": 12, "e": "5 mm", "d": "8 mm"}, id="12 rollers", marks=SOAK),
        pytest.param(LOCKING, {"rho": "0.3 mm"}, id="sharp corners", marks=SOAK),
        pytest.param(CLUTCH, {"M_t": "110 N m"}, id="a little more torque", marks=SOAK),
        pytest.param(CLUTCH, {"mu": 0.32}, id="nearly endless", marks=SOAK),
    ],
)
def test_a_ring_of_a_user_s_own_has_no_failure(case, change, judged, red):
    coarse = replace(case, levels=case.levels[:3]) if case is LOCKING else case
    result = judged(coarse, own(case, **change), drawn=False)
    assert not red(result)
    assert not result.errors
    assert any(row.status is Status.PASS for row in result.rows)
