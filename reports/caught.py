"""Fault detection: shares of mutants that are detected, survivors, references changed."""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verify.core.results import Caught, Survivor

NAMES = {
    "formulas": "Formulas: a sign, a factor, a power, an argument changed",
    "judging": "Judging: the same in the code that judges rows",
    "finite-elements": "Finite elements: the same in weak forms, contact and meshes",
}
SHORT = {
    "formulas": "formulas", "judging": "judging", "finite-elements": "finite elements",
    "references": "references moved",
}  # fmt: skip
PRINTED = "a wider demand: printed as "


@dataclass(frozen=True)
class Moved:
    """Rows of one kind whose references were changed: their number, and how many failed."""

    kind: str
    rows: int
    red: Sequence[int]


def share(count: int, total: int) -> str:
    """A share in per cent; empty for an empty group."""
    return f"{100 * count / total:.1f}\u202f%" if total else ""


def interval(count: int, total: int) -> str:
    """Confidence interval of the share of all mutants at 95 % (Wilson) by a sample."""
    if not total:
        return ""
    z, p = 1.96, count / total
    half = z * math.sqrt(p * (1 - p) / total + (z / (2 * total)) ** 2)
    low, high = ((p + z**2 / (2 * total) + s * half) / (1 + z**2 / total) for s in (-1, 1))
    return f"{100 * low:.0f} to {100 * high:.0f}\u202f%"


def stale(caught: Caught) -> str:
    """Mutants not measured for this code, in words, and those measured for earlier code."""
    known = {group.name for group in caught.groups}
    if caught.references:
        known.add("references")
    heads = {True: "Measured for earlier code, not for this", False: "Not measured for this code"}
    found = {
        head: [SHORT[name] for name in caught.stale if (name in known) is is_known]
        for is_known, head in heads.items()
    }
    return " ".join(f"{head}: {', '.join(names)}." for head, names in found.items() if names)


def moved(caught: Caught) -> tuple[list[str], list[Moved]]:
    """The perturbations of references by name, and a line for each kind of row and for all."""
    data = caught.references
    if not data:
        return [], []
    names = list(data["gate"]["red"])
    kinds: Mapping[str, Any] = {
        **data["kinds"], "all that must fail at ±1 %": data["gate"],
        "of these, all that a formula’s value reaches": data["the rest"],
    }  # fmt: skip
    lines = [
        Moved(kind, one["rows"], [one["red"][name] for name in names])
        for kind, one in kinds.items() if one["rows"]
    ]  # fmt: skip
    return names, lines


def green(caught: Caught) -> list[str]:
    """Rows that pass under some perturbation, in words."""
    return [
        f"{one['row']} at {', '.join(one['green at'])}"
        for one in caught.references.get("survivors", ())
    ]


def only_listed(caught: Caught) -> list[tuple[str, int]]:
    """Reasons why rows are not required to fail, and their numbers, the largest first."""
    counts: Counter[str] = Counter()
    for reason, rows in caught.references.get("listed", {}).get("because", {}).items():
        coarse = reason.startswith(PRINTED)
        counts["lower required sensitivity: printed with few digits" if coarse else reason] += len(
            rows
        )
    return counts.most_common()


def in_words(caught: Caught) -> list[str]:
    """Rows that the shares leave out: not required to fail, not reached, or failing always."""
    data = caught.references
    if not data:
        return []
    listed, moved = data["listed"], data["by formula"]
    always = ", ".join(f"{n} {why}" for why, n in data["apart"].items())
    return [
        f"{listed['rows']} of {data['rows']} rows are not required to fail at ±1 %: "
        f"{listed['share']:.1%}, or {listed['share without convergence']:.1%} without the "
        f"{data['convergence']} rows of convergence.",
        f"If a value of the formulas is changed instead, {moved['reached']} of {moved['rows']} "
        f"rows with a formula depend on it, {moved['rows'] - moved['reached']} do not; "
        f"{len(moved['hidden'])} pass in spite of the change.",
        f"Rows that fail whatever the value of a formula, counted separately: {always}.",
    ]


def survivors(caught: Caught) -> list[tuple[str, list[Survivor]]]:
    """Survivors of each group; survivors without a reason come first."""
    return [
        (SHORT[group.name], found)
        for group in caught.groups
        if (found := sorted(
            (one for one in caught.survivors if one.group == group.name),
            key=lambda one: (bool(one.reason), one.where, one.line),
        ))
    ]  # fmt: skip
