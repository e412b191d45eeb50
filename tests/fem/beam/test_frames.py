"""Plane frames from the textbook: portals, joints of several members, any numbering."""

from math import cos, radians, sin

import numpy as np
import pytest

from fem.beam.section import Section
from fem.beam.straight import solve_frame
from tests.fem.beam.models import both_solvers

H, SPAN = 3.0, 5.0
COLUMN, GIRDER = 40.0, 90.0  # EI
F, q = 8.0, 2.0
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


@pytest.mark.parametrize(
    ("feet", "thrust", "couple"),
    [
        # Kleinlogel: q L^2 / (4 H (2 k + 3)) pinned, q L^2 / (4 H (k + 2)) built in
        pytest.param("xy", q * SPAN**2 / (4 * H * (2 * K + 3)), 0.0, id="pinned feet"),
        pytest.param(
            "xyr", q * SPAN**2 / (4 * H * (K + 2)), q * SPAN**2 / (12 * (K + 2)), id="built in"
        ),
    ],
)
def test_a_portal_under_an_even_load_on_its_girder(feet, thrust, couple):
    s = solve_frame(
        *PORTAL, sections=SECTIONS, bodies=BODIES, supports={0: feet, 3: feet}, loads={},
        distributed={1: (0.0, -q)},
    )  # fmt: skip
    # thrust inwards on both feet; the foot's moment bends it the same way as the corner's
    assert s.reaction(0) == pytest.approx((thrust, q * SPAN / 2, -couple), rel=REL, abs=1e-4)
    assert s.reaction(3) == pytest.approx((-thrust, q * SPAN / 2, couple), rel=REL, abs=1e-4)


@both_solvers
@pytest.mark.parametrize("angles", [[10, 130, 250]], ids=str)
def test_a_joint_shares_its_couple_by_the_stiffness_of_its_members(solve, angles):
    # members of length 1 and 2 in turn, built in at their far ends, the joint held but for turning
    lengths = [1.0 + k % 2 for k in range(len(angles))]
    ends = [
        (a * cos(radians(d)), a * sin(radians(d))) for a, d in zip(lengths, angles, strict=True)
    ]
    C, EI, GA = 6.0, 20.0, 300.0
    f = solve(
        [(0, 0), *ends], [(0, k + 1) for k in range(len(angles))],
        sections=Section(EA=1e3, EI=EI, GA=GA), loads={0: (0.0, 0.0, C)},
        supports={0: "xy"} | {k + 1: "xyr" for k in range(len(angles))},
    )  # fmt: skip
    # (4 + phi) and (2 - phi) EI / (L (1 + phi)) at the near and the far end, phi = 12 EI / (GA L^2)
    phi = [12 * EI / (GA * a**2) for a in lengths]
    near = [(4 + p) * EI / (a * (1 + p)) for a, p in zip(lengths, phi, strict=True)]
    far = [(2 - p) * EI / (a * (1 + p)) for a, p in zip(lengths, phi, strict=True)]
    turn = C / sum(near)
    assert f.u[0, 2] == pytest.approx(turn, rel=ROUND_OFF)
    for k, stiffness in enumerate(far):
        assert f.reaction(k + 1)[2] == pytest.approx(stiffness * turn, rel=ROUND_OFF)


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
def test_a_bracket_sinks_alike_at_every_size_and_place(solve):
    # a square section of steel, a twentieth of the size thick; far away in units of its size
    size, away = 1e-6, (1e6, 0)
    E, d = 210e9, size / 20
    EA, EI, GA, P = E * d**2, E * d**4 / 12, 5 / 6 * E / 2.6 * d**2, 1e-6 * E * d**2
    s = solve(
        size * (BRACKET + away), PAIRS, sections=Section(EA=EA, EI=EI, GA=GA),
        supports={0: "xyr"}, loads={5: (0.0, -P, 0.0)},
    )  # fmt: skip
    # up by 2 sizes, out by 3: bending of both parts, shear and shortening; 6 of 16 digits are lost
    # to the distance, 3 to EA size^2 / EI = 5e3
    up, out = 2 * size, 3 * size
    sink = P * (out**3 / (3 * EI) + out**2 * up / EI + out / GA + up / EA)
    assert s.u[5, 1] == pytest.approx(-sink, rel=1e-7)
    assert s.strain_energy == pytest.approx(P * sink / 2, rel=1e-7)


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
