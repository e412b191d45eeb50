"""Write everything of a run into one folder, each file whole or not at all."""

import fcntl
import json
import shutil
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from reports import in_short, verdicts
from reports.budget_table import budget_csv
from reports.crosscheck_table import crosscheck_csv
from reports.frames import Frame, frames
from reports.html import page
from reports.junit import junit
from reports.pages import FIRST, FOLDER, is_paged, pages
from reports.pdf import content, printed
from reports.pdf import made as made_at
from reports.pdf_data import document
from reports.pdf_record import record
from reports.records import report_record
from reports.rows import rows_csv
from reports.second import seconds
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
    """The page, and what was done in another way than usual, one line each."""

    page: Path
    remarks: tuple[str, ...]


def write(
    report: Report, folder: Path, *, cache: Path | None = None, hint: str = "",
    single_file: bool = False, full_pdf: bool = False,
) -> Written:  # fmt: skip
    """The report as pages, PDF and tables (XLSX, CSV), for programs (JSON, JUnit), fields as VTU.

    `cache` is a folder that keeps what was drawn for the next run; `hint` says what to install
    where pyvista can't draw; with `single_file` all cases stand on one page. The PDF of
    several cases is the record, with `full_pdf` the whole. errors.txt holds the
    tracebacks of cases that failed. All files are made before the first takes its place; OSError
    names the one that can't be written.
    """
    try:
        drawn = frames(report.cases, cache, hint)
        files, why = _files(report, drawn, single_file=single_file, full_pdf=full_pdf)
    except OSError as error:  # a temporary file of a drawing
        raise OSError(f"{folder}: no report can be made: {error.strerror or error}") from error
    remarks = dict.fromkeys(frame.why for group in drawn.values() for frame in group if frame.why)
    if why:
        remarks[f"{PAPER} is not written: {why}"] = None
    with _alone_in(folder), _staging(folder) as staging:
        for name, content in files.items():
            try:
                (staging / name).parent.mkdir(exist_ok=True)
                (staging / name).write_bytes(content)
            except OSError as error:
                raise OSError(f"{folder / name} cannot be written: {error.strerror}") from error
        for name in files:
            (folder / name).parent.mkdir(exist_ok=True)
            (staging / name).replace(folder / name)
        # of a run over other cases, or of one that could do more
        made = (ERRORS, PAPER, BUDGET, CROSSCHECK)
        others = (*folder.glob("*.vtu"), *folder.glob(f"{FOLDER}/*.html"))
        for stale in (*others, *(folder / name for name in made)):
            if stale.relative_to(folder).as_posix() not in files:
                stale.unlink(missing_ok=True)
    return Written(folder / FIRST, tuple(remarks))


def _files(
    report: Report, drawn: Mapping[str, Sequence[Frame]], *, single_file: bool, full_pdf: bool
) -> tuple[dict[str, bytes], str]:
    """All files by name, and why there is no PDF, or ""."""
    why = ""
    is_record = is_paged(report) and not full_pdf
    make = partial(record, single_file=single_file) if is_record else document
    # typst takes longer than all the rest and holds no lock: it works beside
    with ThreadPoolExecutor(1) as beside:
        paper: Future[bytes] = Future()
        try:
            paper = beside.submit(printed, content(report, drawn, make), made_at(report))
        except NotSet as error:
            paper.set_exception(error)
        files = dict(_tables(report))
        has_pages = is_paged(report) and not single_file
        made = pages(report, drawn) if has_pages else {FIRST: page(report, drawn)}
        files |= {name: text.encode() for name, text in made.items()}
    try:
        files[PAPER] = paper.result()
    except NotSet as error:
        why = str(error)
    return files, why


def _tables(report: Report) -> Iterator[tuple[str, bytes]]:
    """All that needs no picture."""
    schema = Path(__file__).parent / "results.schema.json"
    record = json.dumps(report_record(report), ensure_ascii=False, indent=1, allow_nan=False)
    yield "results.json", record.encode()
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
    yield "tables.xlsx", xlsx(report)
    yield from vtu_files(report)
    if errors := [f"{case.id}\n{trace}" for case in report.cases for trace in case.errors]:
        yield ERRORS, "\n".join(errors).encode()


@contextmanager
def _alone_in(folder: Path) -> Iterator[None]:
    """Two runs into one folder write one after the other, so that its files belong together."""
    with (folder / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextmanager
def _staging(folder: Path) -> Iterator[Path]:
    """A folder on the same file system; those of killed runs go, as nobody else writes now."""
    for abandoned in folder.glob(f"{STAGING}*"):
        shutil.rmtree(abandoned, ignore_errors=True)
    with TemporaryDirectory(dir=folder, prefix=STAGING, ignore_cleanup_errors=True) as name:
        yield Path(name)
