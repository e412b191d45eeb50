"""Write everything of a run into one folder, each file whole or not at all."""

import csv
import fcntl
import io
import json
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from reports.frames import Frame, frames
from reports.html import page
from reports.junit import junit
from reports.records import report_record
from reports.verdicts import verdicts
from reports.vtu import vtu_files
from verify.results import Report, Row

COLUMNS = (
    "case", "quantity", "symbol", "unit", "kind", "analytic", "fem", "difference", "scale",
    "tolerance", "u_num", "u_ref", "u_input", "order", "status", "reason",
)  # fmt: skip
RELATIVE = (
    "difference_relative", "tolerance_relative", "detects_relative", "demand_relative",
    "expected_low_relative", "expected_high_relative",
)  # fmt: skip
ERRORS = "errors.txt"
STAGING = ".part-"
PRINTED = ("printed_theory", "printed_FEA", "printed_test")


@dataclass(frozen=True)
class Written:
    """The page, and what was done in another way than usual, one line each."""

    page: Path
    remarks: tuple[str, ...]


def write(report: Report, folder: Path, *, pictures: Path | None = None, hint: str = "") -> Written:
    """report.html, results.json with its schema, rows.csv, junit.xml and a VTU per field.

    `pictures` is a folder that keeps what was drawn for the next run; `hint` says what to install
    where pyvista can't draw. errors.txt holds the tracebacks of cases that failed. All files are
    made before the first takes its place; OSError names the one that can't be written.
    """
    try:
        drawn = frames(report.cases, pictures, hint)
        files = dict(_files(report, drawn))
    except OSError as error:  # a temporary file of a drawing
        raise OSError(f"{folder}: no report can be made: {error.strerror or error}") from error
    with _alone_in(folder), _staging(folder) as staging:
        for name, content in files.items():
            try:
                (staging / name).write_bytes(content)
            except OSError as error:
                raise OSError(f"{folder / name} cannot be written: {error.strerror}") from error
        for name in files:
            (staging / name).replace(folder / name)
        for stale in (*folder.glob("*.vtu"), folder / ERRORS):  # of a run over other cases
            if stale.name not in files:
                stale.unlink(missing_ok=True)
    remarks = dict.fromkeys(frame.why for group in drawn.values() for frame in group if frame.why)
    return Written(folder / "report.html", tuple(remarks))


def _files(report: Report, drawn: Mapping[str, list[Frame]]) -> Iterator[tuple[str, bytes]]:
    schema = Path(__file__).parent / "results.schema.json"
    record = json.dumps(report_record(report), ensure_ascii=False, indent=1, allow_nan=False)
    yield "results.json", record.encode()
    yield schema.name, schema.read_bytes()
    yield "rows.csv", rows_csv(report.rows).encode()
    yield "verdicts.md", f"{verdicts(report)}\n".encode()
    yield "junit.xml", junit(report).encode()
    yield "report.html", page(report, drawn).encode()
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


def rows_csv(rows: tuple[Row, ...]) -> str:
    """One line a row: values in the row's unit, then what is relative to its scale.

    Starts with a byte-order mark, without which spreadsheets misread µm.
    """
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow((*COLUMNS, *RELATIVE, *PRINTED))
    for row in rows:
        scale = row.scale if row.kind != "fact" else None
        relative = (
            row.difference / scale if scale and row.difference is not None else None,
            row.tolerance / scale if scale and row.tolerance is not None else None,
            row.detects, row.demand, *(row.interval or (None, None)),
        )  # fmt: skip
        printed = (
            "; ".join(p.printed for p in row.published if p.kind == kind.partition("_")[2])
            for kind in PRINTED
        )
        cells = (*(getattr(row, c) for c in COLUMNS), *relative, *printed)
        table.writerow(["" if cell is None else cell for cell in cells])
    return "\ufeff" + text.getvalue()
