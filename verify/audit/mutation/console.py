"""Output of `freewheel mutants`: a line for each group, then every survivor."""

from collections.abc import Mapping
from typing import Any

from verify.core.results import Caught, MutantGroup, Survivor


def told(caught: Caught) -> None:
    """Print the counts of each group and the survivors, those without a reason first."""
    if caught.references:
        for line in moved(caught.references):
            print(line)
    for group in caught.groups:
        print(counted(group))
    for survivor in sorted(caught.survivors, key=lambda one: (one.group, bool(one.reason))):
        print(named(survivor))


def moved(data: Mapping[str, Any]) -> list[str]:
    """Number of failed rows of the gate, and the counts of the other rows."""
    gate, rest, listed, formula = (data[k] for k in ("gate", "the rest", "listed", "by formula"))
    excluded = ", ".join(f"{n} {why}" for why, n in data["apart"].items())
    return [
        f"references: of {gate['rows']} rows fail at {_reds(gate)}",
        f"  of these {rest['rows']} that a formula's value reaches: {_reds(rest)}; "
        f"excluded: {excluded}",
        f"  not required: {listed['rows']} of {data['rows']} rows ({listed['share']:.1%}; "
        f"{listed['share without convergence']:.1%} without {data['convergence']} of convergence)",
        f"  of {formula['rows']} rows with a formula {formula['reached']} depend on its value, "
        f"{formula['rows'] - formula['reached']} do not, {len(formula['hidden'])} hide a change",
    ]


def _reds(shares: Mapping[str, Any]) -> str:
    return ", ".join(f"{name}: {red}" for name, red in shares["red"].items())


def counted(group: MutantGroup) -> str:
    """One line: shares with their counts."""
    tried = max(group.tried, 1)
    parts = ", ".join(
        f"{word} {count} ({count / tried:.1%})"
        for word, count in (
            ("rows", group.rows), ("tests", group.tests), ("nothing", group.survived),
        )
    )  # fmt: skip
    lost = group.apart
    failed = f"; {lost} more crashed or did not end" if lost else ""
    return f"{group.name}: {group.tried} of {group.all} mutants tried, caught by {parts}{failed}"


def named(survivor: Survivor) -> str:
    """One line: place and text of the change, and why it cannot be detected."""
    place = f"{survivor.where} line {survivor.line}"
    reason = survivor.reason or "no reason given"
    return f"  survives: {place}: {survivor.before} -> {survivor.after} ({reason})"
