"""Entries that a user of the page can select: machine parts, all cases, cases in the folder."""

from collections.abc import Sequence

from verify.cases.registry import CASES

PARTS = {
    "Sprag clutch": "sprag-clutch",
    "Roller clutch": "freewheel-clutch",
    "Drawn cup": "freewheel-cup",
    "Polyhedral ring clutch": "polyhedral-clutch",
    "Accordion spring": "spring-accordion",
    "Shaft": "rotor-system",
    "Contact": "contact-roller",
}


def groups(files: Sequence[str], also: str = "") -> list[tuple[str, list[tuple[str, str]]]]:
    """Headings, each with the (name, title) of its entries.

    `files` are Python files with cases. `also` is added to them if it is a Python file.
    """
    own = sorted({*files, *([also] if also.endswith(".py") else [])})
    found = [
        ("Parts", [(case, title) for title, case in PARTS.items()]),
        ("All cases", [(case, case) for case in CASES.ids]),
    ]
    return [*found, ("Cases in the folder", [(name, name) for name in own])] if own else found
