"""Name of the reference of a formula: finite elements, or another method.

A case states the method of its reference. If a row has a `partner`, the partner is the reference
of this row.
"""

from dataclasses import dataclass

from verify.core.results import FE, Row

FINITE_ELEMENTS = "finite elements"


@dataclass(frozen=True)
class Method:
    """Names of the method of a reference: `case` for a whole case, `alone` for a single row."""

    case: str = FINITE_ELEMENTS
    alone: str = FE


BY_INTEGRATION = Method("integration in time", "integration in time")
BY_HALF_SPACE = Method("half-space", "half-space")
BY_SEARCHES = Method("strips, half-space, other searches", "second computation")
BY_STRIPS = Method("strips, sprags drawn point by point, integration in time", "strips")


def reference_name(row: Row) -> str:
    """Method of the reference of a row: "FE", or the name of another method."""
    if row.fem is None or FINITE_ELEMENTS in row.quantity:
        return row.by
    return row.method


def is_finite_elements(row: Row) -> bool:
    """Whether the reference of the row is finite elements."""
    return reference_name(row) == FE
