"""Strips extended over their width, as decks of bricks with one layer through the thickness."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from fem.plane.material import Elastic
from meshes.spring.path import Piece
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Term
from verify.studies.crosscheck.calculix.strips import Strip, strip


@dataclass(frozen=True, kw_only=True)
class SweptDeck:
    """A strip of thickness `b` between planes z = `levels`, as a calculix deck.

    Levels with an odd index contain the middle nodes. The strip is symmetric about the first plane
    and, if the edge is `held`, about the last plane. The tail is clamped. The line of the head is
    displaced along x by `move` without rotation. calculix converts its shells S8R to the same
    twenty-node bricks with reduced integration, but with rigid knots at supported rotations.
    """

    pieces: Sequence[Piece]
    counts: Sequence[int]
    b: float
    levels: Array
    material: Elastic
    move: float
    held: bool = False

    @cached_property
    def part(self) -> Strip:
        return strip(self.pieces, self.counts, self.b)

    @cached_property
    def points(self) -> Array:
        """Positions (nodes, 3) of the nodes of all layers; some nodes belong to no brick."""
        n = len(self.part.points)
        return np.vstack([
            np.column_stack([self.part.points, np.full(n, z)]) for z in self.levels
        ])  # fmt: skip

    @cached_property
    def bricks(self) -> Indices:
        """Nodes of the bricks, (bricks, 20), counted from 0."""
        n, last = len(self.part.points), len(self.levels) - 1
        return np.vstack([_bricks(self.part.cells + k * n, n) for k in range(0, last, 2)])

    @property
    def unknowns(self) -> int:
        return 3 * int(np.unique(self.bricks).size)

    def write(self, path: Path) -> Path:
        used = np.unique(self.bricks)
        with path.open("w", encoding="ascii") as deck:
            keywords.nodes(deck, used + 1, self.points[used])
            number = np.arange(1, len(self.bricks) + 1)
            keywords.elements(deck, "C3D20R", "BODY", self.bricks + 1, number)
            keywords.solid(deck, "BODY", self.material)
            deck.write("*STEP\n*STATIC\n")
            keywords.boundary(deck, self._held(used))
            deck.write("*EL PRINT, ELSET=BODY, TOTALS=ONLY\nELSE\n*NODE FILE\nU\n*END STEP\n")
        return path

    def _held(self, used: Indices) -> list[Term]:
        n, last = len(self.part.points), len(self.levels) - 1
        layers = n * np.arange(len(self.levels))[:, None]
        head, tail = (layers + self.part.across[i] for i in (0, -1))
        edge = last * n + np.arange(n if self.held else 0)
        at_rest = {
            1: layers + self.part.middle(-1),
            2: np.hstack([head, tail]),
            3: np.concatenate([tail.ravel(), np.arange(n), edge]),
        }
        moved = np.intersect1d(layers + self.part.middle(0), used)
        return [
            *((int(node) + 1, i, 0.0) for i, nodes in at_rest.items()
              for node in np.intersect1d(nodes, used)),
            *((int(node) + 1, 1, self.move) for node in moved),
        ]  # fmt: skip


def _bricks(cells: Indices, n: int) -> Indices:
    """Nodes of twenty-node bricks, from eight-node cells in the lowest of three planes.

    Each plane has `n` nodes.
    """
    corners, edges = cells[:, :4], cells[:, 4:]
    return np.hstack([corners, corners + 2 * n, edges, edges + 2 * n, corners + n])
