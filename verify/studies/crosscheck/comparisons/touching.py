"""Input of a contact problem for calculix, and evaluation of its results."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from verify.core.figures import Array
from verify.studies.crosscheck.statement import Numbers, Posed

if TYPE_CHECKING:
    from fem.contact.solution import Touch
    from fem.plane.solution import PlaneSolution
    from verify.studies.crosscheck.calculix.contact import ContactDeck

CONTACT = 0.01
PENALTY = (
    "calculix enforces the contact by a penalty and replaces circles by parabolas; the remaining "
    "overlap reduces the force"
)


@dataclass(frozen=True)
class Touched:
    """Results of a calculix deck with contact, solved in the file `path`.

    Forces apply to the complete width of the problem.
    """

    deck: "ContactDeck"
    path: Path

    @cached_property
    def u(self) -> Array:
        """Displacements (nodes, 2) from the positions in the mesh, in the last increment."""
        from verify.studies.crosscheck.calculix.reading import displacements

        u = displacements(self.path.with_suffix(".frd"))[: self.deck.numbering.count]
        return u if self.deck.shift is None else u + self.deck.shift

    @cached_property
    def solution(self) -> "PlaneSolution":
        """Solution of the project with the displacements replaced by those of calculix."""
        return replace(self.deck.states[-1].plane, u=self.deck.numbering.spread(self.u))

    @cached_property
    def _on_slaves(self) -> Array:
        from verify.studies.crosscheck.calculix.reading import contact_totals

        pairs = len(self.deck.surfaces.pairs)
        return contact_totals(self.path.with_suffix(".dat"), pairs) / self.deck.force_ratio

    def force(self, pair: int = 0) -> tuple[float, float]:
        """Contact force (x, y) on the master surface of a contact pair."""
        x, y = -self._on_slaves[pair, :2]
        return float(x), float(y)

    def moment(self, pair: int = 0) -> float:
        """Moment of the contact force on the master surface about the origin."""
        return -float(self._on_slaves[pair, 5])

    @cached_property
    def pressures(self) -> Array:
        """Contact pressures (nodes,) in the last increment; zero at nodes without contact."""
        from verify.studies.crosscheck.calculix.reading import nodal

        return nodal(self.path.with_suffix(".frd"), "CONTACT")[:, 3]

    def peak(self, pair: int = 0) -> float:
        """Largest pressure at a node of the slave surface."""
        trace = self.deck.surfaces.slaves[pair]
        return float(self.pressures[self.deck.numbering.of[trace.dofs[0]] - 1].max())

    def half_width(self, pair: int = 0) -> float:
        """Half the length of the contact."""
        from verify.studies.crosscheck.calculix.reading import contact_areas

        pairs = len(self.deck.surfaces.pairs)
        areas = contact_areas(self.path.with_suffix(".dat"), pairs)
        return float(areas[pair]) / self.deck.depth / 2


def posed(
    deck: "ContactDeck", ours: Numbers, seconds: float, read: Callable[[Touched], Numbers],
    name: str = "deck",
) -> Posed:  # fmt: skip
    """Comparison of `deck`: `ours` are the project's numbers, `read` gets those of calculix."""
    return Posed(
        ours=ours, seconds=seconds, unknowns=deck.unknowns,
        write=lambda folder: deck.write(folder / f"{name}.inp"),
        read=lambda path: read(Touched(deck, path)),
    )  # fmt: skip


def along_first_moment(touch: "Touch") -> float:
    """Half-width of an elliptic pressure on x >= 0, from the mean of x weighted by the load."""
    x, load = touch.mortar.points.x[0], touch.p * touch.weight
    return float(3 * np.pi / 4 * (load @ x) / load.sum())
