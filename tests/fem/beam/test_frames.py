"""Plane frames from the textbook: portals, joints of several members, any numbering."""

import numpy as np
import pytest

from fem.beam.section import Section
from tests.fem.beam.models import both_solvers

H, SPAN = 3.0, 5.0
COLUMN, GIRDER = 40.0, 90.0  # EI
F = 8.0
K = GIRDER / COLUMN * H / SPAN  # Kleinlogel's k
STIFF = 1e8  # EA and GA, which the portals' formulas take as infinite
REL = 1e-5  # what they miss by that: some 12 EI / (GA H^2) = 1e-6
ROUND_OFF = 1e-10  # relative, of formulas with EA and GA


SECTIONS = {
    "columns": Section(EA=STIFF, EI=COLUMN, GA=STIFF),
    "girder": Section(EA=STIFF, EI=GIRDER, GA=STIFF),
}
BODIES = {"columns": [0, 2], "girder": [1]}
PORTAL = [(0, 0), (0, H), (SPAN, H), (SPAN, 0)], [(0, 1), (1, 2), (2, 3)]


@both_solvers
def test_a_portal_on_built_in_feet_pushed_at_its_top(solve):
    s = solve(
        *PORTAL, sections=SECTIONS, bodies=BODIES, supports={0: "xyr", 3: "xyr"},
        loads={1: (F, 0.0, 0.0)},
    )  # fmt: skip
    # Kleinlogel: feet F/2 and F H/2 (3 k + 1) / (6 k + 1), held down by 3 F H k / (L (6 k + 1))
    foot = F * H / 2 * (3 * K + 1) / (6 * K + 1)
    lift = 3 * F * H * K / (SPAN * (6 * K + 1))
    assert s.reaction(0) == pytest.approx((-F / 2, -lift, foot), rel=REL)
    assert s.reaction(3) == pytest.approx((-F / 2, lift, foot), rel=REL)
    # sway by the slope-deflection equations: F H^3 (3 k + 2) / (12 EI (6 k + 1))
    sway = F * H**3 / (12 * COLUMN) * (3 * K + 2) / (6 * K + 1)
    assert s.u[1, 0] == pytest.approx(sway, rel=REL)


@both_solvers
def test_neither_the_numbers_nor_the_directions_of_the_elements_matter(solve):
    # a bracket: up by H, then out by SPAN, loaded by P down at its end; eight elements, their nodes
    # shuffled and some of them reversed
    EA, EI, GA, P = 400.0, 30.0, 100.0, 4.0
    rng = np.random.default_rng(1)
    line = [(0, H * k / 4) for k in range(4)] + [(SPAN * k / 4, H) for k in range(5)]
    number = rng.permutation(9)
    points = np.empty((9, 2))
    points[number] = line
    pairs = np.column_stack([number[:-1], number[1:]])
    pairs = np.where(rng.random((8, 1)) < 0.5, pairs, pairs[:, ::-1])[rng.permutation(8)]
    foot, end = int(number[0]), int(number[8])
    f = solve(
        points, pairs, sections=Section(EA=EA, EI=EI, GA=GA), supports={foot: "xyr"},
        loads={end: (0.0, -P, 0.0)},
    )  # fmt: skip
    # the foot's part turns by P SPAN H / EI under its constant moment and shortens by P H / EA
    sink = P * SPAN**3 / (3 * EI) + P * SPAN / GA + P * SPAN**2 * H / EI + P * H / EA
    out = P * SPAN * H**2 / (2 * EI)
    turn = -P * SPAN**2 / (2 * EI) - P * SPAN * H / EI
    assert f.u[end] == pytest.approx((out, -sink, turn), rel=ROUND_OFF)
    assert f.strain_energy == pytest.approx(P * sink / 2, rel=ROUND_OFF)


@both_solvers
def test_a_built_in_end_that_settles_and_turns(solve):
    L, EI, s, sink, turn = 2.0, 30.0, 0.05, 0.01, 0.02  # s = EI / (GA L^2)
    f = solve(
        [(0, 0), (L / 2, 0), (L, 0)], [(0, 1), (1, 2)],
        sections=Section(EA=1e3, EI=EI, GA=EI / (s * L**2)),
        supports={0: "xyr", 2: {"x": 0.0, "y": sink, "r": turn}}, loads={},
    )  # fmt: skip
    # slope deflection: 12, 6, 4 + 12 s and 2 - 12 s over 1 + 12 s
    k = EI / (L * (1 + 12 * s))
    force = 12 * k * sink / L**2 - 6 * k * turn / L
    here = -6 * k * sink / L + (4 + 12 * s) * k * turn
    there = -6 * k * sink / L + (2 - 12 * s) * k * turn
    assert f.reaction(2) == pytest.approx((0, force, here), rel=ROUND_OFF, abs=1e-11)
    assert f.reaction(0) == pytest.approx((0, -force, there), rel=ROUND_OFF, abs=1e-11)
    # the supports' work is stored
    assert f.strain_energy == pytest.approx((force * sink + here * turn) / 2, rel=ROUND_OFF)
    assert f.potential_energy == f.strain_energy


BRACKET = np.array([(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (3, 2)], float)
PAIRS = [(k, k + 1) for k in range(5)]


@both_solvers
def test_the_supports_balance_loads_in_force_and_moment(solve):
    rng = np.random.default_rng(1)
    loads = {k: tuple(rng.normal(size=3)) for k in range(6)}
    supports = {0: "xy", 3: "y", 5: "xyr"}
    s = solve(
        BRACKET, PAIRS, sections=Section(EA=500.0, EI=10.0, GA=100.0), supports=supports,
        loads=loads,
    )  # fmt: skip
    total = np.zeros(3)
    for node in range(6):
        x, y = BRACKET[node]
        f = np.array(loads[node])
        if node in supports:
            f += s.reaction(node)
        else:  # nothing holds it
            assert s.reaction(node) == pytest.approx((0, 0, 0), abs=1e-10)
        total += f[0], f[1], f[2] + x * f[1] - y * f[0]
    np.testing.assert_allclose(total, 0, atol=1e-9)
    assert s.reaction(3)[0] == pytest.approx(0, abs=1e-10)  # only held along y
    assert s.reaction(0)[2] == pytest.approx(0, abs=1e-10)  # free to turn
