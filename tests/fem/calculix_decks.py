"""Decks for calculix: plane strain at large displacement, with contact.

Eight-node quadrilaterals with reduced integration, per unit of width.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, TextIO

import numpy as np
from numpy.typing import NDArray

from benchmarks.calculix import run_deck
from fem.plane.material import Elastic

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
STEEL = Elastic(E=206e3, nu=0.3)  # MPa
TIGHT = "1e-6,1e-4,,,1e-6,,,"  # share of the mean force left over, of the last movement changed
Faces = list[tuple[int, int]]
RIGHT, END, LEFT, START = 1, 2, 3, 4  # sides of a cell, seen along the line


def faces(cells: Iterable[int], side: int) -> Faces:
    return [(cell, side) for cell in cells]


class Held(NamedTuple):
    """Component (0, 1) of nodes, held or, in a step, moved to `value`."""

    nodes: Sequence[int]
    component: int
    value: float = 0.0


class Load(NamedTuple):
    """Dead force on a node along a component (0, 1)."""

    node: int
    component: int
    value: float


class Touching(NamedTuple):
    slave: Faces
    master: Faces


@dataclass(frozen=True, kw_only=True)
class Problem:
    """Strips with supports, pairs of surfaces that touch, and steps of loads and movements."""

    points: Array
    cells: Indices
    held: Sequence[Held]
    steps: Sequence[Sequence[Held | Load]]
    watched: Sequence[int]
    touching: Sequence[Touching] = ()
    stiffness: float = 0.0  # of the contact: pressure over overlap
    friction: float = 0.0
    increment: float = 0.25  # of each step


@dataclass(frozen=True)
class Answer:
    """After each step: displacements (k, watched, 2), forces on the first moved nodes (k, 2)."""

    u: Array
    reaction: Array
    seconds: float


def run(problem: Problem, deck: Path, limit: float = 300.0) -> Answer:
    write_deck(problem, deck)
    done = run_deck(deck, limit=limit)
    said = deck.with_suffix(".dat").read_text("ascii")
    u = _blocks(said, "displacements")[:, :, 1:3]
    force = _blocks(said, "total force")[:, 0, :2] if "total force" in said else np.zeros((0, 2))
    return Answer(u, force, done.wall)


def write_deck(problem: Problem, path: Path) -> None:
    p = problem
    moved = _moved(p)
    with path.open("w", encoding="ascii") as deck:
        deck.write("*NODE, NSET=ALL\n")
        numbered = np.column_stack([np.arange(len(p.points)) + 1, p.points])
        np.savetxt(deck, numbered, fmt="%d,%.13e,%.13e,0")
        deck.write("*ELEMENT, TYPE=CPE8R, ELSET=BODY\n")
        numbered = np.column_stack([np.arange(len(p.cells)), p.cells]) + 1
        np.savetxt(deck, numbered, fmt="%d", delimiter=",")
        deck.write(f"*MATERIAL, NAME=M\n*ELASTIC\n{STEEL.E!r},{STEEL.nu!r}\n")
        deck.write("*SOLID SECTION, ELSET=BODY, MATERIAL=M\n1.\n")
        for name, nodes in (("WATCHED", p.watched), ("MOVED", moved)):
            if nodes:
                deck.write(f"*NSET, NSET={name}\n" + "".join(f"{i + 1},\n" for i in nodes))
        _write_contact(p, deck)
        deck.write("*BOUNDARY\n" + _held(p.held))
        deck.write(f"*CONTROLS, PARAMETERS=FIELD\n{TIGHT}\n")
        for step in p.steps:
            _write_step(step, p.increment, deck)
            if moved:
                deck.write("*NODE PRINT, NSET=MOVED, TOTALS=ONLY, FREQUENCY=1000\nRF\n")
            deck.write("*END STEP\n")


def _moved(problem: Problem) -> list[int]:
    held = [own for own in problem.steps[0] if isinstance(own, Held)]
    return sorted({int(node) for own in held for node in own.nodes})


def _write_step(step: Sequence[Held | Load], increment: float, deck: TextIO) -> None:
    deck.write(f"*STEP, NLGEOM, INC=1000\n*STATIC\n{increment!r},1.,1e-6,{increment!r}\n")
    loads = [own for own in step if isinstance(own, Load)]
    if loads:
        deck.write("*CLOAD\n")
        deck.writelines(f"{o.node + 1},{o.component + 1},{o.value:.12e}\n" for o in loads)
    if moved := [own for own in step if isinstance(own, Held)]:
        deck.write("*BOUNDARY\n" + _held(moved))
    deck.write("*NODE PRINT, NSET=WATCHED, FREQUENCY=1000\nU\n")
    deck.write("*NODE FILE, OUTPUT=2D, FREQUENCY=1000\nU\n")


def _write_contact(problem: Problem, deck: TextIO) -> None:
    for k, pair in enumerate(problem.touching):
        for name, own in zip("SM", pair, strict=True):
            deck.write(f"*SURFACE, NAME={name}{k}\n")
            deck.writelines(f"{cell + 1},S{side}\n" for cell, side in own)
    if problem.touching:
        deck.write("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, ")
        deck.write(f"PRESSURE-OVERCLOSURE=LINEAR\n{problem.stiffness!r}\n")
    if problem.friction:
        deck.write(f"*FRICTION\n{problem.friction!r},{problem.stiffness / 2!r}\n")
    for k in range(len(problem.touching)):
        deck.write(f"*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nS{k},M{k}\n")


def _held(held: Iterable[Held]) -> str:
    return "".join(
        f"{node + 1},{own.component + 1},{own.component + 1},{own.value:.12e}\n"
        for own in held
        for node in own.nodes
    )


def _blocks(said: str, title: str) -> Array:
    """Rows of numbers (blocks, rows, columns) under each heading that begins with `title`."""
    found = re.findall(rf" {title}[^\n]*\n\s*\n((?:[ ]+[-+.\dE]+[^\n]*\n)+)", said)
    return np.array(
        [[[float(x) for x in row.split()] for row in own.splitlines()] for own in found]
    )
