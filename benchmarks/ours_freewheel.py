"""One pitch of the freewheel of the benchmark in a separate process, with the time of each stage.

python -m benchmarks.ours_freewheel CELLS [rest]    prints JSON; with `rest`, rotations are searched
"""

import json
import sys
import time
from itertools import pairwise
from typing import Any

from benchmarks import sector
from benchmarks.ours import timed
from benchmarks.ours_contact import SET_UP
from fem.wedge.flat import Sector

PARTS = ("set-up", "first", "fields")  # in processor seconds


def solved(cells: int) -> dict[str, Any]:
    """Solution from the mesh to forces, half-widths, pressures, displacements and stresses."""
    mesh = sector.pitch(cells)
    stages: dict[str, float] = {}
    start, clock = time.perf_counter(), [time.process_time()]
    with timed(stages, SET_UP):
        problem = sector.posed(mesh)
        clock.append(time.process_time())
        solution = sector.turned(problem)
        clock.append(time.process_time())
        found = sector.found(solution)
        solution.plane.cells()
    clock.append(time.process_time())
    seconds = time.perf_counter() - start
    stages["the rest"] = clock[-1] - clock[0] - sum(stages.values())
    times = dict(zip(PARTS, (after - before for before, after in pairwise(clock)), strict=True))
    return {
        "unknowns": int(problem.bodies.basis.N), "stages": stages, "found": found,
        "times": times | {"seconds": seconds, "cpu": clock[-1] - clock[0]},
    }  # fmt: skip


def steered(cells: int) -> dict[str, Any]:
    """Seconds of the search for the rotations of star and ring, with meshing and set-up.

    The first mesh of a process includes the time to load the mesh generator.
    """
    sector.pitch(cells)
    start, begun = time.perf_counter(), time.process_time()
    Sector(sector.PLACE, sector.WIDTHS, cells, mu=sector.MU).rest()
    seconds, cpu = time.perf_counter() - start, time.process_time() - begun
    return {"times": {"seconds": seconds, "cpu": cpu}}


def main() -> None:
    cells, *rest = sys.argv[1:]
    print(json.dumps(steered(int(cells)) if rest else solved(int(cells))))


if __name__ == "__main__":
    main()
