"""Contact problems of `fem.contact` as input files (decks) for calculix.

In calculix, contact and friction are surface-to-surface penalties: the pressure is a slope times
the overlap. The project uses no penalty, and exact circles and flats; calculix uses the parabolic
sides of the cells. Obstacles become strips of elements with fixed nodes.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TextIO

import numpy as np

from fem.contact.bodies import Bodies
from fem.contact.interface import Surfaces
from fem.contact.solution import ContactSolution
from fem.plane.material import Assumption, Elastic
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Term
from verify.studies.crosscheck.calculix.numbering import Numbering
from verify.studies.crosscheck.calculix.obstacles import Strip, strip_of
from verify.studies.crosscheck.calculix.plane import (
    FAMILIES,
    Materials,
    Supports,
    depth,
    nodal_forces,
    write_mesh,
)

RIGID = "RIGID"
TURN = 1 / 180  # of what is turned: calculix makes two degrees of it, and tells their contact force


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Settings of a calculix run.

    `slope` [stress/length] is the ratio of pressure to overlap. `stick` is the ratio of friction
    stress to slip, in units of `slope`. `increments` is the number of increments of each step, and
    `cut` enables their automatic reduction. `full` selects full integration of the elements.
    `solver`, `pairing` and `controls` are keywords of calculix.
    """

    slope: float
    stick: float = 0.5
    solver: str = "SPOOLES"
    increments: int = 1
    cut: bool = False
    pairing: str = "SURFACE TO SURFACE"
    controls: str = ""
    full: bool = False


@dataclass(frozen=True, kw_only=True)
class ContactDeck:
    """Successive states of a contact problem as a calculix deck.

    `shift` (nodes, 2) is the initial displacement of nodes from their positions in the mesh. It
    models an interference as an overlap of the bodies, because a clearance in calculix would
    replace the gap instead of being added to it. An interference without `shift` raises ValueError.
    `given` contains forces that act along mean motions (number of the mean motion: force); these
    motions are then not prescribed.
    """

    states: Sequence[ContactSolution]
    materials: Materials
    assumption: Assumption
    how: Settings
    shift: Array | None = None
    given: Mapping[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.shift is None and any(p.interference for p in self.surfaces.pairs):
            raise ValueError(
                "an interference requires `shift`, because a deck models it by overlapping bodies"
            )

    @property
    def bodies(self) -> Bodies:
        return self.states[-1].bodies

    @cached_property
    def surfaces(self) -> Surfaces:
        return Surfaces(self.bodies, self.states[-1].interface.pairs)

    @cached_property
    def numbering(self) -> Numbering:
        return Numbering(self.bodies.basis)

    @cached_property
    def supports(self) -> Supports:
        last = self.numbering.count + sum(len(strip.x) for strip in self.strips.values())
        return Supports(self.numbering, self.states[-1].plane, last, without=self.given)

    @cached_property
    def strips(self) -> dict[str, Strip]:
        """Strips of elements for obstacles that slave surfaces may touch (obstacle: strip)."""
        surfaces = self.surfaces
        return {
            pair.master: strip_of(
                self.bodies.obstacles[pair.master], slave.points, turn=self.bodies.turn
            )
            for pair, slave, master in zip(
                surfaces.pairs, surfaces.slaves, surfaces.masters, strict=True
            )
            if master is None
        }

    @property
    def unknowns(self) -> int:
        return 2 * self.numbering.count

    @property
    def depth(self) -> float:
        """Thickness of the bodies in the deck."""
        return depth(self.states[-1].plane, self.assumption)

    @property
    def share(self) -> float:
        """Thickness in the deck divided by that in the problem; also the ratio of the forces."""
        return self.depth / self.bodies.thickness

    @property
    def force_ratio(self) -> float:
        """Contact forces printed by calculix divided by those of the problem."""
        return TURN if self.bodies.turn else self.share

    @property
    def kind(self) -> str:
        reduced = "" if self.how.full else "R"
        return f"{FAMILIES[self.assumption]}{len(self.numbering.cells)}{reduced}"

    def write(self, path: Path) -> Path:
        with path.open("w", encoding="ascii") as deck:
            x = self.numbering.x if self.shift is None else self.numbering.x + self.shift.T
            write_mesh(deck, self.numbering, self.kind, self.materials, self.depth, x=x)
            self._write_strips(deck)
            self.supports.write(deck)
            self._write_pairs(deck)
            deck.write(f"{self.how.controls}\n" if self.how.controls else "")
            for state in self.states:
                self._write_step(deck, state)
        return path

    def first_of(self, name: str) -> tuple[int, int]:
        """Numbers of the first node and of the first element of an obstacle's strip."""
        node, cell = self.numbering.count + 1, self.numbering.cells.shape[1] + 1
        for own, strip in self.strips.items():
            if own == name:
                break
            node, cell = node + len(strip.x), cell + len(strip.cells)
        return node, cell

    def _write_strips(self, deck: TextIO) -> None:
        if not self.strips:
            return
        own = self.materials
        any_one = own if isinstance(own, Elastic) else next(iter(own.values()))
        kind = FAMILIES[self.assumption] + "8"
        for k, (name, strip) in enumerate(self.strips.items()):
            node, cell = self.first_of(name)
            label = f"{RIGID}{k}"
            keywords.nodes(deck, node + np.arange(len(strip.x)), strip.x)
            keywords.elements(
                deck, kind, label, strip.cells + node, cell + np.arange(len(strip.cells))
            )
            keywords.solid(deck, label, any_one, self.depth)

    def _write_pairs(self, deck: TextIO) -> None:
        s, how = self.surfaces, self.how
        for i, (pair, slave, master) in enumerate(
            zip(s.pairs, s.slaves, s.masters, strict=True)
        ):  # fmt: skip
            there = (
                self.strips[pair.master].sides(self.first_of(pair.master)[1])
                if master is None
                else self.numbering.traced(master)
            )
            sides = {f"SLAVE{i}": self.numbering.traced(slave), f"MASTER{i}": there}
            keywords.surfaces(deck, sides)
            keywords.interaction(deck, f"I{i}", how.slope, pair.friction, how.stick * how.slope)
            keywords.contact_pair(deck, f"SLAVE{i}", f"MASTER{i}", f"I{i}", how.pairing)

    def _write_step(self, deck: TextIO, state: ContactSolution) -> None:
        how = self.how
        deck.write("*STEP, INC=1000\n")
        deck.write(f"*STATIC, SOLVER={how.solver}{'' if how.cut else ', DIRECT'}\n")
        deck.write(f"{1 / how.increments!r},1.\n")
        keywords.boundary(deck, [*self.supports.values(state.plane.u), *self._obstacles(state)])
        f = self.share * state.total.f[: self.numbering.basis.N]
        spread = [
            (node, i, self.share * force * w)
            for k, force in self.given.items() for node, i, w in self.supports.mean(k)
        ]  # fmt: skip
        keywords.forces(deck, [*nodal_forces(self.numbering, f), *spread])
        often = "FREQUENCY=1000"
        deck.write(f"*NODE FILE, OUTPUT=2D, {often}\nU,RF\n*EL FILE, OUTPUT=2D, {often}\nS\n")
        deck.write(f"*CONTACT FILE, {often}\nCDIS,CSTR\n")
        deck.writelines(
            f"*CONTACT PRINT, SLAVE=SLAVE{i}, MASTER=MASTER{i}, {often}\nCF\n"
            for i in range(len(self.surfaces.pairs))
        )
        deck.write("*END STEP\n")

    def _obstacles(self, state: ContactSolution) -> list[Term]:
        held: list[Term] = []
        for name, strip in self.strips.items():
            node, _ = self.first_of(name)
            moved = strip.moved(state.motion(name))
            held += [
                (node + k, i + 1, float(u))
                for k, row in enumerate(moved)
                for i, u in enumerate(row)
            ]
        return held
