"""Writing of tables into an Excel workbook; texts stay texts, missing numbers stay empty."""

import io
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import xlsxwriter

from reports.rows import FORMULAS
from reports.xml_text import clean
from verify.core.results import Status

LONGEST = 32767  # characters that a cell holds
WIDEST = 60.0  # of a column, in characters
COLOURS = {  # of states, as on the page
    Status.FAIL: ("#b3261e", "#fcebe9"), Status.SKIP: ("#5c646d", "#eceef0"),
    Status.NOTE: ("#8a5a00", "#fff3dc"), Status.CALIBRATED: ("#5a4a9c", "#eeebfa"),
    Status.SHOWN: ("#3f6273", "#e6eff3"), Status.PASS: ("#17704a", "#e5f4ec"),
}  # fmt: skip
_PRINTED = re.compile(r"([−-]?\d+(?:\.(\d+))?)(?:×10\^([−-]?\d+))?")


@dataclass(frozen=True)
class Link:
    """A text that links to a cell of this workbook; `target` has the form 'Sheet'!A1."""

    text: str
    target: str


@dataclass(frozen=True)
class Printed:
    """A number as printed in a paper, including its number of digits."""

    text: str


Cell = str | float | Link | Printed | None


class Book:
    """A workbook in memory; equal tables give equal bytes."""

    def __init__(self, title: str, made: datetime) -> None:
        self._bytes = io.BytesIO()
        self._book = xlsxwriter.Workbook(self._bytes, {"in_memory": True})
        self._book.set_properties({"title": clean(title), "created": made})
        self._formats: dict[str, Any] = {}

    def content(self) -> bytes:
        """Close the workbook and return its bytes; no further sheet can be added."""
        self._book.close()
        return self._bytes.getvalue()

    def table(
        self,
        name: str,
        header: Sequence[str],
        rows: Sequence[Sequence[Cell]],
        *,
        numbers: Mapping[str, str] | None = None,
        above: Sequence[Sequence[Cell]] = (),
    ) -> None:
        """Add a sheet with a fixed head and filters; `numbers` are number formats by column.

        `above` are lines before the head. A column with the name "status" is coloured.
        """
        sheet, top = self._book.add_worksheet(name), len(above)
        for i, line in enumerate(above):
            for k, cell in enumerate(line):
                self._write(sheet, i, k, cell, {"bold": True} if i == 0 else {})
        for k, word in enumerate(header):
            self._write(
                sheet, top, k, word, {"bold": True, "bottom": 1, "text_wrap": True, "valign": "top"}
            )
        for k, word in enumerate(header):
            column = [row[k] for row in rows]
            longest = max(len(_text(cell)) for cell in (word, *column))
            look = {"num_format": (numbers or {}).get(word, "General"), "valign": "top"}
            sheet.set_column(k, k, min(WIDEST, max(7.0, longest + 2.0)))
            for i, cell in enumerate(column, top + 1):
                self._write(sheet, i, k, cell, look | {"text_wrap": longest > WIDEST})
        if not rows:
            return
        sheet.freeze_panes(top + 1, 0)
        sheet.autofilter(top, 0, top + len(rows), len(header) - 1)
        if "status" in header:
            self._coloured(sheet, top + 1, top + len(rows), list(header).index("status"))

    def _coloured(self, sheet: Any, first: int, last: int, column: int) -> None:
        for status, (ink, wash) in COLOURS.items():
            rule = {
                "type": "cell", "criteria": "==", "value": f'"{status.value}"',
                "format": self._format({"font_color": ink, "bg_color": wash}),
            }  # fmt: skip
            sheet.conditional_format(first, column, last, column, rule)

    def _write(self, sheet: Any, i: int, k: int, cell: Cell, look: Mapping[str, Any]) -> None:
        if isinstance(cell, Printed):
            self._write(sheet, i, k, *_printed(cell.text, look))
        elif isinstance(cell, Link):
            link = self._format({**look, "font_color": "#0b4f96", "underline": 1})
            sheet.write_url(i, k, f"internal:{cell.target}", link, clean(cell.text))
        elif isinstance(cell, str):
            if cell:  # a text that looks like a formula stays one when it is edited
                guarded = {"quote_prefix": True} if cell.startswith(FORMULAS) else {}
                sheet.write_string(i, k, clean(cell)[:LONGEST], self._format({**look, **guarded}))
        elif cell is not None and math.isfinite(cell):
            sheet.write_number(i, k, cell, self._format(look))

    def _format(self, look: Mapping[str, Any]) -> Any:
        """Format for a style; each style has one format, because a workbook permits few formats."""
        key = repr(sorted(look.items()))
        if key not in self._formats:
            self._formats[key] = self._book.add_format(dict(look))
        return self._formats[key]


def _printed(text: str, look: Mapping[str, Any]) -> tuple[str | float, Mapping[str, Any]]:
    """A printed number with a format of its decimals, or the text if it is not a number."""
    found = _PRINTED.fullmatch(text)
    if not found:
        return text, look
    shown = f"0.{'0' * len(found[2])}" if found[2] else "0"
    power = "E+00" if found[3] else ""
    number = float(f"{found[1]}e{found[3] or 0}".replace("−", "-"))
    return number, {**look, "num_format": shown + power}


def _text(cell: Cell) -> str:
    if isinstance(cell, Link | Printed):
        return cell.text
    return "" if cell is None else cell if isinstance(cell, str) else f"{cell:.9g}"
