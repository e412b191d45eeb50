"""One pitch of a roller freewheel (benchmark) in calculix: input deck, run and result.

Nodes are those of this project. *EQUATION with the weights of this project ties both cuts and
prescribes the mean rotation of the rim. Contact and friction are surface-to-surface penalties.
calculix has no exact circles and flats: parabolic cell sides are used. The overlap is that of the
mesh.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks import sector
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.contact.trace import Trace
from fem.plane.material import Elastic
from verify.studies.crosscheck.calculix import contact, reading, running
from verify.studies.crosscheck.calculix.keywords import Array
from verify.studies.crosscheck.calculix.numbering import Numbering
from verify.studies.crosscheck.calculix.running import Run

STIFF = sector.CLUTCH.E / sector.WIDTHS[0]  # Pa/m


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Settings of calculix.

    `slope` [E/a] is the ratio of pressure to overlap; `stick` is the ratio of friction to slip, in
    units of `slope`. Element type, linear solver, threads, increments (`cut`: automatic reduction),
    pairing and lines of *CONTROLS are in calculix' notation. `given` [N m] is a uniformly
    distributed torque; it replaces the prescribed rotation of the rim.
    """

    slope: float = 50.0
    stick: float = 0.5
    element: str = "CPE8R"
    solver: str = "SPOOLES"
    threads: int = 1
    increments: int = 1
    cut: bool = False
    pairing: str = "SURFACE TO SURFACE"
    controls: str = ""
    given: float | None = None

    @property
    def in_deck(self) -> contact.Settings:
        """These settings in the form of a deck."""
        return contact.Settings(
            slope=self.slope * STIFF, stick=self.stick, solver=self.solver,
            full=self.element == "CPE8", increments=self.increments, cut=self.cut,
            pairing=self.pairing, controls=self.controls,
        )  # fmt: skip

    def __str__(self) -> str:
        own = [f"slope {self.slope:g} E/a, stick {self.stick:g}", self.element, self.solver]
        if self.increments > 1:
            own.append(f"{self.increments} increments" + (" or more" if self.cut else ""))
        if self.pairing != "SURFACE TO SURFACE":
            own.append(self.pairing.lower())
        if self.controls:
            own.append(self.controls.replace("\n", " ").lower())
        if self.given is not None:
            own.append("torque given")
        return ", ".join([*own, *(["2 threads"] if self.threads == 2 else [])])


@dataclass(frozen=True, kw_only=True)
class Answer:
    """A run, its number of iterations, and the compared quantities."""

    run: Run
    iterations: int
    found: dict[str, float]


class Deck:
    """The input deck of a solved pitch for calculix."""

    def __init__(self, problem: ContactProblem, solution: ContactSolution) -> None:
        self.problem, self.solution = problem, solution
        self.numbering = Numbering(solution.plane.basis)
        self.rim = self.numbering.nodes("ring.rim")

    def write(self, path: Path, ask: Settings) -> None:
        """Write the deck: bore and rim rotated as in this project's solution, or a given torque."""
        given = {} if ask.given is None else {0: -ask.given / (sector.CLUTCH.z * sector.CLUTCH.L)}
        contact.ContactDeck(
            states=[self.solution], assumption="plane strain", how=ask.in_deck, given=given,
            materials=Elastic(E=sector.CLUTCH.E, nu=sector.CLUTCH.nu),
        ).write(path)  # fmt: skip

    def run(self, path: Path, ask: Settings, limit: float) -> Answer:
        """Run and read; RuntimeError if calculix fails or takes more than `limit` seconds."""
        run = running.run_deck(path, threads=ask.threads, limit=limit)
        frd, dat = path.with_suffix(".frd"), path.with_suffix(".dat")
        pressure, force = reading.nodal(frd, "CONTACT")[:, 3], reading.nodal(frd, "FORC")
        x, rim = self.numbering.x, self.rim - 1
        torque = x[0, rim] @ force[rim, 1] - x[1, rim] @ force[rim, 0]
        centre = np.argmin(np.hypot(*(x.T - sector.CENTRE).T))
        slaves = self.problem.surfaces.slaves
        inner, outer = reading.contact_totals(dat, 2)
        area_i, area_o = reading.contact_areas(dat, 2)
        found = sector.values(
            torque=-float(torque),
            forces=((-inner[0], -inner[1]), (-outer[0], -outer[1])),
            centre=(float(run.u[centre, 0]), float(run.u[centre, 1])),
            widths=(area_i / 2, area_o / 2),  # the region with nodal pressures is 3 % too wide
            peaks=(self.peak(slaves[0], pressure), self.peak(slaves[1], pressure)),
        )
        rounds = reading.iterations(path.with_suffix(".sta"))
        return Answer(run=run, iterations=rounds, found=found)

    def peak(self, slave: Trace, pressure: Array) -> float:
        return float(pressure[self.numbering.of[slave.dofs[0]] - 1].max())
