"""Results as tables: lists of dictionaries for any table library, or a DataFrame."""

from collections.abc import Sequence
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.answers.answer import Criterion
from verify.core.differences import difference
from verify.core.results import Row

if TYPE_CHECKING:
    from pandas import DataFrame

Table = list[dict[str, Any]]
COLUMNS = (  # of a row: formula and reference `fem` in `unit`, `detects` relative
    "case", "quantity", "symbol", "unit", "kind", "status", "analytic", "fem", "detects",
    "equation", "reason",
)  # fmt: skip


def of_rows(rows: Sequence[Row]) -> Table:
    """Judged rows as dictionaries with COLUMNS, the relative `difference` and its uncertainty `U`.

    The difference is positive if the formula is larger. A value is None if the row does not have
    it.
    """
    return [_of_row(row) for row in rows]


def _of_row(row: Row) -> dict[str, Any]:
    found = difference(row)
    value, U = (found.value, found.U) if found else (None, None)
    line = {name: getattr(row, name) for name in COLUMNS} | {"difference": value, "U": U}
    return {name: _plain(one) for name, one in line.items()}


def of_criteria(criteria: Sequence[Criterion]) -> Table:
    """Criteria as dictionaries: value and limit [SI], margin [1] and source."""
    return [
        {
            "key": c.key, "criterion": c.what, "value": float(c.value), "limit": float(c.limit),
            "unit": c.unit, "minimum": c.minimum, "margin": float(c.margin), "met": bool(c.is_met),
            "assumed": c.assumed, "source": c.source,
        }
        for c in criteria
    ]  # fmt: skip


def dataframe(table: Table) -> "DataFrame":
    """DataFrame of a table. Raises ImportError if pandas, an optional package, is not installed."""
    try:
        from pandas import DataFrame
    except ImportError as error:
        raise ImportError("to_dataframe requires pandas: install pandas, or use .table") from error
    return DataFrame(table)


def _plain(value: Any) -> Any:
    """A status or kind as text; a number of numpy as a Python number."""
    if isinstance(value, Enum):
        return str(value.value)
    return value.item() if isinstance(value, np.generic) else value
