"""Plane and axisymmetric problems of `fem.plane` as input files (decks) for calculix.

Mesh, materials, supports, ties and mean motions are those of the solved problem. Loads are its
nodal forces, or pressures and centrifugal forces that calculix integrates.
"""

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TextIO

import numpy as np

from fem.plane.material import Assumption, Elastic
from fem.plane.solution import PlaneSolution
from fem.plane.supports import Conditions
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Term
from verify.studies.crosscheck.calculix.numbering import Numbering

FAMILIES = {"plane strain": "CPE", "plane stress": "CPS", "axisymmetric": "CAX"}
# Of the extent: calculix makes bodies in space of its plane stress, whose thickness varies evenly
# from node to node; what that shears is nothing in thin ones alone.
THIN = 1e-4
NOTHING = 1e-12  # of the largest: a displacement or a factor that is round-off
ALL, EVERY = "BODY", "EVERY"  # sets of elements: of the one material, and all

Materials = Elastic | Mapping[str, Elastic]


@dataclass(frozen=True, kw_only=True)
class Spin:
    """Density and angular velocity [rad/s] of a body that rotates about the third axis."""

    rho: float
    omega: float


@dataclass(frozen=True, kw_only=True)
class PlaneDeck:
    """A solved plane problem as a calculix deck.

    calculix integrates `pressures` on boundaries and the centrifugal forces of `spin`. If either is
    given, the nodal forces of the solution are not used. `brief` decks request only displacements
    and stresses, not reactions and energies.
    """

    solution: PlaneSolution
    materials: Materials
    assumption: Assumption
    pressures: Mapping[str, float] = field(default_factory=dict)
    spin: Spin | None = None
    brief: bool = False
    solver: str = "SPOOLES"

    @cached_property
    def numbering(self) -> Numbering:
        return Numbering(self.solution.basis)

    @property
    def unknowns(self) -> int:
        return 2 * self.numbering.count

    @property
    def depth(self) -> float:
        """Thickness of the body in the deck."""
        return depth(self.solution, self.assumption)

    def write(self, path: Path) -> Path:
        with path.open("w", encoding="ascii") as deck:
            write_mesh(deck, self.numbering, self.kind, self.materials, self.depth,
                       rho=self.spin.rho if self.spin else None)  # fmt: skip
            supports = Supports(self.numbering, self.solution)
            supports.write(deck)
            deck.write(f"*STEP\n*STATIC, SOLVER={self.solver}\n")
            keywords.boundary(deck, supports.values(self.solution.u))
            self._write_loads(deck)
            more = "" if self.brief else ",RF"
            deck.write(f"*NODE FILE, OUTPUT=2D\nU{more}\n*EL FILE, OUTPUT=2D\nS\n")
            if not self.brief:
                deck.write(f"*EL PRINT, ELSET={EVERY}, TOTALS=ONLY\nELSE\n")
            deck.write("*END STEP\n")
        return path

    @property
    def kind(self) -> str:
        """Name of the element type in calculix."""
        return f"{FAMILIES[self.assumption]}{len(self.numbering.cells)}"

    def _write_loads(self, deck: TextIO) -> None:
        for name, pressure in self.pressures.items():
            keywords.pressures(deck, self.numbering.sides(name), pressure)
        if self.spin is not None:
            squared = self.spin.omega**2
            deck.write(f"*DLOAD\n{EVERY},CENTRIF,{squared:.12e},0.,0.,0.,0.,0.,1.\n")
        if not self.pressures and self.spin is None:
            share = self.depth / self.solution.thickness
            keywords.forces(deck, nodal_forces(self.numbering, share * self.solution.f))


def depth(solution: PlaneSolution, assumption: Assumption) -> float:
    """Thickness in a deck: that of the solution, or a small thickness in plane stress."""
    if assumption != "plane stress":
        return solution.thickness
    return THIN * float(np.ptp(solution.basis.mesh.p, axis=1).max())


def nodal_forces(numbering: Numbering, f: Array) -> list[Term]:
    """Forces `f` (unknowns,) as forces on the deck's nodes."""
    loaded = [dof for row in numbering.dofs for dof in row[f[row] != 0]]
    return [(int(numbering.of[d]), int(numbering.component[d]), float(f[d])) for d in loaded]


def write_mesh(
    deck: TextIO, numbering: Numbering, kind: str, materials: Materials, thickness: float, *,
    rho: float | None = None, x: Array | None = None,
) -> None:  # fmt: skip
    """Write nodes and the elements of each material.

    The nodes are at `x` (2, nodes) or, by default, at their positions in the mesh.
    """
    places = numbering.x if x is None else x
    keywords.nodes(deck, np.arange(1, numbering.count + 1), places.T, "ALL")
    named = {"": materials} if isinstance(materials, Elastic) else dict(materials)
    sets = []
    for name, material in named.items():
        own, label = numbering.body(name), name.upper() or ALL
        keywords.elements(deck, kind, label, numbering.cells[:, own].T, own + 1)
        if rho is None:
            keywords.solid(deck, label, material, thickness)
        else:
            keywords.dense(deck, label, material, rho, thickness)
        sets.append(label)
    deck.write(f"*ELSET, ELSET={EVERY}\n" + "".join(f"{name},\n" for name in sets))


class Supports:
    """Supports, ties and mean motions of a solution, in the node numbers of a deck.

    Supports along an axis become fixed nodes. Other supports become equations, whose right side is
    the displacement of an additional node. The numbers of additional nodes are larger than `first`
    and larger than the numbers of mesh nodes. Mean motions in `without` are not constrained.
    """

    def __init__(
        self, numbering: Numbering, solution: PlaneSolution, first: int = 0,
        without: Collection[int] = (),
    ) -> None:  # fmt: skip
        self.numbering, self.solution = numbering, solution
        self.conditions: Conditions = solution.conditions
        self.next = max(first, numbering.count) + 1
        axis = np.abs(self.conditions.direction)
        along = axis.min(axis=0) < NOTHING
        known = numbering.of[self.conditions.dofs[0]] > 0
        self.straight, self.inclined = np.flatnonzero(along & known), np.flatnonzero(~along & known)
        self.rows = (
            np.zeros((0, numbering.basis.N)) if solution.held is None
            else solution.held.rows.toarray()
        )  # fmt: skip
        self.handles = {
            **{("condition", int(i)): self._new() for i in self.inclined},
            **{("mean", k): self._new() for k in range(len(self.rows)) if k not in without},
        }

    def _new(self) -> int:
        self.next += 1
        return self.next - 1

    def write(self, deck: TextIO) -> None:
        """Write the additional nodes and the equations; they precede the first step."""
        handles = np.array(list(self.handles.values()), int)
        if handles.size:
            keywords.nodes(deck, handles, np.zeros((handles.size, 2)), "HANDLES")
        self._write_ties(deck)
        held = self.conditions
        for i in self.inclined:
            terms = [
                (int(self.numbering.of[dof]), k + 1, float(n))
                for k, (dof, n) in enumerate(
                    zip(held.dofs[:, i], held.direction[:, i], strict=True)
                )
            ]
            terms.sort(key=lambda term: -abs(term[2]))
            keywords.equation(deck, [*terms, (self.handles["condition", int(i)], 1, -1.0)])
        for (kind, k), handle in self.handles.items():
            if kind == "mean":
                keywords.equation(deck, [*self.mean(k), (handle, 1, -1.0)])

    def values(self, u: Array) -> list[Term]:
        """Prescribed displacements, from `u` (unknowns,), of all supported components."""
        size = NOTHING * float(np.abs(u).max(initial=0.0))

        def kept(value: float) -> float:
            return 0.0 if abs(value) < size else float(value)

        held, found = self.conditions, {}
        for i in self.straight:
            k = int(np.argmax(np.abs(held.direction[:, i])))
            dof = held.dofs[k, i]
            found[int(self.numbering.of[dof]), k + 1] = kept(u[dof])
        for i in self.inclined:
            value = held.direction[:, i] @ u[held.dofs[:, i]]
            found[self.handles["condition", int(i)], 1] = kept(float(value))
        for (kind, k), handle in self.handles.items():
            if kind == "mean":
                found[handle, 1] = float(self.rows[k] @ u)
        return [(node, i, value) for (node, i), value in found.items()]

    def _cut(self) -> Indices:
        """Numbers of tied nodes (followers and leaders), which no other equation may eliminate."""
        if self.solution.held is None:
            return np.zeros(0, int)
        tied = self.solution.held.tied
        return np.unique(self.numbering.of[np.append(tied.follower[0], tied.leader[0])])

    def mean(self, k: int) -> list[Term]:
        """Terms (node, component, weight) of the sum that is mean motion number `k`.

        The force that holds the mean motion is distributed with the same weights.
        """
        row = self.rows[k]
        dofs = np.flatnonzero(np.abs(row) > NOTHING * np.abs(row).max())
        number, component = self.numbering.of[dofs], self.numbering.component[dofs]
        terms = list(zip(number.tolist(), component.tolist(), row[dofs].tolist(), strict=True))
        cut = set(self._cut().tolist())
        return sorted(terms, key=lambda term: (term[0] in cut, -abs(term[2])))

    def _write_ties(self, deck: TextIO) -> None:
        if self.solution.held is None:
            return
        tied, of = self.solution.held.tied, self.numbering.of
        held = set(of[self.conditions.dofs[0, self.straight]].tolist())
        for node, leader, angle in zip(
            of[tied.follower[0]], of[tied.leader[0]], tied.angle, strict=True
        ):
            if node > 0 and node not in held:
                c, s = math.cos(angle), math.sin(angle)
                own, lead = int(node), int(leader)
                keywords.equation(deck, [(own, 1, 1.0), (lead, 1, -c), (lead, 2, s)])
                keywords.equation(deck, [(own, 2, 1.0), (lead, 1, -s), (lead, 2, -c)])
