"""Texts about changes since a release, for the page and for the PDF."""

from collections.abc import Sequence

from reports.pdf_tables import Data, prose
from reports.richtext import Run
from verify.core.results import NAME, Change, Drift

MOST = 150  # lines; results.json has all


def summary(drift: Drift) -> str:
    """Sentence with the numbers of changes, without a full stop."""
    loosened = sum(c.loosened for c in drift.changes)
    renamed = sum(c.aspect == NAME and not c.loosened for c in drift.changes)
    without = len(drift.unexplained)
    counts = [
        (renamed, "row{} renamed"),
        (len(drift.changes) - loosened - renamed, "other change{} listed"),
        (loosened, "requirement{0} loosened"),
        (without, "of these without a reason"),
        (drift.tightened, "row{} tightened"),
    ]
    counts_in_words = [f"{n} {words.format('s' * (n > 1))}" for n, words in counts if n]
    return ", ".join([f"{drift.compared} rows compared", *(counts_in_words or ["no changes"])])


def shown(drift: Drift) -> list[Change]:
    """Changes to list, at most MOST.

    Loosened requirements without a reason come first, renamed rows last.
    """

    def rank(c: Change) -> tuple[bool, bool, bool]:
        return not c.loosened, bool(c.reason), c.aspect == NAME

    return sorted(drift.changes, key=rank)[:MOST]


def left_out(drift: Drift) -> str:
    """Sentence with the number of changes that are not listed; empty if all are listed."""
    return _more(drift.changes)


def tighter(drift: Drift) -> Sequence[Change]:
    """Requirements that became stricter, at most MOST."""
    return drift.tighter[:MOST]


def tighter_left_out(drift: Drift) -> str:
    """Sentence with the number of stricter requirements that are not listed; empty if none."""
    return _more(drift.tighter)


def _more(changes: Sequence[Change]) -> str:
    more = len(changes) - MOST
    return f"{more} more changes are in results.json (key drift)." if more > 0 else ""


def since_data(drift: Drift | None) -> Data | None:
    """Data of the section for the PDF, with loosened requirements first."""
    if drift is None:
        return None
    return {
        "release": drift.release,
        "lead": f"{summary(drift)}; the release is of {drift.date}, commit {drift.commit}.",
        "changes": [_change(c) for c in shown(drift)],
        "more": left_out(drift),
        "tighter": [_change(c) for c in tighter(drift)],
        "tighter_more": tighter_left_out(drift),
    }


def _change(c: Change) -> list[list[Run]]:
    why = (c.reason or "without a reason") if c.loosened else ""
    aspect = f"{c.aspect}, loosened" if c.loosened else c.aspect
    size = "; ".join(part for part in (c.size, why) if part)
    return [prose(text) for text in (c.row, aspect, c.was, c.now, size)]
