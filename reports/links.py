"""Links between the pages of a report: page and address of each place."""

import re

from verify.core.results import Report

FIRST = "report.html"
FOLDER = "report"  # of all other pages, beside the first one
# a place on the page of a section, to which the menu leads
PLACES = {
    "explorer": "explorer",
    "rows": "summary", "papers": "tables", "errata": "errata", "solvers": "crosscheck",
    "faults": "caught", "since": "since", "provenance": "provenance",
}  # fmt: skip
# places on the first page, and kinds of places on the first page and others, by their beginning
HOMES = {
    "first": FIRST, "design": FIRST, "cases": FIRST, "paper": FIRST, "verdict": FIRST,
    "explore": f"{FOLDER}/explorer.html",
    "erratum": f"{FOLDER}/errata.html", "cross": f"{FOLDER}/solvers.html",
}  # fmt: skip
OTHERS = {place: name for name, place in PLACES.items()} | {
    "coverage": "papers", "readings": "errata",
}  # fmt: skip
_LINK = re.compile(r'href="#([^"]+)"')
_ID = re.compile(r'\bid="([^"]+)"')


def path_of(name: str) -> str:
    """Path of the page of a case or section."""
    return f"{FOLDER}/{name}.html"


class Places:
    """Look-up of the page that contains a place (the anchor of a link)."""

    def __init__(self, report: Report) -> None:
        self._cases = [case.id for case in report.cases]
        self._by_row = list(dict.fromkeys(row.case for row in report.rows))

    def page(self, place: str) -> str | None:
        """Path of the page of a place; None for a place that exists on every page."""
        kind, _, rest = place.partition("-")
        if place in OTHERS:
            return path_of(OTHERS[place])
        if kind == "case" and rest in self._cases:
            return path_of(rest)
        if kind == "row":
            return path_of(self._by_row[int(rest.partition("-")[0])])
        return HOMES.get(kind)


def linked(name: str, page: str, places: Places) -> str:
    """A page in which links to places on other pages are relative to its path."""
    here = set(_ID.findall(page))

    def link(found: re.Match[str]) -> str:
        place = found[1]
        target = None if place in here else places.page(place)
        if target is None:
            return found[0]
        path = _path(name, target)
        return f'href="{path}"' if place == "first" else f'href="{path}#{place}"'

    return _LINK.sub(link, page)


def _path(here: str, there: str) -> str:
    """Relative path from one page to another, both in the folder of the report."""
    if here == FIRST:
        return there
    return there.removeprefix(f"{FOLDER}/") if there.startswith(f"{FOLDER}/") else f"../{there}"
