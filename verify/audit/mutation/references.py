"""Number of rows that fail if references are changed: the score, and its required minimum.

Module `references_moved` changes references where they are judged, module `references_read` where
formulas return them. This module checks all rows of all cases by both methods in one pass over the
levels.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verify.audit.mutation import gate
from verify.audit.mutation.references_moved import (
    COMPARED,
    PERTURBATIONS,
    Red,
    Tried,
    is_convergence,
    of_paper,
    tried,
)
from verify.audit.mutation.references_read import own_key, read
from verify.core.case import Case, Check, Context
from verify.core.results import Kind, Status

DIGITS = 4  # significant
BALANCE, ZERO = "exact balances", "deviations from zero"
NO_FORMULA = "other rows"
SIZES = sorted({abs(p) for p in PERTURBATIONS if -p in PERTURBATIONS})  # tried with both signs

Progress = Callable[[int, int, str], None]  # cases done, cases in all, the running one


@dataclass(frozen=True)
class Both:
    """A row, tested with changed references (`moved`) and with changed formulas (`by_formula`).

    `by_formula` is None if no value of the formulas affects the row.
    """

    moved: Tried
    by_formula: Red | None = None

    @property
    def hidden(self) -> list[float]:
        """Sizes of changes that the row detects in its reference but not in its formula."""
        return [s for s in SIZES if _either_way(self.moved.red, s) and not self._reached(s)]

    def _reached(self, size: float) -> bool:
        return self.by_formula is None or _either_way(self.by_formula, size)


def _either_way(red: Red, size: float) -> bool:
    return size in red and -size in red


def measured(
    cases: Sequence[Case], folder: Path | None = None, *,
    show: Progress = lambda _done, _all, _name: None,
) -> dict[str, Any]:  # fmt: skip
    """Score as a dictionary for JSON: failing rows by perturbation and kind, and listed rows.

    `folder` is the cache of finite-element results; all levels must be stored. `show` receives the
    progress. Raises InputError if a level is missing.
    """
    rows: list[Both] = []
    for k, case in enumerate(cases):
        show(k, len(cases), case.id)
        rows += both_ways(case.checks, of_paper(case, folder))
    show(len(cases), len(cases), "")
    return score(rows)


def both_ways(checks: Iterable[Check], context: Context) -> list[Both]:
    """All rows of the checks, tested with changed references and with changed formulas."""
    return [both for check in checks for both in _both(check, context)]


def _both(check: Check, context: Context) -> list[Both]:
    rows = tried(check, context)
    if not any(_has_formula(one) for one in rows):
        return [Both(one) for one in rows]
    found, key = read(check, context), own_key(check)
    own = key if key in found.red else ""

    def by_formula(one: Tried) -> Red | None:
        red = found.of(one.row.quantity, own)
        return red if _has_formula(one) and (own or red) else None

    return [Both(one, by_formula(one)) for one in rows]


def _has_formula(one: Tried) -> bool:
    """Whether one side of the row is a formula, so that a wrong formula must fail the row."""
    return one.row.status is Status.PASS and one.row.kind in set(COMPARED) - {Kind.EXACT}


def of_its_own(both: Both) -> str:
    """Reason why the row is independent of all formula values; empty if it depends on one."""
    row = both.moved.row
    if row.kind is Kind.EXACT:
        return BALANCE
    if row.analytic == 0 and row.kind is not Kind.ASYMPTOTIC:
        return ZERO
    return "" if both.by_formula is not None else NO_FORMULA


def score(rows: Sequence[Both]) -> dict[str, Any]:
    """Score of the checked rows; key "gate" contains the score of the rows that must fail."""
    moved = [both.moved for both in rows]
    held = [one for one in moved if gate.held(one.row)]
    convergence = sum(is_convergence(one.row) for one in moved)
    listed = _listed(moved)
    n = sum(len(names) for names in listed.values())
    by_formula = _by_formula(rows)
    asked = [both for both in rows if gate.held(both.moved.row)]
    excluded = Counter(why for both in asked if (why := of_its_own(both)))
    failures = gate.failures(moved, [name for name, _ in by_formula["hidden"]])
    return {
        "perturbations": list(PERTURBATIONS),
        "rows": len(rows),
        "convergence": convergence,
        "kinds": {
            kind.value: _shares([one for one in held if one.row.kind is kind]) for kind in COMPARED
        },
        "gate": {"held": not failures, "failures": failures} | _shares(held),
        "apart": {why: excluded[why] for why in (BALANCE, ZERO, NO_FORMULA)},
        "the rest": _shares([both.moved for both in asked if not of_its_own(both)]),
        "survivors": _survivors(held),
        "listed": {
            "rows": n, "share": _rounded(n / len(rows)) if rows else 0.0,
            "share without convergence": _rounded(n / max(len(rows) - convergence, 1)),
            "because": listed,
        },
        "by formula": by_formula,
    }  # fmt: skip


def _shares(rows: Sequence[Tried]) -> dict[str, Any]:
    """Number of rows, and numbers of rows that fail at each perturbation."""
    return {
        "rows": len(rows),
        "red": {_name(p): sum(p in one.red for one in rows) for p in PERTURBATIONS},
        "red by share of the scale": {
            _name(p): sum(p in one.red_of_scale for one in rows) for p in PERTURBATIONS
        },
    }


def _name(p: float) -> str:
    return f"{100 * p:+g} %"


def _survivors(rows: Sequence[Tried]) -> list[dict[str, Any]]:
    """Rows that must fail but pass at a perturbation of the reference, with detection limits."""
    return [
        {
            "row": one.row.id, "kind": one.row.kind.value,
            "green at": [_name(p) for p in PERTURBATIONS if p not in one.red],
            "detects": _rounded(one.row.detects), "demand": one.row.demand,
            "scale": one.row.scale_name,
        }
        for one in rows if set(PERTURBATIONS) - one.red
    ]  # fmt: skip


def _listed(rows: Sequence[Tried]) -> dict[str, list[list[Any]]]:
    """Rows to which the requirement does not apply, with detection limits, by reason."""
    found: dict[str, list[list[Any]]] = {}
    for one in rows:
        if why := gate.listed_as(one.row):
            found.setdefault(why, []).append([one.row.id, _rounded(one.row.detects)])
    return dict(sorted(found.items()))


def _by_formula(rows: Sequence[Both]) -> Mapping[str, Any]:
    """Agreement of both methods, over the rows that must fail and that have a formula."""
    asked = [both for both in rows if gate.held(both.moved.row) and _has_formula(both.moved)]
    reached = [both for both in asked if both.by_formula is not None]
    return {
        "rows": len(asked),
        "reached": len(reached),
        "agree": sum(not both.hidden for both in reached),
        "hidden": [[both.moved.row.id, both.hidden] for both in reached if both.hidden],
        "not reached": [both.moved.row.id for both in asked if both.by_formula is None],
    }


def _rounded(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.{DIGITS}g}")
