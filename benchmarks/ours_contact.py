"""The contact of the benchmark in a separate process, with the time of each stage.

python -m benchmarks.ours_contact CELLS CELLS REFINE [friction]    prints JSON
"""

import json
import sys
import time
from collections.abc import Callable
from itertools import pairwise
from statistics import median
from typing import Any

from benchmarks import hertz
from benchmarks.ours import timed
from fem.contact import bodies, condensation, interface, unknowns
from fem.contact.complementarity import Complementarity
from fem.contact.condensation import Condensed
from fem.contact.solution import ContactSolution
from fem.plane.cells import Cells

PARTS = ("set-up", "first", "fields")  # in processor seconds
STEPS = 20
FARTHEST = 1.8e-6  # m, displacement at which the tangential force is 3/4 of its limit
SET_UP = {  # everything else is supports, motions, the Schur complement and loads
    "hand-over": (bodies, ("basis_for",)),
    "assembly": (Cells, ("of", "stiffness")),
    "ordering": (unknowns, ("nested_dissection",)),
    "factorisation": (condensation, ("Cholesky",)),
    "pairing": (interface, ("pair",)),
    "compliance": (bodies.Bodies, ("compliance",)),
    "active sets": (Complementarity, ("solve",)),
}
STEP = {  # everything else is bookkeeping
    "active sets": (Complementarity, ("solve",)),
    "back-substitution": (Condensed, ("inside", "load")),
}


def load_steps(mesh: Any) -> dict[str, Any]:
    """Times of the quarters: set-up, first solution, displacements and stresses, further loads."""
    stages: dict[str, float] = {}
    start, clock = time.perf_counter(), [time.process_time()]
    with timed(stages, SET_UP):
        problem = hertz.pressed(mesh)
        clock.append(time.process_time())
        solution = hertz.solve_pressed(problem)
        clock.append(time.process_time())
        solution.plane.cells()
    clock.append(time.process_time())
    seconds = time.perf_counter() - start
    stages["the rest"] = clock[-1] - clock[0] - sum(stages.values())
    parts = (after - before for before, after in pairwise(clock))
    answer = {
        "unknowns": int(problem.bodies.basis.N), "surface": problem.bodies.unknowns.surface,
        "seconds": seconds, "cpu": clock[-1] - clock[0], "stages": stages,
        "errors": hertz.own_errors(solution),
    } | dict(zip(PARTS, parts, strict=True))  # fmt: skip

    def step(i: int, after: ContactSolution) -> ContactSolution:
        load = -hertz.LOAD / 2 * (1 + i / (5 * STEPS))
        return problem.solve(forces={"upper.middle": (0.0, load)}, after=after)

    return answer | further(step, step(0, solution))


def friction_steps(mesh: Any) -> dict[str, Any]:
    """Times of the halves, first pressed, then loaded in the tangential direction."""
    problem = hertz.sheared(mesh)
    down = -2 * float(hertz.EXACT.approach)

    def step(i: int, after: ContactSolution | None) -> ContactSolution:
        moved = {"x": FARTHEST * i / STEPS, "y": down}
        return problem.solve(displacements={"upper.middle": moved}, after=after)

    used = []

    def pushed(i: int, after: ContactSolution) -> ContactSolution:
        solution = step(i, after)
        touch = solution.touches[0]
        used.append(abs(touch.friction_force) / (hertz.MU * touch.normal_force))
        return solution

    found = further(pushed, step(0, None))
    return found | {"unknowns": int(problem.bodies.basis.N), "friction used": used[-1]}


def further(
    step: Callable[[int, ContactSolution], ContactSolution], solution: ContactSolution
) -> dict[str, Any]:
    """Median seconds of a further step up to contact tractions; processor seconds of each stage."""
    seconds, cpu, parts = [], [], []
    solution = step(1, solution)  # stores the responses that later steps scale
    for i in range(1, STEPS + 1):
        stages: dict[str, float] = {}
        with timed(stages, STEP):
            start, begun = time.perf_counter(), time.process_time()
            solution = step(i, solution)
            solution.touches  # noqa: B018
            seconds.append(time.perf_counter() - start)
            cpu.append(time.process_time() - begun)
        parts.append(stages | {"the rest": cpu[-1] - sum(stages.values())})
    names = {name for part in parts for name in part}
    middle = {name: median(part.get(name, 0.0) for part in parts) for name in names}
    return {"step": median(seconds), "step cpu": median(cpu), "step stages": middle}


def main() -> None:
    upper, lower, refine, *friction = sys.argv[1:]
    mesh = hertz.discs((int(upper), int(lower)), int(refine), whole=bool(friction))
    print(json.dumps(friction_steps(mesh) if friction else load_steps(mesh)))


if __name__ == "__main__":
    main()
