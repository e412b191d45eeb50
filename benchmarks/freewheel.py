"""One pitch of a roller freewheel with friction: this project and calculix on the same mesh.

Both solvers run alternately as separate processes with one thread (`make bench`). This project is
timed twice: from the scikit-fem mesh in memory to torque, contact forces, pressures, half-widths,
displacements and the stress of every cell; and as a complete process with the start of Python.
calculix is timed as a complete process, which reads its deck and writes the same results; its start
time is printed. Meshing and writing the deck are not included. Both are judged by the solution of
this project on a mesh six times as fine.

calculix runs with many settings, which are all printed. The fastest of the settings nearest to the
reference is compared. Numbers and plot are written to benchmarks/out.
"""

import json
import os
import platform
import time
from dataclasses import replace
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks import sector
from benchmarks.calculix_freewheel import Answer, Deck, Settings
from benchmarks.plot_freewheel import draw
from benchmarks.processes import run_module
from verify.studies.crosscheck.calculix import running as calculix

OUT = Path(__file__).parent / "out"
RUNS = 5
MINUTE, PATIENT = 60.0, 600.0  # s
NEAR = 1.1  # errors up to this multiple of the smallest error are considered equal to it
LOST = (
    0.5  # larger relative error of torque: the contacts are open, although calculix has converged
)
USUAL = Settings()
TRIED = (
    *(Settings(slope=slope) for slope in (5, 15, 30, 50, 70, 100, 150)),
    *(replace(USUAL, stick=stick) for stick in (0.02, 0.1, 1.0)),
    *(Settings(slope=slope, stick=0.05) for slope in (30, 100)),
    replace(USUAL, element="CPE8"),
    replace(USUAL, increments=2),
    replace(USUAL, increments=10, cut=True),
    replace(USUAL, threads=2),
    *(replace(USUAL, solver=solver) for solver in ("ITERATIVE CHOLESKY", "PARDISO")),
    replace(USUAL, pairing="SURFACE TO SURFACE, SMALL SLIDING"),
    replace(USUAL, pairing="NODE TO SURFACE"),
    replace(USUAL, pairing="MORTAR"),
    replace(USUAL, controls="*CONTROLS, PARAMETERS=CONTACT\n0.01,.1,100,60"),
)
LADDER = (4, sector.CELLS, 9, 13, 18, 26)  # 5e3 to 7e4 unknowns
TIMES = ("set-up", "first", "fields", "seconds", "cpu", "process")
Errors = dict[str, float]


class Peer:
    """calculix on one mesh, judged by `reference`."""

    def __init__(self, cells: int, reference: dict[str, float]) -> None:
        start = time.perf_counter()
        mesh = sector.pitch(cells)
        self.meshing = time.perf_counter() - start
        problem = sector.posed(mesh)
        solution = sector.turned(problem)
        self.unknowns = int(problem.bodies.basis.N)
        self.torque = sector.found(solution)["T"]
        self.deck, self.reference, self.writing = Deck(problem, solution), reference, 0.0

    def ask(self, how: Settings, limit: float = MINUTE) -> tuple[Answer, Errors]:
        """A run and its errors; RuntimeError if calculix fails or the contacts open."""
        with TemporaryDirectory() as folder:
            path = Path(folder) / "freewheel.inp"
            start = time.perf_counter()
            self.deck.write(path, how)
            self.writing = time.perf_counter() - start
            answer = self.deck.run(path, how, limit)
        errors = sector.errors(answer.found, self.reference)
        if abs(errors["T"]) > LOST:
            raise RuntimeError(
                f"comes to rest with the contacts open, after {answer.iterations} iterations"
            )
        return answer, errors


def error_list(errors: Errors) -> str:
    return f"{sector.worst(errors):.1e} (" + ", ".join(
        f"{name} {errors[name]:+.0e}" for name in sector.JUDGED) + ")"  # fmt: skip


def try_all(peer: Peer) -> list[tuple[Settings, Answer, Errors]]:
    """Run every setting once and print it; return the runs with a result."""
    found = []
    for how in (*TRIED, replace(USUAL, given=peer.torque)):
        try:
            answer, errors = peer.ask(how)
        except (RuntimeError, ValueError, LookupError) as error:
            print(f"    {how!s:60s} no result: {' '.join(str(error).split())[-90:]}", flush=True)
            continue
        found.append((how, answer, errors))
        print(
            f"    {how!s:60s} {answer.run.wall:6.2f} s, processor {answer.run.cpu:6.2f} s, "
            f"{answer.iterations:3d} iterations, error {error_list(errors)}", flush=True
        )  # fmt: skip
    return found


def choose(found: list[tuple[Settings, Answer, Errors]], enough: float) -> Settings:
    """The fastest run with an error of at most `enough`; if there is none, the most accurate."""
    own = [(how, answer, sector.worst(errors)) for how, answer, errors in found if not how.given]
    least = max(enough, NEAR * min(error for _, _, error in own))
    near = [(answer.run.cpu, how) for how, answer, error in own if error <= least]
    return min(near, key=lambda pair: pair[0])[1]


def ours(cells: int, *more: str) -> dict[str, Any]:
    """One run of the project's solver in a new process with one thread."""
    run = run_module("benchmarks.ours_freewheel", cells, *more)
    return {**run, **run["times"]}


def compare(peer: Peer, how: Settings) -> dict[str, Any]:
    """Medians of seconds and of ratios of alternate runs of both solvers."""
    here, there = [], []
    for _ in range(RUNS):
        here.append(ours(sector.CELLS))
        there.append(peer.ask(how, PATIENT)[0])
    pairs = list(zip(here, there, strict=True))
    row: dict[str, Any] = {key: median(run[key] for run in here) for key in TIMES}
    row |= {
        "settings": str(how), "runs": RUNS, "unknowns": peer.unknowns,
        "ours": here[0]["found"], "theirs": there[0].found,
        "ours errors": sector.errors(here[0]["found"], peer.reference),
        "theirs errors": sector.errors(there[0].found, peer.reference),
        "difference": sector.errors(there[0].found, here[0]["found"]),
        "calculix": median(b.run.wall for b in there),
        "calculix cpu": median(b.run.cpu for b in there), "iterations": there[0].iterations,
        "wall": sorted(b.run.wall / a["seconds"] for a, b in pairs),
        "processor": sorted(b.run.cpu / a["cpu"] for a, b in pairs),
        "processes": sorted(b.run.wall / a["process"] for a, b in pairs),
    }  # fmt: skip
    ratios = ", ".join(
        f"{median(row[key]):.1f} ({row[key][0]:.1f} to {row[key][-1]:.1f}) {key}"
        for key in ("wall", "processor", "processes")
    )
    print(
        f"calculix with {how}, {peer.unknowns} unknowns\n"
        f"    ours      median {row['seconds']:6.3f} s, processor {row['cpu']:6.3f} s, "
        f"with Python's start {row['process']:5.2f} s\n"
        f"    calculix  median {row['calculix']:6.3f} s, processor {row['calculix cpu']:6.3f} s, "
        f"{row['iterations']} iterations\n"
        f"    calculix / ours, {RUNS} runs in turn: {ratios}"
    )
    return row


def table(reference: dict[str, float], row: dict[str, Any]) -> None:
    """Errors of both solvers and their difference for each quantity."""
    print(f"    {'':20s} {'reference':>12s} {'ours':>10s} {'calculix':>10s} {'difference':>10s}")
    sides = "ours errors", "theirs errors", "difference"
    for name, words in sector.JUDGED.items():
        value = "" if name == "centre" else f"{reference[name]:.6g}"
        three = " ".join(f"{row[k][name]:+10.1e}" for k in sides)
        print(f"    {words:20s} {value:>12s} {three}")


def climb(how: Settings | None, reference: dict[str, float]) -> list[dict[str, Any]]:
    """Processor seconds of both over the size; calculix up to the size that takes a minute."""
    rows: list[dict[str, Any]] = []
    for cells in LADDER:
        runs = [ours(cells) for _ in range(3)]
        row: dict[str, Any] = {key: median(run[key] for run in runs) for key in TIMES}
        row |= {"cells": cells, "unknowns": runs[0]["unknowns"]}
        row["errors"] = sector.errors(runs[0]["found"], reference)
        rest = [ours(cells, "rest")["cpu"] for _ in range(3)]
        row["rest"] = median(rest)
        peer = ""
        if how is not None:
            try:
                answer, errors = Peer(cells, reference).ask(how)
                row |= {"calculix": answer.run.cpu, "calculix errors": errors}
                peer = f", calculix {row['calculix']:.2f} s, error {sector.worst(errors):.1e}"
            except RuntimeError as error:
                peer, how = f", calculix no longer: {error}", None
        rows.append(row)
        print(
            f"{row['unknowns']:7d} unknowns: set-up {row['set-up']:.3f} s, solve "
            f"{row['first']:.3f} s, fields {row['fields']:.3f} s, error "
            f"{sector.worst(row['errors']):.1e}; with meshing and search for the place at rest "
            f"{row['rest']:.2f} s{peer}", flush=True
        )  # fmt: skip
    return rows


def main() -> None:
    OUT.mkdir(exist_ok=True)
    there = calculix.executable() is not None
    name = f"calculix {calculix.version()}" if there else "calculix is not installed: ours alone"
    print(f"Python {platform.python_version()}, one thread each, runs in turn; {name}")
    print(f"load of the machine before: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    reference = sector.found(sector.turned(sector.posed(sector.pitch(sector.FINE))))
    result: dict[str, Any] = {"peer": name, "reference": reference, "load": os.getloadavg()}
    how = None
    if there:
        peer = Peer(sector.CELLS, reference)
        found = try_all(peer)
        own = sector.found(sector.turned(sector.posed(sector.pitch())))
        how = choose(found, sector.worst(sector.errors(own, reference)))
        print(
            f"meshing {peer.meshing:.2f} s, writing the deck {peer.writing:.2f} s, not counted; "
            f"calculix starts within {calculix.start():.3f} s"
        )
        result["tried"] = [
            {"settings": str(h), "wall": a.run.wall, "cpu": a.run.cpu, "errors": e,
             "iterations": a.iterations} for h, a, e in found
        ]  # fmt: skip
        result["compared"] = compare(peer, how)
        table(reference, result["compared"])
    result["rows"] = climb(how, reference)
    (OUT / "freewheel.json").write_text(json.dumps(result, indent=1), "utf-8")
    draw(result, OUT / "freewheel.svg", OUT / "freewheel.png")


if __name__ == "__main__":
    main()
