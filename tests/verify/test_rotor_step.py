"""The stepped turning shaft: readings and faults turn rows red; shafts of one's own."""

from dataclasses import replace

import numpy as np
import pytest
from pydantic import ValidationError

from analytic.rotor import stepped
from analytic.rotor.transfer_modes import whirl_frequencies
from fem.fourier import vibration
from fem.rotor import assemble, weak
from verify.cases.registry import find
from verify.cases.rotor.step import case as rotor_step
from verify.cases.rotor.step import reference
from verify.cases.rotor.step.case import STEP, SteppedBeam
from verify.cases.rotor.step.inputs import NEAR_ONE
from verify.core.results import Status
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("rotor-step")
RULE = "weak form, 45° rule,"


def names(rows):
    return {row.quantity for row in rows}


def frequencies(q, **more):
    return whirl_frequencies(q.rotor(**more), [q.n], count=3)[0]


def test_no_row_fails_and_the_case_is_registered(judged, red):
    assert not red(judged(STEP))
    assert find("rotor-step") is STEP


def test_what_is_measured_is_shown_with_its_uncertainty(judged):
    """9 % is the size that steps are known to reach; the rule takes off more than half."""
    rows = {row.quantity: row for row in judged(STEP).rows}
    drawn, cone = (rows[f"beam {name}, mode 1 forward"] for name in ("as drawn", "by the 45° rule"))
    assert {drawn.status, cone.status} == {Status.SHOWN}
    assert 0.04 < drawn.analytic / drawn.fem - 1 < 0.09
    assert 0 < cone.analytic / cone.fem - 1 < 0.03
    assert drawn.tolerance / drawn.fem < 2e-3


def scaled(factor):
    return lambda f: lambda *a, **k: factor * f(*a, **k)


def stiff(of):
    """Another diameter that counts for stiffness, in the cones."""
    return lambda f: (
        lambda q, **k: tuple(
            replace(p, d_stiff=of(q, p)) if q.d_1 < p.d_stiff < p.d else p for p in f(q, **k)
        )
    )


def inertia(polar, diametral):
    return lambda f: (
        lambda **k: f(**k | {"polar": polar * k["polar"], "diametral": diametral * k["diametral"]})
    )


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(rotor_step, "whirl_frequencies", scaled(1.001),
                     "closed-form elements, mode 1 forward", id="0.1 % too fast"),
        pytest.param(rotor_step, "whirl_frequencies",
                     lambda f: lambda r, n, **k: f(r, -np.asarray(n), **k),
                     "closed-form elements, mode 1 backward", id="turns the other way"),
        pytest.param(rotor_step, "whirl_frequencies", scaled(0.94),
                     "a step makes the beam too fast in modes 1 to 3", id="6 % too slow"),
        pytest.param(rotor_step, "whirl_frequencies", scaled(1.001),
                     "the beam's error as d_2 goes to d_1", id="0.1 % off without a step"),
        pytest.param(SteppedBeam, "rotor", lambda f: lambda s, **_: f(s),
                     "the 45° rule takes off more than half of the error of mode 1",
                     id="no rule"),
        pytest.param(SteppedBeam, "rotor", lambda f: lambda s, **_: f(s, cone=True),
                     "closed-form elements, mode 3 forward", id="the rule for what is drawn"),
        pytest.param(SteppedBeam, "rotor",
                     lambda f: lambda s, **k: f(s.model_copy(update={"k": s.k / 2}), **k),
                     "weak form, mode 1 forward", id="half the bearings"),
        pytest.param(stepped.SteppedShape, "pieces", stiff(lambda q, p: (p.d_stiff + q.d_1) / 2),
                     f"{RULE} mode 1 forward", id="half the cones' slope"),
        pytest.param(stepped.SteppedShape, "pieces",
                     stiff(lambda q, p: min(p.d, 2 * p.d_stiff - q.d_1)),
                     f"{RULE} mode 1 forward", id="half the cones' reach"),
        pytest.param(stepped, "Disc", inertia(2, 2), f"{RULE} mode 2 forward",
                     id="twice the lumps"),
        pytest.param(stepped, "Disc", inertia(0.5, 1),
                     f"{RULE} what turning splits mode 2 by", id="half the lumps' polar moment"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, red, monkeypatch
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(STEP)))


def judge_with(anew):
    """The case judged on its finite elements, with the values that `anew(q, level)` solves anew."""
    q, results = STEP.inputs(), []
    for level in STEP.levels:
        kept = solve_level(STEP, q, level, default_folder())
        values, arrays = anew(q, level)
        own = replace(kept.result, values=dict(kept.result.values) | values,
                      arrays=dict(kept.result.arrays) | arrays)  # fmt: skip
        results.append(replace(kept, result=own))
    return judge_case(Job(STEP, q), results)


def elements(q, level):
    return reference.elements(q, level), {}


def weak_form(q, level):
    ahead, _ = reference.weak_form(q, level).whirl(q.n)
    return {f"weak_whirl_{j}_forward": ahead[j - 1] for j in (1, 2, 3)}, {}


def body(q, _):
    values, _ = reference.of_body(q, reference.body(q, 1, 0.12))
    return {key: values[key] for key in ("mass_error", "polar_error")}, {}


def near_one(q, level):
    share = q.L_2 / q.L
    found = [reference._half_at_rest(q, r, share, max(level - 1, 1), 0.12) for r in NEAR_ONE]
    return {}, {"near_one": np.array(found)}


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("solve", "owner", "name", "fault", "row"),
    [
        pytest.param(body, vibration, "gyroscopic_form", lambda f: lambda n: f(n) / 2,
                     "polar moment of inertia of the elastic body", id="half the polar moment"),
        pytest.param(body, vibration, "mass_matrix", scaled(0.99), "mass of the elastic body",
                     id="1 % too light"),
        pytest.param(near_one, vibration, "pulls_of", lambda f: lambda *a: [c / 2 for c in f(*a)],
                     "the beam's error as d_2 goes to d_1", id="a quarter of the springs"),
        pytest.param(weak_form, weak, "shear_mixed", lambda _: weak.product,
                     "weak form, mode 3 forward", id="shear without slope"),
        pytest.param(elements, assemble, "rotary_mass", scaled(1.5),
                     "closed-form elements, mode 3 forward", id="too much rotary inertia"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(solve, owner, name, fault, row, monkeypatch, red):
    assert row not in names(red(judge_with(solve)))
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judge_with(solve)))


def test_pieces_make_up_the_shaft_and_stiffness_grows_from_the_steps():
    q = SteppedBeam()
    shape = q.shape
    for cone in (False, True):
        pieces = shape.pieces(cone=cone)
        assert sum(p.length for p in pieces) == pytest.approx(q.L)
        assert sum(p.length * p.d**2 for p in pieces) == pytest.approx(
            sum(length * d**2 for length, d, _ in q.parts)
        )
        assert all(p.d_stiff == p.d for p in pieces) is not cone
    stiff = [p.d_stiff for p in shape.pieces(cone=True)]
    assert stiff == pytest.approx(stiff[::-1])
    assert sorted(set(np.round(stiff, 9)))[:2] == pytest.approx([0.04, 0.04 + 0.04 / 32])


def test_cones_meet_where_the_thick_part_is_short():
    q = SteppedBeam(L_2=0.03, a=0.1)
    assert max(p.d_stiff for p in q.shape.pieces(cone=True)) < q.d_1 + 0.03
    assert sum(p.length for p in q.shape.pieces(cone=True)) == pytest.approx(q.L)


def test_cones_of_many_slices_and_the_weak_form_agree():
    q = SteppedBeam(a=0.1)
    fine = frequencies(q, cone=True, slices=32)
    assert frequencies(q, cone=True) == pytest.approx(fine, rel=1e-4)
    found = reference.weak_form(q, 3, cone=True).whirl(q.n)[0]
    assert found == pytest.approx(fine, rel=1e-4)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"d_2": 0.04}, "1.001 d_1 <= d_2"),
        ({"L": 0.15}, "a block, not a shaft"),
        ({"a": 0.01}, "do not fit beside"),
        ({"a": 0.295}, "do not fit beside"),
        ({"b": 0.06}, "no short bearing"),
        ({"k": -1.0}, "greater than 0"),
    ],
)
def test_inputs_without_sense_are_refused_in_words(wrong, said):
    with pytest.raises(ValidationError, match=said):
        SteppedBeam(**wrong)


def test_an_engineer_is_warned_of_a_step_and_of_none_without_one():
    q = SteppedBeam()
    assert any(
        "45° rule lowers the beam's frequencies by up to 3.5%" in words
        for words in STEP.warnings(q, STEP.analytic(q))
    )
    hardly = SteppedBeam(d_2=0.0402)
    assert not STEP.warnings(hardly, STEP.analytic(hardly))


def test_a_shaft_of_one_s_own_has_no_row_in_red(monkeypatch, red):
    monkeypatch.setattr(reference, "FIRST", 0.12)
    monkeypatch.setattr(reference, "_errors", lambda *_: (0.05, 0.02))  # map: not judged
    q = SteppedBeam(L=0.8, d_1=0.05, d_2=0.065, L_2=0.1, a=0.1, k=5e7, n=0.0)
    runs = [solve_level(STEP, q, level, None) for level in STEP.levels]
    assert not red(judge_case(Job(STEP, q), runs))


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("cone", [False, True])
@pytest.mark.parametrize(("ratio", "share"), [(2.0, 0.4), (2.5, 0.05), (3.0, 0.1)])
def test_cells_are_as_many_where_inputs_differ_by_round_off(seed, cone, ratio, share):
    """Both cones of a short thick part end in one station, and counts of cells are whole."""
    q = SteppedBeam().with_middle(ratio, share)
    noise = 1 + 1e-13 * np.random.default_rng(seed).standard_normal(5)
    names = ("L", "d_1", "d_2", "L_2", "b")
    near = q.model_copy(update={n: getattr(q, n) * x for n, x in zip(names, noise, strict=True)})
    meshes = [reference.weak_form(one, 1, cone=cone).basis.mesh for one in (q, near)]
    assert meshes[0].nelements == meshes[1].nelements
    assert np.diff(np.sort(meshes[1].p[0])).min() > 1e-4 * q.L
