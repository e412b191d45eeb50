"""Output of `freewheel mutants`: one line per group, then all undetected mutants."""

from collections.abc import Mapping
from typing import Any

from verify.core.results import Caught, MutantGroup, Survivor


def print_score(caught: Caught) -> None:
    """Print the counts of each group and the undetected mutants, those without a reason first."""
    if caught.references:
        for line in moved(caught.references):
            print(line)
    for group in caught.groups:
        print(counted(group))
    for survivor in sorted(caught.survivors, key=lambda one: (one.group, bool(one.reason))):
        print(named(survivor))


def moved(data: Mapping[str, Any]) -> list[str]:
    """Lines that count rows with changed references: rows that must fail, then all other rows."""
    gate, rest, listed, formula = (data[k] for k in ("gate", "the rest", "listed", "by formula"))
    excluded = ", ".join(f"{n} {why}" for why, n in data["apart"].items())
    return [
        f"references: {gate['rows']} rows must fail; failed at {_reds(gate)}",
        f"  {rest['rows']} of these rows depend on a value of a formula: {_reds(rest)}; "
        f"excluded: {excluded}",
        f"  not required: {listed['rows']} of {data['rows']} rows ({listed['share']:.1%}; "
        f"{listed['share without convergence']:.1%} without {data['convergence']} of convergence)",
        f"  of {formula['rows']} rows with a formula {formula['reached']} depend on its value, "
        f"{formula['rows'] - formula['reached']} do not, {len(formula['hidden'])} hide an error",
    ]


def _reds(shares: Mapping[str, Any]) -> str:
    return ", ".join(f"{name}: {red}" for name, red in shares["red"].items())


def counted(group: MutantGroup) -> str:
    """Line with the numbers of detected and undetected mutants of one group, also in per cent."""
    tried = max(group.tried, 1)
    parts = ", ".join(
        f"{word} {count} ({count / tried:.1%})"
        for word, count in (
            ("rows", group.rows), ("tests", group.tests), ("nothing", group.survived),
        )
    )  # fmt: skip
    lost = group.apart
    failed = f"; {lost} others crashed or did not end" if lost else ""
    return f"{group.name}: {group.tried} of {group.all} mutants tried, detected by {parts}{failed}"


def named(survivor: Survivor) -> str:
    """Line with the place and the text of an undetected change, and why it is not detected."""
    place = f"{survivor.where} line {survivor.line}"
    reason = survivor.reason or "no reason given"
    return f"  not detected: {place}: {survivor.before} -> {survivor.after} ({reason})"
