"""What is verified, as a table for a README: one line a case."""

import math
from collections import Counter

from verify.results import CaseResult, Kind, Report, Row, Status

HEAD = (
    "| case | what is compared | rows | verdicts | largest difference | any error seen above |\n"
    "|---|---|---|---|---|---|"
)
JUDGED = (Kind.IDENTITY, Kind.APPROXIMATION)


def verdicts(report: Report) -> str:
    """The table in Markdown; the last two columns are over its identities and approximations."""
    places = {
        p["key"]: f"{p['authors'].split(',')[0].split()[-1]} {p['year']}" for p in report.papers
    }
    return "\n".join(
        [HEAD, *(_line(case, places.get(case.paper, case.paper)) for case in report.cases)]
    )


def _line(case: CaseResult, paper: str) -> str:
    count = Counter(row.status for row in case.rows)
    states = ", ".join(f"{count[s]} {s.value}" for s in reversed(Status) if count[s])
    what = f"{case.title} ({paper}, {case.place})"
    judged = [row for row in case.rows if row.kind in JUDGED and row.detects is not None]
    differences = _largest([abs(_relative(row)) for row in judged])
    seen = _largest([row.detects for row in judged if row.detects is not None])
    return f"| `{case.id}` | {what} | {len(case.rows)} | {states} | {differences} | {seen} |"


def _relative(row: Row) -> float:
    return (row.difference or 0.0) / (row.scale or 1.0)


def _largest(values: list[float]) -> str:
    """The largest with two digits, rounded up, in per cent; a dash for none."""
    if not values or max(values) <= 0:
        return "–" if not values else "0 %"
    percent = 100 * max(values)
    last = 10.0 ** (math.floor(math.log10(percent)) - 1)
    return f"{math.ceil(percent / last * (1 - 1e-12)) * last:.2g} %"
