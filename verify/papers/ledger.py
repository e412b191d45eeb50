"""Printed contents of the five papers: values, tables, equations and errata, validated.

Each paper has one TOML file in the folder of this module. A value is stored as the printed text,
because the uncertainty of a printed number is known only from its last digit.
"""

import tomllib
from functools import cache
from pathlib import Path
from typing import Self

from pydantic import model_validator

from verify.papers.entries import Entry, Equation, Erratum, Key, Value, Words
from verify.papers.tables import PrintedTable, check_tables

HERE = Path(__file__).parent
NUMBERED_EQUATIONS = {
    "huang2018": 22,
    "huang2022": 11,
    "nagler2021": 10,
    "wang2023": 13,
    "belcin": 21,
}
NUMBERED_TABLES = {"huang2018": 2, "huang2022": 1, "nagler2021": 2, "wang2023": 1, "belcin": 0}


class Paper(Entry):
    """One paper with all of its entries."""

    key: Key
    authors: Words
    title: Words
    source: Words
    year: int | None = None
    doi: str = ""
    values: tuple[Value, ...]
    tables: tuple[PrintedTable, ...] = ()
    equations: tuple[Equation, ...]
    errata: tuple[Erratum, ...]

    @property
    def cited(self) -> str:
        """Name of the first author and year."""
        return f"{self.authors.split(',')[0].split()[-1]} {self.year or ''}".strip()

    @model_validator(mode="after")
    def _ids_are_unique_and_equations_complete(self) -> Self:
        for name, entries in (("value", self.values), ("erratum", self.errata)):
            ids = [entry.id for entry in entries]
            if twice := sorted({i for i in ids if ids.count(i) > 1}):
                raise ValueError(f"{self.key}: {name} id {', '.join(twice)} is used twice")
        found = [equation.number for equation in self.equations]
        if found != list(range(1, NUMBERED_EQUATIONS[self.key] + 1)):
            raise ValueError(
                f"{self.key}: equations must be 1 to {NUMBERED_EQUATIONS[self.key]} in order, "
                f"got {found}"
            )
        return self

    @model_validator(mode="after")
    def _tables_and_errata_name_values_that_exist(self) -> Self:
        try:
            check_tables(self.tables, self.values, NUMBERED_TABLES[self.key])
        except ValueError as error:
            raise ValueError(f"{self.key}: {error}") from error
        known = {value.id for value in self.values}
        for entry in self.errata:
            if unknown := [i for i in entry.values if i not in known]:
                raise ValueError(f"{self.key}: erratum {entry.id}: unknown value {unknown[0]}")
        return self


@cache
def papers() -> tuple[Paper, ...]:
    """All papers, in the order of `NUMBERED_EQUATIONS`."""
    return tuple(
        Paper.model_validate(tomllib.loads((HERE / f"{key}.toml").read_text("utf-8")))
        for key in NUMBERED_EQUATIONS
    )


def cited(key: str) -> str:
    """First author and year of the paper with this key; for another source, its citation."""
    return {paper.key: paper.cited for paper in papers()}.get(key, key)


@cache
def _index() -> dict[str, Value]:
    return {f"{paper.key}:{value.id}": value for paper in papers() for value in paper.values}


def published(reference: str) -> Value:
    """Printed value with the name "paper:id", such as "wang2023:k1-theory".

    Raises KeyError if there is no such value.
    """
    return _index()[reference]


def erratum(reference: str) -> Erratum:
    """Erratum with the name "paper:id".

    Raises KeyError if there is no such erratum.
    """
    found = {f"{paper.key}:{e.id}": e for paper in papers() for e in paper.errata}
    return found[reference]
