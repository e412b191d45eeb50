"""Changes since a release, in words and for the PDF."""

from collections.abc import Sequence

from reports.pdf_tables import Data, prose
from reports.richtext import Run
from verify.core.results import Change, Drift

MOST = 150  # lines; results.json has all


def summary(drift: Drift) -> str:
    """The counts in one sentence without its stop."""
    loosened = sum(c.loosened for c in drift.changes)
    without = len(drift.unexplained)
    counts = [
        (len(drift.changes) - loosened, "change{} listed"),
        (loosened, "requirement{0} loosened"),
        (without, "of them without a reason"),
        (drift.tightened, "row{} tightened"),
    ]
    told = [f"{n} {words.format('s' * (n > 1))}" for n, words in counts if n]
    return ", ".join([f"{drift.compared} rows compared", *(told or ["nothing moved"])])


def shown(drift: Drift) -> list[Change]:
    """As many changes as fit, relaxed requirements without a reason first."""
    return sorted(drift.changes, key=lambda c: (not c.loosened, bool(c.reason)))[:MOST]


def left_out(drift: Drift) -> str:
    """Number of changes that are not listed, in words."""
    return _more(drift.changes)


def tighter(drift: Drift) -> Sequence[Change]:
    """Requirements that became stricter, as many as fit."""
    return drift.tighter[:MOST]


def tighter_left_out(drift: Drift) -> str:
    """Number of rows with stricter requirements that are not listed, in words."""
    return _more(drift.tighter)


def _more(changes: Sequence[Change]) -> str:
    more = len(changes) - MOST
    return f"{more} more are in results.json, drift." if more > 0 else ""


def since_data(drift: Drift | None) -> Data | None:
    """The section for the PDF, loosened requirements first."""
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
