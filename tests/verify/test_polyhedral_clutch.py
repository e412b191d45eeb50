"""The whole clutch: readings and faults turn rows red; clutches of one's own; what is refused."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.bounds.polyhedral.flat import filleted
from analytic.polyhedral import bore_pressure, capacity, forces, torque, wedging
from analytic.polyhedral.capacity import Driven
from fem.contact import bodies
from fem.contact.driven import DrivenSector
from fem.contact.locked import LockedSector
from verify.app.cli import main
from verify.cases.polyhedral.clutch import formulas
from verify.cases.polyhedral.clutch.case import CLUTCH, PolyhedralClutch
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("polyhedral-clutch")

PAPER = {"M_t": "100 N m", "p_t": "30 MPa", "z": 6, "D_i": "100.06 mm", "d": "10 mm",
         "d_e": "80 mm", "delta_1": "4 mm", "rho": "2 mm", "b": "30 mm", "e": "9 mm", "mu": 0.08,
         "tan_phi": 0.05, "E": "210 GPa", "nu": 0.3}  # fmt: skip
ELASTIC, FORCE = "torque of the elastic ring, series", "force of a roller, series"
EQ_20, EQ_21 = "torque, Eq. 20", "torque of the first design, Eq. 21"
WANTED = "pressure for the torque that is wanted, Eqs. 17 to 20"
NEEDED = "pressure for the torque that is wanted, series"
FILLET = "largest hoop stress in the fillets"


def own(**changes):
    return build(PolyhedralClutch, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


def undrawn():
    return replace(CLUTCH, figures=lambda _: ())


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    return break_


def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(CLUTCH))


# Readings and faults of the formulas: finite elements come from the cache.
def mean_for_middle(right):
    def wrong(**k):
        K = right(**k)
        return replace(K, mid=K.mean)

    return wrong


FAULTS = [
    pytest.param(forces, "pressure_force", lambda f: lambda **k: f(**k) * (math.pi / 6) / math.sin(
        math.pi / 6), EQ_20, id="arc for the side, Eq. 13"),
    pytest.param(torque, "torque", lambda f: lambda **k: f(**k) / 6, EQ_21,
                 id="Eq. 21 as printed, with beta/360"),
    pytest.param(torque, "hub_share", lambda f: lambda **k: f(**k | {"gamma": 0.0}), EQ_21,
                 id="gamma = 0 in the first design"),
    pytest.param(torque, "hub_share", lambda f: lambda **k: f(**k | {"gamma": k["psi"]}), EQ_20,
                 id="gamma = psi in Eq. 20"),
    pytest.param(forces, "contact_radius", lambda _: lambda **k: np.asarray(0.036), EQ_20,
                 id="lever d_i/2 in Eq. 20"),
    pytest.param(bore_pressure, "stiffness_factors", mean_for_middle, EQ_20,
                 id="K of the mean"),
    pytest.param(torque, "hub_share", lambda f: lambda **k: f(**k | {"phi_1": 0.0}), WANTED,
                 id="no friction of the hub"),
    pytest.param(wedging, "largest_torque", lambda f: lambda **k: f(**k) * 2, EQ_20,
                 id="D_i for a radius"),
    pytest.param(Driven, "kappa", lambda f: property(lambda self: f.fget(self) / 2), ELASTIC,
                 id="half of the hub's force"),
    pytest.param(Driven, "lift", lambda _: property(lambda self: 0.0), FORCE,
                 id="a hub that does not lift"),
    pytest.param(capacity, "hub_force", lambda f: lambda **k: f(**k | {"along": -k["along"]}),
                 ELASTIC, id="friction of the hub towards the corner"),
    pytest.param(capacity, "hub_force", lambda f: lambda **k: f(**k | {"normal": k["normal"] / 2}),
                 NEEDED, id="half of the hub's push"),
    pytest.param(formulas, "Roller", lambda f: lambda **k: f(**k | {"d": k["d"] / 2}),
                 FORCE, id="the roller's radius for its diameter"),
    pytest.param(formulas, "Roller", lambda f: lambda **k: f(**k | {"j_D": 2 * k["j_D"]}),
                 ELASTIC, id="clearance on the radius"),
    pytest.param(formulas, "RollerContact", lambda f: lambda *a: f(*a[:4], "plane strain"),
                 ELASTIC, id="plane strain"),
    pytest.param(formulas, "driven_fillet_stress", lambda f: lambda q, hub, N: f(q, hub, 1.1 * N),
                 FILLET, id="fillet under a tenth more"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(CLUTCH)
    broken(owner, name, fault)
    assert row in names(red(judged(CLUTCH, drawn=False)))


@pytest.mark.parametrize(
    "change",
    [{}, {"z": 12, "e": "5 mm"}, {"alpha": "5 deg"}, {"tan_phi": 0.2, "mu": 0.05}],
)
def test_the_chain_is_the_statics_of_vectors(change):
    q = own(**change)
    v = CLUTCH.analytic(q)
    flat = filleted(q.flat, q.touch)
    assert flat.torque(q.p_t) == pytest.approx(v["M_20"], rel=1e-9)
    assert flat.pressure(q.M_t) == pytest.approx(v["p_20"], rel=1e-9)
    assert q.torque_of_first_design() == pytest.approx(v["M_21"], rel=1e-12)


# Faults of the finite elements: solved anew, on the two coarsest meshes.
COARSE = replace(CLUTCH, levels=CLUTCH.levels[:3], figures=lambda _: ())


def solve_anew():
    q = COARSE.inputs()
    return judge_case(Job(COARSE, q), [solve_level(COARSE, q, n, None) for n in COARSE.levels])


FEM_FAULTS = [
    pytest.param(DrivenSector, "push", lambda f: lambda self, N: (f(self, N)[0], -f(self, N)[1]),
                 ELASTIC, id="friction towards the corner"),
    pytest.param(DrivenSector, "push", lambda f: lambda self, N: tuple(x / 2 for x in f(self, N)),
                 NEEDED, id="half of the hub's force"),
    pytest.param(LockedSector, "force", lambda f: lambda *a: f(*a) / 2, FORCE,
                 id="force of half a roller"),
    pytest.param(bodies, "vector_basis", lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k),
                 NEEDED, id="linear elements"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, red):
    broken(owner, name, fault)
    assert row in names(red(solve_anew()))


@pytest.mark.soak  # finite elements solved anew, for the faults above
def test_the_coarser_levels_alone_turn_no_row_red(red):
    assert names(red(solve_anew())) <= {FILLET}  # its tolerance is that of the finest mesh


# Clutches of one's own.
LOCKS = {"M_20", "T", "F_s", "R", "N_16"}
ENDLESS = LOCKS | {"M_21", "N_el", "M_el", "M_rigid", "M_wide", "margin"}
ODD = [
    pytest.param({"z": 3, "p_t": "35 MPa", "e": "12 mm"}, set(), "give R_p", id="three rollers"),
    pytest.param({"z": 12, "e": "5 mm"}, set(), "", id="twelve rollers"),
    pytest.param({"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "3 mm", "p_t": "5 MPa",
                  "M_t": "150 N m"},
                 set(), "p_t must be 5.", id="thin, 24 rollers"),
    pytest.param({"delta_1": "20 mm", "e": "7 mm", "p_t": "300 MPa"}, set(), "p_t must be",
                 id="thick"),
    pytest.param({"mu": 0.22}, LOCKS, "Eqs. 17 to 20 set no limit", id="locks by Eq. 20"),
    pytest.param({"mu": 0.3}, LOCKS | {"M_21"}, "share of N is 1.42", id="and by Eq. 21"),
    pytest.param({"e": "1.6 mm"}, LOCKS | {"M_21", "M_rigid"}, "set no limit",
                 id="ψ just above φ_1"),
    pytest.param({"mu": 0.6}, ENDLESS, "strength limits", id="all lock"),
    pytest.param({"alpha": "6 deg"}, set(), "p_t must be ", id="free rollers"),
    pytest.param({"alpha": "10 deg"}, {"p_20", "p_need", "N_need", "fillet_need"},
                 "expelled", id="expelled rollers"),
    pytest.param({"p_t": "15 MPa"}, set(), "no torque", id="not touched"),
    pytest.param({"p_t": "20.4 MPa"}, set(), "p_t must be ", id="hardly touched"),
    pytest.param({"p_t": "100 MPa", "R_p": "900 MPa"}, set(), "the ring yields", id="crushed"),
    pytest.param({"M_t": "5000 N m"}, set(), "ISO 76", id="too much wanted"),
    pytest.param({"M_t": "1e-3 N m", "R_p": "900 MPa"}, set(), "", id="nothing wanted"),
    pytest.param({"E": "0.07 GPa", "p_t": "0.01 MPa", "M_t": "0.05 N m"}, set(), "give R_p",
                 id="rubber"),
    pytest.param({"e": "16.1 mm", "tan_phi": 0.0}, set(), "give R_p", id="hub beside the corner"),
    pytest.param({"D_i": "100.001 mm"}, set(), "", id="hardly any clearance"),
    pytest.param({"z": 48, "d": "4 mm", "D_i": "88.06 mm", "rho": "0.5 mm", "e": "1.9 mm",
                  "mu": 0.03, "tan_phi": 0.02}, set(), "", id="48 rollers"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "left_out", "said"), ODD)
def test_values_of_odd_clutches_are_finite_or_left_out_and_their_state_is_told(
    change, left_out, said
):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = CLUTCH.analytic(q)
    assert all(math.isfinite(x) for x in v.values())
    assert {output.key for output in CLUTCH.outputs} - set(v) == left_out
    warned = CLUTCH.warnings(q, v)
    always = ("a wedge angle is required", "b/δ_1 = ")  # true of nearly every clutch of this kind
    others = [line for line in warned if not any(words in line for words in always)]
    assert any(said in line for line in others) if said else not others
    assert all("\n" not in line and "inf" not in line for line in warned)
    assert CLUTCH.equations(q, v)
    known = {"M_el", "M_20", "M_21", "M_rigid"} & set(v)
    assert bool(CLUTCH.figures(Context(CLUTCH.id, q, v, [], False))) == bool(known)
    assert CLUTCH.sketch(q).shapes


# Solved anew for seconds each; one set is judged in every run.
SOAK = pytest.mark.soak


@pytest.mark.parametrize(
    ("change", "shown"),
    [
        pytest.param({"mu": 0.22, "p_t": "29 MPa"}, {EQ_20}, id="locks by Eq. 20", marks=SOAK),
        pytest.param({"mu": 0.32}, {EQ_20, EQ_21}, id="nearly endless", marks=SOAK),
        pytest.param({"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "3 mm", "p_t": "5 MPa"},
                     set(), id="thin, 24 rollers", marks=SOAK),
        pytest.param({"M_t": "110 N m"}, set(), id="a little less wanted than is carried"),
        pytest.param({"p_t": "20.5 MPa"}, set(), id="far less than is wanted", marks=SOAK),
        pytest.param({"p_t": "200 MPa"}, set(), id="far more than is wanted", marks=SOAK),
    ],
)  # fmt: skip
def test_no_row_of_an_odd_clutch_fails(change, shown, judged, red):
    result = judged(undrawn(), own(**change))
    assert not red(result)
    assert {row.quantity for row in result.rows if row.status is Status.SHOWN} == shown


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"mu": 0.6}, "pressure does not limit the torque"),
        ({"alpha": "10 deg"}, "the rollers are expelled"),
        ({"p_t": "15 MPa"}, "p_t = 15 MPa hardly reaches the rollers"),
    ],
)
def test_what_has_no_torque_to_compare_is_refused_before_finite_elements(change, said):
    assert said in own(**change).refusal()
    assert not own().refusal()


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("M_t", "1e6 N m", r"M_t = 1e\+06 N m presses"),
        ("p_t", "1000 MPa", "p_t = 1000 MPa presses"),
    ],
)
def test_loads_that_press_the_rollers_flat_are_refused_in_one_line(name, value, said):
    with pytest.raises(InputError, match=said) as caught:
        own(**{name: value})
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("line", ["mu = 0.6", 'alpha = "10 deg"', 'p_t = "15 MPa"'])
def test_json_of_a_clutch_without_a_limit_or_a_torque_has_numbers_alone(line, tmp_path, capsys):
    key = line.partition(" =")[0]
    kept = {k: v for k, v in PAPER.items() if k != key}
    lines = [f"{k} = {json.dumps(v)}" for k, v in kept.items()]
    file = tmp_path / "my.toml"
    file.write_text("\n".join(['case = "polyhedral-clutch"', "[inputs]", *lines, line]), "utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["check", "--json", str(file)])
    assert ended.value.code in (1, 3)  # it fails, or pressure does not decide
    told = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    assert told["values"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"d": "10.1 mm"}, r"rollers do not fit between the rings: d must be below .* = 10.03 mm"),
        ({"d": "9 mm"}, r"rollers are too small: .* j_D = .* = 2.06 mm, at most 0.02 d_e = 1.6 mm"),
        ({"z": 30}, r"neighbouring rollers overlap: d must be below .* = 9.41.* mm for z = 30"),
        ({"e": "17 mm"}, r"hub must touch the flat: e must be at most 0.95 of half a flat, 16.15"),
        (
            {"e": "1.5 mm"},
            r"hub locks itself: ψ = 2.731° must exceed φ_1 = 2.862°; e must be above",
        ),
        ({"rho": "35 mm"}, r"fillets leave no flat: ρ must be at most 34.2 mm"),
        ({"delta_1": "0.3 mm"}, r"the wall vanishes: δ_1 must be at least 0.005 d_e = 0.4 mm"),
        ({"delta_1": "39.5 mm"}, r"the wall leaves no bore: δ_1 must be below 0.49 d_e = 39.2 mm"),
        ({"mu": 0.0}, r"inputs.mu = 0: must be greater than 0"),
        ({"z": 2}, r"inputs.z = 2: must be at least 3"),
        ({"M_t": "150 mm"}, r"inputs.M_t: "),
        ({"alpha": "91 deg"}, r"inputs.alpha = 91 deg: must be at most 25 deg"),
    ],
)
def test_a_clutch_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)


def test_the_wedge_that_rollers_need_is_set_beside_what_the_ring_s_outside_offers():
    q = own(b="5 mm")
    v = CLUTCH.analytic(q)
    assert v["alpha_need"] == pytest.approx(2 * math.atan(q.mu))
    assert v["M_ring"] < 0.02 * v["M_el"]
    warned = CLUTCH.warnings(q, v)
    assert any("a wedge angle is required of 9.15°" in line for line in warned)
    assert not any("b/δ_1" in line for line in warned)
    assert any("b/δ_1" in line for line in CLUTCH.warnings(own(), CLUTCH.analytic(own())))


def test_a_wide_ring_carries_less():
    v = CLUTCH.analytic(own())
    assert 0.7 * v["M_el"] < v["M_wide"] < 0.85 * v["M_el"]
