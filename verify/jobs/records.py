"""Stored results of long studies: small files, each valid only for the code that made it.

All kinds of records have the fields "checksum", "kind", "subject", "date", "made by" and "content".
"made by" includes all data on which the content depends: hashes of code, inputs, settings. A record
is valid as long as "made by" equals the value for the present code. The checksum of all other
fields shows whether a file was edited or damaged.
"""

import hashlib
import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any, TypeVar

from verify.core.files import write_whole

FOLDER = Path(__file__).parents[1] / "measured"
LINE_DEPTH = 3  # a line for each entry of the record, of its content, and of these entries

T = TypeVar("T")


@dataclass(frozen=True)
class Record:
    """Result of a study for one subject, such as a case; its date (UTC) and its dependencies.

    `content` is the result, and `made_by` contains the dependencies; both are JSON values.
    """

    date: str
    made_by: Any
    content: Any


@dataclass(frozen=True)
class Records:
    """The records of one kind, a folder with one file for each subject."""

    kind: str

    def path(self, subject: str) -> Path:
        """Path of the file of a subject."""
        return FOLDER / self.kind / f"{subject}.json"

    def stored(self, subject: str) -> Record | None:
        """Record of a subject, whatever code made it; None if there is no readable record."""
        try:
            data = json.loads(self.path(subject).read_text("utf-8"))
            if (data["kind"], data["subject"]) != (self.kind, subject):
                return None
            if data.pop("checksum") != checksum(data):
                return None
            day = date.fromisoformat(data["date"]).isoformat()
            return Record(day, data["made by"], data["content"])
        except (OSError, ValueError, LookupError, TypeError, RecursionError):
            return None

    def current(self, subject: str, made_by: Any, read: Callable[[Record], T]) -> T | None:
        """Result of `read` for the stored record; None if the record is not valid.

        A record is valid if its dependencies are equal to `made_by` (compared as JSON) and if
        `read` raises no error.
        """
        record = self.stored(subject)
        if record is None or record.made_by != json.loads(json.dumps(made_by)):
            return None
        try:
            return read(record)
        except (ValueError, LookupError, TypeError, AttributeError):
            return None

    def keep(self, subject: str, made_by: Any, content: Any) -> Path:
        """Write the record with today's date and return its path. Raises OSError if this fails."""
        path = self.path(subject)
        text = json.dumps({
            "kind": self.kind, "subject": subject, "date": today(), "made by": made_by,
            "content": content,
        }, allow_nan=False)  # fmt: skip
        data = json.loads(text)
        text = _lines({"checksum": checksum(data)} | data)
        try:
            write_whole(path, lambda file: file.write(f"{text}\n".encode()))
        except OSError as error:
            raise OSError(f"{path}: cannot be written: {error.strerror}") from error
        return path


def checksum(data: Any) -> str:
    """Hexadecimal checksum of the values of a record, independent of the layout of the file."""
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()[:16]


def today() -> str:
    """Date in UTC, such as "2026-01-31"."""
    return time.strftime("%Y-%m-%d", time.gmtime())


def _lines(value: Any, depth: int = 0) -> str:
    """JSON text with one line per entry to the depth LINE_DEPTH, so that a diff shows changes."""
    is_object = isinstance(value, dict)
    entries = list(value.values()) if is_object else value if isinstance(value, list) else []
    if depth == LINE_DEPTH or not any(isinstance(entry, dict | list) for entry in entries):
        return json.dumps(value, ensure_ascii=False)
    texts = [_lines(entry, depth + 1) for entry in entries]
    if is_object:
        keys = (json.dumps(key, ensure_ascii=False) for key in value)
        texts = [f"{key}: {text}" for key, text in zip(keys, texts, strict=True)]
    first, last = "{}" if is_object else "[]"
    space = "\n" + " " * depth
    return first + ",".join(f"{space} {text}" for text in texts) + space + last
