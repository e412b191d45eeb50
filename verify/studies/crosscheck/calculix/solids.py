"""Bodies of `fem.solid` as calculix decks: twenty-node bricks with reduced integration.

The nodes are those of the 27-node cells, except the centres of faces and cells.
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from fem.plane.material import Elastic
from fem.solid.solution import SolidSolution
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Term

# corners and middles of edges of a brick as calculix counts them, in half edges of the unit cube
CORNERS = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))
EDGES = (
    (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
    (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1),
)  # fmt: skip
MIRRORED = (2, 1, 0)  # a left-handed cell has its axes in reverse order


@dataclass(frozen=True, kw_only=True)
class SolidDeck:
    """A solved body of one material under prescribed displacements only, as a calculix deck.

    Raises ValueError if the problem has loads or guides.
    """

    solution: SolidSolution
    material: Elastic
    solver: str = "SPOOLES"

    def __post_init__(self) -> None:
        if np.any(self.solution.f) or self.solution.conditions.ties:
            raise ValueError("the problem of a solid deck must not have loads or guides")

    @cached_property
    def cells(self) -> Indices:
        """Nodes of the bricks, (cells, 20), counted from 0."""
        mesh = self.solution.mesh
        reference = np.rint(2 * np.asarray(mesh.elem().doflocs)).astype(int)
        place = {tuple(row): k for k, row in enumerate(reference.tolist())}
        own = np.array([place[at] for at in (*CORNERS, *EDGES)])
        turned = np.array([
            place[tuple(np.array(at)[list(MIRRORED)].tolist())] for at in (*CORNERS, *EDGES)
        ])  # fmt: skip
        cells = self.solution.cells.nodes
        x: Array = mesh.doflocs.T[cells[:, own]]
        edges = np.stack([x[:, k] - x[:, 0] for k in (1, 3, 4)], axis=1)
        right = np.linalg.det(edges) > 0
        return np.where(right[:, None], cells[:, own], cells[:, turned])

    @property
    def unknowns(self) -> int:
        return 3 * int(np.unique(self.cells).size)

    def write(self, path: Path) -> Path:
        used = np.unique(self.cells)
        with path.open("w", encoding="ascii") as deck:
            keywords.nodes(deck, used + 1, self.solution.mesh.doflocs.T[used])
            number = np.arange(1, len(self.cells) + 1)
            keywords.elements(deck, "C3D20R", "BODY", self.cells + 1, number)
            keywords.solid(deck, "BODY", self.material)
            deck.write(f"*STEP\n*STATIC, SOLVER={self.solver}\n")
            keywords.boundary(deck, self._held(used))
            deck.write("*EL PRINT, ELSET=BODY, TOTALS=ONLY\nELSE\n*NODE FILE\nU\n*END STEP\n")
        return path

    def _held(self, used: Indices) -> list[Term]:
        """Prescribed displacements at the nodes of the deck."""
        conditions = self.solution.conditions
        given = dict(zip(conditions.dofs.tolist(), conditions.value.tolist(), strict=True))
        known = set(used.tolist())
        return [(dof // 3 + 1, dof % 3 + 1, u) for dof, u in given.items() if dof // 3 in known]
