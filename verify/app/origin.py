"""Origin of the stored numbers of a case; cases whose stored numbers depend on a module."""

import inspect
import os
import time
from collections.abc import Iterator
from pathlib import Path

from verify.cases.registry import CASES, find
from verify.core import source_code
from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.plain_code import is_of_project
from verify.core.store import Store
from verify.jobs import cache

ROOT = Path(__file__).parents[2]
SIDES = {"formulas": source_code.whole_parts_of, "reference": source_code.parts_of}


def of_case(name: str) -> Iterator[str]:
    """Lines about every stored result of a case at its default inputs.

    Raises ValueError if the case is unknown.
    """
    case = find(name, CASES)
    store = Store(cache.default_folder())
    yield f"{case.id}, reference: {case.method.case}; code of formulas and reference:"
    for side, (function, modules) in _code(case).items():
        yield f"  {side:10} {function}, and {len(modules)} modules that it reaches"
    yield f"levels in {store.path}, kind {cache.KIND}, with the hash of code, inputs and versions:"
    keys = {level: cache.key(case, case.inputs(), level) for level in case.levels}
    dates = store.dates(cache.KIND, list(keys.values()))
    for level, key in keys.items():
        yield f"  {level:<10} {key}  {_dated(dates.get(key))}"
    own = [g for g in store.groups() if g.subject == case.id and g.kind != cache.KIND]
    for group in own:
        yield f"{group.kind}: {group.entries:,} results of any code and inputs, in the same file"
    yield "files of the project with results of make deep and make crosscheck:"
    for path, state in _measured(case):
        yield f"  {state}  {os.path.relpath(path, ROOT)}"


def of_module(name: str) -> Iterator[str]:
    """Lines about the cases whose code includes a module.

    Raises InputError if there is no such module.
    """
    module = _module(name)
    found = {side: [c.id for c in CASES if _is_part(module, c, side)] for side in SIDES}
    for side, cases in found.items():
        yield f"{side} of {len(cases)} cases: {', '.join(cases) or 'none'}"
    yield (
        f"If the code of {module} changes (other than words or names), verify solves the "
        "references of "
        f"{len(found['reference'])} cases again. The results on regions of validity, error "
        "budgets and second "
        "solvers of all listed cases are then no longer valid."
    )


def _code(case: Case) -> dict[str, tuple[str, list[str]]]:
    """The functions for formulas and for the reference, each with its name and its modules."""
    found = {}
    for side, parts in SIDES.items():
        function = case.analytic if side == "formulas" else case.reference
        module = inspect.getmodule(function)
        name = getattr(function, "__name__", "")
        found[side] = (f"{module.__name__}:{name}" if module else name, parts(function)[1])
    return found


def _is_part(module: str, case: Case, side: str) -> bool:
    function, reached = _code(case)[side]
    return module in reached or function.startswith(f"{module}:")


def _module(name: str) -> str:
    """Dotted name of a module, from a dotted name or a file name."""
    path = Path(name)
    if path.suffix == ".py":
        full = (path if path.is_file() else ROOT / path).resolve()
        parts = full.relative_to(ROOT).with_suffix("").parts if full.is_relative_to(ROOT) else ()
        name = ".".join(parts)
    if not is_of_project(name) or not all(name.split(".")) or not source_code.is_module(name):
        raise InputError(
            f"--code {path}: must be a module of the project, such as analytic.ring.lame"
        )
    if source_code.is_package(name):
        raise InputError(f"--code {path}: is a package: give one of its modules")
    return name


def _measured(case: Case) -> Iterator[tuple[str, str]]:
    from verify.studies.budget import store as budgets
    from verify.studies.budget.measuring import plan_of
    from verify.studies.budget.plan import rows
    from verify.studies.crosscheck import store as crosschecks
    from verify.studies.crosscheck.registry import COMPARISONS
    from verify.studies.validity import store as regions

    if case.scans:
        yield str(regions.RECORDS.path(case.id)), _state(regions.measured(case))
    if rows(case):
        yield str(budgets.RECORDS.path(case.id)), _state(budgets.measured(plan_of(case.id)))
    for cross in (one for one in COMPARISONS if one.case == case.id):
        yield str(crosschecks.RECORDS.path(cross.file)), _state(crosschecks.current(cross))


def _state(found: object) -> str:
    date = getattr(found, "date", "")
    return f"{date}, of this code" if date else "not measured for this code"


def _dated(found: tuple[float, int] | None) -> str:
    if found is None:
        return "not stored: freewheel verify solves it"
    made, size = found
    return f"{time.strftime('%Y-%m-%d %H:%M', time.localtime(made))}, {size / 1e6:.1f} MB"
