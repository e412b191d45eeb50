"""Decks of plane strips of eight-node elements with contact, at large displacement.

The cells have reduced integration. Plane strain is computed per unit of width. Plane stress is
modelled by a thin strip, whose forces are also per unit of width.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, NamedTuple, TextIO

import numpy as np

from fem.plane.material import Elastic
from verify.studies.crosscheck.calculix import keywords
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Side, Term
from verify.studies.crosscheck.calculix.plane import FAMILIES
from verify.studies.crosscheck.calculix.reading import blocks, buckling_factors
from verify.studies.crosscheck.calculix.running import run_deck

STEEL = Elastic(E=206e3, nu=0.3)  # MPa
TIGHT = "1e-6,1e-4,,,1e-6,,,"  # limits: residual over mean force, correction over last displacement
RIGHT, END, LEFT, START = 1, 2, 3, 4  # sides of a cell, seen along the line


def faces(cells: Iterable[int], side: int) -> list[Side]:
    """Side number `side` of each of the `cells`, as pairs (cell, side); cells count from 0."""
    return [(cell, side) for cell in cells]


class Held(NamedTuple):
    """Component (0 or 1) of nodes that is fixed or, in a step, displaced to `value`."""

    nodes: Sequence[int] | Indices
    component: int
    value: float = 0.0


class Load(NamedTuple):
    """Force of constant direction on a node, along a component (0 or 1)."""

    node: int
    component: int
    value: float


class Touching(NamedTuple):
    """Two surfaces that may touch."""

    slave: list[Side]
    master: list[Side]


@dataclass(frozen=True, kw_only=True)
class Problem:
    """Strips with supports, possible contacts, and steps of loads and displacements.

    `linear` strips are solved in the initial geometry. A `buckling` step computes factors on the
    loads with fully integrated cells. With reduced integration, calculix includes half of the
    stress stiffness, and the factors are too large by a factor of 2.
    """

    points: Array
    cells: Indices
    held: Sequence[Held]
    steps: Sequence[Sequence[Held | Load]]
    watched: Sequence[int]
    touching: Sequence[Touching] = ()
    stiffness: float = 0.0  # of the contact: pressure over overlap
    friction: float = 0.0
    increment: float = 0.25  # of each step
    material: Elastic = STEEL
    assumption: Literal["plane strain", "plane stress"] = "plane strain"
    width: float = 1.0  # of the deck; a thin one in plane stress
    linear: bool = False
    buckling: bool = False


@dataclass(frozen=True)
class Answer:
    """Displacements (k, watched, 2) and forces (k, 2) after each of k steps.

    The forces act on the nodes that the first step moves. They are per unit of width.
    """

    u: Array
    reaction: Array
    seconds: float


def run(problem: Problem, deck: Path, limit: float = 300.0) -> Answer:
    """Write the deck, run calculix and read the results.

    Raises RuntimeError if calculix fails or exceeds the `limit` [s].
    """
    write_deck(problem, deck)
    done = run_deck(deck, limit=limit)
    return answer(problem, deck, done.wall)


def answer(problem: Problem, deck: Path, seconds: float = 0.0) -> Answer:
    """Results of a solved deck, from the files in its folder."""
    output = deck.with_suffix(".dat")
    u = np.array(blocks(output, "displacements"))[:, :, 1:3]
    force = np.zeros((0, 2))
    if moved_by(problem):
        force = np.array(blocks(output, "total force"))[:, 0, :2] / problem.width
    return Answer(u, force, seconds)


def factor(deck: Path) -> float:
    """Smallest positive factor on the loads at which the strip buckles."""
    found = buckling_factors(deck.with_suffix(".dat"))
    return float(found[found > 0].min())


def write_deck(problem: Problem, path: Path) -> Path:
    p = problem
    moved = moved_by(p)
    with path.open("w", encoding="ascii") as deck:
        keywords.nodes(deck, np.arange(1, len(p.points) + 1), p.points, "ALL")
        kind = f"{FAMILIES[p.assumption]}8" + "R" * (not p.buckling)
        keywords.elements(deck, kind, "BODY", p.cells + 1, np.arange(1, len(p.cells) + 1))
        keywords.solid(deck, "BODY", p.material, p.width)
        for name, nodes in (("WATCHED", p.watched), ("MOVED", moved)):
            if nodes:
                keywords.node_set(deck, name, (int(i) + 1 for i in nodes))
        _write_contact(p, deck)
        keywords.boundary(deck, _held(p.held))
        if not p.linear:
            deck.write(f"*CONTROLS, PARAMETERS=FIELD\n{TIGHT}\n")
        for step in p.steps:
            _write_step(p, step, deck)
            if moved:
                deck.write("*NODE PRINT, NSET=MOVED, TOTALS=ONLY, FREQUENCY=1000\nRF\n")
            deck.write("*END STEP\n")
    return path


def moved_by(problem: Problem) -> list[int]:
    """Nodes with prescribed displacements in the first step, at which the forces are read."""
    held = [own for own in problem.steps[0] if isinstance(own, Held)]
    return sorted({int(node) for own in held for node in own.nodes})


def _write_step(p: Problem, step: Sequence[Held | Load], deck: TextIO) -> None:
    deck.write("*STEP" + ("" if p.linear else ", NLGEOM") + ", INC=1000\n")
    if p.buckling:
        deck.write("*BUCKLE\n4,1e-3,30,200\n")
    elif p.linear:
        deck.write("*STATIC\n")
    else:
        deck.write(f"*STATIC\n{p.increment!r},1.,1e-6,{p.increment!r}\n")
    loads = [own for own in step if isinstance(own, Load)]
    keywords.forces(deck, ((o.node + 1, o.component + 1, p.width * o.value) for o in loads))
    keywords.boundary(deck, _held(own for own in step if isinstance(own, Held)))
    deck.write("*NODE PRINT, NSET=WATCHED, FREQUENCY=1000\nU\n")
    deck.write("*NODE FILE, OUTPUT=2D, FREQUENCY=1000\nU\n")


def _write_contact(p: Problem, deck: TextIO) -> None:
    for k, pair in enumerate(p.touching):
        own = {f"{name}{k}": [(cell + 1, side) for cell, side in sides]
               for name, sides in zip("SM", pair, strict=True)}  # fmt: skip
        keywords.surfaces(deck, own)
    if p.touching:
        keywords.interaction(deck, "I", p.stiffness, p.friction, p.stiffness / 2)
    for k in range(len(p.touching)):
        keywords.contact_pair(deck, f"S{k}", f"M{k}", "I")


def _held(held: Iterable[Held]) -> list[Term]:
    return [(int(node) + 1, own.component + 1, own.value) for own in held for node in own.nodes]
