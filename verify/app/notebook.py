"""Python functions for cases and parts; a notebook displays the results as tables and drawings."""

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from reports.notebook import Drawings, drawings, table
from verify.answers.answer import Verdict
from verify.answers.console import limits
from verify.answers.parameter_file import ParameterFile, completed, read
from verify.answers.template import template
from verify.app.check_command import Options, check_part, in_system
from verify.app.check_console import Checked, answer_lines
from verify.app.tables import Table, dataframe, of_criteria, of_rows
from verify.cases.registry import find
from verify.core.case import Case
from verify.core.console import aligned, raised, sentences
from verify.core.console_rows import row_cells, title
from verify.core.results import CaseResult, Row, Status
from verify.jobs.executor import ThisProcess
from verify.jobs.level import Job
from verify.jobs.session import solve

if TYPE_CHECKING:
    from pandas import DataFrame

FAILED = (Status.FAIL, Status.SKIP)


@dataclass(frozen=True)
class Run:
    """A case that was solved and judged."""

    result: CaseResult

    @property
    def rows(self) -> tuple[Row, ...]:
        """Judged rows of the case; numbers are in the unit of the row."""
        return self.result.rows

    @property
    def passed(self) -> bool:
        """Whether no row failed."""
        return not any(row.status in FAILED for row in self.rows)

    @property
    def table(self) -> Table:
        """Judged rows as dictionaries of plain values; see `verify.app.tables`."""
        return of_rows(self.rows)

    def to_dataframe(self) -> "DataFrame":
        """The table as a DataFrame. Raises ImportError if pandas is not installed."""
        return dataframe(self.table)

    @property
    def drawings(self) -> Drawings:
        """Sketch, figures and convergence plots of the case."""
        return drawings(self.result)

    def __repr__(self) -> str:
        """One line with the case, whether it passed, and the deciding row."""
        failed = [row for row in self.rows if row.status in FAILED]
        main = failed[0] if failed else next((r for r in self.rows if r.analytic is not None), None)
        main_row = f"; {_row_in_line(main)}" if main else ""
        passed = sum(row.status is Status.PASS for row in self.rows)
        status = f"{'FAIL' if failed else 'PASS'}, {passed} of {len(self.rows)} rows pass"
        return f"<Run {self.result.id}: {status}{main_row}>"

    def __str__(self) -> str:
        lines = [title(self.rows), *aligned(row_cells(self.rows)), *sentences(self.rows)]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head = f"{self.result.title}: {title(self.rows)}"
        return _rows_table(self.rows, head)


@dataclass(frozen=True)
class Part:
    """A part that was checked."""

    checked: Checked
    file: ParameterFile

    @property
    def verdict(self) -> Verdict:
        """Verdict: the part holds, the part fails, or neither can be stated."""
        return self.checked.answer.verdict

    @property
    def margin(self) -> float | None:
        """Smallest margin [1] of the criteria; None without criteria."""
        worst = self.checked.answer.limiting
        return worst.margin if worst else None

    @property
    def table(self) -> Table:
        """Criteria as dictionaries: value and limit [SI], margin [1], source."""
        return of_criteria(self.checked.answer.criteria)

    def to_dataframe(self) -> "DataFrame":
        """The table as a DataFrame. Raises ImportError if pandas is not installed."""
        return dataframe(self.table)

    @property
    def values(self) -> dict[str, float]:
        """Values of the formulas [SI], by the names that `freewheel check --keys` lists."""
        return dict(self.file.values)

    def __repr__(self) -> str:
        """One line with the part, its verdict and its smallest margin."""
        margin = "" if self.margin is None else f", margin {self.margin:.3g}"
        return f"<Part {self.file.name} ({self.file.case.id}): {self.verdict.value}{margin}>"

    def __str__(self) -> str:
        return "\n".join(map(raised, answer_lines(self._shown, self.file.system)))

    def _repr_html_(self) -> str:
        first, *rest = str(self).splitlines()
        lines = [Markup("<b>{}</b>").format(first), *map(str.strip, rest)]
        parts = [_paragraph(lines)]
        header = ("", "criterion", "value", "limit", "margin", "source")
        parts.append(table(header, limits(self.checked.answer, self.file.system)))
        if warnings := self.checked.result.warnings:
            parts.append(_paragraph([raised(f"warning: {one}") for one in warnings]))
        if self.checked.used_fem:
            parts.append(_rows_table(self._shown.result.rows, title(self.rows)))
        return "\n".join(parts)

    @property
    def rows(self) -> tuple[Row, ...]:
        """Judged rows; rows that need finite elements are included only after check(fem=True)."""
        return self.checked.result.rows

    @property
    def _shown(self) -> Checked:
        return in_system(self.checked, self.file.system)


def run(case: str | Path, inputs: Mapping[str, Any] | None = None, *, cache: bool = True) -> Run:
    """Solve and judge a case, given by name, case file ("my_pipe.py") or part ("clutch.toml").

    `inputs` contains the inputs to change, as texts with units, such as {"r_i": "40 mm"}; the other
    inputs have the values of `freewheel init`. With `cache`, stored results are used. A run that
    takes long displays its progress. Raises InputError (a ValueError) with a message of one line.
    """
    if Path(case).suffix == ".toml" or inputs:
        part = _part(case, inputs)
        job = Job(part.case, part.inputs, values=part.values)
    else:
        found = find(str(case))
        job = Job(found, found.inputs())
    (result,) = solve([job], ThisProcess(), cache)
    return Run(result)


def check(
    part: str | Path, inputs: Mapping[str, Any] | None = None, *, fem: bool = False,
    cache: bool = True,
) -> Part:  # fmt: skip
    """Check a part, given by a parameter file, or by the name of a case and `inputs` (see `run`).

    With `fem`, the formulas are compared with finite elements for these inputs. Raises InputError
    if an input is wrong.
    """
    file = _part(part, inputs)
    options = Options(fem=fem, cache=cache)
    return Part(check_part(file, str(part), options, ThisProcess()), file)


def _part(part: str | Path, inputs: Mapping[str, Any] | None) -> ParameterFile:
    """Content of a parameter file, or of the template of a case with some changed inputs."""
    if Path(part).suffix == ".toml":
        if inputs:
            raise ValueError(
                f"{part}: inputs must not be given for a parameter file, which "
                "contains them; give a case instead"
            )
        return read(Path(part))
    case = find(str(part))
    raw = _template(case) | dict(inputs or {})
    return completed(case, raw, name=f"my {case.id}", where=str(part))


def _template(case: Case) -> dict[str, Any]:
    """Inputs that `freewheel init` writes for a case."""
    written: dict[str, Any] = tomllib.loads(template(case))["inputs"]
    return written


def _row_in_line(row: Row) -> str:
    """One line with a row, its status and its difference."""
    unit = "" if row.unit == "1" else f" {row.unit}"
    off = "" if row.difference is None else f", difference {row.difference:.3g}{unit}"
    return f"{row.quantity}: {row.status.value}{off}"


def _rows_table(rows: Sequence[Row], head: str) -> Markup:
    header, *lines = row_cells(rows)
    shown = [[raised(cell) for cell in line] for line in lines]
    return table(header, shown, head) + _paragraph(sentences(rows))


def _paragraph(lines: Sequence[str]) -> Markup:
    """HTML paragraph of lines with escaped text."""
    return Markup("<p>{}</p>").format(Markup("<br>").join(lines))
