"""Solve one rerun of a budget in any process, and store the solution."""

import hashlib
import importlib
import json
import math
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from verify.core import source_code
from verify.core.case import FemResult
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.guard import named, of_machine, unsolved
from verify.jobs.level import keep_level
from verify.studies.budget import plan as plans
from verify.studies.budget.changes import changed
from verify.studies.budget.generic import LOOSER, TIGHTER, tolerances
from verify.studies.budget.plan import Plan, Step

KIND = "budget"  # of stored solutions
FORMAT = 2  # 1: changes did not reach modules that had imported a function before


@dataclass(frozen=True)
class Solution:
    """Values [SI] of formulas and finite elements by key.

    If there are no values, `problem` states the reason in one line.
    """

    formulas: Mapping[str, float]
    fe: Mapping[str, float]
    u_it: Mapping[str, float]
    h: float
    seconds: float
    problem: str = ""


def solved(plan: Plan, step: Step, folder: Path | None) -> Solution:
    """Solution of a rerun, from the store or computed and stored.

    An error of the computation is returned as the problem of the solution, which is not stored.
    Raises MemoryError or OSError if the machine fails.
    """
    store = None if folder is None else Store(folder)
    if store is not None and (stored := _stored(store, key(plan, step))) is not None:
        return stored
    start = time.perf_counter()
    try:
        with np.errstate(all="ignore"):
            formulas, result = _both(plan, step, folder)
        found = Solution(
            {k: float(v) for k, v in formulas.items()},
            {k: float(v) for k, v in result.values.items()},
            {k: float(v) for k, v in result.u_it.items()},
            float(result.h), time.perf_counter() - start,
        )  # fmt: skip
    except Exception as error:  # gmsh raises Exception itself
        if of_machine(error):
            raise
        reason = str(error) if unsolved(error) else named(error)
        found = Solution(
            {}, {}, {}, math.nan, time.perf_counter() - start, " ".join(reason.split())
        )
    if store is not None and not found.problem:
        content = json.dumps(asdict(found)).encode()
        store.store(KIND, plan.case.id, {key(plan, step): content})
    return found


def _both(plan: Plan, step: Step, folder: Path | None) -> tuple[Mapping[str, float], FemResult]:
    case, q = plan.case, plans.inputs_of(plan, step)
    mine = [plan.reruns[name] for name in step.causes if name in plan.reruns]
    changes = [change for rerun in mine for change in rerun.changes]
    factor = plans.tolerance_factor(step)
    if factor != 1:
        changes += tolerances(case, factor)
    own = next((rerun.fem for rerun in mine if rerun.fem is not None), None)
    if own is None and not changes:  # only inputs or the mesh: the usual cache
        return case.analytic(q), _usual(plan, q, step.level, folder)
    for function in (case.reference, *([own] if own else ())):
        for name in source_code.modules_of(function):
            importlib.import_module(name)  # before the change: none imports a changed constant
    with changed(changes):
        return case.analytic(q), (own or case.reference)(q, step.level)


def _usual(plan: Plan, q: Any, level: int, folder: Path | None) -> FemResult:
    if folder is not None and (found := cache.load(folder, plan.case, q, level)) is not None:
        return found
    result = plan.case.reference(q, level)
    if folder is not None:
        keep_level(folder, plan.case, q, level, result)
    return result


def key(plan: Plan, step: Step) -> str:
    """Key of a solution, from all data on which it depends."""
    q = plans.inputs_of(plan, step).model_dump()
    parts = [str(FORMAT), json.dumps(q, sort_keys=True, default=str), str(step.level)]
    parts += [code_of(plan, name) for name in step.causes]
    parts += [
        source_code.source_of(plan.case.reference),
        source_code.whole_source_of(plan.case.analytic),
    ]
    parts += [f"{name} {version(name)}" for name in cache.libraries_of(plan.case.reference)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def code_of(plan: Plan, name: str) -> str:
    """Text of the changes that remove a cause: changed objects, new values, and code."""
    rerun = plan.reruns.get(name)
    if rerun is None:
        factor = {plans.TIGHT: TIGHTER, plans.LOOSE: LOOSER}.get(name, 1.0)
        changes = tolerances(plan.case, factor) if factor != 1 else ()
        return f"{name} {', '.join(map(str, changes))}"
    source = "" if rerun.fem is None else source_code.source_of(rerun.fem)
    return f"{', '.join(map(str, rerun.changes))} {source}"


def _stored(store: Store, name: str) -> Solution | None:
    content = store.one(KIND, name)
    try:
        return None if content is None else Solution(**json.loads(content))
    except (ValueError, TypeError):
        return None
