"""One plane problem written as a calculix deck, run there, and its answer read back.

Same nodes and same nodal loads as the solved problem: six-node triangles are the same elements
(CPE6, CPS6), eight-node quadrilaterals (CPE8, CPS8) lack the centre node of the nine-node ones.
"""

import os
import re
import resource
import shutil
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from fem.plane.material import Assumption, Elastic
from fem.plane.solution import PlaneSolution

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Run:
    """Wall-clock and processor seconds of one run, and its displacements `u` (nodes, 2)."""

    wall: float
    cpu: float
    u: Array


def executable() -> str | None:
    """Path of the calculix solver, or None where there is none."""
    return shutil.which("ccx")


def version() -> str:
    """What calculix calls itself."""
    said = subprocess.run([str(executable()), "-v"], capture_output=True, text=True, check=False)  # noqa: S603
    return " ".join(re.findall(r"Version\s+(\S+)", said.stdout)) or "unknown"


def start() -> float:
    """Seconds of a process that only tells its version."""
    begun = time.perf_counter()
    version()
    return time.perf_counter() - begun


def run_deck(deck: Path, threads: int = 1, limit: float | None = None) -> Run:
    """Run calculix on `deck`; RuntimeError with its own words where it fails, or over the `limit`.

    `limit` is in seconds.
    """
    command = [str(executable()), "-i", deck.stem]
    environment = os.environ | {"OMP_NUM_THREADS": str(threads)}
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    try:
        said = subprocess.run(  # noqa: S603
            command, cwd=deck.parent, env=environment, capture_output=True, text=True,
            check=False, timeout=limit,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"calculix took more than {limit:g} s on {deck.name}") from None
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if said.returncode or "*ERROR" in said.stdout:
        raise RuntimeError(f"calculix failed on {deck.name}: {said.stdout[-500:]}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(wall=wall, cpu=cpu, u=displacements(deck.with_suffix(".frd")))


def displacements(frd: Path) -> Array:
    """Displacements (nodes, 2) in the order of the node numbers, six digits each."""
    return nodal(frd, "DISP")[:, :2]


def nodal(frd: Path, name: str) -> Array:
    """Components (nodes, n) of that field in the last increment, in the order of node numbers."""
    rows: list[list[float]] = []
    inside = False
    for line in frd.read_text("ascii").splitlines():
        if line.startswith(" -4"):
            inside = line.split()[1] == name
            rows = [] if inside else rows
        elif inside and line.startswith(" -1"):
            rows.append([float(line[i : i + 12]) for i in range(13, len(line.rstrip()), 12)])
        elif line.startswith(" -3"):
            inside = False
    return np.array(rows)


def write_deck(
    path: Path,
    solution: PlaneSolution,
    *,
    material: Elastic,
    assumption: Assumption,
    solver: str = "SPOOLES",
) -> None:
    """Write the problem that `solution` solves: one material, quadratic, held along x and y."""
    kind = ("CPE" if assumption == "plane strain" else "CPS") + str(len(deck_cells(solution)))
    with path.open("w", encoding="ascii") as deck:
        write_body(deck, solution, kind=kind, material=material)
        deck.write(f"*STEP\n*STATIC, SOLVER={solver}\n")
        write_loads(deck, solution, solution.f)
        deck.write("*NODE FILE, OUTPUT=2D\nU\n*EL FILE, OUTPUT=2D\nS\n*END STEP\n")


def write_body(
    deck: TextIO,
    solution: PlaneSolution,
    *,
    kind: str,
    material: Elastic,
    places: Array | None = None,
) -> None:
    """Nodes at `places` (2, nodes) or where the mesh has them, elements, material, supports."""
    write_mesh(deck, solution, kind=kind, material=material, places=places)
    number, held = numbers(solution), solution.conditions
    axis = np.argmax(np.abs(held.direction), axis=0)
    fixed = np.array([number[held.dofs[0]], axis + 1, axis + 1])[:, number[held.dofs[0]] > 0]
    deck.write("*BOUNDARY\n")
    np.savetxt(deck, np.unique(fixed.T, axis=0), fmt="%d", delimiter=",")


def write_mesh(
    deck: TextIO,
    solution: PlaneSolution,
    *,
    kind: str,
    material: Elastic,
    places: Array | None = None,
) -> None:
    """Nodes at `places` (2, nodes) or where the mesh has them, elements, material."""
    dofs, number, cells = deck_unknowns(solution), numbers(solution), deck_cells(solution)
    x = solution.basis.doflocs[:, dofs[0]] if places is None else places
    # calculix reads 20 characters of a number and drops the rest, exponent and all
    deck.write("*NODE, NSET=ALL\n")
    np.savetxt(deck, np.column_stack([number[dofs[0]], x.T]), fmt="%d,%.12e,%.12e,0")
    deck.write(f"*ELEMENT, TYPE={kind}, ELSET=BODY\n")
    numbered = np.vstack([np.arange(1, cells.shape[1] + 1), cells])
    np.savetxt(deck, numbered.T, fmt="%d", delimiter=",")
    deck.write(f"*MATERIAL, NAME=M\n*ELASTIC\n{material.E!r},{material.nu!r}\n")
    deck.write(f"*SOLID SECTION, ELSET=BODY, MATERIAL=M\n{solution.thickness!r}\n")


def write_loads(deck: TextIO, solution: PlaneSolution, f: Array) -> None:
    """The forces `f` (unknowns,) on the deck's nodes."""
    dofs, number = deck_unknowns(solution), numbers(solution)
    deck.write("*CLOAD\n")
    for i in (0, 1):
        loaded = dofs[i, f[dofs[i]] != 0]
        deck.writelines(f"{number[dof]},{i + 1},{f[dof]:.12e}\n" for dof in loaded)


def numbers(solution: PlaneSolution) -> NDArray[np.int64]:
    """The deck's node number of every unknown, 0 where it has none."""
    dofs = deck_unknowns(solution)
    number = np.zeros(solution.basis.N, int)
    number[dofs] = np.arange(1, dofs.shape[1] + 1)
    return number


def deck_unknowns(solution: PlaneSolution) -> NDArray[np.int64]:
    """Unknowns (2, nodes) of the deck's nodes by number: vertices, then edges."""
    basis = solution.basis
    return np.hstack([np.asarray(basis.nodal_dofs), np.asarray(basis.facet_dofs)])


def deck_cells(solution: PlaneSolution) -> NDArray[np.int64]:
    """Node numbers (6 or 8, cells), counter-clockwise: corners, then edges."""
    mesh = solution.basis.mesh
    n = len(mesh.t)
    cells = 1 + np.vstack([mesh.t, solution.basis.nodal_dofs.shape[1] + np.asarray(mesh.t2f)])
    (a, b), (c, d) = np.diff(mesh.p[:, mesh.t[:3]], axis=1).swapaxes(0, 1)
    clockwise = a * d - b * c < 0
    turned = [0, *range(n - 1, 0, -1), *range(2 * n - 1, n - 1, -1)]
    cells[:, clockwise] = cells[:, clockwise][turned]
    return cells
