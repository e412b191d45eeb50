"""Where each formula may be used, in the PDF: a table for each case in place of cards."""

from collections.abc import Sequence

from reports import formats
from reports.pdf_tables import Data, prose
from reports.richtext import Run, runs
from reports.validity import signed, subjects
from verify.results import Validity, ValidityCard, ValidityRegion


def validity_data(known: Sequence[Validity]) -> list[Data]:
    """Subjects, their cases, and the lines of each."""
    return [
        {"name": name, "cases": [_case(one) for one in cases]} for name, cases in subjects(known)
    ]


def _case(one: Validity) -> Data:
    others = f"Not measured over its inputs: {'; '.join(one.others)}." if one.others else ""
    return {
        "id": one.case,
        "title": runs(one.title),
        "date": one.date,
        "said": prose(f"{one.missing[:1].upper()}{one.missing[1:]}." if one.missing else others),
        "rows": [
            _line(card, region, first=region is card.regions[0])
            for card in one.cards for region in card.regions
        ],
        "exact": _exact(one),
    }  # fmt: skip


def _line(card: ValidityCard, region: ValidityRegion, *, first: bool) -> list[list[Run]]:
    named: list[Run] = [*prose(card.quantity), ["br"]] if first else []
    unsolved = f"; {region.unsolved} of {region.points} without an error" * bool(region.unsolved)
    return [
        [*named, ["small", *prose(region.over)]], [signed(card.error, card.U)] if first else [],
        *(prose(one.words) for one in region.limits), prose(region.breaks + unsolved),
    ]  # fmt: skip


def _exact(one: Validity) -> list[Run]:
    """One sentence for all formulas that solve what finite elements solve."""
    solved = [e for e in one.exact if e.largest is not None]
    if not solved:
        return []
    worst = max(solved, key=lambda e: abs(e.largest or 0.0))
    return [
        f"Exact in its model: {len(solved)} of {len(one.exact)} formulas solved; ",
        "largest difference ", *runs(formats.power(worst.largest)), " ± ",
        *runs(formats.power(worst.U)), " (", *prose(worst.quantity), "), over ",
        *prose(one.over), ".",
    ]  # fmt: skip
