"""Races under n sprags: readings, faults that turn rows red, and parameters of one's own."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pydantic import ValidationError

from analytic.contact import hertz_line
from analytic.ring import fourier_ring, lame, loaded_race, smeared
from fem.plane import loads, patch, solve
from fem.plane.material import Elastic
from meshes.ring import sector
from verify.cases.registry import find
from verify.cases.ring.loads import figures
from verify.cases.ring.loads import inputs as ring_loads_inputs
from verify.cases.ring.loads.case import INNER, OUTER, InnerRace, OuterRace
from verify.cases.ring.loads.formulas import SpragLoads
from verify.cases.ring.loads_map.case import CHECKED, COUNTS, MAP, RATIOS, LoadsMap
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("ring-loads")
COARSE = replace(OUTER, levels=(2, 3, 4))
BOTH = pytest.mark.parametrize("case", [OUTER, INNER], ids=lambda case: case.id)
WALL = {"ring-loads-outer": "bore", "ring-loads-inner": "rim"}


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case, inputs=None):
    q = inputs or case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


@pytest.fixture
def patched(monkeypatch):
    """Wrap a function of the analytic side, so that only this side reads differently."""

    def patch(module, name, wrapper):
        right = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *a, **k: wrapper(right, *a, **k))

    return patch


@pytest.mark.parametrize("case", [OUTER, INNER, MAP], ids=lambda case: case.id)
def test_every_row_passes_and_the_case_is_registered(case, judged, red):
    assert not red(judged(case))
    assert find(case.id) is case


@BOTH
def test_races_are_thin_rings_plane_stress(case, judged, red, patched):
    patched(SpragLoads, "race",
            lambda right, *a, **k: replace(right(*a, **k), assumption="plane strain"))  # fmt: skip
    assert f"{WALL[case.id]} displacement at a load" in names(red(judged(case)))
    assert "strain energy of the race" in names(red(judged(case)))


@BOTH
def test_eq_6_itself_is_read_in_plane_stress(case, judged, red, patched):
    def long(right, *args, ends, **more):
        return right(*args, ends="plane strain", **more)

    patched(lame, "radial_displacement", long)
    assert f"{WALL[case.id]} displacement, mean" in names(red(judged(case)))


@BOTH
def test_the_contact_s_half_width_is_that_of_long_rollers(case, judged, red, patched):
    patched(hertz_line, "contact_modulus",
            lambda right, **k: right(**k | {"assumption": "plane stress"}))  # fmt: skip
    assert f"{WALL[case.id]} displacement at a load" in names(red(judged(case)))


@BOTH
def test_the_race_s_curvature_has_its_sign(case, judged, red, patched):
    patched(hertz_line, "relative_radius", lambda right, *, R_1, R_2: right(R_1=R_1, R_2=-R_2))
    assert f"{WALL[case.id]} displacement at a load" in names(red(judged(case)))


@BOTH
def test_n_is_the_number_of_sprags(case, judged, red, patched):
    """Not the number of slices of Eqs. 3 to 5, of which 6 would be few, nor a speed."""
    patched(smeared, "race_deflection", lambda right, *, n, **k: right(n=n / 2, **k))
    wall = WALL[case.id]
    assert {f"{wall} displacement, mean", "Eq. 6 at a load", "Eq. 6 between loads"} <= names(
        red(judged(case))
    )


@BOTH
def test_n_and_the_force_are_of_one_sprag_each(case, judged, red, patched):
    """N over all sprags, or a pressure over the pitch of half as many, turns everything red."""
    patched(SpragLoads, "race",
            lambda right, q, **k: replace(right(q, **k), n=q.n // 2, P=2 * q.P))  # fmt: skip
    assert {"ripple over the mean", "strain energy of the race"} <= names(red(judged(case)))


FORMULAS = [
    pytest.param(smeared, "race_deflection", lambda f: lambda **k: f(**k | {"nu": -k["nu"]}),
                 "Eq. 6 at a load", id="sign of Poisson's ratio in Eq. 6"),
    pytest.param(smeared, "race_deflection", lambda f: lambda **k: 1.002 * f(**k),
                 "Eq. 6 between loads", id="Eq. 6 0.2 % too large"),
    pytest.param(loaded_race, "share", lambda f: lambda x: 1.0 + 0 * f(x),
                 "hoop force in the cut between loads", id="a point force for the ellipse"),
    pytest.param(loaded_race, "_mean_logarithm", lambda f: lambda phi, beta: f(phi, 1.1 * beta),
                 "WALL displacement at a load", id="closed sum of a wider patch"),
    pytest.param(fourier_ring, "_wall_tractions",
                 lambda f: lambda m, far: f(m, far) * np.array([1, 1, 1.01, 1]),
                 "WALL displacement between loads", id="a per cent in one of Michell's terms"),
    pytest.param(fourier_ring, "_stresses", lambda f: lambda m, rho, s: -f(m, rho, s),
                 "hoop stress between loads, WALL", id="sign of the waves' stresses"),
    pytest.param(fourier_ring.FourierRing, "kappa", lambda _: property(lambda _self: 1.8),
                 "WALL displacement at a load", id="Kolosov's constant of plane strain"),
]  # fmt: skip


@BOTH
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FORMULAS)
def test_a_wrong_formula_turns_its_row_red(case, owner, name, fault, row, judged, red, monkeypatch):
    row = row.replace("WALL", WALL[case.id])
    assert row not in names(red(judged(case)))
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(case)))


DENTS = {
    "twice the dent": lambda f: lambda q, depth: 2 * f(q, depth),
    "twice the depth": lambda f: lambda q, depth: f(q, 2 * depth),
}


@BOTH
@pytest.mark.parametrize("fault", DENTS.values(), ids=DENTS)
def test_a_wrong_dent_turns_every_row_with_a_dent_red(case, fault, judged, red, monkeypatch):
    judged(case)
    monkeypatch.setattr(SpragLoads, "dent_to", fault(SpragLoads.dent_to))
    assert {
        "Eq. 6 at a load, dent to the wall's depth taken out",
        "Eq. 6 at a load, dent to half the wall taken out",
        "Eq. 6 and Hertz's dent to the wall's depth, at a load",
    } <= names(red(judged(case)))


def test_a_wrong_field_inside_turns_the_rows_of_all_points_red(judged, red, patched):
    """Of the tangential displacement and of stresses off the named points nothing else speaks."""

    def slipped(right, *args, **more):
        moved = right(*args, **more)
        moved[:, 1] *= 1.2
        return moved

    patched(fourier_ring, "_displacements", slipped)
    assert "displacements at every node of both walls within 0.001" in names(red(judged(OUTER)))


def test_a_wrong_shear_stress_turns_the_row_of_all_stresses_red(judged, red, patched):
    def sheared(right, *args):
        stresses = right(*args)
        stresses[:, 2] *= 1.1
        return stresses

    patched(fourier_ring, "_stresses", sheared)
    assert "stresses beyond one patch width within 0.001" in names(red(judged(OUTER)))


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("owner", "name", "fault"),
    [
        pytest.param(Elastic, "lame_constants", lambda f: lambda self, _: f(self, "plane strain"),
                     id="plane strain for plane stress"),
        pytest.param(solve, "vector_basis", lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k),
                     id="linear elements"),
        pytest.param(OuterRace, "half_width", lambda f: property(lambda q: 1.02 * f.fget(q)),
                     id="patch 2 % too wide"),
        pytest.param(patch, "replace", lambda f: lambda s, **k: f(s, **k | {"u": s.u}),
                     id="a load of even cells not made good"),
        pytest.param(sector, "half_block",
                     lambda f: lambda *, width, **k: f(width=1.001 * width, **k),
                     id="a sector 0.1 % too wide"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, monkeypatch, red):
    before = red_without_fault()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert names(red(solve_anew(COARSE))) - before


@pytest.mark.soak  # finite elements solved anew for every fault
def test_a_load_a_thousandth_too_large_turns_a_row_red(monkeypatch, red):
    before = red_without_fault()
    right = loads.push
    monkeypatch.setattr(loads, "push", lambda side, p: right(side, 1.001 * p))
    assert names(red(solve_anew(COARSE))) - before


def test_the_claim_about_eq_6_rests_on_a_fitted_force(judged):
    (row,) = (r for r in judged(INNER).rows if "too soft" in r.quantity)
    assert row.status is Status.CALIBRATED
    assert "+14.5%" in row.reason or "+14.6%" in row.reason


def test_another_number_of_sprags_is_shown_not_claimed(judged):
    result = solve_anew(COARSE, OuterRace(n=6))
    (row,) = (r for r in result.rows if "too soft" in r.quantity)
    assert row.status is Status.SHOWN
    assert "-17.4% off at n = 6" in row.reason


def test_smearing_costs_windup_and_hides_force_from_12_sprags_on():
    races = (OuterRace(), InnerRace())
    windup, peak = figures.ratios(races, 12)
    assert 1.04 < windup < 1.05
    assert 0.97 < peak < 0.98
    windup, peak = figures.ratios(races, 6)
    assert windup < 1 < peak


@pytest.mark.parametrize(
    ("inputs", "wrong", "said"),
    [
        (OuterRace, {"r_o": 19e-3}, "r_i < r_o"),
        (OuterRace, {"r_o": 19.45e-3}, "a shell"),
        (OuterRace, {"n": 1}, "greater than or equal to 2"),
        (OuterRace, {"R": 19e-3}, "smaller than 0.9 of the bore"),
        (OuterRace, {"F": 3e6}, "flattens a = "),
        (InnerRace, {"r_i": 10.8e-3}, "more than 0.3 of the wall"),
        (InnerRace, {"n": 300}, "n = 300 patches of half-width 0.112 mm crowd on a wall"),
        (OuterRace, {"nu": 0.5}, "less than or equal to 0.45"),
        (LoadsMap, {"a_r": 0.016}, "less than or equal to 0.015"),
    ],
)
def test_inputs_without_sense_are_refused_in_words(inputs, wrong, said):
    with pytest.raises(ValidationError, match=said):
        inputs(**wrong)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"R_p": 500e6}, "yields below the contact"),
        ({"R_p": 100e6}, "hoop stress"),
        ({"F": 60e3}, "no steel bears that"),
        ({"r_o": 20.4e-3, "F": 3407.0}, "of the wall"),
    ],
)
def test_an_engineer_is_warned(more, said):
    q = OuterRace(**more)
    assert any(said in words for words in OUTER.warnings(q, OUTER.analytic(q)))


@BOTH
def test_nothing_is_warned_of_at_the_paper_s_numbers(case):
    q = case.inputs()
    assert not case.warnings(q, case.analytic(q))
    assert not case.too_large(q)


@pytest.mark.parametrize(
    ("more", "said"),
    [({"r_o": 300e-3}, "r_o/r_i"), ({"n": 250, "F": 1000.0, "R": 1e-3}, "n = 250"),
     ({"F": 0.05}, "digits")],
)  # fmt: skip
def test_finite_elements_refuse_what_they_cannot_follow(more, said):
    assert said in OuterRace(**more).refusal()


def test_the_map_has_its_checked_points_on_it():
    assert {n for n, _ in CHECKED} <= set(COUNTS)
    assert {ratio for _, ratio in CHECKED} <= set(RATIOS)


@pytest.mark.parametrize("name", ["_wall_tractions", "_displacements"])
def test_a_wrong_ring_turns_the_map_s_rows_red(name, judged, red, patched):
    def off(right, *args):
        found = right(*args).copy()
        found[..., 0] *= 1.01
        found[0] *= 1.01
        return found

    patched(fourier_ring, name, off)
    assert len(red(judged(MAP))) >= 6


def test_inputs_know_their_half_width_by_themselves():
    """Finite elements must not take it from the formulas: the two agree, and share no code."""
    for q in (OuterRace(), InnerRace()):
        assert q.half_width == pytest.approx(q.hertz[0], rel=1e-13)
    assert not hasattr(ring_loads_inputs, "hertz_line")
