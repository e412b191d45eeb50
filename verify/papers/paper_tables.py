"""Tables of the papers for the report: every printed number with its comparisons."""

from collections.abc import Mapping, Sequence

from verify.core import units
from verify.core.case import Case
from verify.core.inputs import meta
from verify.core.references import is_finite_elements
from verify.core.results import CaseResult, PaperCell, PaperClaim, PaperTable, Row
from verify.papers.entries import Value
from verify.papers.ledger import Paper, papers
from verify.papers.tables import PrintedTable, named_tables, referred


def paper_tables(
    results: Sequence[CaseResult], inputs: Mapping[str, Sequence[str]]
) -> tuple[PaperTable, ...]:
    """All tables of all papers, with the inputs and judged rows that use their numbers."""
    rows = claiming_rows(results)
    return tuple(_table(paper, table, inputs, rows) for paper in papers() for table in paper.tables)


def claiming_inputs(cases: Sequence[Case]) -> dict[str, list[str]]:
    """For each printed value "paper:id", equal inputs as text: "input n of spring-accordion"."""
    found: dict[str, list[str]] = {}
    for case in cases:
        for name, field in case.inputs.model_fields.items():
            if reference := meta(field)["claims"]:
                found.setdefault(reference, []).append(f"input {name} of {case.id}")
    return found


def claiming_rows(results: Sequence[CaseResult]) -> dict[str, list[Row]]:
    """Judged rows that are compared with a printed value ("paper:id": rows)."""
    found: dict[str, list[Row]] = {}
    for result in results:
        for row in result.rows:
            for entry in row.published:
                found.setdefault(f"{entry.document}:{entry.id}", []).append(row)
    return found


def _table(
    paper: Paper,
    table: PrintedTable,
    inputs: Mapping[str, Sequence[str]],
    rows: Mapping[str, Sequence[Row]],
) -> PaperTable:
    values = {value.id: value for value in paper.values}

    def cell(text: str) -> PaperCell:
        if (id_ := referred(text)) is None:
            return PaperCell(text=text)
        value, reference = values[id_], f"{paper.key}:{id_}"
        return PaperCell(
            text=value.printed, value=reference, unit=value.unit,
            inputs=tuple(inputs.get(reference, ())),
            rows=tuple(_claim(row, value) for row in rows.get(reference, ())),
            errata=tuple(e.id for e in paper.errata if id_ in e.values),
        )  # fmt: skip

    return PaperTable(
        paper=paper.key, name=table.name, caption=table.caption, header=table.header,
        rows=tuple(tuple(map(cell, row)) for row in table.rows), note=table.note,
        errata=tuple(e.id for e in paper.errata if table.name in named_tables(e.place)),
    )  # fmt: skip


def _claim(row: Row, value: Value) -> PaperClaim:
    """Numbers of a row, converted to the printed unit."""
    f = units.factor(row.unit) / units.factor(value.unit)
    fem = row.fem if is_finite_elements(row) else None
    analytic, fem, u = (None if v is None else v * f for v in (row.analytic, fem, row.u_num))
    return PaperClaim(row=row.id, status=row.status, analytic=analytic, fem=fem, u=u)
