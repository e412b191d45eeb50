"""Practically inextensible members: section forces and energies stay those of statics.

Their strains lie EA / EI times below the displacements whose differences they are.
"""

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


@both_kinds
@stiffnesses
def test_an_inclined_cantilever_carries_its_load_however_stiff(kind, ratio):
    s, exact, energy = cantilever(kind, 8, ratio)
    np.testing.assert_allclose(s.section_forces, exact, atol=ROUND_OFF * F)
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)
    assert s.reaction(0) == pytest.approx((-F, -0.3 * F, (0.6 - 0.8 * 0.3) * F), abs=ROUND_OFF * F)


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
