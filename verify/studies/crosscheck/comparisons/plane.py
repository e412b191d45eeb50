"""Input of a plane problem for calculix, and evaluation of its results."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from verify.core.figures import Array
from verify.studies.crosscheck.statement import Numbers, Posed

if TYPE_CHECKING:
    from fem.plane.solution import PlaneSolution
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

MESH = "same mesh; calculix prints six digits and has fewer integration points"
LINEAR = 5e-5  # of displacements and energies on one mesh
AVERAGED = 1e-3  # of stresses at nodes


@dataclass(frozen=True)
class Fields:
    """Fields at the nodes of a calculix deck that was solved in the file `path`."""

    deck: "PlaneDeck"
    path: Path

    @cached_property
    def solution(self) -> "PlaneSolution":
        """Solution of the project with the displacements replaced by those of calculix."""
        from verify.studies.crosscheck.calculix.reading import displacements

        u = displacements(self.path.with_suffix(".frd"))[: self.deck.numbering.count]
        return replace(self.deck.solution, u=self.deck.numbering.spread(u))

    @cached_property
    def stress(self) -> Array:
        """Stresses (nodes, 6) by calculix, averaged at nodes: xx, yy, zz, xy, yz, zx."""
        from verify.studies.crosscheck.calculix.reading import nodal

        return nodal(self.path.with_suffix(".frd"), "STRESS")

    @property
    def energy(self) -> float:
        """Strain energy by calculix, converted to the thickness of the project's solution."""
        from verify.studies.crosscheck.calculix.reading import strain_energy

        share = self.deck.depth / self.deck.solution.thickness
        return strain_energy(self.path.with_suffix(".dat")) / share

    def hoop(self, boundary: str) -> float:
        """Mean hoop stress about the origin at the nodes of a boundary."""
        number = self.deck.numbering.nodes(boundary) - 1
        x, y = self.deck.numbering.x[:, number]
        xx, yy, _, xy = self.stress[number, :4].T
        return float(((xx * y**2 + yy * x**2 - 2 * xy * x * y) / (x**2 + y**2)).mean())


def posed(
    deck: "PlaneDeck", ours: Numbers, seconds: float, read: Callable[[Fields], Numbers],
    name: str = "deck",
) -> Posed:  # fmt: skip
    """Comparison of `deck`: `ours` are the project's numbers, `read` gets those of calculix."""
    return Posed(
        ours=ours, seconds=seconds, unknowns=deck.unknowns,
        write=lambda folder: deck.write(folder / f"{name}.inp"),
        read=lambda path: read(Fields(deck, path)),
    )  # fmt: skip


def outwards(solution: "PlaneSolution", boundary: str) -> float:
    """Mean radial displacement of a boundary about the origin."""
    side = solution.on_boundary(boundary)
    return float(side.mean(side.polar()[0]))


def hoop(solution: "PlaneSolution", boundary: str) -> float:
    """Mean hoop stress of a boundary about the origin."""
    side = solution.on_boundary(boundary)
    return float(side.mean(side.polar()[2]))


def radial(solution: "PlaneSolution", point: tuple[float, float]) -> float:
    """Radial displacement of the node at `point`, positive away from the origin."""
    return float(np.dot(solution.displacement_at(point), point) / np.hypot(*point))
