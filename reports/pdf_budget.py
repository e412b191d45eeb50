"""Error budgets in the PDF: a table for each case."""

from collections.abc import Collection, Sequence

from reports.budget import Compact, compact, headline, identities, left, lines, percent
from reports.pdf_tables import Data, prose
from reports.richtext import runs
from verify.core.results import CaseBudget


def budget_data(budgets: Sequence[CaseBudget], printed: Collection[str]) -> list[Data]:
    """Data of the error budgets: lines of the drawn row, other rows, sentence on identities.

    Each budget links to its case, which must be among the `printed` cases.
    """
    return [_case(one) for one in budgets if one.case in printed]


def _case(one: CaseBudget) -> Data:
    row, others = headline(one), compact(one)
    missing = f"{one.missing[:1].upper()}{one.missing[1:]}." if one.missing else ""
    return {
        "id": one.case, "title": runs(one.title), "date": one.date,
        "words": prose(missing or " ".join(filter(None, (identities(one), left(one))))),
        "drawn": prose(row.quantity) if row else [],
        "rows": [[prose(cell) for cell in line] for line in lines(row)] if row else [],
        "header": [[_head(others)], ["difference"], *([h] for h in others.header), ["remainder"]]
        if others else [],
        "others": [
            [prose(r.quantity), [percent(r.total)], *([x] for x in cells),
             [percent(r.remainder, r.u)]]
            for r, cells in others.rows
        ] if others else [],
    }  # fmt: skip


def _head(others: Compact) -> str:
    """Head of the column of other formulas; it states how many of them the table contains."""
    shown = len(others.rows)
    if shown == others.of:
        return "Other formulas"
    return f"The {shown} of {others.of} other formulas with the largest remainders"
