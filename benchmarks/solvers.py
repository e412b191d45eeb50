"""Solvers of this project against calculix and ROSS: errors, seconds, memory and lower time limits.

    python -m benchmarks.solvers [--runs 5] [contact] [plane] [rotor] [growth]

Both sides of a row run alternately with one thread. Times of "ours" are from the mesh in memory to
stresses; those of calculix from its deck to its results; those of rotors from matrices to
amplitudes. A ratio is the median over pairs of runs of the ratio of processor seconds. Wall seconds
are of little use if other work shares the machine. The limit is the time of a step that every
method needs: the factorisation (CHOLMOD), or the product of modes and modal amplitudes of a rotor.
Peak memory is that of the complete process for contact and plane, and of the arrays for the rotor.
"""

import argparse
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks import contact, hertz, plane, ring, rotor
from benchmarks.calculix_contact import Settings, write_deck
from benchmarks.processes import Used, measured
from verify.studies.crosscheck.calculix import running as calculix
from verify.studies.crosscheck.calculix.numbering import Numbering

AROUND = 134  # cells along the quarter of the ring: 1e5 unknowns
TRIED = tuple(Settings(slope=slope) for slope in (50, 150, 500))  # the best of `contact.TRIED`
SIZES = (42, 134, 232)  # cells along the quarter for `growth`: 1e4 to 3e5 unknowns


@dataclass(frozen=True)
class Run:
    """One run of one side: error, wall and processor seconds, peak [MB], seconds of the limit."""

    error: float
    wall: float
    cpu: float
    peak: float
    limit: float = float("nan")


def ours(run: dict[str, float], stages: dict[str, float], error: float) -> Run:
    return Run(error, run["seconds"], run["cpu"], run["peak"], stages["factorisation"])


def ccx(deck: Path) -> Used:
    """Run of calculix on a deck."""
    return measured([str(calculix.executable()), "-i", deck.stem], deck.parent)


def plane_runs(kind: str, around: int, runs: int) -> tuple[int, list[Run], list[Run]]:
    """The ring: number of unknowns, runs of this project and of calculix; error of the rim."""
    with tempfile.TemporaryDirectory() as folder:
        deck = Path(folder) / "ring.inp"
        unknowns = plane.ours(kind, around, deck)["unknowns"]
        here, there = [], []
        for _ in range(runs):
            run = plane.ours(kind, around)
            here.append(ours(run, run["stages"], abs(run["rim"] / ring.RIM_MOVES - 1)))
            there.append(ccx(deck))
        error = abs(rim(kind, around, deck) / ring.RIM_MOVES - 1)
    return unknowns, here, [Run(error, used.wall, used.cpu, used.peak) for used in there]


def rim(kind: str, around: int, deck: Path) -> float:
    """Displacement of the rim in the results of calculix."""
    basis = ring.solve_ring(ring.ring_mesh(kind, around)).basis  # type: ignore[arg-type]
    at = basis.doflocs[:, Numbering(basis).dofs[0]] - np.reshape(ring.RIM, (2, 1))
    u = calculix.Run(wall=0.0, cpu=0.0, deck=deck).u
    return float(u[int(np.argmin(np.hypot(*at))), 0])


def contact_runs(runs: int) -> tuple[int, list[Run], list[Run]]:
    """Two discs in contact; the error is the largest of peak pressure, width and approach."""
    peer = contact.Peer(hertz.CELLS, 1)
    found = [(how, peer.ask(how, limit=1e4)) for how in TRIED]
    how = contact.choose(found, contact.worst(hertz.own_errors(peer.solution)))
    error = contact.worst(dict(found)[how].errors)
    here, there = [], []
    with tempfile.TemporaryDirectory() as folder:
        deck = Path(folder) / "contact.inp"
        write_deck(deck, peer.solution, how)
        for _ in range(runs):
            run = contact.ours(hertz.CELLS, 1)
            here.append(ours(run, run["stages"], contact.worst(run["errors"])))
            used = ccx(deck)
            there.append(Run(error, used.wall, used.cpu, used.peak))
    return run["unknowns"], here, there


def rows(names: list[str], runs: int) -> Iterator[tuple[str, str, int, list[Run], list[Run]]]:
    """Name, other solver, number of unknowns and runs of each row."""
    if "contact" in names:
        yield "contact", "calculix", *contact_runs(runs)
    if "plane" in names:
        for kind in plane.KINDS:
            yield f"plane, {kind}", "calculix", *plane_runs(kind, AROUND, runs)
    if "rotor" in names and rotor.ross:
        for unlike in (False, True):
            for damped in (False, True):
                own, here, there = rotor.unbalance(unlike=unlike, damped=damped, runs=runs)
                name = f"rotor, {rotor.words(unlike=unlike, damped=damped)}"
                yield name, "ROSS", own, [Run(*r) for r in here], [Run(*r) for r in there]
    if "growth" in names:
        for kind in plane.KINDS:
            yield from growth(kind)


def growth(kind: str) -> Iterator[tuple[str, str, int, list[Run], list[Run]]]:
    """Print rows of increasingly fine meshes, and exponents of the processor seconds over size."""
    before: tuple[int, float, float] | None = None
    for around in SIZES:
        unknowns, here, there = plane_runs(kind, around, 1)
        yield f"plane, {kind}", "calculix", unknowns, here, there
        now = unknowns, here[0].cpu, there[0].cpu
        if before is not None:
            size, mine, other = (np.log(b / a) for a, b in zip(before, now, strict=True))
            print(f"| exponents from {before[0]} on | {mine / size:.2f}, {other / size:.2f} |")
        before = now


def spread(values: list[float]) -> str:
    return ", ".join(f"{v:.3g}" for v in (min(values), median(values), max(values)))


def line(name: str, peer: str, unknowns: int, here: list[Run], there: list[Run]) -> str:
    """A row of the table."""
    ratios = [b.cpu / a.cpu for a, b in zip(here, there, strict=True)]
    limit, cpu = median(r.limit for r in here), median(r.cpu for r in here)
    most = median(b.cpu for b in there) / limit
    return " | ".join([
        f"| {name} | {unknowns} | {here[0].error:.1e}, {peer} {there[0].error:.1e}",
        spread([r.cpu for r in here]), spread([r.cpu for r in there]), spread(ratios),
        f"{median(r.wall for r in here):.3g}, {median(r.wall for r in there):.3g}",
        f"{here[0].peak:.0f}, {there[0].peak:.0f}",
        f"{limit:.3g} ({100 * limit / cpu:.0f} %), at most {most:.1f} |",
    ])  # fmt: skip


def rate(work: float, run: Callable[[], object]) -> float:
    """The best rate of five runs, in 1e9 per second."""
    seconds = []
    for _ in range(5):
        start = time.process_time()
        run()
        seconds.append(time.process_time() - start)
    return work / min(seconds) / 1e9


def main() -> None:
    """Print the rates of the machine and the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    known = ["contact", "plane", "rotor", "growth"]
    parser.add_argument("names", nargs="*", choices=[[], *known])
    parser.add_argument("--runs", type=int, default=5)
    chosen = parser.parse_args()
    A, long = np.ones((1000, 1000)), np.ones(20_000_000)
    other = np.empty_like(long)
    print(
        f"Python {sys.version.split()[0]}, calculix {calculix.version()}; dense products "
        f"{rate(2e9, lambda: A @ A):.0f} GFlop/s, memory copied at "
        f"{rate(2.0 * long.nbytes, lambda: np.copyto(other, long)):.1f} GB/s"
    )
    print(
        "| problem | unknowns | errors | ours, processor s | other | ratio | wall s "
        "| peak MB | limit s |\n|---|---|---|---|---|---|---|---|---|"
    )
    for row in rows(chosen.names or known[:3], chosen.runs):
        print(line(*row), flush=True)


if __name__ == "__main__":
    main()
