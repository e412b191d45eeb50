"""Summary of a run in Markdown, for the page of a CI job: counts, failing rows, versions."""

import sys
from collections.abc import Sequence
from pathlib import Path

from verify.app.provenance import version_of
from verify.core.console import raised
from verify.core.inputs import InputError
from verify.core.results import Report, Status

FAILED = (Status.FAIL, Status.SKIP)
LISTED = 50  # failing rows; a job's page has room for 1 MB
PROJECT = "freewheel-verification"


def summary(report: Report, *, status: int, changes: Sequence[str] = ()) -> str:
    """Summary of the run in Markdown.

    `changes` are lines about differences from the last release or from stored verdicts.
    """
    head = "passed" if status == 0 else "failed"
    rows, cases = len(report.rows), len(report.cases)
    parts = [
        f"## freewheel verify: {head}",
        f"{rows} rows of {cases} case{'s' if cases > 1 else ''}",
        _counts(report),
    ]
    if report.verdicts:
        from reports.verdicts import counts_in_markdown  # only the command line may import reports

        parts += ["### Verdicts of the formulas", counts_in_markdown(report)]
    if failing := _failing(report):
        parts += ["### Rows that fail", failing]
    if changes:
        parts += ["### Changes", "\n".join(f"- {_cell(line)}" for line in changes)]
    return "\n\n".join([*parts, _versions(report)]) + "\n"


def write(text: str, target: Path) -> None:
    """Append the text to a file, which may be /dev/stdout.

    Raises InputError if the file cannot be written.
    """
    sys.stdout.flush()
    try:
        with target.open("a", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        raise InputError(f"{target}: cannot be written: {error.strerror}") from error


def _counts(report: Report) -> str:
    """Table with the number of rows of each status."""
    names = " | ".join(status.value for status in Status)
    numbers = " | ".join(str(report.count(status)) for status in Status)
    return f"| {names} |\n|{'---|' * len(Status)}\n| {numbers} |"


def _failing(report: Report) -> str:
    """Table of the rows that failed or were not run, with reasons; empty without such rows."""
    failed = [row for row in report.rows if row.status in FAILED]
    if not failed:
        return ""
    lines = ["| case | row | status | reason |", "|---|---|---|---|"]
    for row in failed[:LISTED]:
        cells = (f"`{row.case}`", row.quantity, row.status.value, row.reason)
        lines.append(f"| {' | '.join(map(_cell, cells))} |")
    more = len(failed) - LISTED
    return "\n".join(lines) + (f"\n\nand {more} more rows" if more > 0 else "")


def _versions(report: Report) -> str:
    """Line with version and commit of the suite, Python, machine, date and duration of the run."""
    made = report.provenance
    return (
        f"freewheel {version_of(PROJECT)}, commit {made['commit']}, Python {made['python']}, "
        f"{made['machine']}; {made['made']}, {made['seconds']['total']:.0f} s"
    )


def _cell(text: str) -> str:
    """Text as one line of a table cell, with bars escaped."""
    return raised(" ".join(text.split())).replace("|", r"\|")
