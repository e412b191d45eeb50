"""Stages of the accordion spring against its closed form written out, symmetry and limits."""

import math
import warnings
from dataclasses import fields
from itertools import product

import numpy as np
import pytest

from analytic.spring import frame
from analytic.spring.stages import Stages, gap, stages

STRIP = {"b": 0.1, "h": 56.0, "E": 206e3}
PAPER = {"n": 10, "L1": 11.6, "radius": 0.5, "alpha": math.radians(80), **STRIP}
SPRINGS = [
    PAPER,
    {**PAPER, "n": 7},
    {**PAPER, "n": 4, "alpha": math.radians(90)},
    {**PAPER, "n": 13, "L1": 5.0, "radius": 0.8, "alpha": math.radians(55), "b": 0.3},
]
HEADS, TAILS = ("free", "hinged", "guided"), ("mid-leaf", "arc")
ENDS = tuple(product(HEADS, TAILS))
EI = 206e3 * 56 * 0.1**3 / 12


def shape(s):
    return s["L1"] / 2, s["radius"], s["alpha"]


def f_FC(s):
    """The docstring's integral of y (y + a) from O to the place opposite the tip."""
    a, R, alpha = shape(s)
    beta, y = math.pi / 2 + alpha, a + R * math.cos(alpha)
    bend = R * (2 * a**2 * beta + 3 * a * R * (1 - math.cos(beta))
                + R**2 * (beta / 2 - math.sin(2 * beta) / 4))  # fmt: skip
    leaf = ((y**3 + a**3) / 3 + a * (y**2 - a**2) / 2) / math.sin(alpha)
    return 5 * a**3 / 6, bend, leaf


def f_CC(s):
    """The docstring's integral of (y + a)^2 over the whole loop."""
    a, R, alpha = shape(s)
    beta, y = math.pi / 2 + alpha, a + R * math.cos(alpha)
    bend = R * (4 * a**2 * beta + 4 * a * R * (1 - math.cos(beta))
                + R**2 * (beta / 2 - math.sin(2 * beta) / 4))  # fmt: skip
    return 8 * a**3 / 3 + bend + (y + a) ** 3 / (3 * math.sin(alpha))


def section(s):
    return s["E"] * s["h"] * s["b"] ** 3 / 12


@pytest.mark.parametrize("spring", SPRINGS)
@pytest.mark.parametrize(("tail", "p"), [("mid-leaf", 2), ("arc", 1)])
def test_a_free_head_follows_the_written_out_closed_form(spring, tail, p):
    s = stages(**spring, head="free", tail=tail)
    k1 = frame.stiffness(**spring, head="free", tail=tail)
    J = section(spring) / k1
    F_A = gap(**{k: spring[k] for k in ("L1", "radius", "b", "alpha")}) * section(spring)
    F_A /= sum(f_FC(spring))
    assert s.k1 == pytest.approx(k1, rel=1e-12)
    assert pytest.approx(F_A, rel=1e-12) == s.F_A
    assert pytest.approx(F_A / k1, rel=1e-12) == s.U_A
    k2 = section(spring) / (J - p * sum(f_FC(spring)) ** 2 / f_CC(spring))
    assert s.k2 == pytest.approx(k2, rel=1e-11)


def test_the_paper_s_spring_has_the_numbers_of_the_ledger():
    assert f_FC(PAPER) == pytest.approx((162.6, 108.6, 138.1), abs=0.05)
    assert gap(L1=11.6, radius=0.5, b=0.1, alpha=PAPER["alpha"]) == pytest.approx(2.952, abs=5e-4)
    s = stages(**PAPER, head="free", tail="arc")
    assert pytest.approx((6.93, 11.91), abs=0.005) == (s.F_A, s.U_A)
    assert pytest.approx((11.50, 19.14), abs=0.005) == (s.F_B, s.U_B)


@pytest.mark.parametrize("spring", SPRINGS)
@pytest.mark.parametrize("theory", ["bending", "thin", "shear"])
@pytest.mark.parametrize(("head", "tail"), ENDS)
def test_the_first_stage_is_the_force_method_s_frame(spring, theory, head, tail):
    ends = {"head": head, "tail": tail, "theory": theory}
    assert stages(**spring, **ends).k1 == pytest.approx(
        frame.stiffness(**spring, **ends), rel=1e-11
    )


def test_inner_radius_and_longer_leaves_are_the_paper_s_line():
    path = {**PAPER, "radius": 0.45, "leaf": 11.6 / math.sin(PAPER["alpha"]) + 1 / math.tan(
        PAPER["alpha"])}  # fmt: skip
    assert stages(**path, head="free", tail="arc").k1 == pytest.approx(0.60096, abs=5e-6)


def test_a_guide_takes_the_mean_height_out_of_an_even_spring():
    """k_1 = E I/(J - S²/L): the guide's couple is not zero though the spring is symmetric."""
    line = frame.sections(
        frame.pieces(**{k: PAPER[k] for k in ("n", "L1", "radius", "alpha")}, tail="mid-leaf")
    )
    y, ds = line.at[1], line.ds
    J, S, L = y**2 @ ds, y @ ds, ds.sum()
    assert stages(**PAPER).k1 == pytest.approx(EI / (J - S**2 / L), rel=1e-11)
    assert S**2 / L > 0.008 * J


@pytest.mark.parametrize("n", [4, 7, 10, 11])
@pytest.mark.parametrize("head", ["free", "guided"])
def test_tips_of_a_symmetric_spring_touch_at_once(n, head):
    s = stages(**PAPER | {"n": n}, head=head)
    assert (s.U_B, s.F_B, s.k3) == (s.U_A, s.F_A, s.k2)


@pytest.mark.parametrize(("head", "tail"), [("hinged", "mid-leaf"), ("free", "arc"),
                                            ("guided", "arc")])  # fmt: skip
def test_other_ends_let_one_tip_touch_after_the_other(head, tail):
    s = stages(**PAPER, head=head, tail=tail)
    assert s.U_B > 1.1 * s.U_A
    assert s.k1 < s.k2 < s.k3


def test_force_and_displacement_are_each_other_s_inverse_and_have_no_jump():
    s = stages(**PAPER, head="hinged")
    U = np.linspace(0, 20, 41)
    np.testing.assert_allclose(s.displacement(s.force(U)), U, atol=1e-12)
    for at, force in ((s.U_A, s.F_A), (s.U_B, s.F_B)):
        assert s.force(at * (1 - 1e-9)) == pytest.approx(force, rel=1e-8)
        assert s.force(at * (1 + 1e-9)) == pytest.approx(force, rel=1e-8)
    assert s.intercept == pytest.approx(s.F_A - s.k2 * s.U_A)


def test_point_a_is_a_matter_of_shape_alone():
    """Neither material nor width nor its factor move U_A; forces go with E I."""
    one, other = stages(**PAPER), stages(**PAPER | {"E": 1e3, "h": 3.0}, width_factor=1.07)
    assert pytest.approx(one.U_A, rel=1e-12) == other.U_A
    assert pytest.approx(1.07 * 3e3 / (206e3 * 56), rel=1e-12) == other.F_A / one.F_A
    thick = stages(**PAPER | {"b": 0.2})
    assert thick.U_A / thick.gap == pytest.approx(one.U_A / one.gap, rel=1e-12)
    assert thick.k2 / one.k2 == pytest.approx(8, rel=1e-12)


def test_thickness_is_taken_from_the_gap():
    """Of the tip b/2, of the leaf, which leans, b/(2 sin α)."""
    thick, thin = (float(stages(**PAPER | {"b": b}).gap) for b in (0.2, 1e-9))
    assert thin - thick == pytest.approx(0.1 * (1 + 1 / math.sin(PAPER["alpha"])), rel=1e-6)


def test_parallel_leaves_are_two_radii_apart():
    assert gap(L1=11.6, radius=0.5, b=0.1, alpha=math.pi / 2) == pytest.approx(1 - 0.1)


def test_the_leaf_has_turned_parallel_to_the_tip_at_a():
    """Ten degrees before loading, one or two at A: the force between them lies along the axis."""
    for head, tail in ENDS:
        assert abs(math.degrees(stages(**PAPER, head=head, tail=tail).tilt)) < 2


def test_the_unloaded_leaf_s_normal_moves_point_a_by_a_per_cent():
    along, across = (stages(**PAPER, normal=normal) for normal in ("force", "leaf"))
    assert pytest.approx(-0.011, abs=5e-4) == across.U_A / along.U_A - 1
    assert across.k2 / along.k2 - 1 == pytest.approx(0.009, abs=5e-4)


def test_the_largest_couple_is_at_a_loop_s_top():
    free, guided = (stages(**PAPER, head=head) for head in ("free", "guided"))
    assert free.top_couple == pytest.approx(6.3 * free.F_A)  # L_1/2 + R
    assert guided.top_couple > 6.3 * guided.F_A


def test_arrays_broadcast_and_are_the_same_one_by_one():
    rng = np.random.default_rng(3)
    many = {
        "b": rng.uniform(0.05, 0.15, 6), "radius": rng.uniform(0.4, 0.8, 6),
        "L1": rng.uniform(8, 14, 6), "alpha": np.radians(rng.uniform(60, 90, 6)),
        "nu": rng.uniform(0.1, 0.4, 6),
    }  # fmt: skip
    fixed = {"n": 9, "h": 56.0, "E": 206e3, "head": "hinged", "theory": "shear"}
    together = stages(**many, **fixed)
    for i in range(6):
        alone = stages(**{k: v[i] for k, v in many.items()}, **fixed)
        for f in fields(Stages):
            assert getattr(together, f.name)[i] == pytest.approx(getattr(alone, f.name), rel=1e-10)
    grid = stages(**PAPER | {"L1": np.array([[10.0], [12.0]]), "b": np.array([0.1, 0.11, 0.12])})
    assert grid.k2.shape == (2, 3)


def test_millimetres_and_metres_give_the_same_spring():
    m = {**PAPER, "b": 1e-4, "h": 0.056, "L1": 0.0116, "radius": 5e-4, "E": 206e9}
    in_m, in_mm = stages(**m, theory="shear"), stages(**PAPER, theory="shear")
    assert (in_m.k2, in_m.F_A, in_m.U_A) == pytest.approx(
        (in_mm.k2 * 1e3, in_mm.F_A, in_mm.U_A / 1e3), rel=1e-11
    )


@pytest.mark.parametrize(("head", "tail"), ENDS)
def test_every_spring_of_a_wide_range_touches_and_stiffens(head, tail):
    rng = np.random.default_rng(7)
    m = 400
    for n in (4, 5, 8, 15, 40):
        R = rng.uniform(0.2, 1, m)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            s = stages(
                n=n, b=R * rng.uniform(0.02, 1, m), h=10.0, radius=R, E=1e5, head=head, tail=tail,
                L1=R * rng.uniform(2.1, 60, m), alpha=np.radians(rng.uniform(20, 90, m)),
            )  # fmt: skip
        assert np.all(np.isfinite(s.F_B))
        assert np.all((s.k1 < s.k2) & (s.k2 <= s.k3) & (s.U_A <= s.U_B))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"n": 3}, "needs n >= 4 segments, got n=3"),
        ({"L1": -1.0}, "L1 must be positive and finite, got -1.0 m"),
        ({"b": math.nan}, "b must be positive and finite, got nan m"),
        ({"E": 0.0}, "E must be positive and finite, got 0.0 Pa"),
        ({"width_factor": 0.0}, "width_factor must be positive and finite, got 0.0"),
        ({"alpha": 2.0}, r"alpha must lie in \(0, 90\] deg, got 114.59"),
        ({"nu": 0.7}, r"Poisson's ratio must lie in \(-1, 0.5\], got nu=0.7"),
        ({"b": 1.2}, "arcs need b < 2 R, got b=1.2 m, radius=0.5 m"),
    ],
)
def test_impossible_springs_are_named_in_one_line(change, message):
    with pytest.raises(ValueError, match=message):
        stages(**PAPER | change)


def test_a_guide_moves_point_a_as_worked_out_by_hand():
    """Another derivation: the guide takes a couple of -0.36 mm F."""
    paper = {"n": 10, "b": 0.1, "h": 56.0, "radius": 0.5, "L1": 11.6, "alpha": np.radians(80),
             "E": 206e3}  # fmt: skip
    free, guided = (stages(**paper, head=head) for head in ("free", "guided"))
    assert [float(v) for v in (free.k1, free.U_A, free.F_A)] == pytest.approx(
        [0.55997, 12.3828, 6.9340], rel=2e-5
    )
    assert [float(v) for v in (guided.k1, guided.U_A, guided.F_A)] == pytest.approx(
        [0.56510, 13.9607, 7.8892], rel=5e-5
    )
