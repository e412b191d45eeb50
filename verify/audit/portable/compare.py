"""Differences between the rows of two machines; this module does not solve or write anything.

Module verify.audit.portable.moving defines the change of a row and its limit.
"""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from verify.audit.portable.moving import LIMIT, Number, Record, is_other_tolerance, move


class Kind(StrEnum):
    """Kind of a difference; in reports, "of the first kind" means every kind except VALUE."""

    STATUS = "status"
    MISSING = "missing row"
    ADDED = "additional row"
    DUPLICATE = "row of the same name"
    ORDER = "order of rows"
    VALUE = "value"


@dataclass(frozen=True, kw_only=True)
class Difference:
    """A row that differs between the baseline and one other machine.

    `move` is the change in units of the row's tolerance, nan if no value changed.
    """

    kind: Kind
    row: str
    row_kind: str
    variant: str
    was: str
    now: str
    move: float = math.nan
    reason: str = ""


def differences(
    baseline: Sequence[Record], variant: Sequence[Record], name: str, *, perturbed: bool
) -> list[Difference]:
    """Differences of the rows of machine `name` from the baseline, without permissible changes.

    If several rows have one id, only the last one is compared; therefore, such rows are reported.
    """
    known = {row.id: row for row in baseline}
    found = {row.id: row for row in variant}
    result = [_only_here(row, name) for i, row in known.items() if i not in found]
    result += [_only_there(row, name) for i, row in found.items() if i not in known]
    result += _duplicates(baseline, variant, name)
    for was, now in _pairs(known, found):
        result += _differences(was, now, name, perturbed=perturbed)
    return result + _order(list(known), list(found), known, name)


def moves(
    baseline: Sequence[Record], variant: Sequence[Record], name: str, *, perturbed: bool
) -> list[Difference]:
    """Changes of all rows that both machines have, however small."""
    known, found = ({row.id: row for row in rows} for rows in (baseline, variant))
    return [_moved(was, now, name, perturbed=perturbed) for was, now in _pairs(known, found)]


def _only_here(row: Record, name: str) -> Difference:
    return Difference(
        kind=Kind.MISSING, row=row.id, row_kind=row.kind, variant=name, was=row.status, now=""
    )


def _only_there(row: Record, name: str) -> Difference:
    return Difference(
        kind=Kind.ADDED, row=row.id, row_kind=row.kind, variant=name, was="", now=row.status
    )


def _duplicates(
    baseline: Sequence[Record], variant: Sequence[Record], name: str
) -> Iterator[Difference]:
    """Differences for ids that several rows of one machine have."""
    here, there = (Counter(row.id for row in rows) for rows in (baseline, variant))
    for row in {row.id: row for row in (*variant, *baseline)}.values():
        if max(here[row.id], there[row.id]) > 1:
            yield Difference(
                kind=Kind.DUPLICATE, row=row.id, row_kind=row.kind, variant=name,
                was=f"{here[row.id]} times", now=f"{there[row.id]} times",
            )  # fmt: skip


def _pairs(
    known: Mapping[str, Record], found: Mapping[str, Record]
) -> Iterator[tuple[Record, Record]]:
    return ((known[i], found[i]) for i in known if i in found)


def _differences(was: Record, now: Record, name: str, *, perturbed: bool) -> Iterator[Difference]:
    if was.status != now.status:
        yield Difference(
            kind=Kind.STATUS, row=was.id, row_kind=was.kind, variant=name, was=_verdict(was),
            now=_verdict(now), move=move(was, now, perturbed=perturbed),
        )  # fmt: skip
        return
    moved = _moved(was, now, name, perturbed=perturbed)
    if is_other_tolerance(was, now):
        yield replace(
            moved, was=f"{moved.was}, tolerance {_number(was.tolerance)}",
            now=f"{moved.now}, tolerance {_number(now.tolerance)}",
        )  # fmt: skip
    elif not moved.move <= LIMIT:
        yield moved


def _moved(was: Record, now: Record, name: str, *, perturbed: bool) -> Difference:
    return Difference(
        kind=Kind.VALUE, row=was.id, row_kind=was.kind, variant=name, was=_numbers(was),
        now=_numbers(now), move=move(was, now, perturbed=perturbed),
    )  # fmt: skip


def _order(
    before: Sequence[str], after: Sequence[str], known: Mapping[str, Record], name: str
) -> list[Difference]:
    """The first row that is not at its position in the baseline, among rows of both machines."""
    common = [i for i in after if i in known]
    for was, now in zip((i for i in before if i in set(after)), common, strict=True):
        if was != now:
            kind = known[was].kind
            return [Difference(kind=Kind.ORDER, row=was, row_kind=kind, variant=name, was=was,
                               now=now)]  # fmt: skip
    return []


def _verdict(row: Record) -> str:
    return f"{row.status} ({row.reason})" if row.reason else row.status


def _numbers(row: Record) -> str:
    """Numbers of a row as text: "formula 1.25, reference 1.26, difference -0.01"."""
    all_numbers = {**row.values, "difference": row.difference}
    return ", ".join(f"{n} {_number(v)}" for n, v in all_numbers.items() if v is not None)


def _number(value: Number) -> str:
    return "none" if value is None else f"{value:.12g}"
