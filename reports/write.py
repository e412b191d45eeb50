"""Write everything of a run into one folder, each file whole or not at all."""

import csv
import fcntl
import io
import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from reports.html import page
from reports.junit import junit
from reports.records import report_record
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
PRINTED = ("printed_theory", "printed_FEA", "printed_test")


def write(report: Report, folder: Path) -> Path:
    """report.html, results.json with its schema, rows.csv, junit.xml and a VTU per field."""
    schema = Path(__file__).parent / "results.schema.json"
    record = json.dumps(report_record(report), ensure_ascii=False, indent=1, allow_nan=False)
    files: dict[str, str | bytes] = {
        "results.json": record,
        "results.schema.json": schema.read_text("utf-8"),
        "rows.csv": rows_csv(report.rows),
        "junit.xml": junit(report),
        "report.html": page(report),
        **dict(vtu_files(report)),
    }
    with _alone_in(folder):
        for name, content in files.items():
            _whole(folder / name, content)
        for stale in folder.glob("*.vtu"):  # of a run over other cases
            if stale.name not in files:
                stale.unlink()
    return folder / "report.html"


@contextmanager
def _alone_in(folder: Path) -> Iterator[None]:
    """Two runs into one folder write one after the other, so that its files belong together."""
    with (folder / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


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


def _whole(path: Path, content: str | bytes) -> None:
    """Under a temporary name first, so that no reader meets half a file."""
    data = content.encode() if isinstance(content, str) else content
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=".part-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(temporary).chmod(0o644)
        Path(temporary).replace(path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise
