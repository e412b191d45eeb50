"""The command `check`: formulas and, on request, finite elements for a user's parameters."""

import json
import shlex
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from verify.answers.answer import EXIT_STATUS, Answer, Verdict
from verify.answers.answer_units import assumed_in, dynamic_in_units, in_units, record_in_units
from verify.answers.assumed.listed import with_sources
from verify.answers.dependence import margin_notes
from verify.answers.evidence import why_not_solved, with_rows
from verify.answers.evidence import with_dynamic as answer_with_dynamic
from verify.answers.parameter_file import ParameterFile, read
from verify.answers.registry import answer as answer_of
from verify.answers.shared_readings import SharedReading, shared_readings
from verify.answers.usual import unusual
from verify.app.check_console import Checked, answer_lines, limits_table, print_check
from verify.app.check_record import check_record
from verify.app.commands import writable, write_report
from verify.app.report import make_report
from verify.core.case import Case
from verify.core.inputs import InputError, Inputs
from verify.core.results import CaseResult, Status
from verify.core.unit_systems import System
from verify.jobs.dynamic import asked_for, run_dynamic, with_dynamic
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve
from verify.verdicts.console import of_part

GIVE_STRENGTH = "give R_p"
DRAWN_IN_MM = "equations, figures and further tables of this page are in mm, N and MPa"
FAILED = (Status.FAIL, Status.SKIP)


@dataclass(frozen=True, kw_only=True)
class Options:
    """Options of `check`.

    With notes=False, the influence of the assumed inputs on the margin is not computed, which would
    be slow.
    """

    fem: bool = False
    dynamic: bool = False
    json: bool = False
    jobs: int = 0
    cache: bool = True
    out: Path | None = None
    units: System | None = None
    notes: bool = True


def run_check(path: Path, options: Options) -> int:
    """Print the answer to a parameter file and return the exit status.

    The status is 0 if the part holds, 1 if the part or a row fails, and 3 if the answer is
    undecided. Raises InputError if the file or an option is wrong.
    """
    file = read(path)
    if options.out is not None:
        writable(options.out)
    start = time.perf_counter()
    checked = check_part(file, str(path), options, Where(options.jobs), _command(path, options))
    system = options.units or file.system
    if options.json:
        record = check_record(in_system(checked, system), file.inputs, file.values)
        print(json.dumps(record_in_units(record, system), ensure_ascii=False))
    else:
        print_check(in_system(checked, system), system)
    if options.out is not None:
        _write(in_system(checked, system), options, system, time.perf_counter() - start)
    return exit_status(checked)


def check_part(
    file: ParameterFile, named: str, options: Options, where: Where, command: str = ""
) -> Checked:
    """Check the inputs of a file as `options` require; error messages call the file `named`.

    Raises InputError if finite elements or the simulation in time cannot solve the inputs.
    """
    case, inputs, values = file.case, file.inputs, file.values
    if options.dynamic:
        asked_for(case, named)
    if options.fem and (reason := case.too_large(inputs)):
        raise InputError(f"{named}: inputs: {reason}")
    drawn = options.out is not None
    dynamic = None
    if options.dynamic:
        dynamic = run_dynamic(case, inputs, values, where=named, drawn=drawn, quiet=options.json)
    job = Job(case, inputs, use_fem=options.fem, values=values, drawn=drawn)
    (result,) = solve([job], where, options.cache, quiet=options.json)
    part = _assessed(file, named, options.notes)
    odd = unusual(inputs)
    doubts = [w for w in result.warnings if not w.endswith(GIVE_STRENGTH)]  # a limit decides that
    warnings = (*odd.values(), *doubts)
    result = replace(result, name=file.name, command=command, warnings=warnings)
    result = with_sources(result, file.assumed)
    if not options.fem:
        result = refused(result, case, inputs)
    if dynamic is not None and result.refused:
        dynamic = dynamic.unjudged()
    answer = part.answer if dynamic is None else answer_with_dynamic(part.answer, dynamic)
    answer = with_rows(answer, result.rows)
    notes: tuple[str, ...] = (f"outside the usual range: {', '.join(odd)}",) if odd else ()
    return Checked(
        case=case, result=result, answer=answer, used_fem=options.fem, dynamic=dynamic,
        notes=notes + part.notes, assumed=file.assumed, shared=part.shared,
        verdicts=of_part(case, inputs),
    )  # fmt: skip


def in_system(checked: Checked, system: System) -> Checked:
    """The checked part with its results and assumed inputs in the units of `system`."""
    return replace(
        checked, result=in_units(checked.result, system),
        dynamic=dynamic_in_units(checked.dynamic, system),
        assumed=assumed_in(checked.assumed, system),
    )  # fmt: skip


def exit_status(checked: Checked) -> int:
    """Exit status: 0 if the part holds, 1 if the part or a row fails, 3 for "cannot say".

    If rows failed only because the reference has no value, the answer is "cannot say", unless the
    part fails.
    """
    rows = checked.result.rows
    if any(row.status in FAILED for row in rows) and not why_not_solved(rows):
        return EXIT_STATUS[Verdict.FAILS]
    return EXIT_STATUS[checked.answer.verdict]


@dataclass(frozen=True, kw_only=True)
class _Assessed:
    """Answer, notes and shared assumptions of a part."""

    answer: Answer
    notes: tuple[str, ...]
    shared: tuple[SharedReading, ...]


def _assessed(file: ParameterFile, where: str, notes: bool) -> _Assessed:
    """Answer, dependence on assumed inputs, and shared assumptions of a part.

    Raises InputError if the criteria cannot be evaluated.
    """
    case, inputs, values = file.case, file.inputs, file.values
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            return _Assessed(
                answer=answer_of(case, inputs, values, assumed=[one.name for one in file.assumed]),
                notes=margin_notes(case, inputs, file.assumed) if notes else (),
                shared=shared_readings(case.id, inputs, values),
            )
    except (ValueError, ArithmeticError) as error:
        raise InputError(
            f"{where}: inputs: the criteria cannot be evaluated with these values ({error})"
        ) from error


def refused(result: CaseResult, case: Case, inputs: Inputs) -> CaseResult:
    """Result whose field `refused` states why finite elements cannot solve the inputs.

    If finite elements can solve the inputs, the result is unchanged.
    """
    with np.errstate(all="ignore"):
        reason = case.too_large(inputs).partition("; check ")[0]
    if not reason:
        return result
    values = tuple(replace(value, judged=False) for value in result.values)
    return replace(result, refused=reason, values=values)


def _command(path: Path, options: Options) -> str:
    flags = "--fem " * options.fem + "--dynamic " * options.dynamic
    return f"freewheel check {flags}{shlex.quote(path.name)}"


def _write(checked: Checked, options: Options, system: System, seconds: float) -> None:
    """Write the report of one part; its findings begin with the answer."""
    result = checked.result
    if checked.dynamic is not None:
        result = with_dynamic(result, checked.dynamic)
    first = tuple(line.strip() for line in answer_lines(checked, system))
    limits = limits_table(checked, system)
    if system != "mm":
        first += (DRAWN_IN_MM,)
    result = replace(result, findings=(*first, *result.findings),
                     tables=(limits, *result.tables))  # fmt: skip
    report = make_report([result], [checked.case], seconds, result.name)
    assert options.out is not None
    write_report(report, options.out, options.cache)
    print(f"report: {options.out / 'report.html'}", file=sys.stderr if options.json else sys.stdout)
