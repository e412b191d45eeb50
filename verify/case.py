"""The form of a case: one class that declares inputs, formulas, a reference and comparisons.

Everything that a case file needs is imported from here; `verify.form.case.Case` says how.
"""

from verify.core.case import FemResult as Level
from verify.core.case import Scan
from verify.core.inputs import count, table, text, word
from verify.core.inputs import quantity as given
from verify.form import sketches
from verify.form.case import Case, solved
from verify.form.comparisons import (
    Comparison,
    Expected,
    about,
    approximation,
    balance,
    fact,
    identity,
    limit,
    over_family,
)
from verify.form.fields import picture, plane_field
from verify.form.figures import Overlay
from verify.form.quantity import CaseError, Quantity, shared

__all__ = [
    "Case",
    "CaseError",
    "Comparison",
    "Expected",
    "Level",
    "Overlay",
    "Quantity",
    "Scan",
    "about",
    "approximation",
    "balance",
    "count",
    "fact",
    "given",
    "identity",
    "limit",
    "over_family",
    "picture",
    "plane_field",
    "shared",
    "sketches",
    "solved",
    "table",
    "text",
    "word",
]
