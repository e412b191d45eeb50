"""The benchmark's pitch of a freewheel as a calculix deck, run there, and its answer read back.

Same nodes, cuts tied and the rim's mean rotation held by *EQUATION with this project's own weights.
Contact is a penalty there, surface to surface, friction another one; circle and flat cannot be
told, the parabolas of the cells' sides stand for them. The overlap is the mesh's own.
"""

import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from benchmarks import calculix, sector
from benchmarks.calculix import Array, Run
from benchmarks.calculix_contact import sides
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.contact.trace import Trace
from fem.plane.material import Elastic

STIFF = sector.CLUTCH.E / sector.WIDTHS[0]  # Pa/m
Term = tuple[int, int, float]  # node, component from 1, factor


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How calculix is asked.

    `slope` [E/a] of the pressure over the overlap; `stick` of the friction over the slip, in
    slopes. Kind of element, linear solver, threads, increments (`cut` shorter where needed),
    pairing and lines of *CONTROLS as calculix has them. `given` [N m]: that torque, evenly spread,
    in place of the rim's rotation.
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
    """A run, how many iterations it took, and what is judged."""

    run: Run
    iterations: int
    found: dict[str, float]


class Deck:
    """What calculix is told of a solved pitch."""

    def __init__(self, problem: ContactProblem, solution: ContactSolution) -> None:
        self.problem, self.plane = problem, solution.plane
        self.basis = solution.plane.basis
        self.number = calculix.numbers(self.plane)
        dofs = calculix.deck_unknowns(self.plane)
        self.x: Array = self.basis.doflocs[:, dofs[0]]
        self.component = np.zeros(self.basis.N, int)
        self.component[dofs] = [[1], [2]]
        self.turn = dofs.shape[1] + 1  # a node for the rim's mean motion
        self.bore, self.rim = self._nodes("star.bore"), self._nodes("ring.rim")

    def _nodes(self, boundary: str) -> NDArray[np.int64]:
        number = np.unique(self.number[self.basis.get_dofs(boundary).all()])
        return number[number > 0]

    def write(self, path: Path, ask: Settings) -> None:
        material = Elastic(E=sector.CLUTCH.E, nu=sector.CLUTCH.nu)
        with path.open("w", encoding="ascii") as deck:
            calculix.write_mesh(deck, self.plane, kind=ask.element, material=material)
            deck.write(f"*NODE, NSET=TURN\n{self.turn},0,0,0\n")
            self._write_equations(deck, ask)
            self._write_contact(deck, ask)
            deck.write("*BOUNDARY\n")
            deck.writelines(f"{node},1,2\n" for node in self.bore)
            deck.write(f"{ask.controls}\n" if ask.controls else "")
            direct = "" if ask.cut else ", DIRECT"
            deck.write(f"*STEP, INC=1000\n*STATIC, SOLVER={ask.solver}{direct}\n")
            deck.write(f"{1 / ask.increments!r},1.\n")
            self._write_drive(deck, ask)
            deck.write("*NODE FILE, OUTPUT=2D\nU,RF\n*EL FILE, OUTPUT=2D\nS\n")
            deck.write("*CONTACT FILE\nCDIS,CSTR\n")
            for i in range(2):
                deck.write(f"*CONTACT PRINT, SLAVE=SLAVE{i}, MASTER=MASTER{i}\nCF\n")
            deck.write("*END STEP\n")

    def _write_equations(self, deck: TextIO, ask: Settings) -> None:
        deck.write("*EQUATION\n")
        tied = self.problem.bodies.tied
        follower, leader = self.number[tied.follower[0]], self.number[tied.leader[0]]
        for node, of, angle in zip(follower, leader, tied.angle, strict=True):
            if node > 0 and node not in self.bore:
                c, s = math.cos(angle), math.sin(angle)
                _equation(deck, [(node, 1, 1.0), (of, 1, -c), (of, 2, s)])
                _equation(deck, [(node, 2, 1.0), (of, 1, -s), (of, 2, -c)])
        if ask.given is None:
            cut = np.union1d(follower, leader)
            terms = sorted(self._rotation(), key=lambda t: (t[0] in cut, -abs(t[2])))
            _equation(deck, [*terms, (self.turn, 1, -1.0)])

    def _rotation(self) -> list[Term]:
        """The rim's mean rotation times R."""
        row = sector.CLUTCH.R * self.problem.bodies.mean_rows.toarray()[0]
        dofs = np.flatnonzero(np.abs(row) > 1e-9 * np.abs(row).max())
        named = (self.number[dofs], self.component[dofs], row[dofs])
        return list(zip(*(column.tolist() for column in named), strict=True))

    def _write_contact(self, deck: TextIO, ask: Settings) -> None:
        surfaces, slope = self.problem.surfaces, ask.slope * STIFF
        for name, traces in (("SLAVE", surfaces.slaves), ("MASTER", surfaces.masters)):
            for i, trace in enumerate(traces):
                assert trace is not None, "calculix has no obstacles without a mesh"
                deck.write(f"*SURFACE, NAME={name}{i}\n")
                deck.writelines(f"{cell},S{side}\n" for cell, side in sides(self.plane, trace))
        deck.write("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n")
        deck.write(f"{slope:.12e}\n*FRICTION\n{sector.MU!r},{ask.stick * slope:.12e}\n")
        for i in range(2):
            deck.write(f"*CONTACT PAIR, INTERACTION=I, TYPE={ask.pairing}\nSLAVE{i},MASTER{i}\n")

    def _write_drive(self, deck: TextIO, ask: Settings) -> None:
        deck.write("*BOUNDARY\n")
        for node in self.bore:
            x, y = sector.TILT * self.x[::-1, node - 1] * (1, -1)
            deck.write(f"{node},1,1,{x:.12e}\n{node},2,2,{y:.12e}\n")
        if ask.given is None:
            deck.write(f"{self.turn},1,1,{-sector.ROTATION * sector.CLUTCH.R:.12e}\n")
            return
        force = -ask.given / (sector.CLUTCH.z * sector.CLUTCH.L * sector.CLUTCH.R)
        deck.write("*CLOAD\n")
        deck.writelines(f"{node},{i},{force * w:.12e}\n" for node, i, w in self._rotation())

    def run(self, path: Path, ask: Settings, limit: float) -> Answer:
        """Run and read; RuntimeError where calculix fails or takes more than `limit` seconds."""
        run = calculix.run_deck(path, threads=ask.threads, limit=limit)
        frd = path.with_suffix(".frd")
        pressure, force = calculix.nodal(frd, "CONTACT")[:, 3], calculix.nodal(frd, "FORC")
        rim = self.rim - 1
        torque = self.x[0, rim] @ force[rim, 1] - self.x[1, rim] @ force[rim, 0]
        centre = np.argmin(np.hypot(*(self.x.T - sector.CENTRE).T))
        slaves = [trace for trace in self.problem.surfaces.slaves if trace is not None]
        dat = path.with_suffix(".dat").read_text("ascii")
        (inner, outer), (area_i, area_o) = on_slaves(dat), areas(dat)
        found = sector.values(
            torque=-float(torque),
            forces=((-inner[0], -inner[1]), (-outer[0], -outer[1])),
            centre=(float(run.u[centre, 0]), float(run.u[centre, 1])),
            widths=(area_i / 2, area_o / 2),  # nodal pressures reach 3 % too far
            peaks=(self.peak(slaves[0], pressure), self.peak(slaves[1], pressure)),
        )
        return Answer(run=run, iterations=iterations(path.with_suffix(".sta")), found=found)

    def peak(self, slave: Trace, pressure: Array) -> float:
        return float(pressure[self.number[slave.dofs[0]] - 1].max())


def _equation(deck: TextIO, terms: list[Term]) -> None:
    """Terms whose sum vanishes; calculix eliminates the first, and reads four a line."""
    said = [f"{node},{component},{factor:.12e}" for node, component, factor in terms]
    rows = [",".join(said[i : i + 4]) for i in range(0, len(said), 4)]
    deck.write("\n".join([str(len(terms)), *rows, ""]))


def on_slaves(dat: str) -> list[tuple[float, float]]:
    """Forces (x, y) on both slave surfaces, of the last increment."""
    return [(row[0], row[1]) for row in _rows(dat, "total surface force")]


def areas(dat: str) -> list[float]:
    """In contact, of both pairs per length, of the last increment."""
    return [row[0] for row in _rows(dat, "area,")]


def _rows(dat: str, title: str) -> list[list[float]]:
    """Numbers under the last two headings that begin so."""
    said = re.findall(rf"{title}[^\n]*\n\s*\n\s*([^\n]*)", dat)
    return [[float(word) for word in row.split()] for row in said[-2:]]


def iterations(sta: Path) -> int:
    """Of all increments."""
    rows = (row.split() for row in sta.read_text("ascii").splitlines())
    return sum(int(row[3]) for row in rows if len(row) > 6 and row[0].isdigit())
