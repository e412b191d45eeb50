"""A rotor of 132 unknowns here and in ROSS: Campbell diagram, and runs of the unbalance response.

    python -m benchmarks.rotor          # in an environment that has ross-rotordynamics, too

Two shafts with 22 nodes, 50 speeds of the Campbell diagram with six frequencies each and 1000 of
the unbalance response, on isotropic and on unlike supports, damped and not. Matrices are assembled
before the clock starts; processor seconds, of the diagram the best of three here and one run there.
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
    """The rotor here, and there; None where ROSS is not installed."""
    other = theirs(ross, unlike=unlike, damped=damped) if ross else None
    return ours(kappas(other) if ross else [0.88] * 20, unlike=unlike, damped=damped), other


def here(own: Any) -> Any:
    """Our amplitudes (unknowns, speeds)."""
    return unbalance_response(own, FINE, UNBALANCES).q.T


def there(other: Any) -> Any:
    """ROSS's amplitudes (unknowns, speeds)."""
    nodes, sizes = list(UNBALANCES), list(UNBALANCES.values())
    return other.run_unbalance_response(nodes, sizes, [0.0, 0.0], frequency=FINE).forced_resp


def unbalance(*, unlike: bool, damped: bool, runs: int) -> tuple[int, list[Run], list[Run]]:
    """The unbalance response: unknowns, and runs of both in turn."""
    own, other = pair(unlike=unlike, damped=damped)
    exact, found = refined(own), ([], [])
    for k in range(runs + 1):
        if k:  # a new rotor: ROSS stores what it finds of one, and its next run takes a tenth
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
    """The error over the size of a sample's motion, the median of the samples."""
    q = q[bending(len(q))][:, SAMPLES]
    exact = exact[bending(len(exact))]
    return float(np.median(np.linalg.norm(q - exact, axis=0) / np.linalg.norm(exact, axis=0)))


def peak(run: Callable[[], object]) -> float:
    """The most memory [MB] that a run allocates."""
    tracemalloc.start()
    run()
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return most / 1e6


def least(rotor: Any) -> float:
    """Seconds of one product of amplitudes of modes (speeds, n) with modes (n, n) by block."""
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
    """Campbell diagrams; the responses are rows of `benchmarks.solvers`."""
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
