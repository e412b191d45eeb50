"""The contact of two discs (benchmark) in calculix: input deck, run and result.

Nodes and nodal loads are those of this project; the eight-node quadrilaterals of calculix lack the
centre node of nine-node cells. Contact is a surface-to-surface penalty: pressure = `slope` times
overlap.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks import hertz
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.plane.solution import PlaneSolution
from verify.studies.crosscheck.calculix import contact, reading, running
from verify.studies.crosscheck.calculix.keywords import Array
from verify.studies.crosscheck.calculix.numbering import Numbering
from verify.studies.crosscheck.calculix.running import Run


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Settings of calculix.

    `slope` [E/a] is the ratio of pressure to overlap. `start` is the initial overlap of the discs
    over the approach of both discs by Hertz; without overlap, calculix finds no contact. Element
    type, linear solver, threads, increments, pairing and lines of *CONTROLS are in calculix'
    notation.
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
        """Initial downward displacement of the upper disc [m]."""
        return self.start * 2 * hertz.EXACT.approach

    @property
    def in_deck(self) -> contact.Settings:
        """These settings in the form of a deck."""
        return contact.Settings(
            slope=self.slope * hertz.STEEL.E / hertz.A, solver=self.solver,
            full=self.element == "CPE8", increments=self.increments, pairing=self.pairing,
            controls=self.controls,
        )  # fmt: skip

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
    """A run, its number of iterations, displacements (nodes, 2) from the mesh, and errors."""

    run: Run
    iterations: int
    u: Array
    errors: dict[str, float]


def write_deck(path: Path, solution: ContactSolution, ask: Settings) -> None:
    """Write the problem of `solution`."""
    deck = contact.ContactDeck(
        states=[solution], materials=hertz.STEEL, assumption=hertz.ASSUMPTION, how=ask.in_deck,
        shift=-lowered(solution.plane, ask),
    )  # fmt: skip
    deck.write(path)


def run_deck(
    deck: Path, problem: ContactProblem, plane: PlaneSolution, ask: Settings, limit: float = 60.0
) -> Answer:
    """Run and evaluate; RuntimeError if calculix fails or takes more than `limit` seconds."""
    run, numbering = (
        running.run_deck(deck, threads=ask.threads, limit=limit),
        Numbering(plane.basis),
    )
    u = run.u[: numbering.count] - lowered(plane, ask)
    pressure = reading.nodal(deck.with_suffix(".frd"), "CONTACT")[:, 3]
    slave = problem.surfaces.slaves[0].dofs[0].ravel()
    middle = slave[np.argmin(np.abs(plane.basis.doflocs[0, slave]))]
    centre = np.argmin(np.hypot(*(numbering.x - [[0.0], [hertz.R]])))
    totals = np.abs(reading.contact_totals(deck.with_suffix(".dat"))[0])
    found = hertz.errors(
        peak=float(pressure[numbering.of[middle] - 1]), moment=float(totals[5]),
        force=float(totals[1]), approach=-float(u[centre, 1]),
    )  # fmt: skip
    rounds = reading.iterations(deck.with_suffix(".sta"))
    return Answer(run=run, iterations=rounds, u=u, errors=found)


def lowered(plane: PlaneSolution, ask: Settings) -> Array:
    """Initial distance (nodes, 2) of each node below its position in the mesh."""
    numbering = Numbering(plane.basis)
    own = numbering.cells[:, numbering.body("upper")]
    down = np.zeros((numbering.count, 2))
    down[np.unique(own) - 1, 1] = ask.shift
    return down
