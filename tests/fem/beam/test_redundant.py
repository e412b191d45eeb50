"""Statically indeterminate straight beams (Roark, tables of shear, moment and deflection).

Shear adds L / GA to every compliance; s = EI / (GA L^2) carries it through the formulas.
"""

import numpy as np
import pytest

from fem.beam.section import Section
from fem.beam.straight import solve_frame
from tests.fem.beam.models import with_middles

L, EA, EI, P, q = 2.0, 1e3, 30.0, 7.0, 5.0  # any
SHEAR = 0.05  # s, a beam about as deep as a third of its length
THIN, DEEP = Section(EA=EA, EI=EI), Section(EA=EA, EI=EI, GA=EI / (SHEAR * L**2))
ROUND_OFF = 1e-10  # relative; 1e-16 times a condition number of about (elements)^4 EA L^2 / EI


every_theory = pytest.mark.parametrize(
    ("solve", "section", "s"),
    [
        pytest.param(solve_frame, THIN, 0.0, id="Bernoulli"),
        pytest.param(solve_frame, DEEP, SHEAR, id="Timoshenko, closed form"),
        pytest.param(with_middles, DEEP, SHEAR, id="Timoshenko, quadratic elements"),
    ],
)


def beam(count=4):
    x = np.linspace(0, L, count + 1)
    return np.column_stack([x, 0 * x]), [(k, k + 1) for k in range(count)]


def under_even_load(supports):
    return solve_frame(
        *beam(), sections=THIN, supports=supports, loads={},
        distributed=dict.fromkeys(range(4), (0.0, -q)),
    )  # fmt: skip


def near(*values):
    return pytest.approx(values, rel=ROUND_OFF, abs=1e-11)


@every_theory
def test_a_force_amid_a_propped_cantilever(solve, section, s):
    f = solve(*beam(), sections=section, supports={0: "xyr", 4: "y"}, loads={2: (0.0, -P, 0.0)})
    prop = P * (5 / 48 + s / 2) / (1 / 3 + s)  # compatibility at the prop; 5/16 P without shear
    assert f.reaction(4) == near(0, prop, 0)
    assert f.reaction(0) == near(0, P - prop, P * L / 2 - prop * L)
    sink = (P * (1 / 24 + s / 2) - prop * (5 / 48 + s / 2)) * L**3 / EI  # 7/768 without shear
    assert f.u[2, 1] == pytest.approx(-sink, rel=ROUND_OFF)


@every_theory
def test_a_built_in_end_that_settles_and_turns(solve, section, s):
    sink, turn = 0.01, 0.02
    f = solve(
        *beam(), sections=section, supports={0: "xyr", 4: {"x": 0.0, "y": sink, "r": turn}},
        loads={},
    )  # fmt: skip
    # slope deflection: 12, 6, 4 + 12 s and 2 - 12 s over 1 + 12 s
    k = EI / (L * (1 + 12 * s))
    force = 12 * k * sink / L**2 - 6 * k * turn / L
    here = -6 * k * sink / L + (4 + 12 * s) * k * turn
    there = -6 * k * sink / L + (2 - 12 * s) * k * turn
    assert f.reaction(4) == near(0, force, here)
    assert f.reaction(0) == near(0, -force, there)
    # the supports' work is stored
    assert f.strain_energy == pytest.approx((force * sink + here * turn) / 2, rel=ROUND_OFF)
    assert f.potential_energy == f.strain_energy


def test_two_spans_under_an_even_load_lean_on_their_middle_support():
    f = under_even_load({0: "xy", 2: "y", 4: "y"})
    for node, share in ((0, 3 / 8), (2, 10 / 8), (4, 3 / 8)):  # of a span's load
        assert f.reaction(node) == near(0, share * q * L / 2, 0)
    assert f.u[2] == near(0, 0, 0)
