"""Stored budgets of a case; a record is valid for unchanged code, inputs and reruns."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache as memoised
from types import ModuleType
from typing import Any

from verify.core import source_code
from verify.jobs.records import Record, Records
from verify.judging import convergence
from verify.studies.budget import balance, compared, corrected
from verify.studies.budget import found as founds
from verify.studies.budget.balance import Balance, Joint, Part
from verify.studies.budget.found import RowBudget
from verify.studies.budget.plan import Plan
from verify.studies.budget.solve import code_of
from verify.studies.sweep import pairs

RECORDS = Records("budget")
DIGITS = 6  # significant: parts add up to totals
ARITHMETIC = (balance, compared, founds, pairs, convergence)  # makes contributions of solutions


@dataclass(frozen=True)
class Measured:
    """Budgets of a case, the date of the measurement, and the time [s] of all reruns."""

    date: str
    seconds: float
    rows: tuple[RowBudget, ...]


def measured(plan: Plan) -> Measured | None:
    """Stored budgets of a case; None if code, inputs or reruns have changed."""
    known = {pair.name: pair for pair in plan.rows}

    def read(record: Record) -> Measured:
        return Measured(record.date, float(record.content["seconds"]), tuple(
            RowBudget(known[name], _balance(row), tuple(_joint(one) for one in row["joints"]))
            for name, row in record.content["rows"].items()
        ))  # fmt: skip

    return RECORDS.current(plan.case.id, _made_by(plan), read)


def keep(plan: Plan, found: Sequence[RowBudget], seconds: float) -> None:
    """Store the budgets of a case.

    Raises OSError if the record cannot be written.
    """
    rows = {
        one.pair.name: {
            "total": one.balance.total, "remainder": one.balance.remainder,
            "u": one.balance.u, "parts": [_spare(asdict(p)) for p in one.balance.parts],
            "joints": [asdict(joint) for joint in one.joints],
        }
        for one in found
    }  # fmt: skip
    content = {"seconds": round(seconds, 1), "rows": _short(rows)}
    RECORDS.keep(plan.case.id, _made_by(plan), content)


def _made_by(plan: Plan) -> dict[str, Any]:
    """All data on which the numbers depend."""
    case, statement = plan.case, plan.statement
    return {
        "arithmetic": _hash(*ARITHMETIC),
        "inputs": case.inputs().model_dump(),
        "code": [source_code.whole_source_of(case.analytic), source_code.source_of(case.reference)],
        "levels": [*case.levels, statement.finer],
        "rows": [pairs.signature(pair) for pair in plan.rows],
        "reruns": [_signature(plan, name) for name in plan.reruns],
        "without": [f"{one.cause}: {one.why}" for one in plan.without],
        **({"corrected": [_hash(corrected), *_corrections(plan)]} if statement.corrected else {}),
    }


@memoised
def _hash(*modules: ModuleType) -> str:
    return source_code.group_hash([module.__name__ for module in modules])[:16]


def _corrections(plan: Plan) -> list[list[str]]:
    return [[one.row, one.key, one.what] for one in plan.statement.corrected]


def _signature(plan: Plan, name: str) -> list[Any]:
    rerun = plan.reruns[name]
    return [name, code_of(plan, name), source_code.source_of(rerun.inputs), list(rerun.rows),
            list(rerun.levels), rerun.after, rerun.shared]  # fmt: skip


def _short(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _short(one) for key, one in value.items()}
    return [_short(one) for one in value] if isinstance(value, list | tuple) else value


def _spare(part: dict[str, Any]) -> dict[str, Any]:
    """The record of a contribution without default values."""
    return {k: v for k, v in part.items() if not (k in ("shared", "note") and not v)}


def _balance(row: Mapping[str, Any]) -> Balance:
    parts = tuple(Part(**part) for part in row["parts"])
    return Balance(float(row["total"]), parts, float(row["remainder"]), float(row["u"]))


def _joint(data: Mapping[str, Any]) -> Joint:
    return Joint(**{**data, "names": tuple(data["names"])})
