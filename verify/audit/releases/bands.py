"""Changes that make the requirements of a row looser or stricter, and changes of its scale."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from verify.audit.releases.store import Kept
from verify.audit.releases.thresholds import Figure, figures, is_wider, relative_error, scale_limit
from verify.core.results import Change

NOTHING = "none"
RECORDED_DIGITS = 9  # significant digits that are stored
STRENGTH = {"PASS": 2, "CALIBRATED": 1, "SHOWN": 0, "NOTE": 0}

Accepted = Sequence[tuple[str, float]]


def loosened(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Requirements and intervals that became looser; changes of scale or acceptance limits."""
    for one in figures(was, now):
        if one.is_loosened:
            old, new = _shares(one)
            yield Change(row=row_id, aspect=one.aspect, was=old, now=new, loosened=True)
    if is_wider(was.interval, now.interval, relative_error(was, now)):
        old, new = _ranges(was.interval, now.interval)
        yield Change(row=row_id, aspect="interval", was=old, now=new, loosened=True)
    yield from _scale(row_id, was, now)
    yield from _acceptance(row_id, was.figures, now.figures)


def tightened(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Requirements and intervals that became stricter."""
    for one in figures(was, now):
        if one.is_tightened:
            old, new = _shares(one)
            yield Change(row=row_id, aspect=one.aspect, was=old, now=new)
    if now.interval is None:
        return
    if was.interval is None or is_wider(now.interval, was.interval, relative_error(was, now)):
        old, new = _ranges(was.interval, now.interval)
        yield Change(row=row_id, aspect="interval", was=old, now=new)


def _scale(row_id: str, was: Kept, now: Kept) -> Iterator[Change]:
    """Change of the scale of requirements and bands; a larger scale accepts more results."""
    if was.unit != now.unit:  # reported as a change of kind
        return
    if was.scale is None or now.scale is None:
        grown, moved = now.scale is None, was.scale is not now.scale
    else:
        grown = abs(now.scale) > abs(was.scale)
        moved = abs(now.scale - was.scale) > scale_limit(was, now)
    if moved:
        yield Change(
            row=row_id, aspect="scale", was=number(was.scale, was.unit),
            now=number(now.scale, now.unit), loosened=grown and STRENGTH.get(was.status, 1) > 0,
        )  # fmt: skip


def _acceptance(row_id: str, was: Accepted, now: Accepted) -> Iterator[Change]:
    """Changes of the acceptance limits of a row.

    If the words of the figures ("accepted" or "required") are the same in both runs, each looser
    figure is a change. Otherwise, there is one change for all figures together.
    """
    if [word for word, _ in was] == [word for word, _ in now]:
        for old, new in zip(was, now, strict=True):
            if _is_looser(old, new):
                yield Change(
                    row=row_id, aspect="acceptance", was=_listed([old]), now=_listed([new]),
                    loosened=True,
                )  # fmt: skip
        return
    lost = Counter(word for word, _ in was) - Counter(word for word, _ in now)
    pairs = ((old, new) for old, new in zip(sorted(was), sorted(now), strict=False))
    looser = any(old[0] == new[0] and _is_looser(old, new) for old, new in pairs)
    yield Change(
        row=row_id, aspect="acceptance", was=_listed(was), now=_listed(now),
        loosened=bool(lost) or looser,
    )  # fmt: skip


def _is_looser(old: tuple[str, float], new: tuple[str, float]) -> bool:
    """Whether the figure `new` permits more than the figure `old` with the same word."""
    return new[1] > old[1] if old[0] == "accepted" else new[1] < old[1]


def _listed(accepted: Accepted) -> str:
    return ", ".join(f"{value:.12g} % {word}" for word, value in accepted) or NOTHING


def number(value: float | None, unit: str, digits: int = 10) -> str:
    """A number with its unit, as text."""
    if value is None:
        return NOTHING
    return f"{value:.{digits}g}" + (f" {unit}" if unit != "1" else "")


def share(value: float | None, digits: int = 4) -> str:
    """A relative number in per cent, as text."""
    return NOTHING if value is None else f"{100 * value:.{digits}g} %"


def _shares(one: Figure) -> tuple[str, str]:
    """A figure in both runs as text.

    A stated figure has as many digits as are required to distinguish the runs.
    """
    most = RECORDED_DIGITS + 1 if one.stated else 4
    for digits in range(4, most + 1):
        texts = share(one.was, digits), share(one.now, digits)
        if texts[0] != texts[1]:
            break
    return texts


def _ranges(was: tuple[float, float] | None, now: tuple[float, float] | None) -> tuple[str, str]:
    """The ends of an interval in both runs, in per cent, as text.

    The digits suffice to distinguish both runs. One unit of the last digit is at most 1e-4 of the
    width.
    """
    for more in range(RECORDED_DIGITS):
        texts = _range(was, more), _range(now, more)
        if texts[0] != texts[1]:
            break
    return texts


def _range(interval: tuple[float, float] | None, more: int) -> str:
    if interval is None:
        return NOTHING
    low, high = interval
    ratio = max(abs(low), abs(high)) / (high - low) if high > low else 1.0
    digits = 6 + more + max(0, math.ceil(math.log10(ratio)))
    return f"{100 * low:+.{digits}g} to {100 * high:+.{digits}g} %"
