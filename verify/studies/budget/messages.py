"""Names of the cause "discretisation" in a budget, by the kind of refinement of the case.

Stored names contain the numbers of levels. This module replaces these numbers by words for the kind
of refinement, such as "the next finer mesh".
"""

import re
from collections.abc import Iterable
from dataclasses import replace

from verify.judging.budget_statement import Cause
from verify.studies.budget.found import RICHARDSON, RowBudget

MESHES = ("the next finer mesh", "the three finest meshes")
STRIPS = ("more and narrower strips", "the three finest divisions into strips")
STEPS = ("shorter time steps", "the three finest time steps")
OTHER = {
    "sprag-engagement": STEPS, "sprag-friction": STEPS, "sprag-clutch": STRIPS,
    "sprag-crown": STRIPS, "sprag-optimum": STRIPS, "sprag-optimum-40": STRIPS,
}  # fmt: skip

_LEVEL = re.compile(rf"{Cause.DISCRETISATION}: level \d+ after \d+")
_EXTRAPOLATED = f"{Cause.DISCRETISATION}: {RICHARDSON}"


def in_words(case_id: str, rows: Iterable[RowBudget]) -> tuple[RowBudget, ...]:
    """Budgets in which the discretisation is named after what the case refines, such as meshes."""
    next_one, finest = OTHER.get(case_id, MESHES)

    def renamed(name: str) -> str:
        name = _LEVEL.sub(f"{Cause.DISCRETISATION}: {next_one}", name)
        extrapolated = f"{Cause.DISCRETISATION}: Richardson from {finest}"
        return name.replace(_EXTRAPOLATED, extrapolated)

    return tuple(
        replace(row, balance=replace(row.balance, parts=tuple(
            replace(part, name=renamed(part.name)) for part in row.balance.parts
        )))
        for row in rows
    )  # fmt: skip
