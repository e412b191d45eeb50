"""Change of a row between two machines, and its permissible value.

A change is measured in units of the row's tolerance on this machine. For a fact, the tolerance is
its margin: the permissible change until the verdict changes. For a row without a tolerance, it is
1e-5 of its scale, so that the limit of one tenth is 1e-6 of the scale.

Perturbed inputs change both sides of a row together. In this case, the difference is compared, and
changes of the values beyond 1e-6 of the scale are reported. A different tolerance would permit
larger changes; therefore, it is reported as well.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from verify.core.results import Row

LIMIT = 0.1  # tolerances
SUBSTITUTE = 1e-5  # of the scale, where a row has no tolerance
ALIKE = 2.0  # times: tolerances that are estimated on each machine
FACT = "fact"

Number = float | None


@dataclass(frozen=True, kw_only=True)
class Record:
    """Compared values of one row; dimensional numbers have the unit of the row."""

    id: str
    kind: str
    status: str
    reason: str = ""
    values: Mapping[str, Number] = field(default_factory=dict)
    difference: Number = None
    tolerance: Number = None
    scale: Number = None


def record(row: Row) -> Record:
    """Compared values of a row."""
    values = {"formula": row.analytic, "reference": row.fem}
    if row.partner is not None:
        values["partner"] = row.partner.value
    return Record(
        id=row.id, kind=row.kind.value, status=row.status.value, reason=row.reason, values=values,
        difference=row.difference, tolerance=row.tolerance, scale=row.scale,
    )  # fmt: skip


def move(was: Record, now: Record, *, perturbed: bool) -> float:
    """Change of a row in units of its tolerance.

    The change is infinite if a number exists, or is finite, on one machine only.
    """
    allowed, substitute = _allowed(was), SUBSTITUTE * _scale(was)
    values = [_change(was.values.get(n), now.values.get(n)) for n in {**was.values, **now.values}]
    parts = [_ratio(one, max(allowed, substitute) if perturbed else allowed) for one in values]
    return max([*parts, _ratio(_change(was.difference, now.difference), allowed)])


def _allowed(row: Record) -> float:
    """Permissible change of the row: its tolerance, the margin of a fact, or part of the scale."""
    U = _tolerance(row)
    if row.kind == FACT and row.difference is not None and math.isfinite(row.difference):
        return max(abs(row.difference) - U, 0.0)
    return U or SUBSTITUTE * _scale(row)


def _tolerance(row: Record) -> float:
    """Tolerance of the row; zero if there is none, or if no number can exceed it."""
    U = row.tolerance
    return U if U is not None and math.isfinite(U) and U > 0 else 0.0


def is_other_tolerance(was: Record, now: Record) -> bool:
    """Whether the tolerance exists on one machine only, or differs by more than a factor of 2.

    For a fact, a difference below a share of its margin is permissible.
    """
    small, large = sorted((_tolerance(was), _tolerance(now)))
    if was.kind == FACT and large - small <= LIMIT * _allowed(was):
        return False
    return large > ALIKE * small


def _change(was: Number, now: Number) -> float:
    if was is None or now is None:
        return 0.0 if was is now else math.inf
    if was == now or (math.isnan(was) and math.isnan(now)):
        return 0.0
    return abs(now - was) if math.isfinite(was) and math.isfinite(now) else math.inf


def _ratio(change: float, allowed: float) -> float:
    return 0.0 if change == 0 else change / allowed if allowed > 0 else math.inf


def _scale(row: Record) -> float:
    """Scale of the row; without a scale, its largest number."""
    if row.scale is not None and math.isfinite(row.scale) and row.scale > 0:
        return row.scale
    numbers = (0.0, *row.values.values(), row.difference)
    return max(abs(v) for v in numbers if v is not None and math.isfinite(v))
