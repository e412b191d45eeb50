"""Inputs that change no error of a formula: a part with other values of them was compared, too.

`independent.toml` declares them with their reasons.
"""

import tomllib
from functools import cache
from pathlib import Path

from verify.core.verdicts import FormulaVerdict
from verify.papers.entries import Entry, Words

FILE = Path(__file__).parent / "independent.toml"


class Declared(Entry):
    """Inputs of a case on which the errors of `rows` do not depend; of all rows without names."""

    case: str
    rows: tuple[Words, ...] = ()
    inputs: tuple[Words, ...]
    reason: Words


class Table(Entry):
    """All of them."""

    independent: tuple[Declared, ...]


@cache
def declared() -> tuple[Declared, ...]:
    """The entries of the file; ValueError where one is not complete."""
    return Table.model_validate(tomllib.loads(FILE.read_text("utf-8"))).independent


def independent(found: FormulaVerdict, case: str) -> frozenset[str]:
    """The inputs of a case on which no error of the formula there depends."""
    rows = (row.partition("/") for row in found.rows + found.model_rows)
    of_rows = [_of_row(case, quantity) for of, _, quantity in rows if of == case]
    return frozenset.intersection(*of_rows) if of_rows else frozenset()


def _of_row(case: str, quantity: str) -> frozenset[str]:
    return frozenset(
        name for one in declared() if one.case == case and quantity in (one.rows or (quantity,))
        for name in one.inputs
    )  # fmt: skip
