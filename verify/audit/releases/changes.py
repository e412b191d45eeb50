"""Comparison of a run with the newest release, and its lines on the terminal."""

from collections.abc import Sequence

from verify.audit.releases.compare import drift
from verify.audit.releases.reasons import read
from verify.audit.releases.store import newest
from verify.core.results import NAME, CaseResult, Change, Drift

WITHOUT = "tolerance loosened without a reason"
MOST = 12  # lines of changes; the report lists all


def since(results: Sequence[CaseResult]) -> Drift | None:
    """Changes since the newest release; None if there is no release.

    Raises InputError if a file of releases or of reasons cannot be read.
    """
    release = newest()
    return None if release is None else drift(release, results, read())


def lines(found: Drift) -> list[str]:
    """Lines for the terminal: loosened requirements first; one line if nothing changed."""
    head = f"since {found.release}: {summary(found)}"
    red = [f"{WITHOUT}: {line(c)}" for c in found.unexplained]
    explained = [f"  {line(c)}" for c in found.changes if c.loosened and c.reason]
    more = sorted((c for c in found.changes if not c.loosened), key=lambda c: c.aspect == NAME)
    other = [f"  {line(c)}" for c in more]
    if len(other) > MOST:
        other = [*other[:MOST], f"  and {len(other) - MOST} more, see the report"]
    unused = [f"  unused reason: {text}" for text in found.unused]
    return [head, *red, *explained, *other, *unused]


def summary(found: Drift) -> str:
    """Text of the counts: "1672 rows compared, no changes"."""
    loosened = sum(c.loosened for c in found.changes)
    renamed = sum(c.aspect == NAME and not c.loosened for c in found.changes)
    counts = [
        (renamed, "{} renamed"),
        (len(found.changes) - loosened - renamed, "{} changed"),
        (loosened, "{} loosened"),
        (len(found.unexplained), "{} of them without a reason"),
        (found.tightened, "{} tightened"),
    ]
    parts = [words.format(n) for n, words in counts if n]
    return ", ".join([f"{found.compared} rows compared", *(parts or ["no changes"])])


def line(change: Change) -> str:
    """Text of one change, with its reason if stated."""
    size = f" ({change.size})" if change.size else ""
    why = f"; {change.reason}" if change.reason else ""
    return f"{change.row}: {change.aspect} {change.was} -> {change.now}{size}{why}"
