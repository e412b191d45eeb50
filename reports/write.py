"""Writing of all files of a run into one folder, each file completely or not at all."""

import fcntl
import shutil
from collections.abc import Container, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from reports import in_short, verdicts
from reports.before import Before
from reports.budget_table import budget_csv
from reports.crosscheck_table import crosscheck_csv
from reports.frames import Frame, frames
from reports.html import page
from reports.junit import junit
from reports.links import FIRST, FOLDER
from reports.origins import BOOK, Origins, digests, fields_of, page_of, part_of
from reports.origins import PAPER as PAPER_PART
from reports.pages import is_paged, pages
from reports.pdf import Make, content, printed
from reports.pdf import made as made_at
from reports.pdf_data import document
from reports.pdf_record import record
from reports.records import report_record, text_of
from reports.rows import rows_csv
from reports.second import seconds
from reports.slim import too_large, unquoted
from reports.typesetting import NotSet
from reports.vtu import vtu_files
from reports.xlsx import xlsx
from verify.core.results import Report

ERRORS = "errors.txt"
PAPER = "report.pdf"
BUDGET = "budget.csv"
CROSSCHECK = "crosscheck.csv"
STAGING = ".part-"


@dataclass(frozen=True)
class Written:
    """The written page, and deviations from the usual procedure, one line each."""

    page: Path
    remarks: tuple[str, ...]


def write(
    report: Report, folder: Path, *, cache: Path | None = None, hint: str = "",
    single_file: bool = False, full_pdf: bool = False, origins: Origins | None = None,
) -> Written:  # fmt: skip
    """Write all files of a report: pages, PDF, tables (XLSX, CSV), JSON, JUnit and VTU.

    `cache` is a folder in which drawings are stored for the next run. `hint` is the advice if
    pyvista cannot draw. With `single_file`, all cases are on one page. The PDF of several cases is
    the record for archiving; with `full_pdf`, it has the whole content. Parts with the same
    `origins` as in the previous run are not written again. errors.txt contains the tracebacks of
    cases that failed. All files are made before the first of them is moved to its place. Raises
    OSError with the name of a file that cannot be written.
    """
    with _alone_in(folder):
        before = Before(folder, digests(report, origins, f"{single_file} {full_pdf}"))
        try:
            drawn = _frames(report, before, cache, hint)
            is_record = is_paged(report) and not full_pdf
            make = partial(record, single_file=single_file) if is_record else document
            parts, why = _made(report, drawn, before, make, single_file=single_file)
        except OSError as error:  # a temporary file of a drawing
            raise OSError(f"{folder}: no report can be made: {error.strerror or error}") from error
        remarks = dict.fromkeys(f.why for group in drawn.values() for f in group if f.why)
        if why:
            remarks[f"{PAPER} is not written: {why}"] = None
        made = {name: text for files in parts.values() for name, text in files.items()}
        if is_paged(report) and not single_file:
            remarks |= dict.fromkeys(too_large(made))
        _replace(folder, made)
        _remove_stale(folder, before.files.union(*parts.values()))
        bad = {page_of(case) for case, group in drawn.items() if any(f.why for f in group)}
        by = {page_of(case): sorted({f.by for f in group if f.by}) for case, group in drawn.items()}
        before.note({name: files for name, files in parts.items() if name not in bad}, by)
    return Written(folder / FIRST, tuple(remarks))


def _frames(
    report: Report, before: Before, cache: Path | None, hint: str
) -> dict[str, Sequence[Frame]]:  # fmt: skip
    """Pictures of cases that need new ones; of other cases, only the program that drew them."""
    needed = [
        case for case in report.cases
        if PAPER_PART not in before or page_of(case.id) not in before
    ]  # fmt: skip
    others = [case.id for case in report.cases if case not in needed]
    known = {name: [Frame("", "", by=by) for by in before.about(page_of(name))] for name in others}
    return {**known, **frames(needed, cache, hint)}


def _replace(folder: Path, files: Mapping[str, bytes]) -> None:
    """Move files into the folder after all of them are written to its disk."""
    with _staging(folder) as staging:
        for name, content in files.items():
            try:
                (staging / name).parent.mkdir(exist_ok=True)
                (staging / name).write_bytes(content)
            except OSError as error:
                raise OSError(f"{folder / name} cannot be written: {error.strerror}") from error
        for name in files:
            (folder / name).parent.mkdir(exist_ok=True)
            (staging / name).replace(folder / name)


def _remove_stale(folder: Path, files: Container[str]) -> None:
    """Remove files of an earlier run with other cases or more optional packages."""
    made = (ERRORS, PAPER, BUDGET, CROSSCHECK)
    others = (*folder.glob("*.vtu"), *folder.glob(f"{FOLDER}/*.html"))
    for stale in (*others, *(folder / name for name in made)):
        if stale.relative_to(folder).as_posix() not in files:
            stale.unlink(missing_ok=True)


def _made(
    report: Report, drawn: Mapping[str, Sequence[Frame]], before: Before, make: Make, *,
    single_file: bool,
) -> tuple[dict[str, dict[str, bytes]], str]:  # fmt: skip
    """Files of each part by name, and the reason if there is no PDF (otherwise "")."""
    why = ""
    # typst takes longest and holds no lock: it runs in parallel
    with ThreadPoolExecutor(1) as beside:
        paper: Future[bytes] = Future()
        try:
            if PAPER_PART not in before:
                paper = beside.submit(printed, content(report, drawn, make), made_at(report))
        except NotSet as error:
            paper.set_exception(error)
        parts: dict[str, dict[str, bytes]] = {"tables": dict(_tables(report))}
        if BOOK not in before:
            parts[BOOK] = {"tables.xlsx": xlsx(report)}
        for case in report.cases:
            if fields_of(case.id) not in before:
                parts[fields_of(case.id)] = dict(vtu_files(case))
        has_pages = is_paged(report) and not single_file
        made = pages(report, drawn, before) if has_pages else {FIRST: page(report, drawn)}
        for name, text in made.items():
            parts.setdefault(part_of(name), {})[name] = unquoted(text).encode()
    try:
        if PAPER_PART not in before:
            parts[PAPER_PART] = {PAPER: paper.result()}
    except NotSet as error:
        why = str(error)
    return parts, why


def _tables(report: Report) -> Iterator[tuple[str, bytes]]:
    """Tables that can be written in negligible time."""
    schema = Path(__file__).parent / "results.schema.json"
    yield "results.json", text_of(report_record(report)).encode()
    yield schema.name, schema.read_bytes()
    yield "rows.csv", rows_csv(report.rows, seconds(report.crosschecks).rows).encode()
    if report.budgets:
        yield BUDGET, budget_csv(report.budgets).encode()
    if report.crosschecks:
        yield CROSSCHECK, crosscheck_csv(report.crosschecks).encode()
    yield "cases.md", f"{in_short.markdown(report)}\n".encode()
    if report.verdicts:
        yield "verdict-counts.md", f"{verdicts.counts_in_markdown(report)}\n".encode()
        yield "verdicts.md", f"{verdicts.markdown(report)}\n".encode()
    yield "junit.xml", junit(report).encode()
    if errors := [f"{case.id}\n{trace}" for case in report.cases for trace in case.errors]:
        yield ERRORS, "\n".join(errors).encode()


@contextmanager
def _alone_in(folder: Path) -> Iterator[None]:
    """Lock a folder, so that runs with the same folder write one after the other."""
    with (folder / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextmanager
def _staging(folder: Path) -> Iterator[Path]:
    """Temporary folder on the same file system; folders of killed runs are removed."""
    for abandoned in folder.glob(f"{STAGING}*"):
        shutil.rmtree(abandoned, ignore_errors=True)
    with TemporaryDirectory(dir=folder, prefix=STAGING, ignore_cleanup_errors=True) as name:
        yield Path(name)
