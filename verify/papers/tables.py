"""Tables in the layout of the paper; cells refer to printed values in the file of the paper.

A cell "=k1-theory" is replaced by the value with this id, so that each number is entered only once.
Any other cell is plain text.
"""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Self

from pydantic import model_validator

from verify.papers.digits import is_number
from verify.papers.entries import Entry, Value, Words


class PrintedTable(Entry):
    """One table; `name` is its number in the paper.

    If the table has no rows, `note` gives the reason.
    """

    name: Words
    caption: Words
    header: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    note: str = ""

    @property
    def references(self) -> Iterator[str]:
        """Ids of the values in the cells, row by row."""
        return (id_ for row in self.rows for cell in row if (id_ := referred(cell)))

    @model_validator(mode="after")
    def _has_its_layout(self) -> Self:
        if not self.rows and not self.note:
            raise ValueError(f"{self.name} has no rows: note must state the reason")
        for row in self.rows:
            if len(row) != len(self.header):
                raise ValueError(
                    f"{self.name}: row {' | '.join(row)} has {len(row)} cells, "
                    f"the header {len(self.header)}"
                )
            if typed := [cell for cell in row if is_number(cell)]:
                raise ValueError(f"{self.name}: cell {typed[0]} must be a reference, not a number")
        return self


def referred(cell: str) -> str | None:
    """Id that a cell such as "=k1-theory" refers to; None for plain text.

    >>> referred("=k1-theory"), referred("k_1")
    ('k1-theory', None)
    """
    return cell[1:] if cell.startswith("=") else None


def named_tables(place: str) -> set[str]:
    """Tables that the text `place` names, except tables preceded by "before" or "after".

    >>> sorted(named_tables("Table 1 and Table 2, row 3")), named_tables("Sec. 4, before Table 1")
    (['Table 1', 'Table 2'], set())
    """
    return set(re.findall(r"(?<!before )(?<!after )(Table \d+)", place))


def check_tables(tables: Sequence[PrintedTable], values: Sequence[Value], printed: int) -> None:
    """Raise ValueError unless each value printed in a table is in exactly one cell of this table.

    The tables must be those with the numbers 1 to `printed`, in this order.
    """
    if (names := [t.name for t in tables]) != [f"Table {i + 1}" for i in range(printed)]:
        raise ValueError(f"tables must be Table 1 to {printed} in order, got {names}")
    placed = {v.id: v.place.partition(",")[0] for v in values}
    for table in tables:
        for id_, times in Counter(table.references).items():
            if id_ not in placed:
                raise ValueError(f"{table.name}: unknown value {id_}")
            if times > 1:
                raise ValueError(
                    f"{table.name}: value {id_} must be in one cell only, is in {times} cells"
                )
            if placed[id_] != table.name:
                raise ValueError(
                    f"{table.name} refers to value {id_}, which is printed in {placed[id_]}"
                )
    shown = {id_ for table in tables for id_ in table.references}
    if lost := [i for i, place in placed.items() if place.startswith("Table") and i not in shown]:
        raise ValueError(f"{placed[lost[0]]} has no cell for value {lost[0]}")
