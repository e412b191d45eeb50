"""An invented case whose difference has known parts: functions stand for finite elements."""

from verify.core.case import Case, FemResult
from verify.core.inputs import Inputs, quantity
from verify.core.results import CaseResult
from verify.judging.budget_statement import Argument, Cause, Constant, Rerun, Statement
from verify.judging.checks import Approximation, Identity
from verify.studies.budget.plan import Plan, rows

HERE = "tests.verify.budget_made"
SELF, PLANE, WIDE, FAR, MESH = 0.01, 0.004, 0.02, -0.03, 0.001  # parts of the difference
TOGETHER = 0.005  # what width and distance do more together
SLACK = 1e-4  # of every value: a tolerance of the solver
calls = []


class Leaf(Inputs):
    b: float = quantity("2 mm", "mm", "b", "width", gt=0)
    s: float = quantity("5 mm", "mm", "s", "travel", ge=0)


class Solver:
    """What is called by its keyword, as the solvers of the plane are."""

    def __init__(self, *, assumption):
        self.excess = PLANE if assumption == "plane stress" else 0.0


def formulas(_q):
    return {"k": 100.0, "same": 7.0}


def difference(q, level, excess):
    """Of formula/FE - 1, by parts."""
    wide, far = (q.b / 2e-3) ** 2, q.s / 5e-3
    parts = SELF + WIDE * wide + FAR * far + TOGETHER * wide * far
    return parts + MESH / level**2 + SLACK + excess


def fem(q, level):
    calls.append((q.b, q.s, level))
    m = difference(q, level, Solver(assumption="plane stress").excess)
    same = 7.0 * (1 + 1e-5 / level**2)
    return FemResult(h=1 / level, values={"k": 100.0 / (1 + m), "same": same})


def narrow(q):
    return q.model_copy(update={"b": q.b / 1e4})


def fem_near(q, level):
    return fem(q.model_copy(update={"s": 0.0}), level)


NARROW = Rerun(cause=Cause.GEOMETRY, what="narrow", inputs=narrow, rows=("stiffness",))
NEAR = Rerun(cause=Cause.DISPLACEMENT, what="near", fem=fem_near, rows=("stiffness",))
STRAIN = Rerun(
    cause=Cause.PLANE, what="plane strain", rows=("stiffness",),
    changes=(Argument(f"{HERE}:Solver", {"assumption": "plane strain"}),),
)  # fmt: skip
TIGHT = Rerun(
    cause=Cause.CONTACT, what="no slack", rows=("stiffness",),
    changes=(Constant(f"{HERE}:SLACK", 0.0),),
)  # fmt: skip
CASE = Case(
    id="made-up-leaf", title="A leaf", paper="", place="", lead="", inputs=Leaf, analytic=formulas,
    reference=fem, levels=(1, 2, 4), outputs=(),
    checks=(
        Approximation(name="stiffness", symbol="k", unit="N/mm", analytic="k", fem="k", formal=2,
                      interval=None, source=""),
        Identity(name="the same", symbol="s", unit="1", analytic="same", fem="same", formal=2),
    ),
)  # fmt: skip
RESULT = CaseResult(
    id=CASE.id, title="", paper="", place="", lead="", inputs=(), equations=(), assumptions=(),
    readings=(), rows=(),
)  # fmt: skip
STATEMENT = Statement(reruns=(NARROW, NEAR, STRAIN, TIGHT), finer=8)


def plan(statement=STATEMENT, case=CASE):
    return Plan(case, statement, rows(case))
