"""Finite line contacts on parameters of one's own: states are told, nonsense is refused."""

from dataclasses import replace

import numpy as np
import pytest

from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crown_claims import RESOLVED, straight
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.formulas import StripRoller
from verify.cases.contact.roller.tilted import TILTED
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.form.quantity import forget

pytestmark = pytest.mark.xdist_group("contact-roller")

PAPER = {"F": "3407 N", "L": "9 mm", "R_1": "4.02 mm", "R_2": "11.11 mm", "E_1": "206 GPa",
         "nu_1": 0.3, "E_2": "206 GPa", "nu_2": 0.3, "d": "0.5 mm", "n": 161, "slices": 50,
         "K_1": 2.15, "K_2": 0.6763, "z_m": "0.0121 mm", "Q": "3407 N",
         "theta": "0.03 deg"}  # fmt: skip
UNLIKE = {"E_1": "70 GPa", "nu_1": 0.0, "nu_2": 0.49}
RIM = {"F": "1 N", "Q": "1 N", "z_m": "0.1 µm"}
RUBBER = {"E_1": "0.01 GPa", "nu_1": 0.49, "F": "2 N", "Q": "2 N"}
# Sets that take seconds; those without the mark take the same ways.
SOAK = pytest.mark.soak


def undrawn(case):
    return replace(case, figures=no_figures)


def no_figures(_):
    return ()


def own(case, **changes):
    """Inputs of the case that differ from the paper's as `changes` say."""
    known = PAPER | {"n": 81} if case is UNCROWNED else PAPER
    raw = {k: v for k, v in (known | changes).items() if k in case.inputs.model_fields}
    return build(case.inputs, raw, "my.toml")


ODD = [
    pytest.param(ROLLER, {"F": "1 N"}, "are in contact", id="light, crown for more"),
    pytest.param(ROLLER, {"F": "1 N", "Q": "1 N", "z_m": "0.1 µm"}, "", id="light"),
    pytest.param(ROLLER, {"F": "30 kN"}, "ISO 76", id="heavy, crown for less"),
    pytest.param(ROLLER, {"R_2": "-4.3 mm"}, "of the roller's radius", id="tight bore"),
    pytest.param(ROLLER, {"R_2": "1e9 mm"}, "", id="flat race"),
    pytest.param(ROLLER, UNLIKE, "steel on steel", id="unlike materials"),
    pytest.param(ROLLER, RUBBER, "an end carries", id="rubber"),
    pytest.param(ROLLER, {"K_2": 1.0}, "", id="crowned all along"),
    pytest.param(ROLLER, {"K_2": 0.01}, "an end carries", id="crowned at the very end"),
    pytest.param(ROLLER, {"z_m": "1e-6 mm"}, "an end carries", id="no drop"),
    pytest.param(ROLLER, {"z_m": "1 mm"}, "", id="a large drop"),
    pytest.param(ROLLER, {"n": 41, "slices": 10}, "", id="few strips"),
    pytest.param(ROLLER, {"n": 401, "slices": 401}, "", id="many strips"),
    pytest.param(ROLLER, {"d": "2.25 mm"}, "", id="long ends"),
    pytest.param(ROLLER, {"d": "1 µm"}, "", id="short ends"),
    pytest.param(TILTED, {"theta": "0 deg"}, "", id="no tilt"),
    pytest.param(TILTED, {"theta": "0.3 deg"}, "only 5.087 mm", id="half of it off the race"),
    pytest.param(TILTED, {"theta": "1 deg"}, "only 2.2", id="on one end", marks=SOAK),
    pytest.param(TILTED, RIM, "are in contact", id="on the rim"),
    pytest.param(TILTED, {"F": "30 kN"}, "ISO 76", id="tilted and heavy"),
    pytest.param(TILTED, {"L": "1 mm", "F": "40 N", "d": "0.1 mm"}, "only", id="short and tilted"),
    pytest.param(UNCROWNED, {"F": "1 N"}, "an end carries", id="light, no crown"),
    pytest.param(UNCROWNED, {"L": "100 mm", "F": "30 kN"}, "an end", id="long, no crown"),
    pytest.param(UNCROWNED, {"L": "1 mm", "F": "150 N", "d": "0.25 mm"}, "an end", id="short"),
    pytest.param(CROWNS, {"L": "100 mm", "F": "30 kN"}, "", id="crowns, long"),
    pytest.param(CROWNS, {"F": "30 kN"}, "of the roller's radius", id="crowns, heavy"),
    pytest.param(CROWNS, {"F": "1 N"}, "", id="crowns, light"),
]


@pytest.mark.parametrize(("case", "changes", "said"), ODD)
def test_formulas_of_odd_rollers_are_finite_and_their_state_is_told(case, changes, said):
    q = own(case, **changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        values = case.analytic(q)
    assert all(np.isfinite(value) for value in values.values())
    warned = case.warnings(q, values)
    assert all("\n" not in line for line in warned)
    assert any(said in line for line in warned) if said else not warned


@pytest.mark.parametrize(
    ("case", "changes"),
    [
        pytest.param(ROLLER, RUBBER | {"d": "1 mm"}, id="rubber", marks=SOAK),
        pytest.param(TILTED, {"theta": "0 deg"}, id="no tilt", marks=SOAK),
        pytest.param(TILTED, RIM, id="on the rim", marks=SOAK),
        pytest.param(
            TILTED, UNLIKE | {"R_2": "-12 mm"}, id="unlike materials in a bore", marks=SOAK
        ),
        pytest.param(TILTED, {"F": "30 kN", "n": 41}, id="heavy, few strips", marks=SOAK),
        pytest.param(
            TILTED, {"d": "2.25 mm"}, id="pressure that goes on rising beyond d", marks=SOAK
        ),
        pytest.param(UNCROWNED, {"F": "100 N"}, id="light, no crown", marks=SOAK),
        pytest.param(UNCROWNED, {"n": 401}, id="more strips than the end bears"),
    ],
)
def test_no_row_of_an_odd_roller_fails(case, changes, judged, red):
    result = judged(undrawn(case), own(case, **changes))
    assert not red(result)
    assert any(row.status is Status.PASS for row in result.rows)


@pytest.mark.parametrize("length", ["1 mm", "9 mm", "100 mm", "1000 mm"])
@pytest.mark.parametrize("load", ["1 N", "120 N"])
def test_the_straight_middle_of_rollers_of_every_length_is_that_of_k_2(length, load):
    q = own(CROWNS, L=length, F=load, d="0.2 mm")
    moved, U, _ = straight(Context(CROWNS.id, q, {}, [], False))
    assert moved + U < RESOLVED


@pytest.mark.parametrize(
    ("case", "changes"),
    [pytest.param(TILTED, RIM, id="on the rim"),
     pytest.param(ROLLER, {"R_2": "-12 mm"}, id="bore")],
)  # fmt: skip
def test_figures_of_odd_rollers_are_drawn(case, changes):
    q = own(case, **changes)
    assert case.figures(Context(case.id, q, case.analytic(q), [], False))


def test_own_rollers_near_the_paper_s_are_judged(judged):
    result = judged(undrawn(TILTED), own(TILTED, F="3000 N", R_2="-40 mm"))
    status = {row.quantity: row.status for row in result.rows}
    assert status["largest pressure beyond d of the ends, strips"] is Status.PASS
    assert status["approach, strips"] is Status.PASS
    assert status["tilting moment, strips within 1%"] is Status.SHOWN


def test_an_own_roller_s_wrong_formula_turns_its_row_red(judged, red, monkeypatch):
    q = own(TILTED, F="3000 N", R_2="-40 mm")
    case = undrawn(TILTED)
    judged(case, q)
    right = StripRoller.delta.formula
    monkeypatch.setattr(StripRoller.delta, "formula", lambda case: 1.01 * right(case))
    forget()
    assert "approach, strips" in {r.quantity for r in red(judged(case, q))}


@pytest.mark.parametrize("case", [ROLLER, TILTED, UNCROWNED, CROWNS], ids=lambda case: case.id)
def test_ends_too_short_for_the_half_space_are_refused_before_it(case):
    said = case.too_large(own(case, d="0.1 mm"))
    assert "d = 0.1 mm is shorter than 0.141 mm" in said
    assert "\n" not in said
    assert not case.too_large(own(case))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"z_m": "0 mm"}, r"inputs.z_m = 0 mm: must be greater than 0 mm"),
        ({"z_m": "-3 µm"}, r"inputs.z_m = -0.003 mm: must be greater than 0 mm"),
        ({"K_2": 0.0}, r"inputs.K_2 = 0: must be greater than 0"),
        ({"K_2": 1.01}, r"inputs.K_2 = 1.01: must be at most 1"),
        ({"K_2": float("nan")}, r"inputs.K_2: nan is not finite"),
        ({"K_1": 0.0}, r"inputs.K_1 = 0: must be greater than 0"),
        ({"F": "0 N"}, r"inputs.F = 0 N: must be greater than 0 N"),
        ({"F": "-5 N"}, r"inputs.F = -5 N: must be greater than 0 N"),
        ({"F": "nan N"}, r"inputs.F: "),
        ({"F": "3407 mm"}, r"inputs.F: "),
        ({"F": 3407}, r"inputs.F: 3407 has no unit"),
        ({"L": "9 N"}, r"inputs.L: "),
        ({"R_2": "-4 mm"}, r"the roller does not fit"),
        ({"R_2": "0 mm"}, r"does not fit the bore: R_2 must be positive \(a shaft\) or below -4.1"),
        ({"R_2": "-4.02 mm"}, r"the roller does not fit"),
        ({"R_1": "300 mm", "R_2": "1e6 mm", "L": "1 mm"}, r"touches as a plate"),
        ({"F": "1 MN"}, r"no line contact"),
        ({"d": "3 mm"}, r"at most a quarter of l = 9 mm"),
        ({"n": 40}, r"inputs.n = 40: must be at least 41"),
        ({"n": 402}, r"inputs.n = 402: must be at most 401"),
        ({"n": 100.5}, r"inputs.n: needs a whole number"),
        ({"slices": 9}, r"inputs.slices = 9: must be at least 10"),
        ({"nu_1": 0.5}, r"inputs.nu_1 = 0.5: must be less than 0.5"),
        ({"theta": "2 deg"}, r"inputs.theta = 2 deg: must be at most 1 deg"),
        ({"theta": "-1 deg"}, r"inputs.theta = -1 deg: must be at least 0 deg"),
    ],
)
def test_input_that_makes_no_sense_gets_one_line(changes, message):
    with pytest.raises(InputError, match=message) as caught:
        own(TILTED, **changes)
    assert "\n" not in str(caught.value)


def test_the_ends_may_be_left_out():
    known = {k: v for k, v in PAPER.items() if k in TILTED.inputs.model_fields and k != "d"}
    assert build(TILTED.inputs, known, "my.toml").d == TILTED.inputs().d
