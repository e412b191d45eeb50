"""What the suite catches of mistakes made on purpose: shares, survivors, references moved."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verify.results import Caught, Survivor

NAMES = {
    "formulas": "Formulas: a sign, a factor, a power, an argument changed",
    "judging": "Judging: the same in what judges rows",
    "finite-elements": "Finite elements: the same in weak forms, contact and meshes",
}
SHORT = {"formulas": "formulas", "judging": "judging", "finite-elements": "finite elements"}


@dataclass(frozen=True)
class Moved:
    """Rows of one kind whose references were moved: how many, and how many of them turned red."""

    kind: str
    rows: int
    red: Sequence[int]


def share(count: int, total: int) -> str:
    """A share in per cent; nothing of nothing."""
    return f"{100 * count / total:.1f}\u202f%" if total else ""


def moved(caught: Caught) -> tuple[list[str], list[Moved]]:
    """The perturbations of references by name, and a line for each kind of row and for all."""
    data = caught.references
    if not data:
        return [], []
    names = list(data["gate"]["red"])
    kinds: Mapping[str, Any] = {**data["kinds"], "all that must turn red at ±1 %": data["gate"]}
    lines = [
        Moved(kind, one["rows"], [one["red"][name] for name in names])
        for kind, one in kinds.items() if one["rows"]
    ]  # fmt: skip
    return names, lines


def green(caught: Caught) -> list[str]:
    """Rows that some perturbation leaves green, in words."""
    return [
        f"{one['row']} at {', '.join(one['green at'])}"
        for one in caught.references.get("survivors", ())
    ]


def only_listed(caught: Caught) -> list[tuple[str, int]]:
    """Why rows are not held to the gate, and how many."""
    because = caught.references.get("listed", {}).get("because", {})
    return [(reason, len(rows)) for reason, rows in because.items()]


def survivors(caught: Caught) -> list[tuple[str, list[Survivor]]]:
    """The survivors of each group, those without a reason first."""
    return [
        (SHORT[group.name], found)
        for group in caught.groups
        if (found := sorted(
            (one for one in caught.survivors if one.group == group.name),
            key=lambda one: (bool(one.reason), one.where, one.line),
        ))
    ]  # fmt: skip
