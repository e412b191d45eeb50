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


def cantilever(kind, count, ratio):
    """Inclined, EA = GA = ratio EI; the solution, exact section forces and exact energy."""
    along, across, load = np.array([0.8, 0.6]), np.array([-0.6, 0.8]), F * np.array([1.0, 0.3])
    nodes = np.linspace(0, 1, 2 * count + 1)[:, None] * along
    problem = {
        "sections": Section(EA=ratio * EI, GA=ratio * EI, EI=EI), "supports": {0: "xyr"},
        "loads": {2 * count: (*load, 0.0)},
    }  # fmt: skip
    k = np.arange(2 * count)
    if kind == "straight":
        s = solve_frame(nodes, np.column_stack([k, k + 1]), **problem)
    else:
        s = solve_curved_frame(nodes, np.column_stack([k, k + 2, k + 1])[::2], **problem)
    N, V = load @ along, load @ across
    exact = np.stack(np.broadcast_arrays(N, V, V * (1 - s.stations @ along)), axis=-1)
    return s, exact, V**2 / (6 * EI) + (N**2 + V**2) / (2 * ratio * EI)


@both_kinds
@pytest.mark.parametrize("ratio", [1e6, 1e12])
def test_an_inclined_cantilever_carries_its_load_however_stiff(kind, ratio):
    s, exact, energy = cantilever(kind, 8, ratio)
    np.testing.assert_allclose(s.section_forces, exact, atol=ROUND_OFF * F)
    assert s.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert s.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)
    assert s.reaction(0) == pytest.approx((-F, -0.3 * F, (0.6 - 0.8 * 0.3) * F), abs=ROUND_OFF * F)


@both_kinds
def test_what_is_too_stiff_to_be_resolved_is_refused(kind):
    with pytest.raises((ArithmeticError, ValueError)):
        cantilever(kind, 4, 1e17)
