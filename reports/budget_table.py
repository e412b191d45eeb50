"""Table (CSV) of all error budgets for other programs: one line for each part of each row."""

import csv
import io
from collections.abc import Iterable

from reports.budget import UNKNOWN
from reports.rows import Cell, harmless
from verify.core.results import CaseBudget, RowBudget

HEADER = (
    "case", "quantity", "kind", "part", "what", "contribution_relative", "half_width_relative",
    "counts", "note",
)  # fmt: skip


def budget_csv(budgets: Iterable[CaseBudget]) -> str:
    """CSV text of error budgets; for each row the difference, its parts, and the remainder."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(HEADER)
    for one in budgets:
        if one.missing:
            table.writerow(map(harmless, (one.case, "", "", "", "", None, None, "", one.missing)))
        for row in one.rows:
            for cells in _lines(row):
                table.writerow(map(harmless, (one.case, row.quantity, row.kind.value, *cells)))
    return "\ufeff" + text.getvalue()


def _lines(row: RowBudget) -> Iterable[tuple[Cell, ...]]:
    yield "difference", "", row.total, row.U, "", ""
    for p in row.parts:
        yield p.cause, p.what, p.contribution, p.u, "no" if p.shared else "yes", p.note
    for joint in row.joints:
        yield "both causes", " and ".join(joint.causes), joint.value, None, "no", joint.note
    within = {True: "explained", False: "not explained", None: ""}[row.within]
    note = within if row.apart else f"not decomposed: {row.why or UNKNOWN}"
    yield "remainder", "", row.remainder, row.u, "", note
