"""Lines of the tables of rows, each with its convergence row; failed rows come first."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from verify.core.results import CaseResult, Row, Status

COMPANION = ": convergence"
LISTED_FIRST = (Status.FAIL, Status.SKIP)


@dataclass(frozen=True)
class Line:
    """A line of the table: a row, and its convergence row if this passed or was not run."""

    row: Row
    convergence: Row | None = None

    @property
    def reason(self) -> str:
        """Text below the line; empty for a plain PASS."""
        is_stated = self.row.kind == "fact" or self.row.status is not Status.PASS
        return self.row.reason if is_stated else ""

    @property
    def rank(self) -> int:
        """Rank of the more urgent of both rows."""
        return min(rank(row.status) for row in (self.row, self.convergence) if row is not None)


Group = tuple[CaseResult, Sequence[Line]]


def rank(status: Status) -> int:
    """Rank of a status: 0 for a failed row, 1 for a row that was not run, 2 for any other."""
    return LISTED_FIRST.index(status) if status in LISTED_FIRST else len(LISTED_FIRST)


def failed_first(rows: Iterable[Row]) -> list[Row]:
    """Rows sorted by rank: failed rows, rows that were not run, all others."""
    return sorted(rows, key=lambda row: rank(row.status))


def lines(rows: Sequence[Row]) -> list[Line]:
    """Lines of rows with their convergence rows, sorted by rank."""
    known = {row.quantity for row in rows}
    companions = {
        row.quantity.removesuffix(COMPANION): row
        for row in rows
        if row.quantity.endswith(COMPANION)
        and row.quantity.removesuffix(COMPANION) in known
        and row.status in (Status.PASS, Status.SKIP)
    }
    apart = {row.quantity for row in companions.values()}
    found = [Line(r, companions.get(r.quantity)) for r in rows if r.quantity not in apart]
    return sorted(found, key=lambda line: line.rank)


def groups_failed_first(groups: Sequence[Group]) -> list[Group]:
    """Groups of a table over all cases, with the failed lines of every case before other lines."""
    return [
        (case, listed)
        for wanted in range(len(LISTED_FIRST) + 1)
        for case, group in groups
        if (listed := [line for line in group if line.rank == wanted])
    ]
