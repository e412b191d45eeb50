"""A rotor of 132 unknowns in this project and in ROSS: Campbell diagram and unbalance response.

    python -m benchmarks.rotor          # in an environment with ross-rotordynamics

Two shafts with 22 nodes on isotropic and anisotropic supports, with and without damping. The
Campbell diagram has 50 speeds with six frequencies each; the unbalance response has 1000 speeds.
Times are processor seconds without the assembly of matrices. For the diagram, the time is the best
of three runs of this project, and one run of ROSS.
"""

import time
import tracemalloc
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from fem.rotor.campbell import campbell
from fem.rotor.response import unbalance_response
from tests.fem.rotor.rotor_ross import bending, kappas, ours, theirs  # the same rotors as the tests

try:
    import ross
except ImportError:
    ross = None

SPEEDS = np.linspace(0, 4000, 50)
FINE = np.linspace(4, 4000, 1000)
SAMPLES = range(0, FINE.size, 50)
UNBALANCES = {3: 1.4e-5, 18: 1e-5}
Run = tuple[float, float, float, float, float]  # error, wall s, processor s, peak MB, limit s


def words(*, unlike: bool, damped: bool) -> str:
    return f"{'unlike' if unlike else 'isotropic'}{', damped' if damped else ''}"


def pair(*, unlike: bool, damped: bool) -> tuple[Any, Any]:
    """The rotor in this project and in ROSS; None if ROSS is not installed."""
    other = theirs(ross, unlike=unlike, damped=damped) if ross else None
    return ours(kappas(other) if ross else [0.88] * 20, unlike=unlike, damped=damped), other


def here(own: Any) -> Any:
    """Amplitudes (unknowns, speeds) by this project."""
    return unbalance_response(own, FINE, UNBALANCES).q.T


def there(other: Any) -> Any:
    """Amplitudes (unknowns, speeds) by ROSS."""
    nodes, sizes = list(UNBALANCES), list(UNBALANCES.values())
    return other.run_unbalance_response(nodes, sizes, [0.0, 0.0], frequency=FINE).forced_resp


def unbalance(*, unlike: bool, damped: bool, runs: int) -> tuple[int, list[Run], list[Run]]:
    """Unbalance response: number of unknowns, and alternate runs of both."""
    own, other = pair(unlike=unlike, damped=damped)
    exact, found = refined(own), ([], [])
    for k in range(runs + 1):
        if k:  # a new rotor: ROSS stores results, and a second run takes a tenth
            own, other = pair(unlike=unlike, damped=damped)
        sides = partial(here, own), partial(there, other)
        if not k:
            facts = [(deviation(side(), exact), peak(side)) for side in sides]
            continue
        for (error, most), side, rows in zip(facts, sides, found, strict=True):
            rows.append((error, *seconds(side), most, least(own)))
    return len(own.K), found[0], found[1]


def refined(rotor: Any) -> Any:
    """Amplitudes (unknowns, samples) corrected by residuals of extended precision."""
    s, wide = rotor.system, np.clongdouble
    force = np.zeros(len(s.M), wide)
    for node, size in UNBALANCES.items():
        force[6 * node : 6 * node + 2] += size * np.array([1, -1j])
    found = []
    for w in FINE[SAMPLES].astype(wide):
        D = s.K + 1j * w * (s.C + w * s.G) - w**2 * s.M
        scale = 1 / np.sqrt(abs(np.diag(D)))
        inverse = np.linalg.inv((D * np.outer(scale, scale)).astype(complex))
        q = np.zeros(len(D), wide)
        for _ in range(8):
            q += scale * (inverse @ (scale * (w**2 * force - D @ q)).astype(complex))
        found.append(q.astype(complex))
    return np.array(found).T


def deviation(q: Any, exact: Any) -> float:
    """Median over the samples of the error relative to the size of the motion."""
    q = q[bending(len(q))][:, SAMPLES]
    exact = exact[bending(len(exact))]
    return float(np.median(np.linalg.norm(q - exact, axis=0) / np.linalg.norm(exact, axis=0)))


def peak(run: Callable[[], object]) -> float:
    """Peak memory [MB] allocated by a run."""
    tracemalloc.start()
    run()
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return most / 1e6


def least(rotor: Any) -> float:
    """Seconds of one product, block by block, of modal amplitudes (speeds, n) and modes (n, n)."""
    total = 0.0
    for block in rotor.blocks:
        if "bending" in block.planes and block.sense >= 0:
            n = block.at.size
            q, V = np.ones((FINE.size, n), complex), np.ones((n, n), complex)
            total += min(seconds(lambda q=q, V=V: q @ V)[1] for _ in range(3))
    return total


def seconds(run: Callable[[], object]) -> tuple[float, float]:
    """Wall and processor time of one run."""
    start, begun = time.perf_counter(), time.process_time()
    run()
    return time.perf_counter() - start, time.process_time() - begun


def main() -> None:
    """Print times of Campbell diagrams; `benchmarks.solvers` prints those of the responses."""
    if ross:  # its first run imports and compiles
        theirs(ross).run_campbell(SPEEDS[:2], frequencies=6)
    print(f"{'supports':<18} {'here':>9} {'ROSS':>9} {'ratio':>7}")
    for unlike in (False, True):
        for damped in (False, True):
            own, other = pair(unlike=unlike, damped=damped)
            mine = min(seconds(lambda own=own: campbell(own, SPEEDS, 6))[1] for _ in range(3))
            peer = np.nan
            if ross:
                peer = seconds(lambda other=other: other.run_campbell(SPEEDS, frequencies=6))[1]
            name = words(unlike=unlike, damped=damped)
            print(f"{name:<18} {mine:8.3f}s {peer:8.2f}s {peer / mine:6.0f}x", flush=True)


if __name__ == "__main__":
    main()
