"""Check whether a report is still up to date, so that the run need not be repeated."""

import hashlib
import json
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verify.app.provenance import conditions
from verify.core.files import write_whole
from verify.core.source_files import digest
from verify.core.store import Store
from verify.jobs import cache

STAMP = ".up-to-date.json"


@dataclass(frozen=True)
class Reported:
    """Output of a run, with its exit status, the date of its report, and its summary."""

    lines: tuple[str, ...]
    status: int
    made: str
    summary: str


def key_of(root: Path, names: Sequence[str], form: str = "") -> str:
    """Digest of all data on which a report of the suite's cases depends, except stored results.

    These data are the files of the project, the libraries, the machine, the named cases and the
    `form` of the report.
    """
    parts: dict[str, Any] = {
        "files": digest(), "conditions": conditions(root), "cases": list(names), "form": form,
    }  # fmt: skip
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def found(out: Path, key: str) -> Reported | None:
    """Output of the run whose report is in a folder; None if the report is no longer valid.

    The report is also no longer valid if its files were changed, or its stored results removed.
    """
    try:
        stamp = json.loads((out / STAMP).read_text("utf-8"))
        if stamp["key"] != key or not _unchanged(out, stamp["files"]):
            return None
        levels = stamp["levels"]
        if len(Store(cache.default_folder()).dates(cache.KIND, levels)) < len(levels):
            return None
        return Reported(
            tuple(stamp["lines"]), stamp["status"], stamp["made"], stamp["summary"]
        )  # fmt: skip
    except (OSError, ValueError, LookupError, TypeError):  # none, or not whole
        return None


def keep(out: Path, key: str, levels: Sequence[str], reported: Reported) -> None:
    """Store the key of the report in its folder, with the keys of the stored results it uses."""
    stamp = {
        "key": key, "made": reported.made, "status": reported.status, "lines": reported.lines,
        "summary": reported.summary, "levels": list(levels), "files": _files(out),
    }  # fmt: skip
    with suppress(OSError):  # the next run is made in full
        write_whole(out / STAMP, lambda file: file.write(json.dumps(stamp, indent=1).encode()))


def _files(out: Path) -> dict[str, list[int]]:
    """Size and time of the last change of each file of a report."""
    return {
        path.relative_to(out).as_posix(): [path.stat().st_size, path.stat().st_mtime_ns]
        for path in sorted((*out.iterdir(), *out.glob("report/*.html")))
        if path.is_file() and not path.name.startswith(".")
    }  # fmt: skip


def _unchanged(out: Path, files: dict[str, list[int]]) -> bool:
    now = _files(out)
    return all(now.get(name) == known for name, known in files.items())
