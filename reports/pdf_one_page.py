"""A case on one page of the PDF: verdicts, main drawings, most important rows, inputs."""

from collections.abc import Iterator, Sequence
from itertools import islice

from reports import formats
from reports.advice import advised, of_case
from reports.drawable import drawable
from reports.environment import present, printed
from reports.figures import plot
from reports.first_page import groups
from reports.frames import Frame
from reports.pdf_case import MARKS
from reports.pdf_tables import Data, prose, quantity
from reports.pdf_verdicts import group_data
from reports.richtext import digits, runs
from reports.row_lines import Line, lines
from reports.sketch import sketch
from reports.standalone import standalone
from verify.core.results import CaseResult, Kind, Report, Row, Status
from verify.core.verdicts import FormulaVerdict, Verdict

MOST_ROWS = 40  # more fit on no page
MOST_VERDICTS = 8
MOST_FINDINGS = 3
MOST_INPUTS = 14  # with their meaning; of others symbol and value
MOST_DRAWINGS = 2
APPROXIMATE = (Kind.APPROXIMATION, Kind.ASYMPTOTIC)
WORST_FIRST = (Verdict.UNSAFE, Verdict.WRONG, Verdict.NONE, Verdict.CONSERVATIVE, Verdict.PART)


def one_page(
    case: CaseResult, report: Report, frames: Sequence[Frame], source: str, page: str
) -> Data:
    """Content for a page, sorted by importance; the template omits rows that do not fit.

    `source` states the origin of the formulas of the case; `page` is the file with the full
    content.
    """
    verdicts = of_case(advised(report.verdicts), case.id, case.rows)
    found = [group_data(group, set()) for group in groups(sorted(verdicts, key=_badness))]
    ordered = by_weight(case, verdicts)
    return {
        "id": case.id, "name": case.name, "title": runs(case.title), "source": source,
        "lead": prose(case.lead),
        "counts": [[status.value, count] for status, count in present(case.rows)],
        "findings": [prose(text) for text in case.findings[:MOST_FINDINGS]],
        "more_findings": len(case.findings[MOST_FINDINGS:]),
        "warnings": [prose(text) for text in case.warnings],
        "verdicts": found[:MOST_VERDICTS], "more_verdicts": len(found[MOST_VERDICTS:]),
        "drawings": [
            {"drawing": standalone(drawn), "title": prose(title[:1].upper() + title[1:])}
            for drawn, title in islice(_drawings(case, frames), MOST_DRAWINGS)
        ],
        "rows": [_row(line) for line in ordered[:MOST_ROWS]], "all_rows": len(ordered),
        **_inputs(case, _varied(case, report, verdicts)), "page": page, "command": case.command,
    }  # fmt: skip


def by_weight(case: CaseResult, verdicts: Sequence[FormulaVerdict]) -> list[Line]:
    """Lines sorted by importance: failed, not run, evidence of verdicts, printed numbers, others.

    Among the others, approximations and rows that did not pass come first, then identities, then
    balances and statements.
    """
    evidence = {row for v in verdicts for row in (*v.rows, *v.model_rows)}

    def weight(line: Line) -> tuple[int, bool, bool, int]:
        row = line.row
        return line.rank, row.id not in evidence, not row.published, _kind(row)

    return sorted(lines(case.rows), key=weight)


def _kind(row: Row) -> int:
    """Rank of a row: 0 if not passed or an approximation, 1 for an identity, 2 for any other."""
    if row.status is not Status.PASS or row.kind in APPROXIMATE:
        return 0
    return 1 if row.kind is Kind.IDENTITY else 2


def _badness(one: FormulaVerdict) -> int:
    return WORST_FIRST.index(one.verdict) if one.verdict in WORST_FIRST else len(WORST_FIRST)


def _drawings(case: CaseResult, frames: Sequence[Frame]) -> Iterator[tuple[str, str]]:
    """Sketch, figures and pictures of fields with their titles; the first ones are on the page."""
    if case.sketch and (drawn := sketch(case.sketch)):
        yield drawn, case.sketch.title
    yield from ((plot(figure), figure.title) for figure in case.figures if drawable(figure))
    yield from ((frame.svg, frame.caption) for frame in frames if frame.svg)


def _row(line: Line) -> Data:
    row, shown = line.row, formats.values(line.row)
    return {
        "quantity": quantity(row), "formula": runs(shown.formula), "fem": runs(shown.fem),
        "by": prose(shown.by),
        "paper": [[MARKS[kind], runs(text)] for kind in MARKS if (text := printed(row, kind))],
        "difference": runs(formats.difference(row)), "tolerance": runs(formats.tolerance(row)),
        "status": row.status.value, "reason": prose(line.reason),
    }  # fmt: skip


def _varied(case: CaseResult, report: Report, verdicts: Sequence[FormulaVerdict]) -> frozenset[str]:
    """Names of the inputs over which errors of the case's formulas were measured."""
    regions = [r for v in report.validity if v.case == case.id for c in v.cards for r in c.regions]
    sides = [s for v in verdicts for r in v.ranges if r.case == case.id for s in r.studied]
    return frozenset([axis.name for r in regions for axis in r.axes] + [s.name for s in sides])


def _inputs(case: CaseResult, varied: frozenset[str]) -> Data:
    """Inputs with their meaning (varied inputs first), and the other inputs in short form."""
    found = sorted(case.inputs, key=lambda one: one.name not in varied)
    cells = [
        {"symbol": runs(formats.symbol(one.symbol)), "what": prose(one.what),
         "value": digits(formats.number(one.value)),
         "unit": prose(one.unit) if one.unit != "1" else [], "is_varied": one.name in varied}
        for one in found
    ]  # fmt: skip
    return {"inputs": cells[:MOST_INPUTS], "more_inputs": cells[MOST_INPUTS:]}
