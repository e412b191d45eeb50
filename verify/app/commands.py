"""Actions of the commands list and verify, and functions that other commands share."""

import gc
import sys
import tempfile
import time
from collections.abc import Collection, Mapping, Sequence
from functools import partial
from pathlib import Path

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.parameter_file import read
from verify.app import summary as in_short
from verify.app import up_to_date
from verify.app.parts import Parts
from verify.app.report import make_report
from verify.cases import files
from verify.cases.registry import CASES, QUICK, find, ids
from verify.core import environment, source_memory
from verify.core.case import Case, Values
from verify.core.console import raised, verdict_lines
from verify.core.inputs import REQUIRED, InputError, Inputs, meta
from verify.core.results import CaseResult, Report, Status
from verify.core.source_files import code_of
from verify.core.terminal import print_wrapped
from verify.jobs import cache, judged
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve, stored_levels
from verify.papers.ledger import cited
from verify.verdicts.console import in_list
from verify.verdicts.record import moved

ROOT = Path(__file__).parents[2]
BAD = (Status.FAIL, Status.SKIP)
GARBAGE_AFTER = 20_000  # new objects: syntax trees and pages are numerous and stay in use


def run_list() -> int:
    """Print each case with its subject, its verdicts, its required and its optional inputs."""
    for case in (*CASES, *map(find, files.installed())):
        assumable = {one.name for one in ASSUMPTIONS.get(case.id, ())}
        needed: list[str] = []
        optional: list[str] = []
        for name, field in case.inputs.model_fields.items():
            unit = meta(field)["unit"]
            text = name if unit == "1" else f"{name} [{unit}]"
            is_needed = meta(field)["omitted"] == REQUIRED and name not in assumable
            (needed if is_needed else optional).append(text)
        source = ", ".join(filter(None, (cited(case.paper), case.place)))
        print_wrapped(f"{case.id:20}  {case.title}{f' ({source})' if source else ''}")
        if found := in_list(case):
            print_wrapped(f"{'':20}  verdicts: {found}")
        print_wrapped(f"{'':20}  inputs: {', '.join(needed)}")
        if optional:
            print_wrapped(f"{'':20}  optional: {', '.join(optional)}")
    return 0


def run_verify(
    names: Sequence[str], *, quick: bool, where: Where, out: Path | None, use_cache: bool,
    single_file: bool = False, full_pdf: bool = False, summary: Path | None = None,
) -> int:  # fmt: skip
    """Run cases with the paper's numbers, write the report and print the verdicts.

    A summary in Markdown is appended to the file `summary`. Returns the exit status.
    """
    if quick and names:
        raise InputError(
            f"--quick runs {', '.join(QUICK)}: do not name cases together with --quick"
        )
    names = QUICK if quick else names
    out = out or ROOT / "reports" / "out"
    writable(out)
    if summary:
        in_short.write("", summary)  # a place that cannot be written is found before the work
    start = time.perf_counter()
    gc.set_threshold(GARBAGE_AFTER)
    key = ""
    if use_cache and all(name in CASES.ids for name in names):
        form = "one page" * single_file + "full PDF" * full_pdf
        key = up_to_date.key_of(ROOT, names, form)
        if (before := up_to_date.found(out, key)) is not None:
            print_wrapped(*before.lines)
            took = f"{time.perf_counter() - start:.1f} s"
            print(
                f"report: {_page(out)} (of {before.made}; nothing has changed since then; {took})"
            )
            if summary:
                in_short.write(before.summary, summary)
            return before.status
    cases = _chosen(names)
    folder = cache.default_folder() if use_cache else None
    if folder:
        source_memory.use(folder)
    keys = judged.keys({name: CASES.module_of(name) for name in ids(cases) if name in CASES.ids})
    known = judged.load(folder, keys) if folder else {}
    work = [Job(case, case.inputs()) for case in _others(cases, known)]
    new = _solved_for_report(work, where, keys) if folder else solve(work, where, False)
    by_name = {result.id: result for result in new} | {n: one.result for n, one in known.items()}
    results = [by_name[name] for name in ids(cases)]
    parts = Parts(folder, keys)
    report = make_report(results, cases, time.perf_counter() - start, parts=parts)
    lines = verdict_lines(report)
    print_wrapped(*lines)
    is_complete = write_report(
        report, out, use_cache, single_file=single_file, full_pdf=full_pdf, keys=keys
    )  # fmt: skip
    drift = [*drift_lines(report), *_moved_verdicts(report)]
    print_wrapped(*drift)
    print(f"report: {_page(out)} ({time.perf_counter() - start:.1f} s)")
    status = _exit_status(report)
    text = in_short.summary(report, status=status, changes=drift)
    if summary:
        in_short.write(text, summary)
    if any(case.errors for case in report.cases):
        print(f"tracebacks: {out / 'errors.txt'}")
    elif key and is_complete:
        made = str(report.provenance["made"])
        reported = up_to_date.Reported((*lines, *drift), status, made, text)
        levels = [*stored_levels(work), *(level for one in known.values() for level in one.levels)]
        up_to_date.keep(out, key, levels, reported)
    return status


def _chosen(names: Sequence[str]) -> Sequence[Case]:
    """Cases with these names, by default all; cases of the suite are imported when needed."""
    if all(name in CASES.ids for name in names):
        return CASES.only(names or CASES.ids)
    return [find(name) for name in dict.fromkeys(names)]


def _others(cases: Sequence[Case], known: Collection[str]) -> list[Case]:
    """Cases that are not among the `known` ones."""
    return [find(name, cases) for name in ids(cases) if name not in known]


def _solved_for_report(
    work: list[Job], where: Where, keys: Mapping[str, str]
) -> list[CaseResult]:  # fmt: skip
    """Solve and judge cases, store the results, and draw the report's pictures at the same time."""
    from reports.ahead import Ahead

    if not work:
        return []
    folder, cases = cache.default_folder(), [job.case for job in work]
    with Ahead(folder, _hint(), lambda: _read_records(cases)) as ahead:
        results = solve(work, where, True, judged=ahead.add)
    for job, result in zip(work, results, strict=True):
        if result.id in keys:
            judged.keep(folder, job, result, keys[result.id])
    return results


def _read_records(cases: Sequence[Case]) -> None:
    """Hash all code on which stored results of studies depend; the first call takes seconds."""
    from verify.studies.budget.measuring import plan_of
    from verify.studies.budget.store import measured as budget
    from verify.studies.crosscheck.judged import reported
    from verify.studies.validity.store import measured as region

    for case in cases:
        if case.scans:
            region(case)
        budget(plan_of(case.id))
    reported([case.id for case in cases])


def _page(out: Path) -> Path:
    return out / "report.html"


def _exit_status(report: Report) -> int:
    failed = any(row.status in BAD for row in report.rows)
    loosened = report.drift is not None and report.drift.unexplained
    return 1 if failed or loosened or _moved_verdicts(report) else 0


def _moved_verdicts(report: Report) -> list[str]:
    """Formulas whose verdict differs from the stored one; empty if only some cases were run."""
    return moved(report.verdicts) if report.verdicts else []


def drift_lines(report: Report) -> list[str]:
    """Lines about changes of the rows since the last release; empty if no release is stored."""
    if not report.drift:
        return []
    from verify.audit.releases.changes import lines

    return [raised(line) for line in lines(report.drift)]


def writable(out: Path) -> None:
    """Make the folder `out`. Raises InputError if files cannot be written into the folder."""
    for place in (out, *out.parents):
        if place.exists() and not place.is_dir():
            raise InputError(f"{place}: is a file, expected a folder")
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=out):
            pass
    except OSError as error:
        raise InputError(f"{out}: cannot be written: {error.strerror}") from error


def write_report(
    report: Report, out: Path, use_cache: bool, *, single_file: bool = False,
    full_pdf: bool = False, keys: Mapping[str, str] | None = None,
) -> bool:  # fmt: skip
    """Write the report into `out`; returns whether all parts were written without problems.

    Problems are printed, such as a missing program that a substitute replaces. If `use_cache` is
    True and `keys` (case: key of its judged result) is given, only changed files are written.
    """
    from reports.origins import Origins  # only the command line may import reports
    from reports.write import write

    code = partial(code_of, write.__module__)
    drawn = cache.default_folder() if use_cache else None
    origins = (
        Origins(source_memory.remembered("code", write, code), keys) if use_cache and keys else None
    )
    written = write(
        report, out, cache=drawn, hint=_hint(), single_file=single_file, full_pdf=full_pdf,
        origins=origins,
    )  # fmt: skip
    for remark in written.remarks:
        print(f"freewheel: {remark}", file=sys.stderr)
    return not written.remarks


def _hint() -> str:
    """Packages to install if pyvista cannot draw; empty if no package is missing."""
    return environment.remedy_for_pictures().removeprefix("; ")


def load(path: Path) -> tuple[str, Case, Inputs, Values]:
    """Name, case, inputs and formula values of a parameter file.

    Raises InputError with a message of one line.
    """
    file = read(path)
    return file.name, file.case, file.inputs, file.values
