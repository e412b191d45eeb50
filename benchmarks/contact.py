"""Hertz contact of two elastic bodies: this project and calculix on the same mesh; `make bench`.

Both solvers run alternately as separate processes with one thread. This project is timed twice:
from the scikit-fem mesh in memory to contact pressures, displacements and the stress of every cell;
and as a complete process with the start of Python. calculix is timed as a complete process, which
reads its deck and writes the same results. Meshing and writing the deck are reported, but not
included. Both are judged by the peak pressure, the half-width from the moment of the pressure, and
the approach of the centres.

calculix runs with many settings, which are all printed. The fastest of the most accurate settings
is compared. A separate row has discs whose initial overlap is as wide as the final contact:
calculix then has no contact to search, but this start requires the solution. Numbers and plot are
written to benchmarks/out.
"""

import json
import platform
import time
from dataclasses import replace
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks import hertz
from benchmarks.calculix_contact import Answer, Settings, run_deck, write_deck
from benchmarks.plot_contact import draw
from benchmarks.processes import run_module
from verify.studies.crosscheck.calculix import running as calculix

OUT = Path(__file__).parent / "out"
RUNS = 7
MINUTE = 60.0  # s
NEAR = 1.1  # errors up to this multiple of the smallest error are considered equal to it
# circles with the overlap a^2/R intersect at 2a: start from the solution
SOLVED_START = hertz.A**2 / hertz.R / (2 * hertz.EXACT.approach)
USUAL = Settings()
TRIED = (
    *(Settings(slope=slope) for slope in (5, 50, 100, 150, 500, 5000)),
    *(Settings(slope=slope, element="CPE8") for slope in (50, 150, 500)),
    *(replace(USUAL, start=start) for start in (0.0, 0.1, 0.5, 1.0)),
    replace(USUAL, increments=2),
    replace(USUAL, threads=2),
    *(replace(USUAL, solver=s) for s in ("ITERATIVE SCALING", "ITERATIVE CHOLESKY", "PARDISO")),
    replace(USUAL, pairing="SURFACE TO SURFACE, SMALL SLIDING"),
    replace(USUAL, pairing="NODE TO SURFACE"),
    replace(USUAL, pairing="MORTAR"),
    *(
        replace(USUAL, controls=f"*CONTROLS, PARAMETERS=CONTACT\n{change},.1,100,60")
        for change in (0.01, 0.1)
    ),
)
LADDER = (  # cells of both fine zones, refinement: 1e3 to 3e5 unknowns
    ((3, 2), 1), ((6, 5), 1), ((12, 10), 1), (hertz.CELLS, 1), (hertz.CELLS, 2), (hertz.CELLS, 3),
    (hertz.CELLS, 5),
)  # fmt: skip


def ours(cells: tuple[int, int], refine: int, *more: str) -> dict[str, Any]:
    """One run of the project's solver in a new process with one thread."""
    return run_module("benchmarks.ours_contact", *cells, refine, *more)


class Peer:
    """calculix on one mesh."""

    def __init__(self, cells: tuple[int, int], refine: int) -> None:
        start = time.perf_counter()
        mesh = hertz.discs(cells, refine)
        self.meshing = time.perf_counter() - start
        self.problem = hertz.pressed(mesh)
        self.solution = hertz.solve_pressed(self.problem)
        self.writing = 0.0

    def ask(self, how: Settings, limit: float = MINUTE) -> Answer:
        """Result of a run; RuntimeError if calculix fails."""
        with TemporaryDirectory() as folder:
            deck = Path(folder) / "contact.inp"
            start = time.perf_counter()
            write_deck(deck, self.solution, how)
            self.writing = time.perf_counter() - start
            return run_deck(deck, self.problem, self.solution.plane, how, limit)


def worst(errors: dict[str, float]) -> float:
    """The largest of the compared errors."""
    return max(abs(errors[name]) for name in ("p_0", "a", "approach"))


def error_list(errors: dict[str, float]) -> str:
    names = ("p_0", "a", "approach")
    return " ".join(f"{name} {errors[name]:+.1e}" for name in names)


def try_all(peer: Peer) -> list[tuple[Settings, Answer]]:
    """Run every setting once and print it; return the runs with a result."""
    found = []
    for how in (*TRIED, *(replace(USUAL, start=SOLVED_START, slope=s) for s in (50, 150, 500))):
        try:
            answer = peer.ask(how)
        except RuntimeError as error:
            reason = " ".join(str(error).split())[-90:]
            print(f"    {how!s:66s} no result: {reason}")
            continue
        found.append((how, answer))
        print(
            f"    {how!s:66s} {answer.run.wall:6.2f} s, processor {answer.run.cpu:6.2f} s, "
            f"{answer.iterations:3d} iterations, errors {error_list(answer.errors)}"
        )
    return found


def choose(found: list[tuple[Settings, Answer]], enough: float) -> Settings:
    """The fastest run with an error of at most `enough`; if there is none, the most accurate."""
    least = max(enough, NEAR * min(worst(answer.errors) for _, answer in found))
    near = [(answer.run.cpu, how) for how, answer in found if worst(answer.errors) <= least]
    return min(near, key=lambda pair: pair[0])[1]


def compare(peer: Peer, how: Settings, runs: int) -> dict[str, Any]:
    """Medians of seconds and of ratios of alternate runs of both solvers."""
    here, there = [], []
    for _ in range(runs):
        here.append(ours(hertz.CELLS, 1))
        there.append(peer.ask(how))
    pairs = list(zip(here, there, strict=True))
    row = {key: median(run[key] for run in here) for key in ("seconds", "cpu", "process")}
    row |= {
        "settings": str(how), "runs": runs, "ours": here[0]["errors"],
        "theirs": there[0].errors, "calculix": median(b.run.wall for b in there),
        "calculix cpu": median(b.run.cpu for b in there),
        "iterations": there[0].iterations,
        "wall": sorted(b.run.wall / a["seconds"] for a, b in pairs),
        "processor": sorted(b.run.cpu / a["cpu"] for a, b in pairs),
        "processes": sorted(b.run.wall / a["process"] for a, b in pairs),
    }  # fmt: skip
    ratios = ", ".join(
        f"{median(row[key]):.1f} ({row[key][0]:.1f} to {row[key][-1]:.1f}) {key}"
        for key in ("wall", "processor", "processes")
    )
    print(
        f"calculix with {how}\n"
        f"    ours      median {row['seconds']:6.3f} s, processor {row['cpu']:6.3f} s, "
        f"with Python's start {row['process']:5.2f} s; errors {error_list(row['ours'])}\n"
        f"    calculix  median {row['calculix']:6.3f} s, processor {row['calculix cpu']:6.3f} s, "
        f"{row['iterations']} iterations; errors {error_list(row['theirs'])}\n"
        f"    calculix / ours, {runs} runs in turn: {ratios}"
    )
    return row


def climb(how: Settings | None) -> list[dict[str, Any]]:
    """Processor seconds of both over the size; calculix up to the size that takes a minute."""
    rows: list[dict[str, Any]] = []
    for cells, refine in LADDER:
        runs = [ours(cells, refine) for _ in range(3 if refine < 3 else 1)]
        keys = ("set-up", "first", "fields", "step cpu", "cpu")
        row: dict[str, Any] = {key: median(run[key] for run in runs) for key in keys}
        row |= {key: runs[0][key] for key in ("unknowns", "surface", "errors", "stages")}
        if how is not None:
            try:
                answer = Peer(cells, refine).ask(how)
                row["calculix"] = answer.run.cpu
                row["calculix errors"] = answer.errors
            except RuntimeError as error:
                print(f"    {error}")
                how = None
        rows.append(row)
        peer = f", calculix {row['calculix']:.2f} s" if "calculix" in row else ""
        print(
            f"{row['unknowns']:7d} unknowns: set-up {row['set-up']:.3f} s, first solve "
            f"{row['first']:.3f} s, fields {row['fields']:.3f} s, further step "
            f"{1e3 * row['step cpu']:.2f} ms{peer}; errors {error_list(row['errors'])}"
        )
    return rows


def steps() -> dict[str, Any]:
    """Further steps on the condensed problem."""
    found = {"load": ours(hertz.CELLS, 1), "friction": ours(hertz.CELLS, 1, "friction")}
    for name, run in found.items():
        parts = ", ".join(f"{k} {1e3 * v:.2f}" for k, v in sorted(run["step stages"].items()))
        print(f"further {name} step, {run['unknowns']} unknowns: {1e3 * run['step']:.2f} ms")
        print(f"    ms: {parts}")
    used = found["friction"]["friction used"]
    print(f"    at the last friction step Q is {used:.2f} mu P")
    return found


def main() -> None:
    OUT.mkdir(exist_ok=True)
    there = calculix.executable() is not None
    name = f"calculix {calculix.version()}" if there else "calculix is not installed: ours alone"
    print(f"Python {platform.python_version()}, one thread each, runs in turn; {name}")
    result: dict[str, Any] = {"peer": name}
    how = None
    if there:
        peer = Peer(hertz.CELLS, 1)
        found = try_all(peer)
        enough = worst(hertz.own_errors(peer.solution))
        how = choose([(h, a) for h, a in found if h.start != SOLVED_START], enough)
        print(f"meshing {peer.meshing:.2f} s, writing the deck {peer.writing:.2f} s, not counted")
        result["tried"] = [
            {"settings": str(h), "wall": a.run.wall, "cpu": a.run.cpu, "errors": a.errors,
             "iterations": a.iterations} for h, a in found
        ]  # fmt: skip
        result["compared"] = compare(peer, how, RUNS)
        from_solution = choose([(h, a) for h, a in found if h.start == SOLVED_START], enough)
        print("started from the solution, which ours does not need:")
        result["from the solution"] = compare(peer, from_solution, RUNS)
    result["steps"] = steps()
    result["rows"] = climb(how)
    (OUT / "contact.json").write_text(json.dumps(result, indent=1), "utf-8")
    draw(result["rows"], OUT / "contact.svg", OUT / "contact.png")


if __name__ == "__main__":
    main()
