"""Practically inextensible members: section forces and energies stay those of statics.

Their strains lie EA / EI times below the displacements whose differences they are.
"""

from math import pi

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

EI, F = 1.0, 1.0  # on lengths of 1
ROUND_OFF = 1e-11  # of F; the worst seen is 1e-13
both_kinds = pytest.mark.parametrize("kind", ["straight", "curved"])
stiffnesses = pytest.mark.parametrize("ratio", [1e6, 1e12], ids=lambda r: f"{r:g}")


def solve(kind, nodes, ratio, *, closed=False, **problem):
    """The line through `nodes`, every second a middle node of curves; EA = GA = ratio EI."""
    n = len(nodes)
    section = Section(EA=ratio * EI, GA=ratio * EI, EI=EI)
    if kind == "straight":
        k = np.arange(n if closed else n - 1)
        pairs = np.column_stack([k, (k + 1) % n])
        return solve_frame(nodes, pairs, sections=section, **problem)
    k = np.arange(0, n if closed else n - 1, 2)
    triples = np.column_stack([k, (k + 2) % n, k + 1])
    return solve_curved_frame(nodes, triples, sections=section, **problem)


def cantilever(kind, count, ratio):
    """Inclined; the solution, exact section forces and exact energy."""
    along, across, load = np.array([0.8, 0.6]), np.array([-0.6, 0.8]), F * np.array([1.0, 0.3])
    nodes = np.linspace(0, 1, 2 * count + 1)[:, None] * along
    s = solve(kind, nodes, ratio, supports={0: "xyr"}, loads={2 * count: (*load, 0.0)})
    N, V = load @ along, load @ across
    exact = np.stack(np.broadcast_arrays(N, V, V * (1 - s.stations @ along)), axis=-1)
    return s, exact, V**2 / (6 * EI) + (N**2 + V**2) / (2 * ratio * EI)


def ring(kind, count, ratio):
    """Radius 1, `count` elements a quarter, foot held and head pulled by F."""
    phi = np.linspace(0, 2 * pi, 8 * count + 1)[:-1]
    nodes = np.column_stack([np.cos(phi), np.sin(phi)])
    head, foot = 2 * count, 6 * count
    s = solve(kind, nodes, ratio, closed=True, supports={foot: "xyr"}, loads={head: (0.0, F, 0.0)})
    return s, s.u[head, 1]


def tangents(kind, s):
    """Of the counter-clockwise ring's chords, or of its parabolas at their Gauss points."""
    n, first, X = len(s.points), np.arange(len(s.stations)), (1 + np.array([-1, 1]) / 3**0.5) / 2
    if kind == "straight":
        t = (s.points[(first + 1) % n] - s.points)[:, None]
    else:
        a, middle, b = (s.points[(2 * first + k) % n][:, None] for k in range(3))
        X = X[:, None]
        t = (4 * X - 3) * a + (4 - 8 * X) * middle + (4 * X - 1) * b
    return t / np.linalg.norm(t, axis=-1, keepdims=True)


@both_kinds
@stiffnesses
def test_an_inclined_cantilever_carries_its_load_however_stiff(kind, ratio):
    s, exact, energy = cantilever(kind, 8, ratio)
    np.testing.assert_allclose(s.section_forces, exact, atol=ROUND_OFF * F)
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)
    assert s.reaction(0) == pytest.approx((-F, -0.3 * F, (0.6 - 0.8 * 0.3) * F), abs=ROUND_OFF * F)


@both_kinds
@stiffnesses
def test_each_half_of_a_ring_carries_half_the_pull_however_stiff(kind, ratio):
    count = 8
    s, growth = ring(kind, count, ratio)
    N, V, M = np.moveaxis(s.section_forces, -1, 0)
    np.testing.assert_allclose(np.hypot(N, V), F / 2, atol=ROUND_OFF * F)
    along = np.broadcast_to(abs(tangents(kind, s)[..., 1]), N.shape)
    np.testing.assert_allclose(N, F / 2 * along, atol=ROUND_OFF * F)
    # M = M_0 - F/2 |x|, and the ring closes: M_0 is F/2 times the mean |x| of its centre line
    under = M + F / 2 * abs(s.stations[..., 0])
    half = pi / 8 / count  # of a chord's angle
    closed, rel = {"straight": (half / np.tan(half), ROUND_OFF), "curved": (1.0, 1e-6)}[kind]
    assert under.mean() == pytest.approx(closed * F / pi, rel=rel)
    np.testing.assert_allclose(under, under.mean(), atol=ROUND_OFF * F)
    # Castigliano; chords err at second order, curves at fourth
    exact = F * ((pi / 4 - 2 / pi) / EI + pi / 2 / (ratio * EI))
    assert growth == pytest.approx(exact, rel={"straight": 2.1e-3, "curved": 4e-5}[kind])
    assert s.strain_energy == pytest.approx(F * growth / 2, rel=ROUND_OFF)


@both_kinds
@pytest.mark.parametrize(("count", "ratio"), [(1, 1e13), (16, 1e13), (4, 1e17)])
def test_what_is_too_stiff_to_be_resolved_is_refused_and_never_wrong(kind, count, ratio):
    try:
        s, exact, energy = cantilever(kind, count, ratio)
    except (ArithmeticError, ValueError):
        if ratio > 1e13:
            return
        raise
    np.testing.assert_allclose(s.section_forces, exact, atol=1e-6 * F)
    assert s.strain_energy == pytest.approx(energy, rel=1e-6)
