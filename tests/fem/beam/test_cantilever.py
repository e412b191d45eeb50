"""Cantilevers against the integrals of M / EI, V / GA and N / EA, which both solvers meet exactly.

Straight elements are the solution of the beam's equations; quadratic ones with two Gauss points
have exact ends under end loads.
"""

from math import cos, radians, sin

import numpy as np
import pytest

from fem.beam.section import Section
from fem.beam.straight import solve_frame
from tests.fem.beam.models import both_solvers

L, EA, EI, GA = 3.0, 5000.0, 70.0, 900.0  # any
ROUND_OFF = 1e-10  # relative; 1e-16 times a condition number of about (elements)^4 = 1e4


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
