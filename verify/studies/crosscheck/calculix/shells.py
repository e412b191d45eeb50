"""Shells of `fem.shell` as calculix decks: eight-node shells with reduced integration.

The nodes are those of the nine-node cells, except the centres. calculix converts the shells to one
layer of solid elements, with rigid knots at supported rotations. Therefore, a clamp stiffens parts
of the cells next to it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from fem.plane.material import Elastic
from fem.shell.solution import ShellSolution
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Indices
from verify.studies.crosscheck.calculix.reading import nodal


@dataclass(frozen=True, kw_only=True)
class ShellDeck:
    """A solved shell of constant thickness as a calculix deck, with clamps and nodal forces."""

    solution: ShellSolution
    material: Elastic
    thickness: float
    clamped: Sequence[str]

    @cached_property
    def used(self) -> Indices:
        """Nodes of the mesh that the deck contains, in the order of the deck."""
        return np.unique(self.solution.cells[:, :8])

    def write(self, path: Path) -> Path:
        s = self.solution
        held = np.unique(np.concatenate([np.unique(s.boundaries[name]) for name in self.clamped]))
        with path.open("w", encoding="ascii") as deck:
            keywords.nodes(deck, self.used + 1, s.points[self.used], "ALL")
            number = np.arange(1, len(s.cells) + 1)
            keywords.elements(deck, "S8R", "SHELL", s.cells[:, :8] + 1, number)
            keywords.shell(deck, "SHELL", self.material, self.thickness)
            keywords.boundary(deck, ((int(n) + 1, i, 0.0) for n in held for i in range(1, 7)))
            deck.write("*STEP\n*STATIC\n")
            keywords.forces(deck, (
                (int(n) + 1, int(i) + 1, float(s.f[n, i]))
                for n, i in zip(*np.nonzero(s.f[:, :3]), strict=True)
            ))  # fmt: skip
            deck.write("*NODE FILE, OUTPUT=2D\nU\n*END STEP\n")
        return path

    def moved(self, path: Path, node: int) -> Array:
        """Displacement (3,) of a node of the mesh, from the results of a solved deck."""
        found = nodal(path.with_suffix(".frd"), "DISP")[:, :3]
        return np.asarray(found[np.searchsorted(self.used, node)])
