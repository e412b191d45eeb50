"""The width stiffens the shell of a spring's strip as it does calculix's solids.

These are second-order bricks of reduced integration, one layer of them: what calculix makes of
its shells S8R, but without the rigid knots that it puts where rotations are held.
"""

from math import radians

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.strip import swept_path
from meshes.spring.path import accordion
from verify.studies.crosscheck.calculix.reading import strain_energy
from verify.studies.crosscheck.calculix.running import executable, run_deck
from verify.studies.crosscheck.calculix.swept import SweptDeck

STEEL = Elastic(E=206e3, nu=0.3)  # MPa, mm
B, PER_ARC, PER_LEAF = 0.1, 6, 12
SPRING = {"n": 4, "L1": 11.6, "radius": 0.5, "alpha": radians(80), "tail": "arc"}
UNIT = 1.0  # movement of the head


def shell_stiffness(mesh, h, edge):
    """Of the guided head's line along x, over the whole width."""
    s = solve_shell(
        mesh.points, mesh.cells, thickness=B, materials=STEEL, boundaries=mesh.boundaries,
        ties={"head": "x"}, edge_loads={"head": (2 / h, 0, 0)},
        supports={"tail": "xyzabc", "middle": "zab", "head": "yabc", "edge": edge},
    )  # fmt: skip
    return -1 / s.potential_energy


def solid_stiffness(path, levels, edge, deck):
    """The same by bricks between the planes z = `levels`, whose odd ones hold middle nodes."""
    swept = SweptDeck(
        pieces=path, counts=[PER_ARC if piece.turn else PER_LEAF for piece in path], b=B,
        levels=levels, material=STEEL, move=UNIT, held=bool(edge),
    )  # fmt: skip
    run_deck(swept.write(deck))
    return 4 * strain_energy(deck.with_suffix(".dat")) / UNIT**2


def both(h, across, finest, edge, folder):
    """Stiffness per width of the shell and of calculix's solids, on cells of the same sizes."""
    path = list(accordion(**SPRING))
    mesh = swept_path(path, width=h / 2, per_arc=PER_ARC, per_leaf=PER_LEAF, across=across,
                      finest=finest, leaf_ends=0.1)  # fmt: skip
    levels = np.unique(mesh.points[np.unique(mesh.boundaries["tail"]), 2].round(9))
    solids = solid_stiffness(path, levels, edge, folder / "strip.inp")
    return shell_stiffness(mesh, h, edge) / h, solids / h


@pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")
@pytest.mark.parametrize(("h", "finest"), [(5.6, 0.15)])
def test_the_strip_s_width_factor_is_that_of_calculix(h, finest, tmp_path):
    # with held edges both are in plane strain, where only (b/R)^2 tells solids from shells
    held = both(2.0, 1, None, "zab", tmp_path)
    assert held[1] == pytest.approx(held[0], rel=2e-3)
    free = both(h, 10, finest, "", tmp_path)
    assert free[0] < (1 - 2e-3) * held[0]
    assert free[1] / held[1] == pytest.approx(free[0] / held[0], rel=5e-4)
