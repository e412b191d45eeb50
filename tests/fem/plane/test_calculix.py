"""The benchmark's decks pose the same problem to calculix as to the project's solver."""

import numpy as np
import pytest

from benchmarks.ring import STEEL, ring_mesh
from fem.plane.solve import solve_plane
from verify.studies.crosscheck.calculix.plane import PlaneDeck
from verify.studies.crosscheck.calculix.running import executable, run_deck

# Of the largest displacement: calculix prints six digits, and integrates curved triangles with
# three points each, whose difference falls with the fourth power of the cells.
AGREE = 5e-5
installed = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")


def both(mesh, assumption, folder):
    """The ring's displacements (nodes, 2) here and in calculix."""
    ring = solve_plane(
        mesh, materials=STEEL, assumption=assumption, supports={"x=0": "x", "y=0": "y"},
        pressures={"bore": 100e6}, thickness=0.3,
    )  # fmt: skip
    deck_of_ring = PlaneDeck(solution=ring, materials=STEEL, assumption=assumption)
    deck = deck_of_ring.write(folder / "ring.inp")
    return ring.u[deck_of_ring.numbering.dofs].T, run_deck(deck).u


@installed
def test_six_node_triangles_move_as_in_calculix(tmp_path):
    ours, theirs = both(ring_mesh("triangles", 8), "plane stress", tmp_path)
    np.testing.assert_allclose(theirs, ours, atol=AGREE * np.abs(ours).max())


@installed
def test_nine_node_quadrilaterals_move_nearly_as_eight_node_ones_in_calculix(tmp_path):
    ours, theirs = both(ring_mesh("quadrilaterals", 16), "plane strain", tmp_path)
    np.testing.assert_allclose(theirs, ours, atol=1e-4 * np.abs(ours).max())


@installed
def test_what_calculix_says_of_a_broken_deck_is_passed_on(tmp_path):
    (tmp_path / "broken.inp").write_text("*NODE\n1,0,0,0\n*STEP\n*NONSENSE\n*END STEP\n")
    with pytest.raises(RuntimeError, match=r"calculix failed on broken\.inp"):
        run_deck(tmp_path / "broken.inp")
