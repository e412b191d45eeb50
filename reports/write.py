"""Write everything of a run into one folder, each file whole or not at all."""

import csv
import io
import json
import os
import tempfile
from pathlib import Path

from reports.html import page
from reports.junit import junit
from reports.records import report_record
from reports.vtu import vtu_files
from verify.results import Report, Row

COLUMNS = (
    "case", "quantity", "symbol", "unit", "kind", "analytic", "fem", "difference", "scale",
    "tolerance", "detects", "demand", "u_num", "u_ref", "u_input", "order", "status", "reason",
)  # fmt: skip


def write(report: Report, folder: Path) -> Path:
    """report.html, results.json with its schema, rows.csv, junit.xml and a VTU per field."""
    schema = Path(__file__).parent / "results.schema.json"
    record = json.dumps(report_record(report), ensure_ascii=False, indent=1, allow_nan=False)
    _whole(folder / "results.json", record)
    _whole(folder / "results.schema.json", schema.read_text("utf-8"))
    _whole(folder / "rows.csv", rows_csv(report.rows))
    _whole(folder / "junit.xml", junit(report))
    for name, content in vtu_files(report):
        _whole(folder / name, content)
    _whole(folder / "report.html", page(report))
    return folder / "report.html"


def rows_csv(rows: tuple[Row, ...]) -> str:
    """One line a row, in the row's unit."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(COLUMNS)
    for row in rows:
        table.writerow(["" if getattr(row, c) is None else getattr(row, c) for c in COLUMNS])
    return text.getvalue()


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
