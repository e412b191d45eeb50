"""One solution of the ring of the benchmark in a separate process, with the time of each stage.

python -m benchmarks.ours KIND AROUND [DECK]    prints JSON; with DECK writes it for calculix
"""

import json
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

from benchmarks.ring import ASSUMPTION, RIM, STEEL, ring_mesh, solve_ring
from fem.plane import factors, solve
from fem.plane.cells import Cells
from verify.studies.crosscheck.calculix.plane import PlaneDeck

# Everything else is loads, supports and the checks of them.
STAGES = {
    "hand-over": (solve, ("basis_for",)),
    "assembly": (Cells, ("of", "stiffness")),
    "factorisation": (factors, ("Cholesky",)),
    "corrections": (Cells, ("internal_forces",)),
}


@contextmanager
def timed(
    stages: dict[str, float], table: Mapping[str, tuple[Any, tuple[str, ...]]]
) -> Iterator[None]:
    """Add the processor seconds of each stage of `table` (owner, names) that runs to `stages`."""

    def watched(stage: str, run: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any, **more: Any) -> Any:
            start = time.process_time()
            try:
                return run(*args, **more)
            finally:
                stages[stage] = stages.get(stage, 0.0) + time.process_time() - start

        return call

    with ExitStack() as patches:
        for stage, (owner, names) in table.items():
            for name in names:
                patches.enter_context(
                    patch.object(owner, name, watched(stage, getattr(owner, name)))
                )
        yield


def main() -> None:
    kind, around, *deck = sys.argv[1:]
    mesh = ring_mesh(kind, int(around))  # type: ignore[arg-type]
    stages: dict[str, float] = {}
    start, cpu = time.perf_counter(), time.process_time()
    with timed(stages, STAGES):
        ring = solve_ring(mesh)
    solved = time.process_time()
    ring.cells()
    seconds, end = time.perf_counter() - start, time.process_time()
    stages["stresses"] = end - solved
    stages["the rest"] = end - cpu - sum(stages.values())
    answer = {
        "unknowns": int(ring.basis.N), "seconds": seconds, "cpu": end - cpu,
        "stages": stages, "rim": ring.displacement_at(RIM)[0],
        "energy": float(ring.f @ ring.u) / 2,
    }  # fmt: skip
    if deck:
        written = PlaneDeck(solution=ring, materials=STEEL, assumption=ASSUMPTION, brief=True)
        written.write(Path(deck[0]))
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
