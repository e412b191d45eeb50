"""Ranges of validity of formulas in the PDF: a table for each case instead of cards."""

from collections.abc import Sequence

from reports.pdf_tables import Data, prose
from reports.richtext import Run, runs
from reports.validity import common, signed, subjects
from verify.core.results import Validity, ValidityCard, ValidityRegion


def validity_data(known: Sequence[Validity]) -> list[Data]:
    """Names of subjects, each with the data of its cases for their tables."""
    return [
        {"name": name, "cases": [_case(one) for one in cases]} for name, cases in subjects(known)
    ]


def _case(one: Validity) -> Data:
    over = common(one)
    others = (
        f"Formulas without measurements at other inputs are: “{'”; “'.join(one.others)}”."
        if one.others
        else ""
    )
    return {
        "id": one.case,
        "title": runs(one.title),
        "date": one.date,
        "words": prose(f"{one.missing[:1].upper()}{one.missing[1:]}." if one.missing else others),
        "over": prose(f"Measured over {over}.") if over else [],
        "rows": [
            _line(card, region, first=region is card.regions[0], over="" if over else region.over)
            for card in one.cards for region in card.regions
        ],
        "exact": _exact(one),
    }  # fmt: skip


def _line(card: ValidityCard, region: ValidityRegion, *, first: bool, over: str) -> list[list[Run]]:
    named = prose(card.quantity) if first else []
    small: list[Run] = []
    if over:
        small = [*([["br"]] if first else []), ["small", *prose(f"measured over {over}")]]
    unsolved = (f"; {region.unsolved} of {region.points} points without a solution") * bool(
        region.unsolved
    )
    return [
        [*named, *small], [signed(card.error, card.U)] if first else [],
        *(prose(one.words) for one in region.limits), prose(region.breaks + unsolved),
    ]  # fmt: skip


def _exact(one: Validity) -> list[Run]:
    """Sentence about all formulas that solve the same problem as finite elements."""
    solved = [e for e in one.exact if e.largest is not None]
    if not solved:
        return []
    worst = max(solved, key=lambda e: abs(e.largest or 0.0))
    return [
        f"{len(solved)} of {len(one.exact)} formulas were solved and are exact within their "
        f"models. The largest error is {signed(worst.largest, worst.U)} (",
        *prose(worst.quantity), "), measured over ", *prose(one.over), ".",
    ]  # fmt: skip
