"""1000 finite-element points on processes and on a dask cluster of this machine.

    python -m benchmarks.sweep [--points N]

Runs are cold: nothing is stored before, and each process imports its modules. The sweeps are K of
the polyhedral ring over flats, wall and fillet, and k_1 of the accordion spring over segments and
thickness. Both engines must give identical numbers. Two processes are compared with one.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

from meshes.polyhedral.half_sector import half_sector
from meshes.spring.centre_line import centre_line
from verify.cases.registry import CASES, find
from verify.core.case import Case
from verify.core.inputs import Inputs
from verify.jobs.executor import Where
from verify.studies.sweep.axes import changed
from verify.studies.sweep.pairs import portion, selected
from verify.studies.sweep.plan import Plan, grid
from verify.studies.sweep.run import Solved, solve

RING, SPRING = "K in the middle of the flats", "stiffness of the paper's lengths"


def ring_plan(count: int) -> Plan:
    """K over z, wall and fillet; about `count` points."""
    n = max(2, round((count / 10) ** 0.5))
    case = find("polyhedral-ring", CASES)
    inputs = changed(case.inputs(), {"e": 2e-3})
    vary = ["z=3:12:10", f"delta_1=2mm:8mm:{n}", f"rho=1mm:4mm:{n}"]
    return grid(case, "ring", inputs, selected(case, [RING]), vary)


def spring_plan(count: int) -> Plan:
    """k_1 over n and b; about `count` points."""
    case = find("spring-accordion", CASES)
    chosen = [p for p in selected(case, []) if p.fem in case.portions[0].keys][:1]
    vary = ["n=4:22:10", f"b=0.05mm:0.2mm:{max(2, count // 10)}"]
    return grid(case, "spring", case.inputs(), tuple(chosen), vary)


def unknowns(plan: Plan) -> int:
    """Unknowns of the three meshes of a point, at the inputs of the file."""
    q, part = plan.inputs, portion(plan.case, plan.chosen)
    return sum(_unknowns(plan.case, q, level) for level in part.levels)


def _unknowns(case: Case, q: Inputs, level: int) -> int:
    if case.id == "polyhedral-ring":
        from verify.cases.polyhedral.fem import ARC

        g = {"z": q.z, "d_e": q.d_e, "d_i": q.d_i, "fillet": q.rho}  # type: ignore[attr-defined]
        return 2 * int(half_sector(**g, refine=level, arc=ARC).p.shape[1])
    path = q.paper_path  # type: ignore[attr-defined]
    line = centre_line(**path, tail="arc", per_arc=level, per_leaf=max(1, level // 2))
    return 3 * len(line.points)


def measured(plan: Plan, where: Where) -> tuple[Solved, float]:
    """The sweep solved without stored results, and its seconds."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        solved = solve(plan, where, folder=Path(folder))
        return solved, time.perf_counter() - start


def numbers(solved: Solved) -> list[str]:
    """Results of a sweep without its times."""
    return [
        repr((one.formulas, one.h, one.fe, one.u_it, one.problem_fe)) for one in solved.solutions
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--points", type=int, default=1000)
    count = parser.parse_args().points
    print(
        f"{'sweep':8} {'engine':10} {'points':>6} {'unknowns':>8} {'wall':>8} {'a point':>8} "
        "overhead"
    )
    for plan in (ring_plan(count), spring_plan(count)):
        found: dict[str, tuple[Solved, float]] = {}
        for name, where in (
            ("1 local", Where(1)), ("2 local", Where(2)), ("2 dask", Where(2, "dask")),
        ):  # fmt: skip
            if name == "1 local":
                few = np.linspace(0, len(plan.points) - 1, max(8, len(plan.points) // 5))
                part = Plan(
                    plan.case, plan.name, plan.inputs, plan.chosen, plan.points[few.astype(int)],
                    axes=plan.axes,
                )  # fmt: skip
                found[name] = measured(part, where)
            else:
                found[name] = measured(plan, where)
            solved, seconds = found[name]
            each = solved.timing.busy / max(solved.timing.points, 1)
            print(
                f"{plan.name:8} {name:10} {solved.timing.points:6} {unknowns(plan):8} "
                f"{seconds:7.1f}s {1e3 * each:6.1f}ms {solved.timing.overhead:.1%}", flush=True,
            )  # fmt: skip
        same = numbers(found["2 local"][0]) == numbers(found["2 dask"][0])
        rate = [n.timing.points / s for n, s in (found["2 local"], found["1 local"])]
        print(f"{plan.name:8} same numbers: {same}; two processes {rate[0] / rate[1]:.2f} x one")


if __name__ == "__main__":
    main()
