"""Change of a row between two machines, in units of the row's tolerance on this machine.

For a fact, the unit is the margin: the largest change without a change of the verdict. For a row
without a tolerance, the unit is 1e-5 of the scale. A change of more than a tenth of the unit is
reported.

Perturbed inputs change both sides of a row together. In this case, the difference is compared;
changes of the values are also reported if they exceed both 1e-6 of the scale and a tenth of the
unit. A different tolerance would permit larger changes; therefore, it is reported as well.
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
    """Unit of the row's change: its tolerance, the margin of a fact, or a fraction of the scale."""
    U = _tolerance(row)
    if row.kind == FACT and row.difference is not None and math.isfinite(row.difference):
        return max(abs(row.difference) - U, 0.0)
    return U or SUBSTITUTE * _scale(row)


def _tolerance(row: Record) -> float:
    """Tolerance of the row; zero if there is none, or if it is infinite."""
    U = row.tolerance
    return U if U is not None and math.isfinite(U) and U > 0 else 0.0


def is_other_tolerance(was: Record, now: Record) -> bool:
    """Whether the tolerance exists on one machine only, or differs by more than a factor of 2.

    For a fact, the tolerances may also differ by up to LIMIT times the margin.
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
    """Scale of the row; if it has none, the largest magnitude of its numbers."""
    if row.scale is not None and math.isfinite(row.scale) and row.scale > 0:
        return row.scale
    numbers = (0.0, *row.values.values(), row.difference)
    return max(abs(v) for v in numbers if v is not None and math.isfinite(v))
