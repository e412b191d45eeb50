"""report.pdf: the report as PDF, made by typst from templates/report.typ and plain data."""

import json
import re
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from typing import Any

from reports.frames import Frame
from reports.pdf_data import document
from reports.pdf_tables import Data
from reports.typesetting import NotSet, typeset
from reports.xml_text import clean
from verify.core.results import Report

# Scripts that the fonts of typst hold: Latin, Greek, Cyrillic, Hebrew, punctuation, mathematics.
_FOREIGN = re.compile("[^\\x00-\u05ff\u1d00-\u2e7f\ufb00-\ufb4f\ufffd\U0001d400-\U0001d7ff]")

Frames = Mapping[str, Sequence[Frame]]
Make = Callable[[Report, Frames], Data]


def pdf(report: Report, frames: Frames, make: Make = document) -> bytes:
    """PDF of the report, by default of its whole content; equal reports give equal bytes.

    Raises NotSet if typst fails.
    """
    return printed(content(report, frames, make), made(report))


def content(report: Report, frames: Frames, make: Make = document) -> str:
    """JSON content of the PDF of a report. Raises NotSet for unsupported mathematics."""
    try:
        return json.dumps(_cleaned(make(report, frames)), ensure_ascii=False)
    except ValueError as error:
        raise NotSet(" ".join(str(error).split())) from error


def printed(data: str, stamp: datetime) -> bytes:
    """PDF of this content with its date. Raises NotSet if typst fails.

    Fonts of the system are searched only if the content has characters of a writing system that the
    fonts of typst do not contain.
    """
    paper: bytes = typeset(
        "report.typ", {"document": data}, ignore_system_fonts=not _FOREIGN.search(data),
        timestamp=stamp,
    )  # fmt: skip
    return paper


def made(report: Report) -> datetime:
    """Time of the run from its provenance; the epoch if it has no date."""
    try:
        stamp = datetime.strptime(report.provenance["made"], "%Y-%m-%d %H:%M UTC")
    except (KeyError, ValueError):
        return datetime(1970, 1, 1, tzinfo=UTC)
    return stamp.replace(tzinfo=UTC)


def _cleaned(value: Any) -> Any:
    """Data without characters that XML and PDF do not permit."""
    if isinstance(value, str):
        return clean(value)
    if isinstance(value, Mapping):
        return {clean(k): _cleaned(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_cleaned(v) for v in value]
    return value
