"""A wedged sprag: sweep, inputs, words, and that every fault turns a row red."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.bounds.sprag import wedge
from analytic.contact import hertz_line
from analytic.ring import smeared
from analytic.sprag import closure, column, course, elastic, parts, printed
from analytic.sprag.compliance import Yields
from fem.plane.material import Elastic
from fem.wedge.races import State
from meshes.sprag.wedged import Place
from verify.app.cli import run
from verify.cases.sprag.wedge import formulas, model
from verify.cases.sprag.wedge import sweep as sprag_wedge_sweep
from verify.cases.sprag.wedge.case import WEDGE, WedgedSprag
from verify.cases.sprag.wedge.figures import parts_of
from verify.cases.sprag.wedge.model import rigid_force
from verify.cases.sprag.wedge.sketch import outline
from verify.core.case import Context
from verify.core.results import Status
from verify.form import quantity
from verify.jobs.level import Job, judge_case, solve_level

LEVELS = (4, 6, 8)
COARSE = replace(WEDGE, levels=LEVELS)
Q = WedgedSprag()

pytestmark = pytest.mark.xdist_group("sprag-wedge")


def names(rows):
    return {row.quantity for row in rows}


def forget():
    for kept in (model.bodies, model.bounds, sprag_wedge_sweep.starts_by_fem):
        kept.cache_clear()
    quantity.forget()


def solve_anew():
    forget()
    return judge_case(Job(COARSE, Q), [solve_level(COARSE, Q, level, None) for level in LEVELS])


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it."""

    def break_(owner, name, fault):
        right = owner.__dict__[name]
        monkeypatch.setattr(owner, name, fault(right))
        forget()

    yield break_
    monkeypatch.undo()
    forget()


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew().rows if r.status is Status.FAIL))


# Formulas.
def test_elastic_yields_are_those_of_rings_under_single_loads_and_of_the_column():
    parts = dict(parts_of(Q, np.array([rigid_force(Q)])))
    assert sum(float(p[0]) for p in parts.values()) == pytest.approx(Q.at_share(1.0).H, rel=1e-12)
    P = rigid_force(Q) / Q.l
    a_i, a_e = (float(a) for a in Q.bodies.half_widths(np.array(rigid_force(Q))))
    for name, r_i, r_o, loaded, a in (("inner", Q.R_id, Q.R_i, "rim", a_i),
                                      ("outer", Q.R_e, Q.R_ed, "bore", a_e)):  # fmt: skip
        ring = elastic.LoadedRace(r_i=r_i, r_o=r_o, E=Q.E, nu=Q.nu, assumption="plane strain",
                                loaded=loaded, n=Q.z, P=P, a=a)  # fmt: skip
        both = float(parts[f"{name} mean"][0] + parts[f"{name} dent"][0])
        assert both == pytest.approx(abs(ring.displacement(ring.r, 0.0)), rel=2e-4)


def test_half_planes_written_out_are_those_of_the_plane_compliance():
    N = rigid_force(Q)
    assert model.bounds(Q.part, N).plane_yields() == pytest.approx(
        float(Q.bodies.plane.compliance.yields(N).H), rel=2e-3
    )


def test_the_work_of_the_torque_is_that_of_the_yields_but_not_for_the_printed_closure():
    clutch, N, h = Q.clutch, rigid_force(Q), 1e-4
    low, high = (closure.wedged(clutch, N * (1 + s)) for s in (-h, h))
    at = closure.wedged(clutch, N)
    turn = course.rolled(clutch, N * (1 + h)) - course.rolled(clutch, N * (1 - h))
    work = Q.z * N * (high.yields.H - low.yields.H)
    assert float(at.T * turn / work) == pytest.approx(1.0, abs=1e-3)
    before, after = (printed.wedged(clutch, N * (1 + s)).alpha_b for s in (-h, h))
    assert 0.85 < float((after - before) / (high.alpha_b - low.alpha_b)) < 0.92


def test_intervals_do_not_move_with_the_formula_they_judge(broken):
    before = model.bounds(Q.part, rigid_force(Q)).plane()
    broken(parts.Parts, "plane", lambda right: lambda self: replace(right(self), sprag=1e-9))
    assert model.bounds(Q.part, rigid_force(Q)).plane() == pytest.approx(before, rel=1e-9)


# Inputs and words.
def test_a_sprag_rolls_over_where_its_flank_comes_to_the_race():
    v = WEDGE.analytic(Q)
    assert 100 < v["T_roll"] < 200
    q = WedgedSprag(T=1.01 * v["T_roll"])
    told = WEDGE.findings(q, WEDGE.analytic(q))
    assert told[0].startswith("rolls over: a contact reaches the sprag's flank")
    assert "roll over" in " ".join(WEDGE.warnings(q, WEDGE.analytic(q)))
    assert WEDGE.summary(q, WEDGE.analytic(q))["verdict"] == "rolls over"
    assert WEDGE.findings(Q, v)[0].startswith("holds with friction above")
    assert not WEDGE.warnings(Q, v)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"nu_0": 0.11}, "that oiled steel hardly exceeds: the clutch slips"),
        ({"T": 110.0}, "exceeds the 4000 MPa"),
        ({"r_i": 6e-3, "b": 5e-3}, "wider than they are round"),
    ],
)
def test_inputs_near_an_end_of_the_range_are_warned_of(change, words):
    q = WedgedSprag(**change)
    assert words in " ".join(WEDGE.warnings(q, WEDGE.analytic(q)))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"T": 60.0}, "their contacts come to the flanks"),
        ({"b": 2.5e-3}, "their contacts come to the flanks"),
        ({"r_i": 6e-3, "b": 5e-3}, "wider than they are round"),
        ({"nu_0": 0.2, "T": 600.0}, "r wide under"),
        ({"R_id": 10.8e-3, "T": 20.0, "nu_0": 0.2}, "of its wall: displacements are not small"),
    ],
)
def test_what_finite_elements_cannot_do_is_said_beforehand(change, words):
    reason = WEDGE.too_large(WedgedSprag(**change))
    assert words in reason
    assert "check it without --fem" in reason
    assert not WEDGE.too_large(Q)


@pytest.mark.parametrize(
    "change",
    [
        {"z": 3}, {"z": 40, "b": 1.5e-3}, {"nu_0": 0.0175}, {"nu_0": 0.105}, {"R_id": 10.3e-3},
        {"R_ed": 20.5e-3}, {"E": 2e9, "T": 1.0, "nu": 0.45}, {"T": 200.0}, {"T": 0.01}, {"b": 2e-3},
        {"r_i": 2.5e-3}, {"nu": 0.0},
    ],
)  # fmt: skip
def test_odd_clutches_have_finite_values_and_words(change):
    q = WedgedSprag(**change)
    v = WEDGE.analytic(q)
    for output in WEDGE.outputs:
        assert output.key in v or output.key == "T_roll"
    assert WEDGE.findings(q, v)
    assert WEDGE.equations(q, v)
    assert WEDGE.sketch(q)
    assert WEDGE.figures(Context(WEDGE.id, q, v, (), is_paper=False))


BASE = {
    "R_id": "7.21 mm", "R_i": "11.11 mm", "R_e": "19.44 mm", "R_ed": "26.23 mm", "r_i": "4.02 mm",
    "nu_0": "3.15 deg", "z": 12, "l": "9 mm", "b": "4 mm", "T": "25 N m", "E": "206 GPa", "nu": 0.3,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"R_id": "11.2 mm"}, "the inner race needs a wall"),
        ({"R_e": "11 mm"}, "the sprags need room"),
        ({"R_ed": "19 mm"}, "the outer race needs a wall"),
        ({"r_i": "0 mm"}, "inputs.r_i"),
        ({"r_i": "20 mm"}, "m"),
        ({"nu_0": "0 deg"}, "inputs.nu_0"),
        ({"nu_0": "20 deg"}, "inputs.nu_0"),
        ({"z": 2}, "inputs.z"),
        ({"b": "6 mm"}, "sprags stand side by side"),
        ({"T": "25 N"}, "inputs.T"),
        ({"T": "1e7 N m"}, "T = 1e+07 N m"),
        ({"nu": 0.5}, "inputs.nu"),
        ({"mu": 0.1}, "mu"),
    ],
)
def test_wrong_inputs_end_in_one_line(change, words, tmp_path, capsys):
    lines = [f"{k} = {v!r}".replace("'", '"') for k, v in (BASE | change).items()]
    path = tmp_path / "own.toml"
    path.write_text("\n".join(['case = "sprag-wedge"', "[inputs]", *lines]), "utf-8")
    assert run(["check", str(path)]) == 2
    told = capsys.readouterr()
    assert words in told.err
    assert len(told.err.strip().splitlines()) == 1
    assert not told.out


def test_the_drawn_sprag_touches_both_races():
    body = outline(Q, turned=0.0, alpha_b=0.0, OC_e=float(Q.sprag.OC_e))
    r = np.hypot(*body.T)
    assert r.min() == pytest.approx(Q.R_i, rel=1e-9)
    assert r.max() == pytest.approx(Q.R_e, rel=1e-9)


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(WEDGE))


def test_every_row_finds_what_it_compares(judged):
    result = judged(WEDGE)
    assert len({row.id for row in result.rows}) == len(result.rows)
    context = Context(WEDGE.id, Q, WEDGE.analytic(Q), (), is_paper=True)
    told = [r.id for c in WEDGE.checks for r in
            (c.skipped(WEDGE.id, "") if c.needs_fem else c.rows(context))]  # fmt: skip
    assert set(told) <= {row.id for row in result.rows}


AT = ", at N_0"
RATIO = "T_i/N_i becomes tan ν_0 without load (Eq. 10)"
NU, OMEGA = (
    "T_i/N_i against the strut's tan ν (Eq. 10), at N_0/4",
    "T_e/N_e against the strut's tan ω (Eq. 10), at N_0/4",
)
YIELDS, TURN = (
    f"all yields of elastic bodies{AT}",
    "rotation of the sprags with elastic yields, at N_0",
)
TORQUE, FORCE = f"torque n_s N tan(ν) OA{AT}", "normal force (Eq. 10), at T"
ROLLS = f"turn of the races by rolling, against n_s ∫dU/T{AT}"
PRINTED = f"rotation with Eqs. 9, 10 as printed and elastic yields{AT}"
PLANE = f"rotation with half planes and Eq. 6, long{AT}"
MEAN, THIN = (
    f"mean displacement of the outer race (Eq. 6, long){AT}",
    f"mean displacement of the inner race (Eq. 6 as printed, thin){AT}",
)
EXCESS = f"excess of N_e over N_i, which the paper has equal{AT}"
P_I, A_O = (
    f"peak pressure on the inner race (Hertz){AT}",
    f"half-width on the outer race (Hertz){AT}",
)


def scaled(factor):
    return lambda right: lambda *a, **k: factor * np.asarray(right(*a, **k))


def as_printed(right):
    """The unstrained spiral at the lever arm."""
    return lambda clutch, N, yields, *, OA_s, OA: right(clutch, N, yields, OA_s=OA, OA=OA)


def without_half_yields(right):
    return lambda clutch, N, yields, *, OA_s, OA: right(
        clutch, N, yields, OA_s=OA_s + yields.contact_i / 2, OA=OA)  # fmt: skip


def angles_off(share):
    return lambda right: lambda **k: tuple(share * angle for angle in right(**k))


def without_bending(right):
    return lambda *a, **k: replace(right(*a, **k), turned=0.0, moved=0.0)


def whole_yield_in_the_lever(right):
    return lambda clutch, N, yields, *, OA_s, OA: right(
        clutch, N, yields, OA_s=OA_s, OA=OA - yields.contact_i / 2)  # fmt: skip


BENT = "T_i/N_i against the strut's tan ν (Eq. 10), at 1.8 N_0"

READINGS = [
    pytest.param(closure, "strut", angles_off(1.0035), BENT, id="angles 0.35 % too large"),
    pytest.param(closure, "strut", angles_off(0.9970), BENT, id="angles 0.3 % too small"),
    pytest.param(closure, "closed", whole_yield_in_the_lever,
                 "T_e/N_e against the strut's tan ω (Eq. 10), at N_0",
                 id="all of delta_HI in the lever arm"),
    pytest.param(wedge, "shift", without_bending, BENT, id="the column does not bend"),
    pytest.param(
        wedge, "shift", without_bending,
        "force ratio on the inner race at 1.8 N_0, but for the column's bending",
        id="a rigid column, as the force ratio has it",
    ),
    pytest.param(closure, "strut", lambda right: lambda **k: right(**k)[::-1], NU,
                 id="nu and omega swapped"),
    pytest.param(closure, "strut", lambda right: lambda **k: right(
        OA=k["OA"] * 1.001, OB=k["OB"], beta=k["beta"]), RATIO, id="OA too long by its yields"),
    pytest.param(closure, "strut", lambda right: lambda **k: (
        right(**k)[0], right(**k)[0] - 1.01 * k["beta"]), OMEGA, id="omega off"),
    pytest.param(closure, "closed", as_printed, TURN, id="Eqs. 9 and 10 as printed"),
    pytest.param(closure, "closed", as_printed, ROLLS, id="Eqs. 9 and 10 as printed, turn"),
    pytest.param(closure, "closed", without_half_yields, TURN, id="half of delta_HI left out"),
    pytest.param(printed, "wedged", lambda _: closure.wedged, PRINTED,
                 id="the corrected closure where the printed one is told"),
    pytest.param(formulas, "wedged", lambda right: lambda clutch, N: right(clutch, Q.z * N), TORQUE,
                 id="the force of all sprags"),
    pytest.param(formulas, "at_torque", lambda right: lambda clutch, T: right(clutch, T / 2), FORCE,
                 id="half the torque"),
    pytest.param(elastic.Elastic, "E_plane", lambda _: property(
        lambda self: self.parts.E), YIELDS, id="1 - nu² dropped"),
    pytest.param(elastic.Race, "at", lambda right: lambda self, a: right(self, 2 * a), YIELDS,
                 id="widths for half-widths in races"),
    pytest.param(column, "approach", scaled(1.05), YIELDS, id="sprag 5 % too soft"),
    pytest.param(Yields, "H", lambda right: property(
        lambda self: right.fget(self) - self.race_i), YIELDS, id="a yield left out of H"),
    pytest.param(smeared.lame, "radial_displacement", scaled(1.01), THIN, id="Eq. 6 off by 1 %"),
    pytest.param(parts, "race_deflection", lambda right: lambda **k: right(
        **k | {"ends": "plane strain"}), THIN, id="long rings where thin ones are told"),
    pytest.param(elastic.LoadedRace, "mean_pressure", lambda right: property(
        lambda self: right.fget(self) * 1.002), MEAN, id="races pressed 0.2 % too much"),
    pytest.param(parts.Parts, "plane", lambda right: lambda self: replace(
        right(self), sprag=self.palmgren().sprag), PLANE, id="the bar counted twice"),
    pytest.param(hertz_line, "relative_radius", lambda right: lambda **k: right(
        R_1=k["R_1"], R_2=abs(k["R_2"])), A_O, id="a convex outer race"),
    pytest.param(hertz_line, "contact_modulus", lambda right: lambda **k: right(
        **k | {"assumption": "plane stress"}), P_I, id="plane stress for plane strain"),
    pytest.param(formulas, "pressures", lambda right: lambda p, s: tuple(
        np.pi / 4 * x for x in right(p, s)), P_I, id="mean pressure for its peak"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(WEDGE)
    broken(owner, name, fault)
    assert row in names(red(judged(WEDGE, drawn=False)))


FEM_FAULTS = [
    pytest.param(Elastic, "lame_constants", lambda right: lambda self, _: right(
        self, "plane stress"), MEAN, id="plane stress"),
    pytest.param(State, "torque", lambda right: property(
        lambda self: right.fget(self) * (1 - 1 / Q.z)), TORQUE, id="a sprag too few"),
    pytest.param(Place, "H", lambda right: property(
        lambda self: right.fget(self) / 2), YIELDS, id="half of the overlaps"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, red):
    before = red_without_fault()
    broken(owner, name, fault)
    assert row in names(red(solve_anew())) - before
