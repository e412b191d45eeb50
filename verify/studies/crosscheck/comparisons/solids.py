"""A loop of the accordion spring with solid and shell elements, compared with calculix."""

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from verify.cases.spring.width.case import WIDTH
from verify.cases.spring.width.reference import fem_loop, fem_mesh, fem_pulled, fem_steel
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.statement import CALCULIX, Cross, Posed, Quantity

LEVEL, ACROSS = 3, 6  # of the shell's mesh, and cells over half the width
# Calculix loses digits where bricks are much wider than thick: 14 % of the stiffness at h/b = 560.
WIDE = 20.0  # times the thickness, as in a row of the case
ARC, LEAF = 12, 40  # cells of solids along an arc and half a leaf
MOVED = 1e-3  # m, of the loop's head
GRADED = 30.0  # cells over the width: the first over the last
K = "stiffness of the loop with h/b = 20"
ROW = "stiffness of a loop by shell and by solid elements, h/b = 20"
BRICKS = "same mesh; elements of the project have 27 nodes, those of calculix have 20 nodes"


def loop(held: bool) -> Posed:
    """The loop with 27-node solid elements; the edge is free or, with `held`, in plane strain."""
    from fem.solid.solve import solve_solid
    from meshes.solid.strip import solid_strip
    from verify.studies.crosscheck.calculix.reading import strain_energy
    from verify.studies.crosscheck.calculix.solids import SolidDeck

    q = narrow()
    path, steel = fem_loop(q), fem_steel(q)
    x, y = path[-1].end
    mesh = solid_strip(
        path, b=q.b, width=q.h / 2, through=1, per_arc=ARC, per_leaf=LEAF,
        across=1 if held else ACROSS, grading=GRADED,
    )  # fmt: skip
    supports: dict[Any, Any] = {
        "middle": "z", "head": "y", "tail": "y", (x, y, None): "x" if held else "xz",
        (0.0, 0.0, None): {"x": MOVED}, **({"edge": "z"} if held else {}),
    }  # fmt: skip
    solved, seconds = timed(
        lambda: solve_solid(mesh, materials=steel, points=(2, 3, 3), supports=supports)
    )
    deck = SolidDeck(solution=solved, material=steel)
    return Posed(
        ours={K: stiffness(solved.strain_energy)}, seconds=seconds, unknowns=deck.unknowns,
        write=lambda folder: deck.write(folder / "deck.inp"),
        read=lambda path: {K: stiffness(strain_energy(path.with_suffix(".dat")))},
    )  # fmt: skip


def narrow() -> Any:
    """Inputs of the case with a narrow strip."""
    q: Any = WIDTH.inputs()
    return q.model_copy(update={"h": WIDE * q.b})


def stiffness(energy: float) -> float:
    """Stiffness of the complete width, from the strain energy of half the width."""
    return 2 * 2 * energy / MOVED**2


def shell() -> Posed:
    """The loop with shell elements, compared with solid elements of the same size."""
    from verify.studies.crosscheck.calculix.reading import strain_energy
    from verify.studies.crosscheck.calculix.swept import SweptDeck

    q = narrow()
    path, steel = list(fem_loop(q)), fem_steel(q)
    mesh = fem_mesh(path, q.b, q.h, LEVEL, across=ACROSS)
    solved, seconds = timed(lambda: fem_pulled(mesh, q.b, q.h, steel, "yabc"))
    levels = np.unique(mesh.points[np.unique(mesh.boundaries["tail"]), 2].round(12))
    deck = SweptDeck(pieces=path, counts=[ARC if piece.turn else LEAF for piece in path],
                     b=q.b, levels=levels, material=steel, move=MOVED)  # fmt: skip

    def read(at: Path) -> dict[str, float]:
        return {K: stiffness(strain_energy(at.with_suffix(".dat")))}

    return Posed(
        ours={K: -1 / solved.potential_energy}, seconds=seconds, unknowns=deck.unknowns,
        write=lambda folder: deck.write(folder / "deck.inp"), read=read,
    )  # fmt: skip


SOLIDS = (
    *(
        Cross(
            id=f"spring-width, loop, {words}", case="spring-width", solver=CALCULIX,
            what=f"half the width of a loop of the spring by solid elements, side edge {words} in "
            "the direction of the width",
            pose=partial(loop, held),
            quantities=(
                Quantity(name=K, symbol="k", unit="N/mm", allowed=5e-3, why=BRICKS,
                         beside=True, row=ROW),
            ),
        )
        for held, words in ((True, "held"), (False, "free"))
    ),
    Cross(
        id="spring-width, shell", case="spring-width", solver=CALCULIX,
        what="half the width of a loop of the spring: shells in the project, solids in calculix",
        pose=shell,
        quantities=(
            Quantity(name=K, symbol="k", unit="N/mm", allowed=5e-3,
                     why="for arcs of thickness b and radius R, the stiffnesses by shell and solid "
                     "elements differ by a fraction of about (b/R)²",
                     beside=True, row=ROW),
        ),
    ),
)  # fmt: skip
