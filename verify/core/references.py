"""What a formula is compared with: finite elements, or another method by its name.

A case's `fem` also holds references that are not finite elements. The names of these stand here
alone; a row whose `partner` is set names its reference itself.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from verify.core.results import Row

FE = "FE"
FINITE_ELEMENTS = "finite elements"


@dataclass(frozen=True)
class Method:
    """The references of a `case` in words, and what stands `alone` in rows that name no other."""

    case: str
    alone: str


_IN_TIME = Method("integration in time", "integration in time")
_HALF_SPACE = Method("half-space", "half-space")
_SEARCHES = Method("strips, half-space, other searches", "second computation")
_SPRAGS = "strips, sprags drawn point by point, integration in time"

OTHERS: Mapping[str, Method] = {  # cases in which some or all references are not finite elements
    "sprag-engagement": _IN_TIME,
    "sprag-friction": _IN_TIME,
    "sprag-clutch": Method(_SPRAGS, "strips"),
    "sprag-crown": Method(_SPRAGS, "strips"),
    "sprag-optimum": _SEARCHES,
    "sprag-optimum-40": _SEARCHES,
    "contact-roller": Method("half-space; finite elements at mid-length", "half-space"),
    "contact-roller-tilted": _HALF_SPACE,
    "contact-roller-flat": _HALF_SPACE,
    "contact-roller-crowns": _HALF_SPACE,
    "rotor-clutch": Method("struts in exact kinematics", "struts"),
}


def case_method(case: str) -> str:
    """What the formulas of the case with this id are compared with, in words."""
    return OTHERS[case].case if case in OTHERS else FINITE_ELEMENTS


def reference_name(row: Row) -> str:
    """Whose value the formula of the row is compared with: "FE", or another method's name."""
    if row.fem is None or row.case not in OTHERS or FINITE_ELEMENTS in row.quantity:
        return row.by
    return OTHERS[row.case].alone


def is_finite_elements(row: Row) -> bool:
    """Whether the reference of the row is finite elements."""
    return reference_name(row) == FE
