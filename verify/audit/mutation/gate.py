"""Requirement for perturbed references: which rows must fail, and which are only listed.

The requirement applies to comparisons that pass and whose required sensitivity is 1 % or less:
identities, asymptotics, trends, approximations with an expected interval, and balances. All other
rows are listed with the reason and their detection limit: facts, SHOWN, NOTE and CALIBRATED rows,
and less sensitive comparisons. Convergence rows belong to a comparison and have no reference; they
are neither required to fail nor listed. A row that fails if its reference is changed must also fail
if a value of its formula is wrong.
"""

from collections.abc import Sequence

from verify.audit.mutation.references_moved import Tried, is_convergence
from verify.core.results import Kind, Row, Status
from verify.judging.judge import DEMAND

SMALL, LARGE = 0.01, 0.05  # changes of the reference, with both signs
LEAST = 0.99  # share of the held rows that fail at `SMALL`, each sign; all fail at `LARGE`
MOST_LISTED = 0.2  # of all rows

TOLD = {
    Status.SHOWN: "SHOWN: the uncertainty or the expected error is unknown",
    Status.NOTE: "NOTE: the printed value is proved wrong, or is used unchanged",
    Status.CALIBRATED: "CALIBRATED: inputs were fitted",
    Status.FAIL: "the row fails without a change",
    Status.SKIP: "not run",
}
A_FACT = "fact: a statement that is true or false, such as convergence"
WIDER = "the smallest change that must be detected exceeds 1 %"


def listed_as(row: Row) -> str:
    """Reason why a row need not fail; empty for rows that must fail and for convergence rows."""
    if is_convergence(row):
        return ""
    if row.status is not Status.PASS:
        return TOLD[row.status]
    if row.kind is Kind.FACT:
        return A_FACT
    wide = row.demand is not None and row.demand > DEMAND
    return f"{WIDER}: {row.demand_reason}" if wide else ""


def held(row: Row) -> bool:
    """Whether the row must fail if its reference is perturbed."""
    return not is_convergence(row) and not listed_as(row)


def share(rows: Sequence[Tried], p: float) -> float:
    """Fraction of `rows` that fail if their references change by the fraction `p`; 1 if no rows."""
    return sum(p in tried.red for tried in rows) / len(rows) if rows else 1.0


def failures(rows: Sequence[Tried], hidden: Sequence[str] = ()) -> list[str]:
    """Violations of the requirement, one line each; empty if there are none.

    `hidden` are rows that pass although the value of their formula is wrong.
    """
    gated = [tried for tried in rows if held(tried.row)]
    found = [] if gated else ["no row must fail"]
    found += [
        f"{p:+.0%} makes {share(gated, p):.2%} of {len(gated)} rows fail, {asked:.0%} required"
        for size, asked in ((SMALL, LEAST), (LARGE, 1.0))
        for p in (size, -size)
        if share(gated, p) < asked
    ]
    listed = sum(bool(listed_as(tried.row)) for tried in rows)
    if listed > MOST_LISTED * len(rows):
        found.append(f"{listed} of {len(rows)} rows are only listed, maximum {MOST_LISTED:.0%}")
    if hidden:
        found.append(f"{_rows(len(hidden))} an error of the formula, first {hidden[0]}")
    return found


def _rows(count: int) -> str:
    return "1 row does not reveal" if count == 1 else f"{count} rows do not reveal"
