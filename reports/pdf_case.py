"""One case as data for the PDF template: texts as runs, numbers as text, drawings as SVG."""

from collections.abc import Mapping, Sequence

from reports import formats, second, signature
from reports.convergence import convergence, on_meshes
from reports.crosscheck import Problem
from reports.environment import present, printed, reproduce
from reports.figures import plot
from reports.frames import Frame
from reports.mathematics import tree
from reports.pdf_tables import Data, budget, expected, levels, prose, quantity, shortened
from reports.richtext import Run, digits, runs
from reports.row_lines import Line, failed_first, lines
from reports.second import NOTHING, Seconds
from reports.sketch import sketch
from reports.standalone import Drawing, standalone
from verify.core.figures import FormulaValue, InputValue
from verify.core.results import CaseResult, Crosscheck, Row

MARKS = {"theory": "|", "FEA": "□", "test": "◇"}  # as the graphic of a row draws them


def case_data(
    case: CaseResult,
    frames: Sequence[Frame],
    anchors: Mapping[str, str],
    sheets: Sequence[str],
    source: str,
    beside: Seconds = NOTHING,
) -> Data:
    """All data of a case for the PDF; `source` is the place of its formulas.

    `sheets` are the names of the workbook's sheets for the tables of the case; `beside` are the
    results of second solvers.
    """
    rows, group = failed_first(case.rows), lines(case.rows)
    refined = [row for row in rows if row.grid and row.levels]
    return {
        "id": case.id,
        "name": case.name,
        "title": runs(case.title),
        "kicker": " · ".join(filter(None, (case.id, source))),
        "lead": prose(case.lead),
        "counts": [[status.value, count] for status, count in present(case.rows)],
        "findings": [prose(f) for f in case.findings],
        "warnings": [prose(w) for w in case.warnings],
        "lines": [
            line_data(line, anchors) | {"second": _second(beside.of(line.row), line.row)}
            for line in group
        ],
        "second": [_problem(p) for p in beside.cases.get(case.id, ())],
        "sketch": standalone(sketch(case.sketch)),
        "sketch_title": _caption(case.sketch.title) if case.sketch else [],
        "inputs": [_input(i) for i in case.inputs],
        "values": [value_cells(v) for v in case.values],
        "equations": [
            {"formula": maths(e.tex), "numbers": maths(e.numbers), "place": prose(e.place)}
            for e in case.equations
        ],
        "readings": [prose(x) for x in case.readings],
        "assumptions": [prose(x) for x in case.assumptions],
        "figures": _figures(case, frames),
        "budget": budget([line.row for line in group]),
        "finer": "on every mesh" if on_meshes(refined) else "at every refinement",
        "levels": levels(refined),
        "expected": [expected(row) for row in rows if row.interval],
        "tables": [shortened(t, sheet) for t, sheet in zip(case.tables, sheets, strict=True)],
        "command": reproduce(case),
    }


def maths(tex: str) -> Data | None:
    """An equation as its source and as a tree."""
    return {"tex": tex, "tree": tree(tex)} if tex else None


def line_data(line: Line, anchors: Mapping[str, str]) -> Data:
    """Data of a row of the summary with its convergence."""
    row, beside = line.row, line.convergence
    shown = formats.values(row)
    return {
        "label": anchors[row.id],
        "quantity": quantity(row),
        "formula": runs(shown.formula),
        "fem": runs(shown.fem),
        "by": prose(shown.by),
        "paper": [[MARKS[kind], runs(text)] for kind in MARKS if (text := printed(row, kind))],
        "difference": runs(formats.difference(row)),
        "signature": standalone(signature.signature(row)),
        "tolerance": runs(formats.tolerance(row)),
        "detects": runs(formats.fraction(row, row.detects)),
        "order": formats.order(beside) if beside else "",
        "order_label": anchors[beside.id] if beside else None,
        "order_status": beside.status.value if beside else "",
        "status": row.status.value,
        "reason": prose(line.reason),
    }


def _second(checks: Sequence[Crosscheck], row: Row) -> list[list[Run]]:
    """Results of each second solver for the row."""
    return [
        [f"{c.solver}: ", *runs(second.value(c, row)), ", ", *runs(second.difference(c))]
        for c in checks
    ]


def _problem(problem: Problem) -> list[Run]:
    """Sentence about results of a second solver that belong to no single row."""
    sentence: list[Run] = [f"Second solver, {problem.head.solver}: ", *prose(problem.head.what)]
    for i, check in enumerate(problem.lines):
        sentence += [
            ". " if i == 0 else "; ",
            *prose(check.quantity),
            ": ",
            *runs(second.difference(check)),
        ]
    return [*sentence, "."]


def _caption(title: str) -> list[Run]:
    return prose(title[:1].upper() + title[1:])


def _input(entry: InputValue) -> list[list[Run]]:
    what = prose(entry.what)
    if entry.source:
        what += [" ", ["place", *prose(entry.source)]]
    return [
        runs(formats.symbol(entry.symbol)), what,
        digits(formats.number(entry.value)), _unit(entry.unit),
    ]  # fmt: skip


def value_cells(value: FormulaValue) -> list[list[Run]]:
    aside: list[Run] = [] if value.judged else [" ", ["small", "(not judged)"]]
    return [
        runs(formats.symbol(value.symbol)), [*prose(value.what), *aside],
        digits(formats.number(value.value)), _unit(value.unit),
    ]  # fmt: skip


def _unit(unit: str) -> list[Run]:
    return prose(unit) if unit != "1" else []


def _figures(case: CaseResult, frames: Sequence[Frame]) -> list[Data]:
    found = [_figure(standalone(plot(f)), f.title, f.note) for f in case.figures]
    curves = standalone(convergence([row for row in case.rows if row.levels]))
    words = (
        "Difference of each level from the finest level, or from the exact value if an order is "
        "judged. There is one colour "
        "for each theoretical order. Rows without an order are not drawn."
    )
    found += [_figure(curves, "Convergence", words)] if curves else []
    return found + [_figure(standalone(f.svg), f.caption, f.note) for f in frames if f.svg]


def _figure(drawing: Drawing | None, title: str, note: str) -> Data:
    return {"drawing": drawing, "title": prose(title), "note": prose(note)}
