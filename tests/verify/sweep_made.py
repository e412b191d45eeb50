"""Sweeps of an invented case with errors defined by a test, and a file of a ring."""

from concurrent.futures import Future
from contextlib import contextmanager

import numpy as np

from verify.core.case import Case, FemResult
from verify.core.inputs import Inputs, count, quantity
from verify.jobs.engine import Engine
from verify.jobs.executor import Here as Executor
from verify.jobs.executor import Where, local
from verify.jobs.processes import WorkerDiedError
from verify.judging.checks import Approximation
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.pairs import portion, selected
from verify.studies.sweep.point import Solution
from verify.studies.sweep.run import Solved, Timing

RING = """
case = "polyhedral-ring"
[inputs]
d_e = "80 mm"
delta_1 = "4 mm"
j_D = "0.06 mm"
E = "210 GPa"
nu = 0.3
z = 6
rho = "2 mm"
e = "2 mm"
R_b = "200 N/mm"
tan_phi = 0.05
"""


class Plate(Inputs):
    a: float = quantity("4 mm", "mm", "a", "length", gt=0)
    b: float = quantity("2 mm", "mm", "b", "width", gt=0)
    c: float = quantity("1 mm", "mm", "c", "thickness, which nothing depends on", gt=0)
    n: int = count(3, "n", "holes", ge=1)


def formulas(q):
    return {"k": 1e3 * q.a / q.b, "s": 1e6 * (q.n - 3)}


def fem(q, level):
    """The stiffness is off by 10 of (a / 40 mm)², second order; nothing fits more than 8 holes."""
    if q.n > 8:
        raise ValueError(f"{q.n} holes do not fit")
    h = 1 / level
    exact = 1e3 * q.a / q.b / (1 + 10 * (q.a / 0.04) ** 2)
    return FemResult(h=h, values={"k": exact * (1 + 1e-4 * h**2), "s": 1e6})


def row(name, symbol, unit, key):
    return Approximation(
        name=name, symbol=symbol, unit=unit, analytic=key, fem=key, formal=2, interval=None,
        source="",
    )  # fmt: skip


CASE = Case(
    id="made-up-plate", title="", paper="", place="", lead="", inputs=Plate, analytic=formulas,
    reference=fem, levels=(1, 2, 4),
    checks=(row("stiffness", "k", "N/mm", "k"), row("stress", "σ", "MPa", "s")), outputs=(),
)  # fmt: skip


def chosen(*only):
    return selected(CASE, only or ("stiffness",))


class Dying(Where):
    """Its processes die on every task."""

    @contextmanager
    def entered(self):
        executor = Executor()
        executor.submit = lambda *_: died()
        yield Engine(executor, lambda: 1)


def died():
    """The future of a task whose process died."""
    future = Future()
    future.set_exception(WorkerDiedError("the process died (signal 9)"))
    return future


class Here(Where):
    """Solves in the process of the caller."""

    @contextmanager
    def entered(self):
        with local(0) as engine:
            yield engine


def course(plan, error, U_error=0.0, *, pair=0, fe=2000.0, problems=None):
    """A course with errors at the points of the plan, shares; NaN is unsolved."""
    m = len(plan.points)
    error = np.broadcast_to(np.asarray(error, float), m).copy()
    U_error = np.where(np.isnan(error), np.nan, np.broadcast_to(U_error, m))
    fe = np.where(np.isnan(error), np.nan, np.broadcast_to(np.asarray(fe, float), m))
    why = problems or tuple("does not converge" if np.isnan(e) else "" for e in error)
    return Course(
        pair=plan.chosen[pair], formula=fe * (1 + error), fe=fe, U=fe * U_error, error=error,
        U_error=U_error, problems=why,
    )  # fmt: skip


def outcome(plan, *courses, problems=None, timing=None):
    """The outcome with these courses; `problems` of whole points by row."""
    problems = problems or {}
    solutions = tuple(
        Solution({}, (), {}, {}, problem_fe=problems.get(n, "")) for n in range(len(plan.points))
    )
    part = portion(plan.case, plan.chosen)
    solved = Solved(
        plan, part, (None,) * len(plan.points), solutions, timing or Timing(4, 2.0, 3.0, 2, 1)
    )
    return Outcome(solved, courses)
