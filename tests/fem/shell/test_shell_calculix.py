"""A strip of leaf, arc and leaf moves as in calculix, whose shells are solids of one layer."""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.strip import swept_path
from meshes.spring.path import Piece
from verify.studies.crosscheck.calculix.running import executable, run_deck
from verify.studies.crosscheck.calculix.shells import ShellDeck

STEEL = Elastic(E=206e3, nu=0.3)
R, LEAF, WIDTH, T = 5.0, 8.0, 6.0, 0.1
HOOK = [
    Piece("leaf", 0.0, 0.0, 0.0, LEAF, 0.0, 1),
    Piece("arc", LEAF, 0.0, 0.0, R * pi / 2, pi / 2, 1),
    Piece("leaf", LEAF + R, R, pi / 2, LEAF, 0.0, 1),
]
AGREE = 1e-3  # of the largest movement; (T / R)^2 is 4e-4


def head_moves(load, refined, folder):
    """Of the head's middle, here and in calculix."""
    mesh = swept_path(
        HOOK, width=WIDTH, per_arc=8 * refined, per_leaf=6 * refined, across=4 * refined
    )
    s = solve_shell(
        mesh.points, mesh.cells, thickness=T, materials=STEEL, boundaries=mesh.boundaries,
        supports={"tail": "xyzabc"}, edge_loads={"head": load},
    )  # fmt: skip
    shells = ShellDeck(solution=s, material=STEEL, thickness=T, clamped=["tail"])
    deck, node = shells.write(folder / "hook.inp"), mesh.nodes["head"]
    run_deck(deck)
    return s.u[node], shells.moved(deck, node)


@pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")
def test_a_hook_moves_as_in_calculix(tmp_path):
    load = (1e-2, 0, 0)
    coarse, fine = (head_moves(load, refined, tmp_path) for refined in (1, 2))
    # their clamp, of rigid knots, stiffens a share of its first cells: order one
    np.testing.assert_allclose(2 * fine[1] - coarse[1], fine[0], atol=AGREE * np.abs(fine[0]).max())
