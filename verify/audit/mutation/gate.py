"""What perturbed references have to show: which rows are held to it, which are only listed.

Held are comparisons that pass and are asked to show 1 % or less: identities, asymptotics, trends,
approximations with an expected interval, and balances. The rest is listed with the reason and with
what it detects: facts, what is shown or noted or calibrated, and comparisons with a wider demand.
Convergence rows stand beside a comparison and have no reference: neither held nor listed.
A row that turns red where it is judged must do so as well where a value of its formula slips.
"""

from collections.abc import Sequence

from verify.audit.mutation.references_moved import Tried, is_convergence
from verify.core.results import Kind, Row, Status
from verify.judging.judge import DEMAND

SMALL, LARGE = 0.01, 0.05  # of the reference, either way
LEAST = 0.99  # share of the held rows that `SMALL` turns red, each sign; `LARGE` turns all
MOST_LISTED = 0.2  # of all rows

TOLD = {
    Status.SHOWN: "shown: its reference states no uncertainty",
    Status.NOTE: "noted: a printed value that is shown wrong",
    Status.CALIBRATED: "calibrated: it was fitted",
    Status.FAIL: "red already",
    Status.SKIP: "not run",
}
A_FACT = "a fact: an order, a presence, or more than one figure"
WIDER = "a wider demand"


def listed_as(row: Row) -> str:
    """Why the row is not held to the gate; "" where it is, and of convergence."""
    if is_convergence(row):
        return ""
    if row.status is not Status.PASS:
        return TOLD[row.status]
    if row.kind is Kind.FACT:
        return A_FACT
    wide = row.demand is not None and row.demand > DEMAND
    return f"{WIDER}: {row.demand_reason}" if wide else ""


def held(row: Row) -> bool:
    """Whether the gate asks the row to turn red."""
    return not is_convergence(row) and not listed_as(row)


def share(rows: Sequence[Tried], p: float) -> float:
    """Of the rows that the perturbation `p` of the reference turns red; 1 of none."""
    return sum(p in tried.red for tried in rows) / len(rows) if rows else 1.0


def failures(rows: Sequence[Tried], hidden: Sequence[str] = ()) -> list[str]:
    """In a line each what the gate finds wrong; empty where it holds.

    `hidden` names rows that stay green where their own formula's value slips.
    """
    gated = [tried for tried in rows if held(tried.row)]
    found = [] if gated else ["no row is held to the gate"]
    found += [
        f"{p:+.0%} turns {share(gated, p):.2%} of {len(gated)} rows red, {asked:.0%} asked"
        for size, asked in ((SMALL, LEAST), (LARGE, 1.0))
        for p in (size, -size)
        if share(gated, p) < asked
    ]
    listed = sum(bool(listed_as(tried.row)) for tried in rows)
    if listed > MOST_LISTED * len(rows):
        found.append(f"{listed} of {len(rows)} rows are only listed, {MOST_LISTED:.0%} at most")
    if hidden:
        found.append(f"{_rows(len(hidden))} a slip of their own formula, {hidden[0]} first")
    return found


def _rows(count: int) -> str:
    return "1 row hides" if count == 1 else f"{count} rows hide"
