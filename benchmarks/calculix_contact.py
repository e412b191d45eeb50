"""The benchmark's contact as a calculix deck, run there, and its answer read back.

Same nodes, same nodal loads; eight-node quadrilaterals lack the centre node of the nine-node ones.
Contact is a penalty there, surface to surface: a pressure of `slope` times the overlap.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks import calculix, hertz
from benchmarks.calculix import Array, Run
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.contact.trace import Trace
from fem.plane.solution import PlaneSolution


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How calculix is asked.

    `slope` [E/a] of the pressure over the overlap; `start` [approach of both discs by Hertz]: how
    far the discs overlap to begin with, for without any overlap the upper one falls through. Kind
    of element, linear solver, threads, increments, pairing and lines of *CONTROLS as calculix
    has them.
    """

    slope: float = 150.0
    start: float = 0.25
    element: str = "CPE8R"
    solver: str = "SPOOLES"
    threads: int = 1
    increments: int = 1
    pairing: str = "SURFACE TO SURFACE"
    controls: str = ""

    @property
    def shift(self) -> float:
        """By how much the upper disc is lowered [m]."""
        return self.start * 2 * hertz.EXACT.approach

    def __str__(self) -> str:
        own = [f"slope {self.slope:g} E/a", f"start {self.start:.2g}", self.element, self.solver]
        if self.increments > 1:
            own.append(f"{self.increments} increments")
        if self.pairing != "SURFACE TO SURFACE":
            own.append(self.pairing.lower())
        if self.controls:
            own.append(self.controls.replace("\n", " ").lower())
        return ", ".join([*own, *(["2 threads"] if self.threads == 2 else [])])


@dataclass(frozen=True, kw_only=True)
class Answer:
    """A run, how many iterations it took, displacements (nodes, 2) from the mesh, errors."""

    run: Run
    iterations: int
    u: Array
    errors: dict[str, float]


def write_deck(
    path: Path, problem: ContactProblem, solution: ContactSolution, ask: Settings
) -> None:
    """Write what `solution` solves."""
    plane = solution.plane
    places = plane.basis.doflocs[:, calculix.deck_unknowns(plane)[0]] - lowered(plane, ask).T
    slope = ask.slope * hertz.STEEL.E / hertz.A
    with path.open("w", encoding="ascii") as deck:
        calculix.write_body(deck, plane, kind=ask.element, material=hertz.STEEL, places=places)
        for name, trace in (
            ("SLAVE", problem.surfaces.slaves[0]),
            ("MASTER", problem.surfaces.masters[0]),
        ):
            assert trace is not None, "calculix has no obstacles without a mesh"
            deck.write(f"*SURFACE, NAME={name}\n")
            deck.writelines(f"{cell},S{side}\n" for cell, side in sides(plane, trace))
        deck.write("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n")
        deck.write(f"{slope!r}\n*CONTACT PAIR, INTERACTION=I, TYPE={ask.pairing}\nSLAVE,MASTER\n")
        deck.write(f"{ask.controls}\n" if ask.controls else "")
        deck.write(f"*STEP\n*STATIC, SOLVER={ask.solver}, DIRECT\n{1 / ask.increments!r},1.\n")
        calculix.write_loads(deck, plane, solution.total.f)
        deck.write("*NODE FILE, OUTPUT=2D\nU\n*EL FILE, OUTPUT=2D\nS\n")
        deck.write("*CONTACT FILE\nCDIS,CSTR\n*CONTACT PRINT, SLAVE=SLAVE, MASTER=MASTER\nCF\n")
        deck.write("*END STEP\n")


def run_deck(
    deck: Path, problem: ContactProblem, plane: PlaneSolution, ask: Settings, limit: float = 60.0
) -> Answer:
    """Run and judge; RuntimeError where calculix fails or takes more than `limit` seconds."""
    run = calculix.run_deck(deck, threads=ask.threads, limit=limit)
    u = run.u - lowered(plane, ask)
    number = calculix.numbers(plane)
    pressure = calculix.nodal(deck.with_suffix(".frd"), "CONTACT")[:, 3]
    slave = problem.surfaces.slaves[0]
    middle = slave.dofs[0].ravel()[np.argmin(np.abs(plane.basis.doflocs[0, slave.dofs[0].ravel()]))]
    centre = np.argmin(np.hypot(*(_places(plane) - [[0.0], [hertz.R]])))
    force, moment = totals(deck.with_suffix(".dat"))
    found = hertz.errors(
        peak=float(pressure[number[middle] - 1]), moment=moment, force=force,
        approach=-float(u[centre, 1]),
    )  # fmt: skip
    iterations = [int(row.split()[3]) for row in _table(deck.with_suffix(".sta"))]
    return Answer(run=run, iterations=sum(iterations), u=u, errors=found)


def totals(dat: Path) -> tuple[float, float]:
    """Sizes of the contact's force along y and moment about the origin, of the last increment."""
    numbers = r"total surface force[^\n]*\n\s*\n\s*([^\n]*)"
    row = re.findall(numbers, dat.read_text("ascii"))[-1].split()
    return abs(float(row[1])), abs(float(row[5]))


def lowered(plane: PlaneSolution, ask: Settings) -> Array:
    """How far (nodes, 2) each node starts below its place in the mesh."""
    mesh = plane.basis.mesh
    number = calculix.deck_cells(plane)[:, mesh.subdomains["upper"]]
    down = np.zeros((calculix.deck_unknowns(plane).shape[1], 2))
    down[np.unique(number) - 1, 1] = ask.shift
    return down


def sides(plane: PlaneSolution, trace: Trace) -> list[tuple[int, int]]:
    """Element and side, both from 1, of each facet."""
    cells = calculix.deck_cells(plane)
    corners = cells[: len(cells) // 2, trace.cells]
    after = np.roll(corners, -1, axis=0)
    ends = np.sort(trace.ends + 1, axis=0)
    match = (np.minimum(corners, after) == ends[0]) & (np.maximum(corners, after) == ends[1])
    return list(zip((trace.cells + 1).tolist(), (match.argmax(axis=0) + 1).tolist(), strict=True))


def _places(plane: PlaneSolution) -> Array:
    return np.asarray(plane.basis.doflocs[:, calculix.deck_unknowns(plane)[0]])


def _table(sta: Path) -> list[str]:
    return [row for row in sta.read_text("ascii").splitlines() if re.match(r"\s+\d+\s+\d+", row)]
