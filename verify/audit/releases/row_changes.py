"""Differences between a row of a release and the present row."""

from collections.abc import Iterator

from verify.audit.releases.bands import NOTHING, STRENGTH, loosened, number, share
from verify.audit.releases.store import Kept
from verify.audit.releases.thresholds import (
    ROUND_OFF,
    SOLVE_TOL,
    margin_limit,
    numerical_error,
    sensitivity_limit,
    value_limit,
)
from verify.core.results import Change, Status
from verify.judging.judge import COVERAGE

GROWN = 2.0  # times a detection limit or uncertainty: meshes of other gmsh builds do less
CONVERGENCE = ": convergence"  # these rows judge an order, which may scatter


def row_changes(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """All changes of one row."""
    if was.status != now.status:
        yield Change(
            row=row_id, aspect="status", was=was.status, now=now.status,
            loosened=STRENGTH.get(now.status, 9) < STRENGTH.get(was.status, -1),
        )  # fmt: skip
    kinds = [f"{x.kind} [{x.unit}]" for x in (was, now)]
    if kinds[0] != kinds[1] and now.status != Status.FAIL:
        yield Change(row=row_id, aspect="kind", was=kinds[0], now=kinds[1])
    if Status.FAIL in (was.status, now.status):
        yield from _of_red(row_id, was, now)
        return
    if kinds[0] == kinds[1]:
        yield from _values(row_id, was, now)
        yield from _less_sensitive(row_id, was, now)
    yield from loosened(row_id, was, now)


def _of_red(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Changes of a row that fails in one of the runs, in which any number may be missing."""
    if (was.kind, was.unit) == (now.kind, now.unit):
        yield from (c for c in _values(row_id, was, now) if NOTHING not in (c.was, c.now))
    is_red = now.status == Status.FAIL
    bands = loosened(row_id, was, now)
    yield from (c for c in bands if c.was != NOTHING and not (is_red and c.now == NOTHING))


def _values(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Changes of the formula, of finite elements, or of the margin of a fact."""
    if row_id.endswith(CONVERGENCE):
        return
    error, limit = numerical_error(was, now), value_limit(was, now)
    yield from _moved(row_id, "formula", (was.analytic, now.analytic), was, error, limit)
    solved = limit or SOLVE_TOL * abs(was.reference or 0.0)
    yield from _moved(row_id, "finite elements", (was.reference, now.reference), was, error, solved)
    if was.kind == "fact":
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
    """Yield a change if a value differs by more than `limit` [unit] and more than round-off.

    A change is also yielded if the value exists in one run only.
    """
    was, now = values
    if was is None and now is None:
        return
    if was is None or now is None:
        was_text, now_text = number(was, row.unit), number(now, row.unit)
        yield Change(row=row_id, aspect=aspect, was=was_text, now=now_text)
        return
    scale = row.scale or 0.0
    if abs(now - was) > max(limit, ROUND_OFF * max(scale, abs(was), abs(now))):
        digits = 10 if abs(now - was) > 1e-9 * abs(was) else 15
        yield Change(
            row=row_id, aspect=aspect, was=number(was, row.unit, digits),
            now=number(now, row.unit, digits), size=_size(now - was, scale or abs(was), error),
        )  # fmt: skip


def _size(change: float, scale: float, error: float) -> str:
    share = f"{change / scale:+.2g} of the scale" if scale else f"{change:+.2g}"
    return f"{share}, {abs(change) / error:.3g} error bars" if error else share


def _less_sensitive(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Yield a change if the detection limit or the uncertainty increases more than permissible.

    The increase must exceed both a factor of GROWN and the `sensitivity_limit`. An increase of the
    uncertainty is reported only if that of the detection limit is permissible.
    """
    if row_id.endswith(CONVERGENCE):
        return
    for aspect, read in (("detects", _detected), ("uncertainty", _uncertainty)):
        old, new = read(was), read(now)
        if old is None:
            continue
        least = max(GROWN * old, old + sensitivity_limit(was), ROUND_OFF)
        if new is None or new > least:
            size = f"{new / old:.3g} times" if new is not None and old else ""
            yield Change(row=row_id, aspect=aspect, was=share(old), now=share(new), size=size)
            return


def _detected(row: Kept) -> float | None:
    return row.detects


def _uncertainty(row: Kept) -> float | None:
    """Expanded uncertainty relative to the scale; for a fact, the uncertainty of its margin."""
    return row.tolerance if row.kind == "fact" else _numerical(row)


def _numerical(row: Kept) -> float | None:
    return None if row.u_num is None or not row.scale else COVERAGE * row.u_num / row.scale
