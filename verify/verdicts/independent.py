"""Inputs on which the error of a formula does not depend.

They may have any value if a user's inputs are compared with the ranges of studies.
`independent.toml` declares them with reasons.
"""

import tomllib
from functools import cache
from pathlib import Path

from verify.core.verdicts import FormulaVerdict
from verify.papers.entries import Entry, Words

FILE = Path(__file__).parent / "independent.toml"


class Declared(Entry):
    """Inputs of a case on which the errors of `rows` (all rows if empty) do not depend."""

    case: str
    rows: tuple[Words, ...] = ()
    inputs: tuple[Words, ...]
    reason: Words


class Table(Entry):
    """All entries of `independent.toml`."""

    independent: tuple[Declared, ...]


@cache
def declared() -> tuple[Declared, ...]:
    """Entries of `independent.toml`.

    Raises ValueError if an entry is incomplete.
    """
    return Table.model_validate(tomllib.loads(FILE.read_text("utf-8"))).independent


def independent(found: FormulaVerdict, case: str) -> frozenset[str]:
    """Names of the inputs of a case on which no error of the formula in this case depends."""
    rows = (row.partition("/") for row in found.rows + found.model_rows)
    of_rows = [_of_row(case, quantity) for of, _, quantity in rows if of == case]
    return frozenset.intersection(*of_rows) if of_rows else frozenset()


def _of_row(case: str, quantity: str) -> frozenset[str]:
    return frozenset(
        name for one in declared() if one.case == case and quantity in (one.rows or (quantity,))
        for name in one.inputs
    )  # fmt: skip
