"""Fault detection in the PDF: the same counts and undetected mutants as on the page."""

from reports.caught import (
    NAMES,
    green,
    in_words,
    interval,
    moved,
    only_listed,
    share,
    stale,
    survivors,
)
from reports.pdf_tables import Data, prose
from verify.core.results import Caught, MutantGroup


def caught_data(caught: Caught | None) -> Data | None:
    """Tables as cells of text; None in a report on user inputs."""
    if caught is None:
        return None
    names, lines = moved(caught)
    missing = f"{caught.missing[:1].upper()}{caught.missing[1:]}." if caught.missing else ""
    listed = "; ".join(f"{n} ({reason})" for reason, n in only_listed(caught))
    words = " ".join(in_words(caught))
    left = (
        (f"{words} Numbers of rows that are not required to fail at ±1 %, and reasons: {listed}.")
        if listed
        else words
    )
    return {
        "missing": prose(missing),
        "date": caught.date,
        "stale": stale(caught),
        "groups": [_group(group) for group in caught.groups],
        "moved": {
            "names": names,
            "rows": [
                [line.kind, str(line.rows), *(share(n, line.rows) for n in line.red)]
                for line in lines
            ],
            "green": prose("; ".join(green(caught))),
            "listed": prose(left),
        },
        "survivors": [
            {"name": name, "rows": [
                {"where": one.where, "line": one.line, "before": one.before, "after": one.after,
                 "reason": prose(one.reason or "no reason known")}
                for one in found
            ]}
            for name, found in survivors(caught)
        ],
    }  # fmt: skip


def _group(group: MutantGroup) -> list[str]:
    return [
        NAMES[group.name], f"{group.tried} of {group.all}",
        f"{share(group.caught, group.tried)} ({interval(group.caught, group.tried)})",
        *(f"{n} ({share(n, group.tried)})" for n in (group.rows, group.tests, group.survived)),
        str(group.apart),
    ]  # fmt: skip
