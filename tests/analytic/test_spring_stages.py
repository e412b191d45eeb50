"""Stages of the accordion spring, and the width factor of a leaf."""

import math
from dataclasses import fields
from itertools import product

import numpy as np
import pytest

from analytic.spring import frame
from analytic.spring.stages import Stages, gap, stages
from analytic.spring.wide_leaf import width_factor

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


@pytest.mark.parametrize("spring", SPRINGS[1::2])
@pytest.mark.parametrize("theory", ["thin", "shear"])
@pytest.mark.parametrize(("head", "tail"), ENDS)
def test_the_first_stage_is_the_force_method_s_frame(spring, theory, head, tail):
    ends = {"head": head, "tail": tail, "theory": theory}
    assert stages(**spring, **ends).k1 == pytest.approx(
        frame.stiffness(**spring, **ends), rel=1e-11
    )


def test_force_and_displacement_are_each_other_s_inverse_and_have_no_jump():
    s = stages(**PAPER, head="hinged")
    U = np.linspace(0, 20, 41)
    np.testing.assert_allclose(s.displacement(s.force(U)), U, atol=1e-12)
    for at, force in ((s.U_A, s.F_A), (s.U_B, s.F_B)):
        assert s.force(at * (1 - 1e-9)) == pytest.approx(force, rel=1e-8)
        assert s.force(at * (1 + 1e-9)) == pytest.approx(force, rel=1e-8)
    assert s.intercept == pytest.approx(s.F_A - s.k2 * s.U_A)


NU = 0.3
WIDEST = 1 / (1 - NU**2)


def test_a_leaf_stiffens_with_its_width_between_a_beam_and_a_plate():
    f = width_factor(np.geomspace(1e-2, 100, 20), 1.0)
    assert (np.diff(f) > 0).all()
    assert 1 < f[0] < 1.003
    assert WIDEST - 5e-4 < f[-1] < WIDEST


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


@pytest.mark.parametrize("spring", SPRINGS)
def test_the_tilt_at_contact_is_the_angle_less_the_integral_of_the_curvature(spring):
    """Rotation F_A int y ds/(E I) over half leaf, arc and leaf, from 90 deg - alpha."""
    a, R, alpha = shape(spring)
    beta, y = math.pi / 2 + alpha, a + R * math.cos(alpha)
    bend = R * (a * beta + R * (1 - math.cos(beta)))
    turned = a**2 / 2 + bend + (y**2 - a**2) / 2 / math.sin(alpha)
    s = stages(**spring, head="free")
    left = math.pi / 2 - alpha - float(s.F_A) * turned / section(spring)
    assert float(s.tilt) == pytest.approx(left, abs=1e-11)


@pytest.mark.parametrize("spring", [PAPER, {**PAPER, "n": 4}])
def test_the_top_couple_of_a_guided_head_is_that_of_the_side_with_one_loop_more(spring):
    """M = y - S/L for even n, with S^2/L from the two stiffnesses; y = a + R at the tops."""
    a, R, alpha = shape(spring)
    straight = (2 * a + 2 * R * math.cos(alpha)) / math.sin(alpha)
    L = 2 * a + math.pi * R + (spring["n"] - 2) * (2 * alpha * R + straight)
    free, guided = (stages(**spring, head=head) for head in ("free", "guided"))
    square = section(spring) * float(1 / free.k1 - 1 / guided.k1)  # S^2/L
    mean = math.sqrt(square / L)
    assert float(guided.top_couple / guided.F_A) == pytest.approx(a + R + mean, rel=1e-9)
    assert float(free.top_couple / free.F_A) == pytest.approx(a + R, rel=1e-12)
