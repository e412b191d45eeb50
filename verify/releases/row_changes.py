"""What differs between a row of a release and the same row now."""

import math
from collections.abc import Iterator

from verify.judge import COVERAGE
from verify.releases.kept import Kept
from verify.releases.thresholds import (
    ROUND_OFF,
    SOLVE_TOL,
    figures,
    is_wider,
    margin_limit,
    numerical_error,
    relative_error,
    sensitivity_limit,
    value_limit,
)
from verify.results import Change, Status

GROWN = 2.0  # times a detection limit or uncertainty: meshes of other gmsh builds do less
NOTHING = "none"
CONVERGENCE = ": convergence"  # judges an order, which may scatter
STRENGTH = {"PASS": 2, "CALIBRATED": 1, "SHOWN": 0, "NOTE": 0}


def row_changes(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
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
        yield from _less_sensitive(row_id, was, now)
    yield from _bands(row_id, was, now)


def _values(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Formula, finite elements, or the margin of a fact, where it moved."""
    if row_id.endswith(CONVERGENCE):
        return
    error, limit = numerical_error(was, now), value_limit(was, now)
    yield from _moved(row_id, "formula", (was.analytic, now.analytic), was, error, limit)
    solved = limit or SOLVE_TOL * abs(was.reference or 0.0)
    yield from _moved(row_id, "finite elements", (was.reference, now.reference), was, error, solved)
    if was.kind == "fact" and was.analytic is None and was.reference is None:
        margins = (was.difference, now.difference)
        yield from _moved(row_id, "margin", margins, was, error, margin_limit(was, now))


def _moved(
    row_id: str,
    aspect: str,
    values: tuple[float | None, float | None],
    row: Kept,
    error: float,
    limit: float,
) -> Iterator[Change]:
    """A value that moved by more than `limit` [unit] and round-off, or is there in one run only."""
    was, now = values
    if was is None and now is None:
        return
    if was is None or now is None:
        was_text, now_text = _number(was, row.unit), _number(now, row.unit)
        yield Change(row=row_id, aspect=aspect, was=was_text, now=now_text)
        return
    scale = row.scale or 0.0
    if abs(now - was) > max(limit, ROUND_OFF * max(scale, abs(was), abs(now))):
        digits = 10 if abs(now - was) > 1e-9 * abs(was) else 15
        yield Change(
            row=row_id, aspect=aspect, was=_number(was, row.unit, digits),
            now=_number(now, row.unit, digits), size=_size(now - was, scale or abs(was), error),
        )  # fmt: skip


def _size(change: float, scale: float, error: float) -> str:
    share = f"{change / scale:+.2g} of the scale" if scale else f"{change:+.2g}"
    return f"{share}, {abs(change) / error:.3g} error bars" if error else share


def _number(value: float | None, unit: str, digits: int = 10) -> str:
    if value is None:
        return NOTHING
    return f"{value:.{digits}g}" + (f" {unit}" if unit != "1" else "")


def _less_sensitive(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Detection limit, or else uncertainty, where it grew to a multiple and by 10 % of the band."""
    if row_id.endswith(CONVERGENCE):
        return
    for aspect, read in (("detects", _detected), ("uncertainty", _uncertainty)):
        old, new = read(was), read(now)
        if old is None:
            continue
        least = max(GROWN * old, old + sensitivity_limit(was), ROUND_OFF)
        if new is None or new > least:
            size = f"{new / old:.3g} times" if new is not None and old else ""
            yield Change(row=row_id, aspect=aspect, was=_share(old), now=_share(new), size=size)
            return


def _detected(row: Kept) -> float | None:
    return row.detects


def _uncertainty(row: Kept) -> float | None:
    """The expanded one over the scale; of a fact that of its margin."""
    return row.tolerance if row.kind == "fact" else _numerical(row)


def _numerical(row: Kept) -> float | None:
    return None if row.u_num is None or not row.scale else COVERAGE * row.u_num / row.scale


def _bands(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Demands and bands that let more pass."""
    for one in figures(was, now):
        if one.is_loosened:
            yield Change(
                row=row_id, aspect=one.aspect, was=_share(one.was), now=_share(one.now),
                loosened=True,
            )  # fmt: skip
    if is_wider(was.interval, now.interval, relative_error(was, now)):
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


def tightened(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Demands and bands that let less pass."""
    for one in figures(was, now):
        if one.is_tightened:
            yield Change(row=row_id, aspect=one.aspect, was=_share(one.was), now=_share(one.now))
    if now.interval is None:
        return
    if was.interval is None or is_wider(now.interval, was.interval, relative_error(was, now)):
        old, new = _range(was.interval), _range(now.interval)
        yield Change(row=row_id, aspect="interval", was=old, now=new)


def _share(value: float | None) -> str:
    return NOTHING if value is None else f"{100 * value:.4g} %"


def _range(interval: tuple[float, float] | None) -> str:
    """Both ends in per cent, with as many digits as show 1e-4 of the width."""
    if interval is None:
        return NOTHING
    low, high = interval
    ratio = max(abs(low), abs(high)) / (high - low) if high > low else 1.0
    digits = 6 + max(0, math.ceil(math.log10(ratio)))
    return f"{100 * low:+.{digits}g} to {100 * high:+.{digits}g} %"
