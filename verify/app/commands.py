"""What the commands do, apart from reading the command line."""

import gc
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.parameter_file import read
from verify.app import up_to_date
from verify.cases import files
from verify.cases.registry import CASES, QUICK, find, ids
from verify.core import environment
from verify.core.case import Case, Values
from verify.core.console import raised, verdict_lines
from verify.core.inputs import REQUIRED, InputError, Inputs, meta
from verify.core.results import (
    CaseBudget,
    CaseResult,
    Caught,
    Crosscheck,
    Report,
    Status,
    StoredStudy,
    Validity,
)
from verify.core.verdicts import FormulaVerdict
from verify.jobs import cache
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve, stored_levels
from verify.papers.ledger import cited
from verify.verdicts.console import in_list
from verify.verdicts.record import moved

ROOT = Path(__file__).parents[2]
BAD = (Status.FAIL, Status.SKIP)
GARBAGE_AFTER = 20_000  # new objects: syntax trees and pages are many that stay in use


def run_list() -> int:
    """Print each case with its subject, its inputs, which may be left out, and its verdicts."""
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
        print(f"{case.id:20} {case.title}{f' ({source})' if source else ''}")
        print(f"{'':20} inputs: {', '.join(needed)}")
        if optional:
            print(f"{'':20} optional: {', '.join(optional)}")
        if found := in_list(case):
            print(f"{'':20} verdicts: {found}")
    return 0


def run_verify(
    names: Sequence[str], *, quick: bool, where: Where, out: Path | None, use_cache: bool,
    single_file: bool = False,
) -> int:  # fmt: skip
    """Run the cases on the paper's numbers, write the report and print the verdicts."""
    if quick and names:
        raise InputError(f"--quick runs {', '.join(QUICK)}: name no case beside it")
    names = QUICK if quick else names
    out = out or ROOT / "reports" / "out"
    writable(out)
    start = time.perf_counter()
    gc.set_threshold(GARBAGE_AFTER)
    key = ""
    if use_cache and all(name in CASES.ids for name in names):
        key = up_to_date.key_of(ROOT, names, "one page" if single_file else "")
        if (before := up_to_date.found(out, key)) is not None:
            print("\n".join(before.lines))
            took = f"{time.perf_counter() - start:.1f} s"
            print(f"report: {_page(out)} (of {before.made}: nothing has changed since; {took})")
            return before.status
    cases = [find(name) for name in dict.fromkeys(names)] or list(CASES)
    work = [Job(case, case.inputs()) for case in cases]
    results = _solved_for_report(work, where) if use_cache else solve(work, where, False)
    report = make_report(results, cases, time.perf_counter() - start)
    lines = verdict_lines(report)
    print("\n".join(lines))
    is_complete = write_report(report, out, use_cache, single_file=single_file)
    drift = [*drift_lines(report), *_moved_verdicts(report)]
    print("".join(f"{line}\n" for line in drift), end="")
    print(f"report: {_page(out)} ({time.perf_counter() - start:.1f} s)")
    status = _exit_status(report)
    if any(case.errors for case in report.cases):
        print(f"tracebacks: {out / 'errors.txt'}")
    elif key and is_complete:
        made = str(report.provenance["made"])
        up_to_date.keep(
            out, key, stored_levels(work), up_to_date.Reported((*lines, *drift), status, made)
        )
    return status


def _solved_for_report(work: list[Job], where: Where) -> list[CaseResult]:
    """The judged cases; meanwhile the pictures of their report are drawn into the store."""
    from reports.ahead import Ahead

    cases = [job.case for job in work]
    with Ahead(cache.default_folder(), _hint(), lambda: _read_records(cases)) as ahead:
        return solve(work, where, True, judged=ahead.add)


def _read_records(cases: Sequence[Case]) -> None:
    """Hash all code that stored results of studies hold for, which takes seconds the first time."""
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
    """Formulas whose verdict is not that of record; nothing is said of a run of some cases."""
    return moved(report.verdicts) if report.verdicts else []


def drift_lines(report: Report) -> list[str]:
    """What has moved since the last release."""
    if not report.drift:
        return []
    from verify.audit.releases.changes import lines

    return [raised(line) for line in lines(report.drift)]


def writable(out: Path) -> None:
    """Make the folder; a read-only place is found before the work."""
    for place in (out, *out.parents):
        if place.exists() and not place.is_dir():
            raise InputError(f"{place}: is a file, expected a folder")
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=out):
            pass
    except OSError as error:
        raise InputError(f"{out}: cannot be written: {error.strerror}") from error


def write_report(report: Report, out: Path, use_cache: bool, *, single_file: bool = False) -> bool:
    """Write the report into `out`; False where something had to be done in another way, named."""
    from reports.write import write  # only the command line knows reports

    drawn = cache.default_folder() if use_cache else None
    written = write(report, out, cache=drawn, hint=_hint(), single_file=single_file)
    for remark in written.remarks:
        print(f"freewheel: {remark}", file=sys.stderr)
    return not written.remarks


def _hint() -> str:
    """What to install where pyvista cannot draw."""
    return environment.remedy_for_pictures().removeprefix("; ")


def load(path: Path) -> tuple[str, Case, Inputs, Values]:
    """Name, case, inputs and formula values of a parameter file.

    InputError says in one line what is wrong.
    """
    file = read(path)
    return file.name, file.case, file.inputs, file.values


def make_report(
    results: list[CaseResult], cases: Sequence[Case], seconds: float, name: str = ""
) -> Report:
    """A run with the ledgers and its provenance; `name` is that of a user's own parameters."""
    from verify.app.provenance import provenance
    from verify.audit.releases.changes import since
    from verify.papers.ledgers import ledgers, sources
    from verify.studies.readings.tried import searches

    suite = ids(CASES)
    own = [result for result in results if result.id in suite]
    return Report(
        cases=tuple(results),
        provenance={**provenance(ROOT, results, seconds), "left_out": len(CASES) - len(own)},
        name=name,
        validity=() if name or not own else _validity(results, cases),
        studies=() if name or len(results) < 2 else _studies(results),
        drift=None if name or not own else since(own),
        searches=() if name or not own else searches([case.id for case in cases]),
        budgets=() if name or not own else _budgets(results, cases),
        crosschecks=() if name else _crosschecks(results),
        caught=None if name or not own else _caught(),
        verdicts=() if name or len(own) < len(CASES) else _verdicts(results),
        **(ledgers(results, cases) if own else sources(cases)),
    )


def _caught() -> Caught:
    """What is kept of mistakes made on purpose, as far as it counts for the present code."""
    from verify.audit.mutation.score import measured  # what judges anew, which `check` does without

    return measured()


def _verdicts(results: Sequence[CaseResult]) -> tuple[FormulaVerdict, ...]:
    """The verdicts of the papers' formulas, which rest on all cases."""
    from verify.verdicts.found import verdicts

    return verdicts([row for result in results for row in result.rows])


def _validity(results: Sequence[CaseResult], cases: Sequence[Case]) -> tuple[Validity, ...]:
    """The cards, which are about the papers' own inputs."""
    from verify.studies.validity.cards import (
        validity,  # scipy's statistics, which `check` does without
    )

    return validity(results, cases)


def _studies(results: Sequence[CaseResult]) -> tuple[StoredStudy, ...]:
    """The stored points of the cases, which pages of several cases show at a user's inputs."""
    from verify.verdicts.stored_points import studies

    return studies(results)


def _budgets(results: Sequence[CaseResult], cases: Sequence[Case]) -> tuple[CaseBudget, ...]:
    """The error budgets, which are about the papers' own inputs too."""
    from verify.studies.budget.console import told  # reads sources of all that they depend on

    return told(results, cases)


def _crosschecks(results: Sequence[CaseResult]) -> tuple[Crosscheck, ...]:
    """What second solvers found of the cases' problems."""
    from verify.studies.crosscheck.judged import (
        reported,  # reads the sources of all that it compares
    )

    return reported([result.id for result in results])
