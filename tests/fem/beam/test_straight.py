"""Straight members by both linear solvers: cantilevers by their integrals, textbook frames.

Straight elements are the solution of the beam's equations; quadratic ones with two Gauss points
have exact ends under end loads.
"""

from math import cos, radians, sin

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

L, EA, EI, GA = 3.0, 5000.0, 70.0, 900.0  # any
ROUND_OFF = 1e-10  # relative; 1e-16 times a condition number of about (elements)^4 = 1e4


def with_middles(points, elements, **problem):
    """`solve_curved_frame` on straight members: a middle node on every pair."""
    points, elements = np.asarray(points, float), np.asarray(elements)
    numbers = len(points) + np.arange(len(elements))
    return solve_curved_frame(
        np.vstack([points, points[elements].mean(axis=1)]), np.column_stack([elements, numbers]),
        **problem,
    )  # fmt: skip


both_solvers = pytest.mark.parametrize("solve", [solve_frame, with_middles])


def bar(count, angle):
    """Nodes 0 (clamped) to `count`, evenly along `angle` [deg]."""
    along = np.array([cos(radians(angle)), sin(radians(angle))])
    pairs = np.column_stack([np.arange(count), np.arange(1, count + 1)])
    return np.linspace(0, L, count + 1)[:, None] * along + [0.4, -0.7], pairs


def to_plane(along, across, angle):
    c, s = cos(radians(angle)), sin(radians(angle))
    return along * c - across * s, along * s + across * c


@both_solvers
@pytest.mark.parametrize(("angle", "count"), [(50, 1), (-110, 7)])
def test_an_end_force_and_couple_bend_shear_and_stretch(solve, angle, count):
    N, V, C = 40.0, 6.0, -5.0
    points, pairs = bar(count, angle)
    s = solve(
        points, pairs, sections=Section(EA=EA, EI=EI, GA=GA), supports={0: "xyr"},
        loads={count: (*to_plane(N, V, angle), C)},
    )  # fmt: skip
    stretch = N * L / EA
    sink = V * L**3 / (3 * EI) + V * L / GA + C * L**2 / (2 * EI)
    turn = V * L**2 / (2 * EI) + C * L / EI
    assert s.u[count] == pytest.approx((*to_plane(stretch, sink, angle), turn), rel=ROUND_OFF)
    energy = (N * stretch + V * sink + C * turn) / 2  # Clapeyron
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)
    expected = (*to_plane(-N, -V, angle), -C - V * L)
    assert s.reaction(0) == pytest.approx(expected, rel=ROUND_OFF)


@pytest.mark.parametrize(
    ("angle", "count", "shear"), [(-110, 7, GA), (50, 2, np.inf)], ids=["Timoshenko", "Bernoulli"]
)
def test_an_even_load_along_and_across_moves_every_node_as_its_integrals_say(angle, count, shear):
    n, q = 7.0, 3.0
    points, pairs = bar(count, angle)
    s = solve_frame(
        points, pairs, sections=Section(EA=EA, EI=EI, GA=shear), supports={0: "xyr"}, loads={},
        distributed=dict.fromkeys(range(count), to_plane(n, q, angle)),
    )  # fmt: skip
    for node, x in enumerate(np.linspace(0, L, count + 1)):
        stretch = n * (L * x - x**2 / 2) / EA
        bend = q * x**2 * (6 * L**2 - 4 * L * x + x**2) / (24 * EI)
        sink = bend + q * (L * x - x**2 / 2) / shear
        turn = q * x * (3 * L**2 - 3 * L * x + x**2) / (6 * EI)
        expected = (*to_plane(stretch, sink, angle), turn)
        assert s.u[node] == pytest.approx(expected, rel=ROUND_OFF, abs=1e-14)
    expected = (*to_plane(-n * L, -q * L, angle), -q * L**2 / 2)
    assert s.reaction(0) == pytest.approx(expected, rel=ROUND_OFF)
    # int N^2 / 2 EA with N = n (L - x), V alike, M = q (L - x)^2 / 2
    energy = n**2 * L**3 / (6 * EA) + q**2 * L**3 / (6 * shear) + q**2 * L**5 / (40 * EI)
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)  # Clapeyron


H, SPAN = 3.0, 5.0
REL = 1e-5  # what EA = GA = 1e8 leave of the portal's formulas: some 12 EI / (GA H^2) = 1e-6


@both_solvers
def test_a_portal_on_built_in_feet_pushed_at_its_top(solve):
    column, girder, F = 40.0, 90.0, 8.0
    K = girder / column * H / SPAN  # Kleinlogel's k
    s = solve(
        [(0, 0), (0, H), (SPAN, H), (SPAN, 0)], [(0, 1), (1, 2), (2, 3)],
        sections={"columns": Section(EA=1e8, EI=column, GA=1e8),
                  "girder": Section(EA=1e8, EI=girder, GA=1e8)},
        bodies={"columns": [0, 2], "girder": [1]}, supports={0: "xyr", 3: "xyr"},
        loads={1: (F, 0.0, 0.0)},
    )  # fmt: skip
    # Kleinlogel: feet F/2 and F H/2 (3 k + 1) / (6 k + 1), held down by 3 F H k / (L (6 k + 1))
    foot = F * H / 2 * (3 * K + 1) / (6 * K + 1)
    lift = 3 * F * H * K / (SPAN * (6 * K + 1))
    assert s.reaction(0) == pytest.approx((-F / 2, -lift, foot), rel=REL)
    assert s.reaction(3) == pytest.approx((-F / 2, lift, foot), rel=REL)
    # sway by the slope-deflection equations: F H^3 (3 k + 2) / (12 EI (6 k + 1))
    sway = F * H**3 / (12 * column) * (3 * K + 2) / (6 * K + 1)
    assert s.u[1, 0] == pytest.approx(sway, rel=REL)


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


@both_solvers
def test_the_supports_balance_loads_in_force_and_moment(solve):
    points = np.array([(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (3, 2)], float)
    rng = np.random.default_rng(1)
    loads = {k: tuple(rng.normal(size=3)) for k in range(6)}
    supports = {0: "xy", 3: "y", 5: "xyr"}
    s = solve(
        points, [(k, k + 1) for k in range(5)], supports=supports, loads=loads,
        sections=Section(EA=500.0, EI=10.0, GA=100.0),
    )  # fmt: skip
    total = np.zeros(3)
    for node in range(6):
        x, y = points[node]
        f = np.array(loads[node])
        if node in supports:
            f += s.reaction(node)
        else:  # nothing holds it
            assert s.reaction(node) == pytest.approx((0, 0, 0), abs=1e-10)
        total += f[0], f[1], f[2] + x * f[1] - y * f[0]
    np.testing.assert_allclose(total, 0, atol=1e-9)
    assert s.reaction(3)[0] == pytest.approx(0, abs=1e-10)  # only held along y
    assert s.reaction(0)[2] == pytest.approx(0, abs=1e-10)  # free to turn
