"""Results of second solvers for the finite-element value of a row, and for a case."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from reports import formats
from reports.crosscheck import WITHOUT_NUMBERS, Problem, problems
from verify.core.results import Crosscheck, CrossState, Row

COLUMNS = ("second_solver", "second_value", "second_difference_relative", "second_seconds")


@dataclass(frozen=True)
class Seconds:
    """Comparisons by place: `ids` are anchors of the page, `rows` by id of row, `cases` by case.

    A row has the comparisons of its quantity. A case has the problems with a quantity that belongs
    to no single row.
    """

    ids: Mapping[Crosscheck, str]
    rows: Mapping[str, Sequence[Crosscheck]]
    cases: Mapping[str, Sequence[Problem]]

    def of(self, row: Row) -> Sequence[Crosscheck]:
        return self.rows.get(row.id, ())


NOTHING = Seconds({}, {}, {})


def seconds(checks: Sequence[Crosscheck]) -> Seconds:
    """Comparisons that were measured, by the places at which the report displays them."""
    rows: dict[str, list[Crosscheck]] = {}
    others: dict[str, list[Crosscheck]] = {}
    for check in checks:
        if check.state in WITHOUT_NUMBERS:
            continue
        own = check.row == f"{check.case}/{check.quantity}"
        (rows if own else others).setdefault(check.row if own else check.case, []).append(check)
    ids = {check: f"cross-{i}" for i, check in enumerate(checks)}
    return Seconds(ids, rows, {case: problems(group) for case, group in others.items()})


def value(check: Crosscheck, row: Row) -> Markup:
    """Value of the second solver, with its unit if this differs from the unit of the row."""
    unit = "" if check.unit == row.unit or check.unit == "1" else f" {check.unit}"
    return Markup("{}{}").format(formats.written(check.theirs), unit)


def difference(check: Crosscheck, kind: str = "") -> Markup:
    """Text with the difference of both solvers and the computing time of the second solver.

    `kind` is a word before "difference", such as "largest".
    """
    outside = " (more than allowed)" if check.state is CrossState.OUTSIDE else ""
    found = formats.percents(check.difference, signed=True) if check.difference else "0"
    return Markup(
        "{}difference from this project on the same mesh {}{}, computing time {:.2g} s"
    ).format(kind and f"{kind} ", found, outside, check.seconds[1])


def meshes(check: Crosscheck) -> str:
    """Text with both compared values, which are for one mesh (not always the mesh of the row)."""
    here, there = (formats.number(x) for x in (check.ours, check.theirs))
    unit = f" {check.unit}" if check.unit != "1" else ""
    return (
        f"{check.solver} {check.version} on the project's mesh of {check.unknowns} unknowns: "
        f"{there}{unit}; project: {here}{unit}"
    )


def cells(checks: Sequence[Crosscheck]) -> list[str | float | None]:
    """Cells with the result of one second solver, under the heads COLUMNS.

    If a row has several second solvers, the first is used; crosscheck.csv contains all of them.
    """
    if not checks:
        return ["", None, None, None]
    first = checks[0]
    return [first.solver, first.theirs, first.difference, first.seconds[1]]


def records(checks: Sequence[Crosscheck]) -> Iterator[dict[str, Any]]:
    """Records of the comparisons with every second solver, for results.json."""
    for check in checks:
        yield {
            "solver": check.solver, "version": check.version, "value": check.theirs,
            "unit": check.unit, "difference": check.difference, "seconds": check.seconds[1],
        }  # fmt: skip
