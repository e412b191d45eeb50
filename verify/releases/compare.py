"""What has moved since a release: values beyond their errors, and demands and bands beyond it.

A value that moved is told, and an error that grew. A loosened demand or band, a row that is gone or
that judges less, needs a stated reason (verify.releases.reasons); without one the run is red.
"""

import math
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from verify.judge import COVERAGE
from verify.releases.kept import Kept, Release, kept
from verify.releases.reasons import Reason, stated
from verify.results import CaseResult, Change, Drift, Status

ROUND_OFF = 1e-10  # over the row's scale: iterated formulas end at 1e-12, on any processor
REPEATED = 1e-9  # of a margin without uncertainty: sums of other processors
SLACK = 1e-6  # relative, of bands that are computed from formulas
GROWN = 2.0  # times what a row detected or how uncertain it was: meshes of other builds do less
NOTHING = "none"
COMPANION = ": convergence"  # judges an order, which may scatter
STRENGTH = {"PASS": 2, "CALIBRATED": 1, "SHOWN": 0, "NOTE": 0}


def drift(release: Release, results: Sequence[CaseResult], reasons: Sequence[Reason]) -> Drift:
    """What the judged rows of `results` have in common with the release, and what not.

    Cases that were not run, and rows that were skipped, are not compared.
    """
    present = {row.id: kept(row) for r in results for row in r.rows}
    judged = {i: row for i, row in present.items() if row.status != Status.SKIP}
    whole = {
        r.id for r in results if not r.errors and all(x.status is not Status.SKIP for x in r.rows)
    }
    renamed = _renamed(release.rows, present, whole)
    changes: list[Change] = []
    tighter: list[Change] = []
    compared = 0
    for row_id, now in judged.items():
        before = release.rows.get(renamed.get(row_id, row_id))
        if before is None or before.status == Status.SKIP:
            continue
        compared += 1
        found = list(_changes(row_id, before, now))
        if not any(c.loosened for c in found):
            tighter += tightened(row_id, before, now)
        if old := renamed.get(row_id):
            changes.append(_name(old, row_id))
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


def _changes(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """All aspects of one row that differ."""
    if was.status != now.status:
        yield Change(
            row=row_id, aspect="status", was=was.status, now=now.status,
            loosened=STRENGTH.get(now.status, 9) < STRENGTH.get(was.status, -1),
        )  # fmt: skip
    kinds = [f"{x.kind} [{x.unit}]" for x in (was, now)]
    if Status.FAIL in (was.status, now.status):  # red as it is, and may lack any number
        if kinds[0] == kinds[1]:
            yield from (c for c in _values(row_id, was, now) if NOTHING not in (c.was, c.now))
        return
    if kinds[0] != kinds[1]:
        yield Change(row=row_id, aspect="kind", was=kinds[0], now=kinds[1])
    else:
        yield from _values(row_id, was, now)
        yield from _blunted(row_id, was, now)
    yield from _bands(row_id, was, now)


def _values(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Formula, finite elements, or the margin of a fact, where it moved."""
    scale = max(was.scale or 0.0, now.scale or 0.0)
    if row_id.endswith(COMPANION):
        return
    yield from _moved(row_id, "formula", (was.analytic, now.analytic), was.unit, scale, None)
    bar = _bar(was, now)
    yield from _moved(row_id, "finite elements", (was.reference, now.reference), was.unit, scale,
                      bar)  # fmt: skip
    if was.kind == "fact" and was.analytic is None and was.reference is None:
        bar = math.hypot(was.tolerance or 0.0, now.tolerance or 0.0)
        size = max(abs(was.difference or 0.0), abs(now.difference or 0.0))
        bar = max(bar, REPEATED * max(size, scale))
        yield from _moved(row_id, "margin", (was.difference, now.difference), was.unit, scale, bar)


def _bar(was: Kept, now: Kept) -> float:
    """The expanded numerical error of both runs; of a limit or balance what is allowed."""
    if was.u_num is None or now.u_num is None:
        return math.hypot(was.tolerance or 0.0, now.tolerance or 0.0)
    return COVERAGE * math.hypot(was.u_num, now.u_num)


def _moved(
    row_id: str,
    aspect: str,
    values: tuple[float | None, float | None],
    unit: str,
    scale: float,
    bar: float | None,
) -> Iterator[Change]:
    """A value beyond its error bar, or, without one, beyond round-off."""
    was, now = values
    if was is None and now is None:
        return
    if was is None or now is None:
        yield Change(row=row_id, aspect=aspect, was=_told(was, unit), now=_told(now, unit))
        return
    floor = ROUND_OFF * max(scale, abs(was), abs(now))
    if abs(now - was) > max(bar or 0.0, floor):
        digits = 10 if abs(now - was) > 1e-9 * abs(was) else 15
        yield Change(
            row=row_id, aspect=aspect, was=_told(was, unit, digits), now=_told(now, unit, digits),
            size=_size(now - was, scale or abs(was), bar),
        )  # fmt: skip


def _size(change: float, scale: float, bar: float | None) -> str:
    share = f"{change / scale:+.2g} of the scale" if scale else f"{change:+.2g}"
    return f"{share}, {abs(change) / bar:.3g} error bars" if bar else share


def _told(value: float | None, unit: str, digits: int = 10) -> str:
    if value is None:
        return NOTHING
    return f"{value:.{digits}g}" + (f" {unit}" if unit != "1" else "")


def _blunted(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """What a row detects, or else its uncertainty, where it has grown below what is demanded."""
    if row_id.endswith(COMPANION):
        return
    for aspect, read in (("detects", _detected), ("uncertainty", _uncertainty)):
        old, new = read(was), read(now)
        if old is not None and (new is None or new > max(GROWN * old, ROUND_OFF)):
            size = f"{new / old:.3g} times" if new is not None and old else ""
            yield Change(row=row_id, aspect=aspect, was=_share(old), now=_share(new), size=size)
            return


def _detected(one: Kept) -> float | None:
    return one.detects


def _uncertainty(one: Kept) -> float | None:
    """The expanded one over the scale; of a fact that of its margin."""
    if one.kind == "fact":
        return one.tolerance
    return _relative(None if one.u_num is None else COVERAGE * one.u_num, one.scale)


def _bands(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Demands and bands that let more pass."""
    for aspect, old, new in _figures(was, now):
        if _is_more(old, new):
            yield Change(row=row_id, aspect=aspect, was=_share(old), now=_share(new), loosened=True)
    if was.interval is not None and _is_wider(was.interval, now.interval):
        yield Change(
            row=row_id, aspect="interval", was=_range(was.interval), now=_range(now.interval),
            loosened=True,
        )  # fmt: skip
    for (word, old), (other, new) in zip(was.figures, now.figures, strict=False):
        if word == other and (new > old if word == "accepted" else new < old):
            yield Change(
                row=row_id, aspect="acceptance", was=f"{old:g} % {word}", now=f"{new:g} % {word}",
                loosened=True,
            )  # fmt: skip


def _figures(was: Kept, now: Kept) -> list[tuple[str, float | None, float | None]]:
    """Figures that let more pass the larger they are; those of a reference over its scale."""
    return [
        ("demand", was.demand, now.demand),
        ("bound", was.bound, now.bound),
        ("acceptance", was.accepted, now.accepted),
        ("reference", _relative(was.u_ref, was.scale), _relative(now.u_ref, now.scale)),
    ]


def _relative(u: float | None, scale: float | None) -> float | None:
    return None if u is None or not scale else u / scale


def _is_more(old: float | None, new: float | None) -> bool:
    """Grown, or no longer there."""
    if old is None:
        return False
    return new is None or new > old * (1 + SLACK) + 1e-15


def _is_wider(old: tuple[float, float], new: tuple[float, float] | None) -> bool:
    """Beyond the old interval on either side, however narrow on the other."""
    if new is None:
        return True
    slack = SLACK * max(old[1] - old[0], abs(old[0]), abs(old[1]))
    return new[0] < old[0] - slack or new[1] > old[1] + slack


def tightened(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Demands and bands that let less pass."""
    for aspect, old, new in _figures(was, now):
        if old is not None and new is not None and new < old * (1 - SLACK):
            yield Change(row=row_id, aspect=aspect, was=_share(old), now=_share(new))
    if now.interval is not None and (was.interval is None or _is_wider(now.interval, was.interval)):
        old_range, new_range = _range(was.interval), _range(now.interval)
        yield Change(row=row_id, aspect="interval", was=old_range, now=new_range)


def _share(value: float | None) -> str:
    return "none" if value is None else f"{100 * value:.4g} %"


def _range(interval: tuple[float, float] | None) -> str:
    return "none" if interval is None else f"{100 * interval[0]:+.6g} to {100 * interval[1]:+.6g} %"


def _renamed(
    before: Mapping[str, Kept], now: Mapping[str, Kept], whole: Collection[str]
) -> dict[str, str]:
    """New ids by the old one of the same case, kind, unit and values, where only one fits."""
    gone = [i for i in before if i not in now and _case(i) in whole]
    found: dict[str, str] = {}
    for new in (i for i in now if i not in before):
        fits = [
            old for old in gone
            if _case(old) == _case(new) and old.endswith(COMPANION) == new.endswith(COMPANION)
            and old not in found.values() and _is_same(before[old], now[new])
        ]  # fmt: skip
        if len(fits) == 1:
            found[new] = fits[0]
    return found


def _is_same(was: Kept, now: Kept) -> bool:
    """Whether two rows of different names have one kind, one unit and the same numbers."""
    numbers = [(x.analytic, x.reference, x.difference, x.u_num) for x in (was, now)]
    if (was.kind, was.unit) != (now.kind, now.unit) or not any(v is not None for v in numbers[0]):
        return False
    return all(
        (a is None and b is None)
        or (a is not None and b is not None and math.isclose(a, b, rel_tol=REPEATED))
        for a, b in zip(*numbers, strict=True)
    )


def _name(old: str, new: str) -> Change:
    """A new name; where it states another figure, it may claim less."""
    figures = [re.findall(r"\d+(?:\.\d+)?(?= ?%)", name) for name in (old, new)]
    return Change(
        row=new, aspect="name", was=old.partition("/")[2], now=new.partition("/")[2],
        loosened=figures[0] != figures[1],
    )  # fmt: skip


def _gone(
    before: Mapping[str, Kept],
    now: Mapping[str, Kept],
    renamed: Collection[str],
    whole: Collection[str],
) -> list[Change]:
    """Rows that a case no longer has; those that judged something need a reason."""
    return [
        Change(row=i, aspect="gone", was=row.status, now="none", loosened=STRENGTH[row.status] > 0)
        for i, row in before.items()
        if i not in now and i not in renamed and _case(i) in whole and row.status in STRENGTH
    ]


def _new(
    before: Mapping[str, Kept],
    judged: Mapping[str, Kept],
    renamed: Mapping[str, str],
    run: Collection[str],
) -> list[Change]:
    """How many rows each case has more than the release."""
    found = [_case(i) for i in judged if i not in before and i not in renamed]
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
    """Reasons since the release for rows of cases that ran, which no change asks for."""
    return tuple(
        f"{reason.rows}: {reason.aspect}: {reason.what}"
        for reason in reasons
        if reason.since == release.version
        and any(_case(reason.rows) == case for case in whole)
        and not any(c.loosened and reason.covers(c, release.version) for c in changes)
    )


def _case(row_id: str) -> str:
    return row_id.partition("/")[0]
