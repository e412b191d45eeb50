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
    Computed,
    Expected,
    State,
    about,
    approximation,
    as_printed,
    balance,
    errors_of,
    fact,
    identity,
    limit,
    over_family,
    underived,
)
from verify.form.fields import picture, plane_field
from verify.form.figures import AlongLine, Drawn, Overlay
from verify.form.quantity import CaseError, Quantity, shared

__all__ = [
    "AlongLine",
    "Case",
    "CaseError",
    "Comparison",
    "Computed",
    "Drawn",
    "Expected",
    "Level",
    "Overlay",
    "Quantity",
    "Scan",
    "State",
    "about",
    "approximation",
    "as_printed",
    "balance",
    "count",
    "errors_of",
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
    "underived",
    "word",
]
