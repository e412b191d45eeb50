"""What differs between the rows of two machines. Nothing here runs or writes anything.

A move is counted in tolerances of the row on this machine. For a fact the tolerance is its margin,
what may be lost until the verdict changes. A row without a tolerance takes 1e-5 of its scale for
one, so that the limit of a tenth is 1e-6 of the scale. Perturbed inputs move both sides of a row
together: there its difference counts, and its values beyond 1e-6 of the scale.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from verify.results import Row

LIMIT = 0.1  # tolerances
SUBSTITUTE = 1e-5  # of the scale, where a row has no tolerance
FACT = "fact"

Number = float | None


class Kind(StrEnum):
    """What differs; all but the value are differences of the first kind."""

    STATUS = "status"
    MISSING = "missing row"
    ADDED = "additional row"
    ORDER = "order of rows"
    VALUE = "value"


@dataclass(frozen=True, kw_only=True)
class Record:
    """What is compared of one row; dimensional numbers are in its unit."""

    id: str
    kind: str
    status: str
    reason: str = ""
    values: Mapping[str, Number] = field(default_factory=dict)
    difference: Number = None
    tolerance: Number = None
    scale: Number = None


@dataclass(frozen=True, kw_only=True)
class Difference:
    """One row that differs in one variant; `move` is in tolerances, nan where no value moved."""

    kind: Kind
    row: str
    row_kind: str
    variant: str
    was: str
    now: str
    move: float = math.nan
    reason: str = ""


def record(row: Row) -> Record:
    """What is compared of a row."""
    values = {"formula": row.analytic, "reference": row.fem}
    if row.partner is not None:
        values["partner"] = row.partner.value
    return Record(
        id=row.id, kind=row.kind.value, status=row.status.value, reason=row.reason, values=values,
        difference=row.difference, tolerance=row.tolerance, scale=row.scale,
    )  # fmt: skip


def differences(
    baseline: Sequence[Record], variant: Sequence[Record], name: str, *, perturbed: bool
) -> list[Difference]:
    """Rows of the variant `name` whose status differs or whose value moves too far."""
    known = {row.id: row for row in baseline}
    found = {row.id: row for row in variant}
    result = [_only_here(row, name) for i, row in known.items() if i not in found]
    result += [_only_there(row, name) for i, row in found.items() if i not in known]
    for was, now in _pairs(known, found):
        result += _differences(was, now, name, perturbed=perturbed)
    return result + _order(list(known), list(found), known, name)


def moves(
    baseline: Sequence[Record], variant: Sequence[Record], name: str, *, perturbed: bool
) -> list[Difference]:
    """The move of every row that both have, however small."""
    known, found = ({row.id: row for row in rows} for rows in (baseline, variant))
    return [_moved(was, now, name, perturbed=perturbed) for was, now in _pairs(known, found)]


def move(was: Record, now: Record, *, perturbed: bool) -> float:
    """How far a row moved, in tolerances; infinite where a number is there or finite once only."""
    allowed, substitute = _allowed(was), SUBSTITUTE * _scale(was)
    values = [_change(was.values.get(n), now.values.get(n)) for n in {**was.values, **now.values}]
    parts = [_ratio(one, max(allowed, substitute) if perturbed else allowed) for one in values]
    return max(*parts, _ratio(_change(was.difference, now.difference), allowed))


def _allowed(row: Record) -> float:
    """What the row may differ by: its tolerance, of a fact its margin, else a part of the scale."""
    U = row.tolerance if row.tolerance is not None and row.tolerance > 0 else 0.0
    if row.kind == FACT and row.difference is not None:
        return max(abs(row.difference) - U, 0.0)
    return U or SUBSTITUTE * _scale(row)


def _only_here(row: Record, name: str) -> Difference:
    return Difference(
        kind=Kind.MISSING, row=row.id, row_kind=row.kind, variant=name, was=row.status, now=""
    )


def _only_there(row: Record, name: str) -> Difference:
    return Difference(
        kind=Kind.ADDED, row=row.id, row_kind=row.kind, variant=name, was="", now=row.status
    )


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
    if not moved.move <= LIMIT:
        yield moved


def _moved(was: Record, now: Record, name: str, *, perturbed: bool) -> Difference:
    return Difference(
        kind=Kind.VALUE, row=was.id, row_kind=was.kind, variant=name, was=_numbers(was),
        now=_numbers(now), move=move(was, now, perturbed=perturbed),
    )  # fmt: skip


def _order(
    before: Sequence[str], after: Sequence[str], known: Mapping[str, Record], name: str
) -> list[Difference]:
    """The first row that stands in another place among those that both have."""
    common = [i for i in after if i in known]
    for was, now in zip((i for i in before if i in set(after)), common, strict=True):
        if was != now:
            kind = known[was].kind
            return [Difference(kind=Kind.ORDER, row=was, row_kind=kind, variant=name, was=was,
                               now=now)]  # fmt: skip
    return []


def _change(was: Number, now: Number) -> float:
    if was is None or now is None:
        return 0.0 if was is now else math.inf
    if was == now or (math.isnan(was) and math.isnan(now)):
        return 0.0
    return abs(now - was) if math.isfinite(was) and math.isfinite(now) else math.inf


def _ratio(change: float, allowed: float) -> float:
    return 0.0 if change == 0 else change / allowed if allowed > 0 else math.inf


def _scale(row: Record) -> float:
    """The row's scale, else its largest number."""
    if row.scale is not None and math.isfinite(row.scale) and row.scale > 0:
        return row.scale
    numbers = (*row.values.values(), row.difference)
    return max((abs(v) for v in numbers if v is not None and math.isfinite(v)), default=0.0)


def _verdict(row: Record) -> str:
    return f"{row.status} ({row.reason})" if row.reason else row.status


def _numbers(row: Record) -> str:
    """The numbers of a row in one line: "formula 1.25, reference 1.26, difference -0.01"."""
    all_numbers = {**row.values, "difference": row.difference}
    return ", ".join(f"{n} {v:.12g}" for n, v in all_numbers.items() if v is not None)
