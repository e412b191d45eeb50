"""Plane frames from the textbook: portals, joints of several members, any numbering."""

from math import cos, radians, sin

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

H, SPAN = 3.0, 5.0
COLUMN, GIRDER = 40.0, 90.0  # EI
F, q = 8.0, 2.0
K = GIRDER / COLUMN * H / SPAN  # Kleinlogel's k
STIFF = 1e8  # EA and GA, which the portals' formulas take as infinite
REL = 1e-5  # what they miss by that: some 12 EI / (GA H^2) = 1e-6
ROUND_OFF = 1e-10  # relative, of formulas with EA and GA


def with_middles(points, elements, **problem):
    """`solve_curved_frame` on straight members: a middle node on every pair."""
    points, elements = np.asarray(points, float), np.asarray(elements)
    numbers = len(points) + np.arange(len(elements))
    return solve_curved_frame(
        np.vstack([points, points[elements].mean(axis=1)]), np.column_stack([elements, numbers]),
        **problem,
    )  # fmt: skip


both_solvers = pytest.mark.parametrize("solve", [solve_frame, with_middles])
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
def test_a_portal_on_pinned_feet_pushed_at_its_top(solve):
    s = solve(
        *PORTAL, sections=SECTIONS, bodies=BODIES, supports={0: "xy", 3: "xy"},
        loads={1: (F, 0.0, 0.0)},
    )  # fmt: skip
    # by symmetry half the force each, the girder's moment vanishes at its middle:
    # sway = F H^3 / (6 EI_c) + F H^2 L / (12 EI_g)
    assert s.reaction(0) == pytest.approx((-F / 2, -F * H / SPAN, 0), rel=REL, abs=1e-4)
    sway = F * H**3 / (6 * COLUMN) + F * H**2 * SPAN / (12 * GIRDER)
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
@pytest.mark.parametrize("angles", [[0, 90], [10, 130, 250], [0, 72, 150, 200, 300]], ids=str)
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
@pytest.mark.parametrize("angle", [0, 33, 90, -120], ids=lambda a: f"{a} deg")
def test_two_struts_at_right_angles_yield_along_their_axes_and_across(solve, angle):
    # built in at (-1, 0) and (1, 0), joined at (0, -1), pressed down by P: by symmetry the joint
    # only sinks, P = 2 (EA / L sin^2 + 12 EI / (L^3 (1 + phi)) cos^2) sink at 45 deg, L^2 = 2
    EA, EI, GA, P = 100.0, 3.0, 50.0, 3.0
    turn = np.array([
        [cos(radians(angle)), -sin(radians(angle))], [sin(radians(angle)), cos(radians(angle))]
    ])  # fmt: skip
    points = np.array([(-1, 0), (0, -1), (1, 0)]) @ turn.T
    f = solve(
        points, [(0, 1), (1, 2)], sections=Section(EA=EA, EI=EI, GA=GA),
        supports={0: "xyr", 2: "xyr"}, loads={1: (*(turn @ [0, -P]), 0.0)},
    )  # fmt: skip
    across = 12 * EI / (2**1.5 * (1 + 12 * EI / (GA * 2)))
    sink = P / (EA / 2**0.5 + across)
    assert tuple(f.u[1, :2] @ turn) == pytest.approx((0, -sink), rel=ROUND_OFF, abs=1e-15)
    assert f.u[1, 2] == pytest.approx(0, abs=1e-15)


@both_solvers
@pytest.mark.parametrize("seed", range(5))
def test_neither_the_numbers_nor_the_directions_of_the_elements_matter(solve, seed):
    # a bracket: up by H, then out by SPAN, loaded by P down at its end; eight elements, their nodes
    # shuffled and some of them reversed
    EA, EI, GA, P = 400.0, 30.0, 100.0, 4.0
    rng = np.random.default_rng(seed)
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
def test_a_closed_square_pulled_at_two_opposite_corners(solve):
    # by its two symmetries no corner turns and every side takes P / sqrt 8 along and across:
    # the pulled diagonal grows by P/2 (a^3 / 12 EI + a / GA + a / EA), the other one shrinks by
    # P/2 (a^3 / 12 EI + a / GA - a / EA)
    a, EA, EI, GA, P = 1.5, 200.0, 10.0, 60.0, 7.0
    f = solve(
        [(0, 0), (a, 0), (a, a), (0, a)], [(0, 1), (1, 2), (2, 3), (3, 0)],
        sections=Section(EA=EA, EI=EI, GA=GA), supports={0: "xyr"},
        loads={2: (P / 2**0.5, P / 2**0.5, 0.0)},
    )  # fmt: skip
    bend, stretch = a**3 / (12 * EI) + a / GA, a / EA
    assert (f.u[2, 0] + f.u[2, 1]) / 2**0.5 == pytest.approx(P / 2 * (bend + stretch), rel=1e-10)
    across = ((f.u[1, 0] - f.u[1, 1]) - (f.u[3, 0] - f.u[3, 1])) / 2**0.5
    assert across == pytest.approx(-P / 2 * (bend - stretch), rel=1e-10)
    np.testing.assert_allclose(f.u[:4, 2], 0, atol=1e-13)
