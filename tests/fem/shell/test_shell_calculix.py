"""A strip of leaf, arc and leaf moves as in calculix, whose shells are solids of one layer."""

from math import pi

import numpy as np
import pytest

from benchmarks.calculix import executable, nodal, run_deck
from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.strip import swept_path
from meshes.spring.path import Piece

STEEL = Elastic(E=206e3, nu=0.3)
R, LEAF, WIDTH, T = 5.0, 8.0, 6.0, 0.1
HOOK = [
    Piece("leaf", 0.0, 0.0, 0.0, LEAF, 0.0, 1),
    Piece("arc", LEAF, 0.0, 0.0, R * pi / 2, pi / 2, 1),
    Piece("leaf", LEAF + R, R, pi / 2, LEAF, 0.0, 1),
]
AGREE = 1e-3  # of the largest movement; (T / R)^2 is 4e-4


def write_deck(path, mesh, s):
    """The strip as eight-node shells with reduced integration: its nodes but the cells' centres."""
    used = np.unique(mesh.cells[:, :8])
    tail = np.unique(mesh.boundaries["tail"]) + 1
    with path.open("w", encoding="ascii") as deck:
        deck.write("*NODE, NSET=ALL\n")
        np.savetxt(deck, np.column_stack([used + 1, mesh.points[used]]), fmt="%d,%.12e,%.12e,%.12e")
        deck.write("*ELEMENT, TYPE=S8R, ELSET=SHELL\n")
        numbered = np.column_stack([np.arange(1, len(mesh.cells) + 1), mesh.cells[:, :8] + 1])
        np.savetxt(deck, numbered, fmt="%d", delimiter=",")
        deck.write(f"*MATERIAL, NAME=M\n*ELASTIC\n{STEEL.E!r},{STEEL.nu!r}\n")
        deck.write(f"*SHELL SECTION, ELSET=SHELL, MATERIAL=M\n{T!r}\n*BOUNDARY\n")
        deck.writelines(f"{node},1,6\n" for node in tail)
        deck.write("*STEP\n*STATIC\n*CLOAD\n")
        for node, component in zip(*np.nonzero(s.f[:, :3]), strict=True):
            deck.write(f"{node + 1},{component + 1},{s.f[node, component]:.12e}\n")
        deck.write("*NODE FILE, OUTPUT=2D\nU\n*END STEP\n")
    return used


def head_moves(load, refined, folder):
    """Of the head's middle, here and in calculix."""
    mesh = swept_path(
        HOOK, width=WIDTH, per_arc=8 * refined, per_leaf=6 * refined, across=4 * refined
    )
    s = solve_shell(
        mesh.points, mesh.cells, thickness=T, materials=STEEL, boundaries=mesh.boundaries,
        supports={"tail": "xyzabc"}, edge_loads={"head": load},
    )  # fmt: skip
    used = write_deck(folder / "hook.inp", mesh, s)
    run_deck(folder / "hook.inp")
    theirs = nodal(folder / "hook.frd", "DISP")[:, :3]
    node = mesh.nodes["head"]
    return s.u[node], theirs[np.searchsorted(used, node)]


@pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")
@pytest.mark.parametrize("load", [(1e-2, 0, 0), (0, 1e-2, 0)])
def test_a_hook_moves_as_in_calculix(load, tmp_path):
    coarse, fine = (head_moves(load, refined, tmp_path) for refined in (1, 2))
    # their clamp, of rigid knots, stiffens a share of its first cells: order one
    np.testing.assert_allclose(2 * fine[1] - coarse[1], fine[0], atol=AGREE * np.abs(fine[0]).max())
