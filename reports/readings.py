"""Texts about possible readings of printed numbers, for the page and for the PDF."""

from reports import formats
from reports.pdf_tables import Data, prose
from reports.richtext import Run
from verify.core.results import ReadingsTried


def found(one: ReadingsTried) -> str:
    """Text of the reading that reproduces the number, or a statement that no reading does."""
    if one.met:
        return (
            "the formula gives the number, within the rounding of its inputs; "
            "no other reading is needed"
        )
    if not one.readings:
        return "no reading"
    more = one.hits - 1
    others = (
        f"; the printed number also follows from {more} other combination{'s' * (more > 1)}"
        if more
        else ""
    )
    value = f" ({one.value:.6g})" if one.value is not None else ""
    weight = "" if one.is_evidence else "; the agreement may be accidental"
    return f"{'; '.join(one.readings)}{value}{others}{weight}"


def chance(expected: float) -> str:
    """Text of the expected number of accidental hits, with at most two digits."""
    return "<0.001" if expected < 1e-3 else f"{expected:.2g}"


def readings_data(searches: tuple[ReadingsTried, ...]) -> Data:
    """Table for the PDF, and the numbers for which no reading was tried."""
    return {
        "rows": [_row(one) for one in searches if not one.missing],
        "missing": [
            prose(f"{one.reference} ({one.printed}{_unit(one)}): {one.missing}")
            for one in searches if one.missing
        ],
    }  # fmt: skip


def _unit(one: ReadingsTried) -> str:
    return "" if one.unit == "1" else f" {one.unit}"


def _row(one: ReadingsTried) -> list[list[Run]]:
    return [
        [*prose(one.place), ["br"], ["small", one.reference]], prose(f"{one.printed}{_unit(one)}"),
        prose(one.what), prose(str(formats.number(one.as_it_stands))), prose(found(one)),
        prose(str(one.tried)), prose(chance(one.chance)),
    ]  # fmt: skip
