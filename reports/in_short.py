"""Results of each case in one line, for the top of the page and as a Markdown table."""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verify.core.results import CaseResult, Kind, Report, Row, Status

HEAD = (
    "| case | what is compared | rows | statuses | largest difference | detection limit |\n"
    "|---|---|---|---|---|---|"
)
JUDGED = (Kind.IDENTITY, Kind.APPROXIMATION)


@dataclass(frozen=True)
class CaseLine:
    """Results of a case in one line.

    `difference` and `seen` (detection limit) are the largest over identities and approximations.
    """

    case: str
    what: str
    rows: int
    states: str
    difference: str
    seen: str


def cases_in_short(report: Report) -> list[CaseLine]:
    """Lines with the results of each case."""
    short = named(report.papers)
    return [_line(case, where(case, short)) for case in report.cases]


def markdown(report: Report) -> str:
    """Markdown table with one line for each case."""
    lines = (
        f"| `{v.case}` | {_cell(v.what)} | {v.rows} | {v.states} | {v.difference} | {v.seen} |"
        for v in cases_in_short(report)
    )
    return "\n".join([HEAD, *lines])


def _cell(text: str) -> str:
    """Text of a cell with escaped bars."""
    return text.replace("|", r"\|")


def first_author(authors: str, year: int | None) -> str:
    """First author's name and year."""
    return f"{authors.split(',')[0].split()[-1]} {year or ''}".strip()


def named(papers: Sequence[Mapping[str, Any]]) -> Mapping[str, str]:
    """First author and year of each paper, by key; the stated source if it has no ledger."""
    return {
        p["key"]: first_author(p["authors"], p["year"]) if p["title"] else p["authors"]
        for p in papers
    }


def where(case: CaseResult, short: Mapping[str, str]) -> str:
    """Source and place of a case's formulas, as far as they are stated."""
    return ", ".join(filter(None, (short.get(case.paper, case.paper), case.place)))


def _line(case: CaseResult, source: str) -> CaseLine:
    count = Counter(row.status for row in case.rows)
    states = ", ".join(f"{count[s]} {s.value}" for s in reversed(Status) if count[s])
    judged = [row for row in case.rows if row.kind in JUDGED and row.detects is not None]
    return CaseLine(
        case.id, f"{case.title} ({source})" if source else case.title, len(case.rows), states,
        _largest([abs(_relative(row)) for row in judged]),
        _largest([row.detects for row in judged if row.detects is not None]),
    )  # fmt: skip


def _relative(row: Row) -> float:
    return (row.difference or 0.0) / (row.scale or 1.0)


def _largest(values: Sequence[float]) -> str:
    """Text of the largest value with two digits, rounded up, in per cent; a dash for none."""
    if not values or max(values) <= 0:
        return "–" if not values else "0 %"
    percent = 100 * max(values)
    last = 10.0 ** (math.floor(math.log10(percent)) - 1)
    rounded = math.ceil(percent / last * (1 - 1e-12)) * last
    return f"{rounded:.0f} %" if rounded >= 99.5 else f"{rounded:.2g} %"
