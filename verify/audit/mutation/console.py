"""What `freewheel mutants` prints: a line for each group, then every survivor."""

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
    """How many of the rows held to the gate turn red, and what is said of the others."""
    gate, rest, listed, way = (data[k] for k in ("gate", "the rest", "listed", "by formula"))
    apart = ", ".join(f"{n} {why}" for why, n in data["apart"].items())
    return [
        f"references: of {gate['rows']} rows red at {_reds(gate)}",
        f"  of these {rest['rows']} that a formula's value reaches: {_reds(rest)}; apart: {apart}",
        f"  not asked: {listed['rows']} of {data['rows']} rows ({listed['share']:.1%}; "
        f"{listed['share without convergence']:.1%} without {data['convergence']} of convergence)",
        f"  of {way['rows']} rows with a formula {way['reached']} are reached by its value "
        f"changed, {way['rows'] - way['reached']} are not, {len(way['hidden'])} hide it",
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
    apart = f"; {group.apart} more crashed or did not end" if group.apart else ""
    return f"{group.name}: {group.tried} of {group.all} mutants tried, caught by {parts}{apart}"


def named(survivor: Survivor) -> str:
    """One line: what was changed where, and why nobody can see it."""
    place = f"{survivor.where} line {survivor.line}"
    reason = survivor.reason or "no reason given"
    return f"  survives: {place}: {survivor.before} -> {survivor.after} ({reason})"
