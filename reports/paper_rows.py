"""Printed rows of a paper's table with the rows of the suite that compare their numbers.

Each row of the suite is a separate line, with its value in the column of the printed number.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup

from reports import formats
from reports.row_lines import LISTED_FIRST, rank
from verify.core.results import PaperCell, PaperClaim, PaperTable, Status

MOST_CLAIMS = 3  # rows of the suite directly below a printed row


@dataclass(frozen=True)
class Claim:
    """A row of the suite below a printed row; `columns` are the columns of the compared numbers."""

    row: str
    name: str
    status: Status
    columns: tuple[int, ...]
    numbers: PaperClaim

    @property
    def formula(self) -> str | Markup:
        """Value of the formula in the printed unit; a dash if the row has none."""
        return formats.small(self.numbers.analytic)

    @property
    def is_first(self) -> bool:
        """Whether the row has a number, or failed, or was not run."""
        has_number = not (self.numbers.analytic is None and self.numbers.fem is None)
        return has_number or self.status in LISTED_FIRST

    def beside(self, printed: PaperCell) -> Markup:
        """Value of the formula and its difference from the printed number above it."""
        value = self.numbers.analytic
        try:
            number = float(printed.text)
        except ValueError:  # a range, a text with a unit
            number = 0.0
        if value is None or not number:
            return Markup("{}").format(self.formula)
        return Markup('{} <span class="unit">({})</span>').format(
            self.formula, formats.percents(value / number - 1, signed=True)
        )

    @property
    def fem(self) -> str | Markup:
        """Finite-element value with its standard uncertainty; empty without a value."""
        fem, u = self.numbers.fem, self.numbers.u
        if fem is None:
            return ""
        return formats.concise(fem, u)[0] if u else formats.small(fem)


@dataclass(frozen=True)
class Uses:
    """Text about the case inputs that are equal to the printed number in a column."""

    column: int
    words: str


@dataclass(frozen=True)
class PrintedRow:
    """Rows of the suite that belong to one row of a printed table."""

    claims: Sequence[Claim]
    inputs: Sequence[Uses]
    errata: Sequence[str]

    @property
    def first(self) -> list[Claim]:
        """Rows directly below the printed row: if possible, one for each column with a number."""
        numbers = [claim for claim in self.claims if claim.is_first]
        new = {k: claim for claim in reversed(numbers) for k in claim.columns}.values()
        listed = sorted(numbers, key=lambda claim: claim not in new)[:MOST_CLAIMS]
        return [c for c in self.claims if c in listed] or list(self.claims[:1])

    @property
    def further(self) -> list[Claim]:
        """Rows of the suite that are not in `first`."""
        return [claim for claim in self.claims if claim not in self.first]


@dataclass(frozen=True)
class UsedNumber:
    """A printed number that cases use as an input, with the name of its row and its column."""

    row: str
    column: str
    printed: str
    words: str


def used_as_inputs(table: PaperTable) -> list[UsedNumber]:
    """Numbers of a table that cases use as inputs."""
    return [
        UsedNumber(_name(cells, use.column), table.header[use.column],
                   cells[use.column].text, use.words)
        for cells in table.rows for use in printed_row(cells).inputs
    ]  # fmt: skip


def _name(cells: Sequence[PaperCell], column: int) -> str:
    """Last text before a number in its row; the first cell if all cells are numbers."""
    texts = [cell.text for cell in cells[:column] if cell.value is None]
    return texts[-1] if texts else cells[0].text


@dataclass(frozen=True)
class PrintedTable:
    """A printed table: `rows` with their comparisons, and comparisons `common` to several rows.

    `has_references` states whether a comparison with one row has a finite-element value.
    """

    rows: Sequence[tuple[Sequence[PaperCell], PrintedRow]]
    common: Sequence[Claim]
    has_references: bool

    @property
    def further(self) -> int:
        """Number of rows of the suite that are not listed directly below their printed row."""
        return sum(len(row.further) for _, row in self.rows)

    @property
    def is_compared(self) -> bool:
        """Whether rows of the suite, or errata, belong to a printed row."""
        return any(row.claims or row.errata for _, row in self.rows)


def printed_table(table: PaperTable) -> PrintedTable:
    """Table for the page; rows of the suite for several printed rows are listed once."""
    rows = [printed_row(cells) for cells in table.rows]
    times = Counter(claim.row for row in rows for claim in row.claims)
    errata = Counter(erratum for row in rows for erratum in row.errata)
    common = {c.row: c for row in rows for c in row.claims if times[c.row] > 1}
    own = [
        replace(
            row, claims=[c for c in row.claims if times[c.row] == 1],
            errata=[e for e in row.errata if errata[e] == 1],
        )
        for row in rows
    ]  # fmt: skip
    claims = [claim for row in own for claim in row.claims]
    return PrintedTable(
        list(zip(table.rows, own, strict=True)),
        sorted(common.values(), key=lambda claim: rank(claim.status)),
        has_references=any(claim.numbers.fem is not None for claim in claims),
    )


def printed_row(cells: Sequence[PaperCell]) -> PrintedRow:
    """Rows, inputs and errata for the numbers of one printed row.

    Rows are in the order of the cells; failed rows come first, then rows that were not run.
    """
    columns: dict[str, list[int]] = {}
    numbers: dict[str, PaperClaim] = {}
    for k, cell in enumerate(cells):
        for claim in cell.rows:
            columns.setdefault(claim.row, []).append(k)
            numbers[claim.row] = claim
    claims = [
        Claim(row, row.partition("/")[2], numbers[row].status, tuple(found), numbers[row])
        for row, found in columns.items()
    ]
    claims.sort(key=lambda claim: rank(claim.status))
    inputs = [Uses(k, _uses(cell.inputs)) for k, cell in enumerate(cells) if cell.inputs]
    errata = dict.fromkeys(e for cell in cells for e in cell.errata)
    return PrintedRow(claims, inputs, list(errata))


def _uses(inputs: Sequence[str]) -> str:
    """Text with the cases by name of their input.

    Example: "input n in ring-lame, ring-rotation; input Z in sprag-wedge".
    """
    cases: dict[str, list[str]] = {}
    for name, _, case in (use.removeprefix("input ").partition(" of ") for use in inputs):
        cases.setdefault(name, []).append(case)
    return "; ".join(f"input {name} in {', '.join(of)}" for name, of in cases.items())
