"""Changes since a release: every change of a stated number, large changes of a computed number.

Kinds, statuses, requirements, stated bands and figures are reported if they differ at all. Computed
numbers are reported if they change by more than the numerical error of the row and 10 % of its band
(verify.audit.releases.thresholds).

A stated reason (verify.audit.releases.reasons) is required for a loosened requirement or band, for
a larger scale of either, and for a row that is missing or has a weaker status. Without a reason,
the run fails. Numbers that are printed with equal digits are not a change. Stated numbers are
printed with all digits that differ.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from verify.audit.releases.bands import STRENGTH, tightened
from verify.audit.releases.reasons import Reason, stated
from verify.audit.releases.renames import case_of, name_change, renamed_rows
from verify.audit.releases.row_changes import row_changes
from verify.audit.releases.store import Kept, Release, kept
from verify.core.results import CaseResult, Change, Drift, Status


def drift(release: Release, results: Sequence[CaseResult], reasons: Sequence[Reason]) -> Drift:
    """Differences between the rows of `results` and those of the release.

    Cases that were not run, and rows that were skipped, are not compared.
    """
    present = {row.id: kept(row) for r in results for row in r.rows}
    judged = {i: row for i, row in present.items() if row.status != Status.SKIP}
    whole = {
        r.id for r in results if not r.errors and all(x.status is not Status.SKIP for x in r.rows)
    }
    renamed = renamed_rows(release.rows, present, whole)
    changes: list[Change] = []
    tighter: list[Change] = []
    compared = 0
    for row_id, now in judged.items():
        before = release.rows.get(renamed.get(row_id, row_id))
        if before is None or before.status == Status.SKIP:
            continue
        compared += 1
        found = _visible(row_changes(row_id, before, now))
        if not any(c.loosened for c in found):
            tighter += _visible(tightened(row_id, before, now))
        if old := renamed.get(row_id):
            changes.append(name_change(old, row_id))
        changes += found
    changes += _gone(release.rows, present, set(renamed.values()), whole)
    changes += _new(release.rows, judged, renamed, [r.id for r in results])
    changes = [
        replace(c, reason=stated(c, reasons, release.version)) if c.loosened else c for c in changes
    ]
    return Drift(
        release=release.version, date=release.date, commit=release.commit, compared=compared,
        tightened=len({c.row for c in tighter}), tighter=tuple(tighter), changes=tuple(changes),
        unused=_unused(changes, reasons, release, whole),
    )  # fmt: skip


def _visible(changes: Iterable[Change]) -> list[Change]:
    """Changes, except those that are printed with equal digits before and after."""
    return [c for c in changes if c.was != c.now]


def _gone(
    before: Mapping[str, Kept],
    now: Mapping[str, Kept],
    renamed: Collection[str],
    whole: Collection[str],
) -> list[Change]:
    """Changes for rows that a case no longer has; a reason is required for judged rows."""
    return [
        Change(row=i, aspect="gone", was=row.status, now="none", loosened=STRENGTH[row.status] > 0)
        for i, row in before.items()
        if i not in now and i not in renamed and case_of(i) in whole and row.status in STRENGTH
    ]


def _new(
    before: Mapping[str, Kept],
    judged: Mapping[str, Kept],
    renamed: Mapping[str, str],
    run: Collection[str],
) -> list[Change]:
    """Changes that state, for each case, how many of its rows are not in the release."""
    found = [case_of(i) for i in judged if i not in before and i not in renamed]
    return [
        Change(row=case, aspect="new", was="none", now=f"{n} row{'s' * (n > 1)}")
        for case in run
        if (n := found.count(case))
    ]


def _unused(
    changes: Sequence[Change],
    reasons: Sequence[Reason],
    release: Release,
    whole: Collection[str],
) -> tuple[str, ...]:
    """Reasons for changes since the release that explain no loosened change.

    Only reasons for rows of the cases in `whole` are included.
    """
    return tuple(
        f"{reason.rows}: {reason.aspect}: {reason.what}"
        for reason in reasons
        if reason.since == release.version
        and any(case_of(reason.rows) == case for case in whole)
        and not any(c.loosened and reason.covers(c, release.version) for c in changes)
    )
