"""Fault detection: shares of detected mutants, undetected mutants, changed references."""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verify.core.results import Caught, Survivor

NAMES = {
    "formulas": "Formulas: a changed sign, factor, power or argument",
    "judging": "Judging: the same changes in the code that judges rows",
    "finite-elements": "Finite elements: the same changes in weak forms, contact and meshes",
}
SHORT = {
    "formulas": "formulas", "judging": "judging", "finite-elements": "finite elements",
    "references": "changed references",
}  # fmt: skip
PRINTED = "the smallest change that must be detected exceeds 1 %: printed with few digits"


@dataclass(frozen=True)
class Moved:
    """Rows of one kind whose references were changed.

    `rows` is their number. `red` is the number of failed rows for each change.
    """

    kind: str
    rows: int
    red: Sequence[int]


def share(count: int, total: int) -> str:
    """Text of a share in per cent; empty for an empty group."""
    return f"{100 * count / total:.1f}\u202f%" if total else ""


def interval(count: int, total: int) -> str:
    """Text of the 95 % confidence interval (Wilson) of the share of detected mutants.

    `count` of the `total` mutants of a sample are detected.
    """
    if not total:
        return ""
    z, p = 1.96, count / total
    half = z * math.sqrt(p * (1 - p) / total + (z / (2 * total)) ** 2)
    low, high = ((p + z**2 / (2 * total) + s * half) / (1 + z**2 / total) for s in (-1, 1))
    return f"{100 * low:.0f} to {100 * high:.0f}\u202f%"


def stale(caught: Caught) -> str:
    """Sentences about groups of mutants that were measured only with earlier code, or never."""
    known = {group.name for group in caught.groups}
    if caught.references:
        known.add("references")
    heads = {
        True: "Measured with earlier code, but not yet with the present code",
        False: "Never measured",
    }
    found = {
        head: [SHORT[name] for name in caught.stale if (name in known) is is_known]
        for is_known, head in heads.items()
    }
    return " ".join(f"{head}: {', '.join(names)}." for head, names in found.items() if names)


def moved(caught: Caught) -> tuple[list[str], list[Moved]]:
    """Names of changes of references; a line for each kind of row and for all that must fail."""
    data = caught.references
    if not data:
        return [], []
    names = list(data["gate"]["red"])
    kinds: Mapping[str, Any] = {
        **data["kinds"], "all rows that must fail at ±1 %": data["gate"],
        "all rows that must fail at ±1 % and depend on a value of a formula": data["the rest"],
    }  # fmt: skip
    lines = [
        Moved(kind, one["rows"], [one["red"][name] for name in names])
        for kind, one in kinds.items() if one["rows"]
    ]  # fmt: skip
    return names, lines


def green(caught: Caught) -> list[str]:
    """Texts about rows that pass although their references were changed."""
    return [
        f"{one['row']}: passes with the reference changed by {', '.join(one['green at'])}"
        for one in caught.references.get("survivors", ())
    ]


def only_listed(caught: Caught) -> list[tuple[str, int]]:
    """Reasons why rows are not required to fail, and the number of rows for each reason.

    The reason with the most rows comes first.
    """
    counts: Counter[str] = Counter()
    for reason, rows in caught.references.get("listed", {}).get("because", {}).items():
        coarse = reason.startswith(PRINTED)
        counts[PRINTED if coarse else reason] += len(rows)
    return counts.most_common()


def in_words(caught: Caught) -> list[str]:
    """Sentences on rows that the shares do not include, by reason."""
    data = caught.references
    if not data:
        return []
    listed, moved = data["listed"], data["by formula"]
    always = ", ".join(f"{n} {why}" for why, n in data["apart"].items())
    return [
        f"{listed['rows']} of {data['rows']} rows are not required to fail if their reference is "
        f"changed by ±1 %. This is {100 * listed['share']:.1f} % of all rows, or "
        f"{100 * listed['share without convergence']:.1f} % of the rows that remain without the "
        f"{data['convergence']} convergence rows.",
        f"If values of formulas are changed instead of references, {moved['reached']} of the "
        f"{moved['rows']} rows with a formula depend on a changed value, and "
        f"{moved['rows'] - moved['reached']} do not; "
        f"of those that depend on one, {len(moved['hidden'])} pass in spite of the change.",
        f"Rows that must fail if their reference is changed, but do not depend on any value of a "
        f"formula: {always}.",
    ]


def survivors(caught: Caught) -> list[tuple[str, list[Survivor]]]:
    """Undetected mutants of each group; those without a reason come first."""
    return [
        (SHORT[group.name], found)
        for group in caught.groups
        if (found := sorted(
            (one for one in caught.survivors if one.group == group.name),
            key=lambda one: (bool(one.reason), one.where, one.line),
        ))
    ]  # fmt: skip
