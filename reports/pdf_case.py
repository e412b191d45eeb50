"""One case as the PDF's template takes it: texts as runs, numbers as written, drawings as SVG."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from reports import formats, plots, signature
from reports.frames import Frame
from reports.html import Line, lines, plot, present, printed, reproduce
from reports.mathematics import tree
from reports.richtext import Run, digits, runs
from reports.sketch import sketch
from reports.standalone import Drawing, standalone
from verify.results import CaseResult, FormulaValue, InputValue, Row, Table

Data = dict[str, Any]

MARKS = {"theory": "|", "FEA": "□", "test": "◇"}  # as the graphic of a row draws them
LONGEST = 20  # rows of a table that are printed whole
SHOWN = 12  # of a longer one
WIDEST = 12  # columns side by side


def case_data(
    case: CaseResult, frames: Sequence[Frame], anchors: Mapping[str, str], sheets: Sequence[str]
) -> Data:
    """Everything of a case; `sheets` name the workbook's sheet of each of its tables."""
    group = lines(case.rows)
    return {
        "id": case.id,
        "name": case.name,
        "title": runs(case.title),
        "kicker": f"{case.id} · {case.paper}, {case.place}",
        "lead": prose(case.lead),
        "counts": [[status.value, count] for status, count in present(case.rows)],
        "warnings": [prose(w) for w in case.warnings],
        "lines": [line_data(line, anchors) for line in group],
        "sketch": standalone(sketch(case.sketch)),
        "sketch_title": case.sketch.title if case.sketch else "",
        "inputs": [_input(i) for i in case.inputs],
        "values": [_value(v) for v in case.values],
        "equations": [
            {"formula": maths(e.tex), "numbers": maths(e.numbers), "place": e.place}
            for e in case.equations
        ],
        "readings": [prose(x) for x in case.readings],
        "assumptions": [prose(x) for x in case.assumptions],
        "figures": _figures(case, frames),
        "budget": _budget([line.row for line in group]),
        "levels": _levels([row for row in case.rows if row.levels]),
        "expected": [_expected(row) for row in case.rows if row.interval],
        "tables": [_table(t, sheet) for t, sheet in zip(case.tables, sheets, strict=True)],
        "command": reproduce(case),
    }


def prose(text: str) -> list[Run]:
    """Running text with lowered indices."""
    return runs(formats.prose(text))


def maths(tex: str) -> Data | None:
    """An equation as its source and as a tree."""
    return {"tex": tex, "tree": tree(tex)} if tex else None


def quantity(row: Row) -> list[Run]:
    """Name, symbol and unit of a row."""
    unit: list[Run] = [" ", ["small", row.unit]] if row.unit != "1" else []
    return [*prose(row.quantity), " ", *runs(formats.symbol(row.symbol)), *unit]


def line_data(line: Line, anchors: Mapping[str, str]) -> Data:
    """A row of the summary with its convergence."""
    row, beside = line.row, line.convergence
    shown = formats.values(row)
    return {
        "label": anchors[row.id],
        "quantity": quantity(row),
        "formula": runs(shown.formula),
        "fem": runs(shown.fem),
        "u": runs(shown.u),
        "paper": [[MARKS[kind], text] for kind in MARKS if (text := printed(row, kind))],
        "difference": runs(formats.difference(row)),
        "signature": standalone(signature.signature(row)),
        "tolerance": runs(formats.tolerance(row)),
        "detects": runs(formats.power(row.detects)),
        "order": formats.order(beside) if beside else "",
        "order_label": anchors[beside.id] if beside else None,
        "order_status": beside.status.value if beside else "",
        "status": row.status.value,
        "reason": prose(line.reason),
    }


def _input(entry: InputValue) -> list[list[Run]]:
    what: list[Run] = [entry.what]
    if entry.source:
        what += [" ", ["place", *prose(entry.source)]]
    return [
        runs(formats.symbol(entry.symbol)), what,
        digits(formats.number(entry.value)), _unit(entry.unit),
    ]  # fmt: skip


def _value(value: FormulaValue) -> list[list[Run]]:
    aside: list[Run] = [] if value.judged else [" ", ["small", "(not judged)"]]
    return [
        runs(formats.symbol(value.symbol)), [*prose(value.what), *aside],
        digits(formats.number(value.value)), _unit(value.unit),
    ]  # fmt: skip


def _unit(unit: str) -> list[Run]:
    return [unit] if unit != "1" else []


def _figures(case: CaseResult, frames: Sequence[Frame]) -> list[Data]:
    found = [_figure(standalone(plot(f)), f.title, f.note) for f in case.figures]
    curves = standalone(plots.convergence([row for row in case.rows if row.levels]))
    words = (
        "Distance to the finest level, or to the exact value where an order is judged; one colour "
        "for each order of theory."
    )
    found += [_figure(curves, "Convergence", words)] if curves else []
    return found + [_figure(standalone(f.svg), f.caption, f.note) for f in frames if f.svg]


def _figure(drawing: Drawing | None, title: str, note: str) -> Data:
    return {"drawing": drawing, "title": prose(title), "note": prose(note)}


def _budget(rows: Sequence[Row]) -> Data:
    """Lines of the error budget; reasons for a demand stand below, each once, with a letter."""
    said = dict.fromkeys(row.demand_reason for row in rows if row.demand_reason)
    marks = {reason: _letter(i) for i, reason in enumerate(said)}
    return {
        "rows": [_budget_line(row, marks.get(row.demand_reason, "")) for row in rows],
        "reasons": [[mark, prose(reason)] for reason, mark in marks.items()],
    }


def _letter(index: int) -> str:
    """A to z, then aa, ab."""
    more, last = divmod(index, 26)
    return (_letter(more - 1) if more else "") + chr(ord("a") + last)


def _budget_line(row: Row, mark: str) -> list[list[Run]]:
    return [
        quantity(row), [row.kind.value], [row.grid.behaviour if row.grid else ""],
        [formats.order(row)], [formats.number(row.formal_order, 3)],
        runs(formats.relative(row, "u_num")), runs(formats.relative(row, "u_ref")),
        runs(formats.tolerance(row)), runs(formats.power(row.detects)),
        [*runs(formats.power(row.demand)), *([["sup", mark]] if mark else [])],
    ]  # fmt: skip


def _levels(rows: Iterable[Row]) -> list[Data]:
    """Values on every mesh, a table for each set of meshes."""
    return [
        {
            "header": [["Quantity"], *([f"h = {formats.number(h, 3)}"] for h in sizes)],
            "rows": [_level_cells(row) for row in group],
        }
        for sizes, group in groupby(sorted(rows, key=_sizes), _sizes)
    ]


def _level_cells(row: Row) -> list[list[Run]]:
    return [quantity(row), *(digits(formats.number(v, 9)) for _, v in row.levels)]


def _sizes(row: Row) -> tuple[float, ...]:
    return tuple(h for h, _ in row.levels)


def _expected(row: Row) -> list[list[Run]]:
    assert row.interval is not None
    ends = (runs(formats.power(m, signed=True)) for m in row.interval)
    return [quantity(row), *ends, prose(row.interval_source)]


def _table(table: Table, sheet: str) -> Data:
    """A table in parts that fit the page's width; a long one begins only."""
    long = len(table.rows) > LONGEST
    rows = table.rows[:SHOWN] if long else table.rows
    count = f"The first {SHOWN} of {len(table.rows)} rows; all stand in tables.xlsx, sheet {sheet}."
    last = len(table.header) - 1
    starts = range(1, max(last, 1) + 1, WIDEST - 1)
    parts = [[0, *range(i, min(i + WIDEST - 1, last + 1))] for i in starts]
    return {
        "title": prose(table.title),
        "parts": [
            {
                "header": [prose(table.header[i]) for i in part],
                "rows": [[_cell(row[i]) for i in part] for row in rows],
                "numbers": [bool(rows) and not isinstance(rows[0][i], str) for i in part],
            }
            for part in parts
        ],
        "note": prose(table.note),
        "shortened": count if long else "",
    }


def _cell(cell: str | float | None) -> list[Run]:
    return prose(cell) if isinstance(cell, str) else digits(formats.number(cell))
