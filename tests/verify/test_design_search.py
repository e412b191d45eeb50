"""The search of a design: formulas, each limit alone, limits to relax, and run time."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.spring import energy, frame
from analytic.spring.wide_leaf import width_factor
from verify.studies.design.front import distance_to_ideal, pareto, scaled, thinned
from verify.studies.design.inputs import Task, default
from verify.studies.design.limits import limits
from verify.studies.design.search import search
from verify.studies.design.springs import Formulas, Springs, candidates, formulas

PAPER = {"n": (10.0,), "b": (1e-4,), "L1": (11.6e-3,), "r": (0.45e-3,),
         "alpha": (math.radians(80),)}  # fmt: skip
# Eqs. 1-9 as the paper reads them
AS_PRINTED = {"arcs": "inner", "head": "free", "tail": "arc", "sway": None}


def asked(ranges=None, **demands):
    """The default task with other demands [SI]."""
    base = default()
    narrow = {"width_factor": 1.0} | demands
    return Task("task", base.demands.model_copy(update=narrow), ranges or base.ranges)


def some(count=4, **ranges):
    """A coarse search."""
    found = {k: (v[:: max(1, len(v) // count)]) for k, v in default().ranges.items()}
    return found | ranges


# Formulas


@pytest.mark.parametrize(("head", "tail"), [("free", "arc"), ("guided", "mid-leaf")])
def test_arrays_give_what_one_spring_gives(head, tail):
    task = asked(some(2, n=(8.0,)), head=head, tail=tail)
    s = candidates(task.ranges)
    f = formulas(s, task.demands)
    q = task.demands
    for i in np.flatnonzero(s.possible)[::7]:
        one = {"n": 8, "L1": s.L1[i], "alpha": s.alpha[i]}
        R = s.r[i] + s.b[i] / 2
        k = frame.stiffness(**one, radius=R, b=s.b[i], h=q.h, E=q.E, head=head, tail=tail)
        assert f.k1[i] == pytest.approx(k, rel=1e-9)
        assert f.L0[i] == pytest.approx(frame.free_length(**one, r=s.r[i], b=s.b[i]), rel=1e-12)
        assert f.U_w[i] == f.L0[i] - q.L_w
        eqs = energy.stiffness(**one, r=s.r[i], b=s.b[i], h=q.h, E=q.E)
        assert f.k1_eqs_1_9[i] == pytest.approx(float(eqs), rel=1e-12)


def test_a_free_head_is_stressed_at_the_apex_of_a_loop():
    task = asked(PAPER, **(AS_PRINTED | {"arcs": "centre line"}), F_w=5.0)
    f = formulas(candidates(PAPER), task.demands)
    straight = 6 * 5.0 * (5.8e-3 + 0.5e-3) / (0.056 * 1e-4**2)
    kappa = float(energy.curvature_factor(b=1e-4, r=0.45e-3))
    assert f.stress[0] == pytest.approx(kappa * straight, rel=1e-9)


def test_without_a_width_factor_every_leaf_is_a_plate():
    task = asked(some(3), width_factor=None)
    s = candidates(task.ranges)
    f, narrow = (formulas(s, one.demands) for one in (task, asked(width_factor=1.0)))
    assert f.k1[s.possible] == pytest.approx((f.f * narrow.k1)[s.possible], rel=1e-12)
    for i in np.flatnonzero(s.possible)[::40]:
        leaf = energy.leaf_length(L1=s.L1[i], r=s.r[i], b=s.b[i], alpha=s.alpha[i])
        assert f.f[i] == pytest.approx(float(width_factor(task.demands.h, leaf)), abs=2e-5)


def test_a_strip_that_cannot_be_bent_is_no_spring():
    ranges = PAPER | {"b": (1e-4, 0.45e-3), "L1": (0.9e-3, 11.6e-3)}  # b = r, and 2 r = L1
    found = search(asked(ranges))
    shapes = list(zip(found.springs.b, found.springs.L1, strict=True))
    possible = [shape for shape, ok in zip(shapes, found.judged.possible, strict=True) if ok]
    assert possible == [(1e-4, 11.6e-3)]
    assert found.judged.reasons(shapes.index((0.45e-3, 11.6e-3))) == ("shape",)


# The spring of the paper by the rules of the paper


def test_the_paper_s_spring_keeps_eqs_11_and_12_and_breaks_eq_13():
    # 5 N at the roller's travel of 8.3 mm, which Sec. 1.2 prints; k_1 = 0.601 N/mm gives 8.32 mm
    task = asked(PAPER, **AS_PRINTED, L_w=None, U_w=8.3e-3, F_w=5.0)
    found = search(task)
    assert found.judged.reasons(0) == ("z_max",)
    (z,) = (limit for limit in found.judged.limits if limit.key == "z_max")
    assert 247 <= z.value[0] <= 256
    assert found.formulas.k1[0] / 1e3 == pytest.approx(0.60096, abs=5e-6)
    assert search(replace(task, demands=task.demands.model_copy(update={"z_max": None}))).front.size


# Each limit alone, at its boundary

ONE = Springs(np.array([10]), *(np.array([v]) for v in (1e-4, 11.6e-3, 0.45e-3, math.radians(80))))
DEMANDS = default().demands.model_copy(
    update={"F_w": 5.0, "L_w": None, "U_w": 8e-3, "margin": 0.25, "sway": 0.5}
)
# 5 N at 8 mm; L_0 = 24 mm: U_w/L_0 = 1/3 and L_0/b = 240; far from every other limit
KEPT = {
    "f": 1.0,
    "L0": 24e-3, "U_w": 8e-3, "k1": 625.0, "k1_eqs_1_9": 600.0, "U_A": 16e-3, "F_A": 10.0,
    "k2": 700.0, "U_cr": 20e-3, "stress": 300e6,
}  # fmt: skip
HAIR = 1e-9
BOUNDARIES = [  # what is changed to lie on the boundary, and the sign that leads beyond it
    ("e_max", {"k1": 625.0 * 1.03}, {}, +1),
    ("e_max", {"k1": 625.0 * 0.97}, {}, -1),
    ("ratio_min", {"L0": 8e-3 / 0.3}, {"z_max": 300.0}, +1),
    ("ratio_max", {"L0": 8e-3 / 0.6}, {}, -1),
    ("z_max", {"L0": 24e-3}, {}, +1),
    ("wedge", {"L0": 20e-3}, {"wedge": 20e-3}, +1),
    ("margin", {"U_A": 10e-3}, {}, -1),
    ("sway", {"U_cr": 12e-3}, {}, -1),
    ("sigma", {"stress": 500e6}, {}, +1),
    ("room", {}, {"room": 11.6e-3 + 2 * 0.55e-3}, +1),
    ("k_band", {}, {"b_tolerance": 2e-6, "k_band": 1.02**3 - 1}, +1),
]


def judged(values, demands):
    f = Formulas(**{k: np.array([v]) for k, v in (KEPT | values).items()})
    return limits(ONE, f, DEMANDS.model_copy(update=demands)).reasons(0)


@pytest.mark.parametrize(("key", "values", "demands", "sign"), BOUNDARIES)
def test_a_limit_holds_on_its_boundary_and_alone_rejects_what_is_beyond(key, values, demands, sign):
    assert judged({}, {}) == ()
    assert judged(values, demands) == ()
    if values:
        values = {k: v * (1 + sign * HAIR) for k, v in values.items()}
    else:  # a limit of the shape is moved itself
        demands = demands | {key: demands[key] * (1 - HAIR)}
    assert judged(values, demands) == (key,)


def test_eq_11_divides_by_the_computed_displacement():
    # U_w = 8 mm, Δ = 5 N/k_1: 3 % of Δ allow Δ up to 8/0.97 = 8.2474 mm, 3 % of U_w only 8.24 mm
    assert judged({"k1": 5.0 / 8.245e-3}, {}) == ()


# What to relax


def test_relaxing_what_is_named_admits_the_named_spring():
    task = asked(some(6), F_w=30.0)
    found = search(task)
    assert not found.front.size
    for together in (*((r,) for r in found.relaxations), found.nearest):
        wider = task.demands.model_copy(update={r.limit.key: r.needed for r in together})
        assert search(replace(task, demands=wider)).judged.feasible[together[0].candidate]


# The front


def beaten(rows, i):
    """The definition, by hand: somebody is as good everywhere and better somewhere."""
    return any(
        all(a <= b for a, b in zip(other, rows[i], strict=True))
        and any(a < b for a, b in zip(other, rows[i], strict=True))
        for other in rows
    )


@pytest.mark.parametrize("levels", [4, 1000])  # with many ties, and nearly none
def test_the_front_follows_its_definition(levels):
    rows = np.random.default_rng(0).integers(0, levels, (120, 4)).astype(float)
    expected = [i for i in range(len(rows)) if not beaten(rows.tolist(), i)]
    assert pareto(rows).tolist() == expected


def test_the_ideal_has_the_best_of_every_objective_and_a_thinned_front_its_extremes():
    rows = np.array([[2.0, 7.0], [4.0, 7.0], [3.0, 7.0]])
    assert scaled(rows).tolist() == [[0, 0], [1, 0], [0.5, 0]]  # all equal: no difference
    rows = np.array([[0.0, 4.0], [3.0, 0.0], [1.0, 1.0]])
    assert distance_to_ideal(rows) == pytest.approx([1, 1, np.hypot(1 / 3, 1 / 4)])
    angle = np.linspace(0, np.pi / 2, 500)
    rows = np.column_stack([1 - np.cos(angle), 1 - np.sin(angle)])
    kept = thinned(rows, 20)
    distance = distance_to_ideal(rows)
    assert len(kept) == len(set(kept.tolist())) == 20
    assert {0, 499, int(distance.argmin())} <= set(kept.tolist())
    assert np.all(np.diff(distance[kept]) >= 0)  # the nearest first
    assert np.diff(np.sort(angle[kept])).max() < 0.12  # no gap: 0.083 if even
