"""Run time of the search for the optimal crown of a sprag clutch, with and without kriging.

    python -m benchmarks.optimum

The clutch of the paper under 25 N m, with the bounds of Eq. 19: 125 engagements in two processes,
first with compilation (empty cache), then without; separate kriging of the end and the rest;
genetic algorithm and differential evolution on the surrogate; further designs until the surrogate
agrees with the engagement. For comparison, DIRECT on engagements without surrogate: the number of
engagements to reach the same pressure. Each process has one thread.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.sprag.best_crown import answers, fit_regimes, infilled
from analytic.surrogate.designs import full_factorial
from analytic.surrogate.evolution import evolve
from analytic.surrogate.genetic import genetic
from verify.cases.sprag.optimum.deep import direct_fem
from verify.cases.sprag.optimum.inputs import Optimum25Inputs
from verify.cases.sprag.peaks import peaks_fem

JOBS = 2
ENGAGEMENTS = 400  # number of engagements for DIRECT
AS_GOOD = (1.01, 1.005, 1.002, 1.001, 1.0)  # multiples of the final pressure by kriging
COLD = "--factorial"  # a separate run: the engagements of the factorial, seconds printed


def main() -> None:
    if COLD in sys.argv:
        print(factorial_seconds())
        return
    with tempfile.TemporaryDirectory() as empty:
        factorial = subprocess.run(  # noqa: S603
            [sys.executable, "-m", "benchmarks.optimum", COLD], capture_output=True, text=True,
            check=True, env=os.environ | {"NUMBA_CACHE_DIR": empty},
        )  # fmt: skip
    print(f"125 engagements, {JOBS} processes, compiled first: {float(factorial.stdout):6.1f} s")
    by_kriging, pressure = surrogate()
    directly(pressure, by_kriging)


def factorial_seconds() -> float:
    """Seconds of the engagements of the factorial design."""
    q = Optimum25Inputs()
    start = time.perf_counter()
    peaks_fem(q, full_factorial(q.box, q.levels), [q.T], jobs=JOBS)
    return time.perf_counter() - start


def surrogate() -> tuple[float, float]:
    """Seconds of the complete solution by kriging, and its final pressure [Pa]."""
    q = Optimum25Inputs()
    x = full_factorial(q.box, q.levels)
    peaks_fem(q, x[:1], [q.T])  # compiled
    peaks, warm = timed(lambda: peaks_fem(q, x, [q.T], jobs=JOBS))
    known = answers(peaks)
    first, fitted = timed(lambda: fit_regimes(x, known, q.box))
    ga, bred = timed(lambda: genetic(first.predict, q.box))
    de, evolved = timed(lambda: evolve(first.predict, q.box))
    last, filled = timed(lambda: infilled(
        q.box, x, known, lambda crown: answers(peaks_fem(q, crown[None], [q.T]))[0], first
    ))  # fmt: skip
    whole = warm + fitted + filled
    for words, seconds in (
        (f"125 engagements, {JOBS} processes, compiled", warm),
        ("kriging of two regimes", fitted),
        (f"genetic algorithm, {ga.evaluations:,} points: {ga.value / 1e6:.2f} MPa", bred),
        (f"differential evolution, {de.evaluations:,} points: {de.value / 1e6:.2f} MPa", evolved),
        (f"{len(last.history)} rounds until the true model agrees: {last.true / 1e6:.2f} MPa",
         filled),
        ("engagements, kriging and these rounds", whole),
    ):  # fmt: skip
        print(f"  {words:66} {seconds:6.2f} s")
    return whole, last.true


def directly(pressure: float, by_kriging: float) -> None:
    """DIRECT on engagements: number and seconds until the pressure is near that of kriging."""
    found, seconds = timed(lambda: direct_fem(Optimum25Inputs())["direct"])
    lowest = np.minimum.accumulate(found[:, 3])
    each = seconds / len(found)
    print(f"DIRECT on {len(found)} engagements, one process: {lowest[-1] / 1e6:.2f} MPa, "
          f"{seconds:.1f} s")  # fmt: skip
    for times in AS_GOOD:
        below = np.flatnonzero(lowest <= times * pressure)
        if not len(below):
            print(f"  {times - 1:+.1%} of kriging's pressure: not reached")
            continue
        n = int(below[0]) + 1
        print(f"  {times - 1:+.1%} of kriging's pressure: {n} engagements, {n * each:.1f} s, "
              f"{n * each / by_kriging:.2f} times kriging's time")  # fmt: skip


def timed(run: Callable[[], Any]) -> tuple[Any, float]:
    start = time.perf_counter()
    found = run()
    return found, time.perf_counter() - start


if __name__ == "__main__":
    main()
