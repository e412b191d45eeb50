"""Cost of finite-element points of sweeps, and the time saved by each cache.

    OPENBLAS_NUM_THREADS=1 python -m benchmarks.points [points]

A point is solved on the three meshes of its portion. Each sweep runs alternately with and without
the data that earlier solutions leave in the process. Times are processor seconds. The results of
both are compared bit for bit.
"""

import itertools
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from fem.plane import discretisation, factors
from meshes.contact import blocks
from verify.cases.polyhedral import fem as polyhedral_fem
from verify.cases.polyhedral.inputs import HubRing
from verify.cases.polyhedral.ring.case import RING
from verify.cases.spring.accordion.case import ACCORDION, AccordionSpring
from verify.cases.spring.accordion.ends import PAPER
from verify.cases.spring.accordion.reference import line_of
from verify.core.case import Portion

Run = Callable[[Any], Any]
POINTS = 20
CACHES: dict[str, Any] = {
    "topologies": blocks.TOPOLOGIES,
    "numbers of unknowns": discretisation.NUMBERS,
    "factors": factors.FACTORS,
}


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    ring, spring = RING.portions[0], ACCORDION.portions[0]
    print(f"{count} points of each sweep, seconds of one processor a point of three meshes")
    shape, load, modulus = rings(count), loads(count), moduli(count)
    table = (
        ("ring's K: wall, fillet", shape, solved(ring), ("topologies", "numbers of unknowns")),
        ("ring's K: E", modulus, solved(ring), ("factors",)),
        ("ring's K: E", modulus, solved(ring), tuple(CACHES)),
        ("hub's force: R_b and tan φ", load, pushed, ("factors",)),
    )
    for name, points, run, what in table:
        cached, cleared = both(points, run, what)
        print(f"{name:28} {cached:.3f} s, {cleared:.3f} s without {', '.join(what)}: "
              f"{cleared / cached:.2f} times as long")  # fmt: skip
    springs = [spring_of(n, b) for n, b in grid(count, (4, 10, 16), np.linspace(6e-5, 2e-4, 9))]
    print_levels(ring, shape, unknowns)
    print_levels(spring, springs, frame_unknowns)


def print_levels(portion: Portion, points: Sequence[Any], size: Callable[[Any, int], int]) -> None:
    """Print median seconds of each level of a portion over `points`, and unknowns of the first."""
    for level in portion.levels:
        seconds = []
        for q in points:
            start = time.process_time()
            portion.fem(q, level)
            seconds.append(time.process_time() - start)
        print(f"{portion.name:4} level {level:2}: {np.median(seconds) * 1e3:6.1f} ms, "
              f"{size(points[0], level)} unknowns")  # fmt: skip


def grid(count: int, *axes: Iterable[float]) -> list[tuple[Any, ...]]:
    """`count` evenly distributed points of the grid over `axes`."""
    whole = list(itertools.product(*axes))
    return [whole[k] for k in np.linspace(0, len(whole) - 1, count).astype(int)]


def rings(count: int) -> list[HubRing]:
    """Rings with small differences in wall and fillet, like neighbouring points of a sweep."""
    walls, fillets = np.linspace(3.8e-3, 4.2e-3, 5), np.linspace(1.8e-3, 2.2e-3, count)
    return [ring_of(delta_1=wall, rho=rho) for wall, rho in grid(count, walls, fillets)]


def moduli(count: int) -> list[HubRing]:
    """One ring with several materials."""
    return [ring_of(E=E) for E in np.linspace(70e9, 210e9, count)]


def loads(count: int) -> list[HubRing]:
    """One ring under several forces of its hub."""
    return [ring_of(R_b=R, tan_phi=t) for R, t in grid(count, (1e5, 2e5, 3e5), (0.0, 0.03, 0.06))]


def ring_of(**changes: Any) -> HubRing:
    return HubRing().model_copy(update=changes)


def spring_of(n: int, b: float) -> AccordionSpring:
    return AccordionSpring().model_copy(update={"n": n, "b": b})


def solved(portion: Portion) -> Run:
    """All levels of a portion at a point."""
    return lambda q: [portion.fem(q, level).values for level in portion.levels]


def pushed(q: HubRing) -> list[list[float]]:
    """Displacements under both loads of the hub on three meshes."""
    return [s.u.tolist() for level in (1, 2, 3) for s in polyhedral_fem.pushed_fem(q, level)]


def both(points: Sequence[Any], run: Run, what: Sequence[str]) -> tuple[float, float]:
    """Mean seconds per point, with all caches and without `what`, in alternate runs."""
    with_all, without, without_too, with_all_too = (
        sweep(points, run, names) for names in ((), what, what, ())
    )
    if with_all[1] != without[1]:
        raise RuntimeError(f"another result without {what}")
    cached, cleared = with_all[0] + with_all_too[0], without[0] + without_too[0]
    return cached / 2 / len(points), cleared / 2 / len(points)


def sweep(points: Sequence[Any], run: Run, without: Sequence[str]) -> tuple[float, list[Any]]:
    """Seconds and values of all points, without caching for the functions `without`."""
    most = {name: CACHES[name].most for name in without}
    for cache in CACHES.values():
        cache.kept.clear()
    for name in without:
        CACHES[name].most = 0
    start = time.process_time()
    values = [run(q) for q in points]
    seconds = time.process_time() - start
    for name in without:
        CACHES[name].most = most[name]
    return seconds, values


def unknowns(q: HubRing, level: int) -> int:
    return int(polyhedral_fem.pressed_fem(q, level, "plane stress", polyhedral_fem.ARC).u.size)


def frame_unknowns(q: AccordionSpring, level: int) -> int:
    return 3 * len(line_of(q.held(PAPER), level).points)


if __name__ == "__main__":
    main()
