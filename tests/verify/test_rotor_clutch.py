"""Clutch between two rotors: rows pass, faults and other readings turn rows red, own numbers."""

import re
from dataclasses import replace

import numpy as np
import pytest
from pydantic import ValidationError

from analytic.contact import palmgren
from analytic.rotor import clutch, clutch_inclined, clutch_tilted, clutch_uniform
from fem.rotor import struts, struts_kinds
from verify.cases.rotor.clutch.case import CLUTCH, ClutchLink
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.core.case import Context
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("rotor-clutch")
COARSE = replace(CLUTCH, levels=(8, 16, 32))
TILTS = np.ones((6, 6))
TILTS[3:5, 3:5] = 0  # Newton's steps for the twist stay what they are


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case):
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


def row_of(result, name):
    (row,) = (r for r in result.rows if r.quantity == name)
    return row


def test_every_row_passes_or_is_a_note_on_a_misprint(of_paper):
    rows = of_paper(CLUTCH).rows
    assert {row.status for row in rows} == {Status.PASS, Status.NOTE}
    assert sum(row.status is Status.NOTE for row in rows) == 4


def times(by):
    return lambda f: lambda *a, **k: by * f(*a, **k)


def in_slices(share):
    """Slices whose middles spread over `share` of the length."""
    return lambda f: lambda *, L, n_s: f(L=share * L, n_s=n_s)


def lever_of(power):
    """d_t with R_i to another power, or R_i sin nu in place of R_i tan nu."""
    return lambda f: property(lambda self: f.fget(self) * power)


def with_gradient(factors):
    """Columns of the deformation's gradient times factors."""

    def fault(f):
        def post_init(self):
            f(self)
            object.__setattr__(self, "gradient", self.gradient * factors)

        return post_init

    return fault


FORMULA_FAULTS = [
    pytest.param(clutch_uniform, "radial_stiffness", times(2), "stiffness along x, uniform",
                 id="Z for Z/2"),
    pytest.param(clutch_uniform, "torsional_stiffness", times(1.0001),
                 "torsional stiffness, uniform", id="1e-4 in K_zz"),
    pytest.param(clutch_uniform, "tilting_stiffness", times(1.01), "tilting stiffness, uniform",
                 id="1 % in K_tilt"),
    pytest.param(clutch_uniform, "offset_coupling", times(-1),
                 "coupling of bending and torsion by an offset, first order", id="sign of K_xz"),
    pytest.param(clutch_uniform, "contact_stiffness", times(0.9), "stiffness along x, uniform",
                 id="secant for tangent"),
    pytest.param(clutch_uniform, "approach", times(2), "stiffness along y, uniform",
                 id="each contact yields as both"),
    pytest.param(palmgren, "approach", times(1.0001), "torsional stiffness, uniform",
                 id="Palmgren's number"),
    pytest.param(clutch, "slice_middles", in_slices(1.01), "tilting stiffness, with a crown",
                 id="Eq. 5, slices beyond the ends"),
    pytest.param(clutch.Clutch, "d_t", lever_of(1.001), "torsional stiffness, with sprags missing",
                 id="Eq. 4, another lever"),
    pytest.param(clutch.Clutch, "deformation",
                 lambda f: lambda self, q: f(self, np.asarray(q) * [-1, 1, 1, 1, 1]),
                 "coupling of bending and torsion, with an offset", id="Eq. 3, sign"),
    pytest.param(SpragLink, "crown", times(2), "stiffness along x, with a "
                 "crown", id="Eq. 6, four drops for two"),
    pytest.param(clutch.Clutch, "__post_init__", with_gradient([1, 1, -1, 1, 1]),
                 "coupling of y and the tilt about x, aside and tilted", id="Eq. 7, tilt about x"),
    pytest.param(clutch.Clutch, "__post_init__", with_gradient([1, 1, 1, -1, 1]),
                 "coupling of y and the tilt about x, aside and tilted", id="Eq. 7, tilt about y"),
    pytest.param(clutch_inclined, "replace", lambda f: lambda c, psi: f(c, psi=2 * c.psi - psi),
                 "coupling of x and y by the wedge angle, with offset, crown and gap",
                 id="forces inclined the other way"),
    pytest.param(clutch_tilted, "aside", lambda f: lambda *a: (f(*a)[0], f(*a)[1] / 2),
                 "coupling of x and the tilt about y, aside and tilted", id="half the tilt"),
    pytest.param(clutch.Clutch, "slopes", times(1.001), "tangent against differences of the loads, "
                 "1e-8", id="Eq. 11, a tangent of other loads"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FORMULA_FAULTS)
def test_a_wrong_formula_turns_its_row_red(owner, name, fault, row, judged, red, monkeypatch):
    judged(CLUTCH)  # struts as they are
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(CLUTCH)))


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(struts, "power_law", lambda f: lambda k, n: f(k * 1.0001, n),
                     "torsional stiffness, uniform", id="stiffer struts"),
        pytest.param(struts, "power_law", lambda f: lambda k, n: f(k, 1.0),
                     "exponent of the stiffness over the torque", id="linear struts"),
        pytest.param(struts_kinds, "_turned", lambda f: lambda e, y: f(e, y) * TILTS,
                     "tilting stiffness, uniform", id="forces that do not tilt"),
        pytest.param(struts_kinds, "Pinned", lambda f: lambda **k: f(**k | {"b": 1.001 * k["b"]}),
                     "torsional stiffness, ends held in both races", id="a larger outer race"),
        pytest.param(struts_kinds, "Rolling", lambda f: lambda **k: f(**k | {"angle": k["angle"]
                     - 0.055}), "coupling of bending and torsion, with sprags missing",
                     id="radial struts"),
        pytest.param(struts_kinds, "Rolling", lambda f: lambda **k: f(**k | {"angle": k["angle"]
                     - 0.11}), "coupling of x and y by the wedge angle, with sprags missing",
                     id="struts inclined the other way"),
        pytest.param(struts_kinds, "Rolling", lambda f: lambda **k: f(**k | {"z": 1.01 * k["z"]}),
                     "coupling of y and the tilt about x, aside and tilted", id="longer struts"),
    ],
)  # fmt: skip
def test_wrong_struts_turn_their_row_red(owner, name, fault, row, monkeypatch, red):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(solve_anew(COARSE)))


def test_coarse_struts_alone_turn_nothing_red_but_what_asks_for_slices(red):
    assert not {"stiffness along x, uniform", "torsional stiffness, uniform"} & names(
        red(solve_anew(COARSE))
    )


def test_values_are_those_of_a_pocket_calculator():
    q = ClutchLink()
    v = CLUTCH.analytic(q)
    # 15/(12 * 11.11e-3 * 0.0550333) N; twice 3.84e-5 N^0.9/9^0.8 mm
    assert v["N"] == pytest.approx(2044.4, rel=1e-4)
    assert v["delta_0"] == pytest.approx(2 * 3.84e-8 * 2044.4**0.9 / 9**0.8, rel=1e-4)
    k = 10 / 9 * v["N"] / v["delta_0"]
    assert v["K_xx"] == pytest.approx(6 * k, rel=1e-12)
    assert v["K_zz"] == pytest.approx(12 * k * (11.11e-3 * 0.0550333) ** 2, rel=1e-5)


def test_a_yield_of_one_s_own_takes_palmgren_s_place():
    soft, palmgrens = ClutchLink(a=20e-6), ClutchLink()
    # 1 kN is 1000 N by definition of a
    assert soft.k_n * 20e-6 ** (10 / 9) == pytest.approx(1000, rel=1e-12)
    assert CLUTCH.analytic(soft)["K_xx"] < CLUTCH.analytic(palmgrens)["K_xx"]


@pytest.mark.parametrize(
    "own",
    [
        {"Z": 24, "R_i": 40e-3, "R_e": 50e-3, "L": 20e-3, "T": 150.0},
        {"e": 30e-6, "drop": 0.0},
        {"a": 20e-6, "n_s": 7, "T": 40.0, "missing": 5, "nu": 0.1},
        {"Z": 4},
        {"missing": 6},
    ],
    ids=str,
)
def test_an_engineer_s_own_clutch_passes_too(own, red):
    q = ClutchLink(**own)
    assert CLUTCH.too_large(q) == ""
    fem = [solve_level(CLUTCH, q, level, None) for level in CLUTCH.levels]
    assert not red(judge_case(Job(CLUTCH, q), fem))


@pytest.mark.parametrize(
    ("own", "said"),
    [
        ({"T": 0.01}, "nearly no preload"),
        ({"e": 30e-6}, r"under the offset \d+% of the contacts are open"),
        ({"drop": 20e-6}, "under the crown .* of the contacts are open"),
        ({"nu": 0.15}, "the clutch slips"),
        ({"T": 600.0}, "farther than sprags roll"),
        ({"Z": 18, "R_i": 30e-3, "R_e": 38.33e-3, "T": 150.0}, "lean .* is 12.* too large"),
    ],
)
def test_an_engineer_is_warned(own, said):
    q = ClutchLink(**own)
    words = CLUTCH.warnings(q, CLUTCH.analytic(q))
    assert any(re.search(said, w) for w in words), words


def test_nothing_is_warned_of_at_the_case_s_own_numbers():
    q = ClutchLink()
    assert not CLUTCH.warnings(q, CLUTCH.analytic(q))
    assert CLUTCH.too_large(q) == ""


@pytest.mark.parametrize(
    ("own", "said"), [({"T": 600.0}, "no sprag rolls so far"), ({"drop": 20e-6}, "ends open")]
)
def test_struts_are_not_asked_where_they_say_nothing(own, said):
    assert said in CLUTCH.too_large(ClutchLink(**own))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"R_e": 11e-3}, "R_i < R_e"),
        ({"missing": 10}, "three sprags must remain"),
        ({"Z": 2}, "greater than or equal to 3"),
        ({"T": 0.0}, "greater than 0"),
    ],
)
def test_inputs_without_sense_are_refused_in_words(wrong, said):
    with pytest.raises(ValidationError, match=said):
        ClutchLink(**wrong)


def test_findings_say_how_much_is_coupled_and_what_eq_3_leaves_out():
    q = ClutchLink()
    words = " ".join(CLUTCH.findings(q, CLUTCH.analytic(q)))
    for said in ("2044 N", "12.6 µm", "couples no bending with torsion", "0.62%", "tan²ν = 0.30%",
                 "tan ν = 5.50%", "x is coupled with y by -1.10% of K_xx",
                 "keep 21% of the torsional stiffness"):  # fmt: skip
        assert said in words


def test_a_ledger_s_numbers_are_told(of_paper):
    result = of_paper(CLUTCH)
    assert "1.11111" in row_of(result, "Eq. 10 with whole displacements").reason
    assert "2 times" in row_of(result, "a torque with another lever than Eq. 4's").reason


def test_everything_is_drawn_with_and_without_struts(of_paper):
    result = of_paper(CLUTCH)
    assert len(result.figures) == 4
    assert result.sketch
    q = ClutchLink()
    alone = CLUTCH.figures(Context(CLUTCH.id, q, CLUTCH.analytic(q), (), is_paper=True))
    assert len(alone) == 4
    for figure in (*result.figures, *alone):
        for curve in figure.curves:
            assert np.isfinite(curve.x).all()
            assert np.isfinite(curve.y).all()
