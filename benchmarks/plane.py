"""Plane elasticity over the size: this project and calculix on the same mesh; `make bench`.

Both solvers run alternately as separate processes with one thread. This project is timed twice:
from the scikit-fem mesh in memory to displacements and the stress of every cell; and as a complete
process with the start of Python. calculix is timed as a complete process, which reads its deck and
writes displacements and stresses. Ratios are printed only if displacement and energy agree. Numbers
and plot are written to benchmarks/out.
"""

import json
import platform
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from benchmarks.plot import draw
from benchmarks.processes import run_module
from benchmarks.ring import RIM, RIM_MOVES, ring_mesh, solve_ring
from verify.studies.crosscheck.calculix import running as calculix
from verify.studies.crosscheck.calculix.numbering import Numbering

OUT = Path(__file__).parent / "out"
SIZES = {42: 5, 134: 3, 232: 2}  # cells along the quarter (1e4, 1e5, 3e5 unknowns): runs
KINDS = ("triangles", "quadrilaterals")
AGREE = 1e-4  # calculix prints six digits; its quadrilaterals have eight nodes, ours nine


def ours(kind: str, around: int, deck: Path | None = None) -> dict[str, Any]:
    """One run of the project's solver in a new process with one thread."""
    return run_module("benchmarks.ours", kind, around, *([] if deck is None else [deck]))


def check(kind: str, around: int, deck: Path) -> None:
    """RuntimeError unless the displacements of both solvers and Lamé, and both energies, agree."""
    ring = solve_ring(ring_mesh(kind, around))  # type: ignore[arg-type]
    dofs = Numbering(ring.basis).dofs
    theirs, here = calculix.run_deck(deck).u, ring.u[dofs].T
    rim = np.argmin(np.hypot(*(ring.basis.doflocs[:, dofs[0]] - np.reshape(RIM, (2, 1)))))
    energy = float(ring.f[dofs].T.ravel() @ theirs.ravel()), float(ring.f @ ring.u)
    differences = {
        "displacement": np.abs(theirs - here).max() / np.abs(here).max(),
        "energy": abs(energy[0] / energy[1] - 1),
        "displacement against Lamé": abs(theirs[rim, 0] / RIM_MOVES - 1),
    }
    for name, value in differences.items():
        if not value < AGREE:
            raise RuntimeError(f"{kind}, {around} around: {name} differs by {value:.1e}")
    print(f"agree to {max(differences.values()):.0e}", end="  ")


def measure(kind: str, around: int, peer: bool) -> dict[str, Any]:
    """Medians and minima of seconds, and ratios, of alternate runs of both solvers."""
    deck = OUT / f"{kind}-{around}.inp"
    ours(kind, around, deck)  # warms up, and writes the deck
    if peer:
        check(kind, around, deck)
    here, there = [], []
    for _ in range(SIZES[around]):
        here.append(ours(kind, around))
        if peer:
            there.append(calculix.run_deck(deck))
    row: dict[str, Any] = {"kind": kind, "unknowns": here[0]["unknowns"]}
    for key in ("seconds", "cpu", "process", "process cpu"):
        row[key] = sorted(run[key] for run in here)
    row["stages"] = {name: median(r["stages"][name] for r in here) for name in here[0]["stages"]}
    if peer:
        row["calculix"] = sorted(run.wall for run in there)
        row["calculix cpu"] = sorted(run.cpu for run in there)
        row["calculix 2 threads"] = calculix.run_deck(deck, threads=2).wall
        pairs = list(zip(here, there, strict=True))
        row["ratio"] = median(b.wall / a["seconds"] for a, b in pairs)
        row["ratio cpu"] = median(b.cpu / a["cpu"] for a, b in pairs)
        row["ratio of processes"] = median(b.wall / a["process"] for a, b in pairs)
    for file in OUT.glob(f"{deck.stem}.*"):
        file.unlink()
    return row


def print_row(row: dict[str, Any]) -> None:
    print(f"{row['kind']}, {row['unknowns']} unknowns")
    for side, wall in (("ours", "seconds"), ("ours", "process"), ("calculix", "calculix")):
        if wall in row:
            cpu = row["cpu" if wall == "seconds" else f"{wall} cpu"]
            what = {"seconds": "mesh to stresses", "process": "with Python's start"}.get(wall, "")
            t = median(row[wall]), row[wall][0], cpu[0]
            seconds = "median {:6.2f} s, min {:6.2f} s, processor {:6.2f} s".format(*t)
            print(f"    {side:9s}{what:20s} {seconds}")
    print("    " + ", ".join(f"{name} {value:.2f}" for name, value in row["stages"].items()))
    if "ratio" in row:
        print(
            f"    calculix / ours: {row['ratio']:.1f} wall, {row['ratio cpu']:.1f} processor, "
            f"{row['ratio of processes']:.1f} whole processes; "
            f"calculix on 2 threads {row['calculix 2 threads']:.2f} s"
        )


def main() -> None:
    OUT.mkdir(exist_ok=True)
    peer = calculix.executable() is not None
    words = (
        f"calculix {calculix.version()}, SPOOLES"
        if peer
        else "calculix is not installed: ours alone"
    )
    print(f"Python {platform.python_version()}, one thread each, runs in turn; {words}")
    rows = []
    for kind in KINDS:
        for around in SIZES:
            rows.append(measure(kind, around, peer))
            print_row(rows[-1])
    (OUT / "plane.json").write_text(json.dumps({"peer": words, "rows": rows}, indent=1), "utf-8")
    draw(rows, OUT / "plane.svg", OUT / "plane.png")


if __name__ == "__main__":
    main()
