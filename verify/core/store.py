"""Store of results that take time to compute: one SQLite file, by kind, subject and key.

A key includes all data on which a result depends. If the data change, the key changes: an entry is
never wrong, but may be unused.
Every commit is complete: a process that is killed loses at most the entry that it was writing.
Several processes can use the store at the same time.

The file has two tables: `entries`, and `readings` with the time of the last reading of an entry.
`PRAGMA user_version` is the number of the file's format. A later format causes an error.
"""

import io
import sqlite3
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.core.database import Database
from verify.core.files import made_folder

FILE = "store.sqlite"
AT_ONCE = 500  # keys in one question
LARGEST = 2e9  # bytes
ROOM = 0.2  # of it, made free at once
RECENT = 86400.0  # s in which a second reading is not noted: a note is a writing
FORMAT = 1
TABLES = (
    "CREATE TABLE IF NOT EXISTS entries (kind TEXT NOT NULL, key TEXT NOT NULL, subject TEXT NOT "
    "NULL, made REAL NOT NULL, content BLOB NOT NULL, PRIMARY KEY (kind, key))",
    # separate from the contents: SQLite writes a whole row, however large, to change a number of it
    "CREATE TABLE IF NOT EXISTS readings (kind TEXT NOT NULL, key TEXT NOT NULL, used REAL NOT "
    "NULL, PRIMARY KEY (kind, key))",
)
READ = (
    "SELECT key, CAST(content AS BLOB), MAX(made, COALESCE(used, 0)) "
    "FROM entries LEFT JOIN readings USING (kind, key) WHERE kind = ?"
)
TRIM = (
    "DELETE FROM entries WHERE rowid IN (SELECT id FROM (SELECT entries.rowid AS id, "
    "SUM(LENGTH(content)) OVER (ORDER BY MAX(made, COALESCE(used, 0)) DESC, entries.rowid) AS upto "
    "FROM entries LEFT JOIN readings USING (kind, key)) WHERE upto > ?)"
)
FORGET = (
    "DELETE FROM readings WHERE NOT EXISTS (SELECT 1 FROM entries WHERE "
    "entries.kind = readings.kind AND entries.key = readings.key)"
)


@dataclass(frozen=True)
class Group:
    """Summary of the entries of one kind and subject: number, bytes, oldest and newest date."""

    kind: str
    subject: str
    entries: int
    size: int
    oldest: float
    newest: float


class Store:
    """Stored entries in a folder; `kind` is the study that made an entry, `subject` its case."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / FILE
        self._database = Database(self.path, TABLES, FORMAT)

    def load(self, kind: str, keys: Sequence[str]) -> dict[str, bytes]:
        """Contents of those keys that have an entry. Raises OSError if the file cannot be read."""
        parts = [keys[k : k + AT_ONCE] for k in range(0, len(keys), AT_ONCE)]
        named = [(f"AND key IN ({','.join('?' * len(part))})", part) for part in parts]
        return self._read(kind, named)

    def all(self, kind: str, subject: str) -> dict[str, bytes]:
        """All entries of a kind and subject (key: content). Raises OSError as `load` does."""
        return self._read(kind, [("AND subject = ?", [subject])])

    def one(self, kind: str, key: str) -> bytes | None:
        """Content of one key; None if there is none or if the file cannot be read."""
        try:
            return self.load(kind, [key]).get(key)
        except OSError:
            return None

    def store(
        self, kind: str, subject: str, entries: Mapping[str, bytes], made: float | None = None
    ) -> None:
        """Write all entries (key: content), or none of them if the file cannot be written.

        `made` is the time of the entries [s since 1970], by default now. Raises OSError if the file
        cannot be written.
        """
        made_folder(self.path.parent)
        made = time.time() if made is None else made
        lines = [(kind, key, subject, made, content) for key, content in entries.items()]
        with self._database.writing() as database:
            database.executemany("INSERT OR REPLACE INTO entries VALUES (?, ?, ?, ?, ?)", lines)
            if _size(database) > LARGEST:
                _trim(database)

    def check(self) -> None:
        """Raise OSError if nothing can be stored, so that this is known before a computation."""
        made_folder(self.path.parent)
        with self._database.writing() as database:
            database.execute("BEGIN IMMEDIATE")

    def dates(self, kind: str, keys: Sequence[str]) -> dict[str, tuple[float, int]]:
        """Date [s since 1970] and number of bytes of each stored entry of `keys`.

        Raises OSError as `load` does.
        """
        if not self._database.is_there():
            return {}
        question = "SELECT made, LENGTH(content) FROM entries WHERE kind = ? AND key = ?"
        with self._database.reading() as database:
            lines = {key: database.execute(question, (kind, key)).fetchone() for key in keys}
        return {key: line for key, line in lines.items() if line}

    def groups(self) -> list[Group]:
        """Summaries of the entries by kind and subject.

        Raises OSError if the store cannot be read.
        """
        if not self._database.is_there():
            return []
        with self._database.reading() as database:
            return [Group(*line) for line in database.execute(
                "SELECT kind, subject, COUNT(*), SUM(LENGTH(content)), MIN(made), MAX(made) "
                "FROM entries GROUP BY kind, subject ORDER BY kind, subject"
            )]  # fmt: skip

    def clear(self, kind: str = "", subject: str = "") -> int:
        """Remove the entries of a kind and subject, by default all; returns their number."""
        if not self._database.is_there():
            return 0
        with self._database.writing() as database:
            removed = database.execute(
                "DELETE FROM entries WHERE (? = '' OR kind = ?) AND (? = '' OR subject = ?)",
                (kind, kind, subject, subject),
            ).rowcount
            database.execute(FORGET)
        with suppress(OSError):  # they are removed, and later entries reuse their space in the file
            self._database.compact()
        return removed

    def _read(self, kind: str, conditions: Sequence[tuple[str, Sequence[str]]]) -> dict[str, bytes]:
        if not self._database.is_there():
            return {}
        found: dict[str, bytes] = {}
        before = time.time() - RECENT
        stale: list[str] = []
        with self._database.reading() as database:
            for condition, values in conditions:
                lines = database.execute(f"{READ} {condition}", (kind, *values))
                for key, content, used in lines:
                    found[key] = bytes(content)
                    if used < before:
                        stale.append(key)
        if stale:
            self._note(kind, stale)
        return found

    def _note(self, kind: str, keys: Sequence[str]) -> None:
        """Store the time of reading of entries; the least recently read are removed first."""
        lines = [(kind, key, time.time()) for key in keys]
        # a note is no reason to fail, or to wait for another process that writes
        with suppress(OSError), self._database.writing(patience=0.0) as database:
            database.executemany("INSERT OR REPLACE INTO readings VALUES (?, ?, ?)", lines)


def _size(database: sqlite3.Connection) -> int:
    """Size of the used pages in bytes."""
    pages, free, size = (
        int(database.execute(f"PRAGMA {name}").fetchone()[0])
        for name in ("page_count", "freelist_count", "page_size")
    )
    return (pages - free) * size


def _trim(database: sqlite3.Connection) -> None:
    """Remove the least recently used entries until the contents are well below LARGEST."""
    database.execute(TRIM, ((1 - ROOM) * LARGEST,))
    database.execute(FORGET)


def packed(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Bytes of an npz file with these arrays."""
    file = io.BytesIO()
    np.savez(file, allow_pickle=False, **arrays)
    return file.getvalue()


def unpacked(content: bytes) -> dict[str, NDArray[Any]]:
    """Arrays from the bytes of an npz file."""
    with np.load(io.BytesIO(content), allow_pickle=False) as data:
        return {name: data[name] for name in data.files}
