"""Unique names of a workbook's sheets, with at most 31 characters and no brackets or slashes."""

import re
from collections.abc import Iterable

from reports.xml_text import clean
from verify.core.results import Report

FIXED = (
    "Summary", "Rows", "Inputs and values", "Levels", "Errata", "Equations", "Printed numbers",
    "Provenance",
)  # fmt: skip
LONGEST = 31
_FORBIDDEN = re.compile(r"[\[\]:*?/\\\x00-\x1f]+")


class Sheets:
    """Sheet names of all tables: `of_case` by case and table, `of_paper` by table of the papers."""

    def __init__(self, report: Report) -> None:
        self._taken = {name.casefold() for name in (*FIXED, "History")}  # the latter is reserved
        self.of_case = [self._names(t.title for t in case.tables) for case in report.cases]
        self.of_paper = self._names(f"{t.paper} {t.name}" for t in report.tables)

    def _names(self, titles: Iterable[str]) -> list[str]:
        return [self._name(title) for title in titles]

    def _name(self, title: str) -> str:
        """The beginning of the title, with a number if this name is already used."""
        words = " ".join(_FORBIDDEN.sub(" ", clean(title)).split()).strip("'") or "Table"
        name, number = words[:LONGEST].strip(" '"), 1
        while name.casefold() in self._taken:
            number += 1
            end = f" {number}"
            name = words[: LONGEST - len(end)].strip(" '") + end
        self._taken.add(name.casefold())
        return name
