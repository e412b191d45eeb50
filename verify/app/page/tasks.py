"""Tasks that a page runs in other processes: finite elements, a report, a sweep of formulas."""

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from verify.answers.parameter_file import ParameterFile, completed
from verify.answers.registry import answer
from verify.app.check_command import Options, check_part, in_system, run_check
from verify.app.check_console import Checked
from verify.app.page.answers import WHERE, Shown, of_checked
from verify.app.page.shapes import Shape, shapes
from verify.cases.registry import find
from verify.core import units
from verify.core.inputs import InputError
from verify.core.progress import State as Progress
from verify.core.progress import names
from verify.jobs import cache
from verify.jobs.executor import ThisProcess
from verify.jobs.level import Job
from verify.jobs.scheduler import run
from verify.studies.sweep.axes import Axis, axis, changed

Notify = Callable[[Any], None]
MOST_POINTS = 1000
MARGIN, DESIGN = "margin", "design value"  # results of a sweep in addition to the case's values


def finite_elements(case: str, name: str, raw: Mapping[str, Any], notify: Notify) -> Shown:
    """Answer with judged rows. Raises InputError if the inputs cannot be solved.

    Each solved level (mesh) is stored, and `notify` receives the progress.
    """
    file = _file(case, name, raw)
    return of_checked(in_system(_solved(file, notify), file.system))


def fields(case: str, name: str, raw: Mapping[str, Any], notify: Notify) -> tuple[Shape, ...]:
    """The fields of the finest mesh as bodies. Raises InputError if the case has none."""
    file = _file(case, name, raw)
    if not file.case.pictures(file.inputs):
        raise InputError("this case has no field to display: it defines no pictures of fields")
    result = _solved(file, notify).result
    if found := shapes(result.fields, result.pictures):
        return found
    raise InputError("the pictures of this case require fields that the solution does not contain")


def _solved(file: ParameterFile, notify: Notify) -> Checked:
    """The check with finite elements. The levels are solved first, to report the progress."""
    if reason := file.case.too_large(file.inputs):
        raise InputError(f"these inputs cannot be solved by finite elements: {reason}")

    def show(state: Progress) -> None:
        notify((state.done, state.total, names(state.running)))

    notify((0, len(file.case.levels), ""))
    job = Job(file.case, file.inputs, values=file.values, drawn=False)
    run([job], engine=ThisProcess().entered(), cache_folder=cache.default_folder(), show=show)
    notify((len(file.case.levels), len(file.case.levels), "judging"))
    return check_part(file, WHERE, Options(fem=True, json=True), ThisProcess())


def report(path: Path, out: Path, fem: bool, _notify: Notify) -> tuple[str, ...]:
    """Write the report of `freewheel check --out` for a parameter file.

    Returns the names of the files of the report.
    """
    with (
        Path(os.devnull).open("w", encoding="utf-8") as nowhere,
        redirect_stdout(nowhere), redirect_stderr(nowhere),
    ):  # fmt: skip
        run_check(path, Options(fem=fem, json=True, out=out, jobs=1))
    names = sorted(one.name for one in out.iterdir() if one.is_file())
    return tuple(name for name in names if not name.startswith("."))


@dataclass(frozen=True, kw_only=True)
class Swept:
    """Results of a sweep: one row per value of the second axis, one column per value of the first.

    A result is None if the formulas have no solution at its point. Values are in display units;
    `problem` is the message of the first point without a result.
    """

    axes: tuple[tuple[str, tuple[float, ...]], ...]
    label: str
    values: tuple[tuple[float | None, ...], ...]
    problem: str = ""


def sweep(
    case: str, name: str, raw: Mapping[str, Any], vary: Sequence[str], result: str, notify: Notify
) -> Swept:
    """Values of one result of the formulas over one or two varied inputs.

    `vary` contains the axes in the form of `freewheel sweep --vary`. `result` is MARGIN, DESIGN or
    the key of a value. Raises InputError for wrong inputs or axes.
    """
    file = _file(case, name, raw)
    found = [axis(file.inputs, text) for text in vary]
    lines = [(None,)] if len(found) == 1 else [(v,) for v in found[1].values]
    count = len(lines) * len(found[0].values)
    if count > MOST_POINTS:
        raise InputError(f"a sweep must have at most {MOST_POINTS} points, got {count}")
    point = _Point(file, found, result)
    values: list[tuple[float | None, ...]] = []
    for second in (line[0] for line in lines):
        row: list[float | None] = []
        for first in found[0].values:
            notify((len(values) * len(found[0].values) + len(row), count, ""))
            row.append(point.value(first, second))
        values.append(tuple(row))
    return Swept(
        axes=tuple((_label(a), tuple(a.in_unit(v) for v in a.values)) for a in found),
        label=point.label(), values=tuple(values), problem=point.problem,
    )  # fmt: skip


class _Point:
    """Computes one result at changed inputs. `problem` is the message of the first failure."""

    def __init__(self, file: ParameterFile, axes: Sequence[Axis], result: str) -> None:
        self.file, self.axes, self.result, self.problem = file, axes, result, ""
        self.assumed = [one.name for one in file.assumed]

    def value(self, first: float, second: float | None) -> float | None:
        given = dict(zip([a.name for a in self.axes], (first, second), strict=False))
        try:
            with np.errstate(over="raise", divide="raise", invalid="raise"):
                found = self._value({k: v for k, v in given.items() if v is not None})
        except (ValueError, ArithmeticError, KeyError) as error:
            self.problem = self.problem or " ".join(str(error).split())
            return None
        return float(f"{found:.6g}") if found is not None and np.isfinite(found) else None

    def _value(self, given: Mapping[str, float]) -> float | None:
        case, inputs = self.file.case, changed(self.file.inputs, given)
        values = case.analytic(inputs)
        if self.result not in (MARGIN, DESIGN):
            unit = next(o.unit for o in case.outputs if o.key == self.result)
            return values[self.result] / units.factor(unit)
        found = answer(case, inputs, values, assumed=self.assumed,
                       with_design=self.result == DESIGN)  # fmt: skip
        if self.result == DESIGN:
            one = found.design
            return None if one is None else one.value / units.factor(one.unit)
        if found.failures:
            raise ValueError(found.failures[0])
        return None if found.limiting is None else found.limiting.margin

    def label(self) -> str:
        """Text that names the result and its unit."""
        if self.result == MARGIN:
            return MARGIN
        case = self.file.case
        if self.result == DESIGN:
            found = answer(case, self.file.inputs, self.file.values, assumed=self.assumed)
            return f"{found.design.symbol}{_unit(found.design.unit)}" if found.design else DESIGN
        of = next(o for o in case.outputs if o.key == self.result)
        return f"{of.symbol}{_unit(of.unit)}"


def _file(case: str, name: str, raw: Mapping[str, Any]) -> ParameterFile:
    return completed(find(case), raw, name=name, where=WHERE, named=case)


def _label(one: Axis) -> str:
    return f"{one.symbol}{_unit(one.unit)}"


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" [{unit}]"
