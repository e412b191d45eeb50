"""Results that took time, in one SQLite file, by kind, subject and key.

A key covers everything that a result depends on: an entry is never wrong, only unused. Every commit
is whole, so that a process that is killed loses at most the entry that it was writing, and
processes that run at the same time do not disturb each other.
"""

import io
import sqlite3
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.core.files import made_folder

FILE = "store.sqlite"
PATIENCE = 30.0  # s for another process to finish its writing
AT_ONCE = 500  # keys in one question
LARGEST = 2e9  # bytes
ROOM = 0.2  # of it, made free at once
TABLE = (
    "CREATE TABLE IF NOT EXISTS entries (kind TEXT NOT NULL, key TEXT NOT NULL, subject TEXT NOT "
    "NULL, made REAL NOT NULL, content BLOB NOT NULL, PRIMARY KEY (kind, key))"
)
QUESTION = "SELECT key, CAST(content AS BLOB) FROM entries WHERE kind = ? AND key IN (KEYS)"


@dataclass(frozen=True)
class Group:
    """Entries of one kind and subject: how many, their bytes, when the first and last were made."""

    kind: str
    subject: str
    entries: int
    size: int
    oldest: float
    newest: float


class Store:
    """The entries in a folder; `kind` names the study that made one, `subject` its case."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / FILE

    def load(self, kind: str, keys: Sequence[str]) -> dict[str, bytes]:
        """The content of those keys that have an entry; OSError where the file cannot be read."""
        found: dict[str, bytes] = {}
        if not self.path.is_file():
            return found
        with self._open() as database:
            for k in range(0, len(keys), AT_ONCE):
                some = keys[k : k + AT_ONCE]
                question = QUESTION.replace("KEYS", ",".join("?" * len(some)))
                found |= {key: bytes(c) for key, c in database.execute(question, (kind, *some))}
        return found

    def one(self, kind: str, key: str) -> bytes | None:
        """The content of one key; None where there is none or the file cannot be read."""
        try:
            return self.load(kind, [key]).get(key)
        except OSError:
            return None

    def store(self, kind: str, subject: str, entries: Mapping[str, bytes]) -> None:
        """Write entries by key, all or none; OSError where the file cannot be written."""
        made_folder(self.path.parent)
        now = time.time()
        lines = [(kind, key, subject, now, content) for key, content in entries.items()]
        with self._open() as database:
            database.executemany("INSERT OR REPLACE INTO entries VALUES (?, ?, ?, ?, ?)", lines)

    def groups(self) -> list[Group]:
        """What is stored, by kind and subject; OSError where it cannot be read."""
        if not self.path.is_file():
            return []
        with self._open() as database:
            return [Group(*line) for line in database.execute(
                "SELECT kind, subject, COUNT(*), SUM(LENGTH(content)), MIN(made), MAX(made) "
                "FROM entries GROUP BY kind, subject ORDER BY kind, subject"
            )]  # fmt: skip

    def clear(self, kind: str = "", subject: str = "") -> int:
        """Remove the entries of a kind and subject, by default all; how many they were."""
        if not self.path.is_file():
            return 0
        with self._open() as database:
            removed = database.execute(
                "DELETE FROM entries WHERE (? = '' OR kind = ?) AND (? = '' OR subject = ?)",
                (kind, kind, subject, subject),
            ).rowcount
        with self._open(transaction=False) as database:
            database.execute("VACUUM")
        return removed

    def trim(self, largest: float = LARGEST) -> None:
        """Remove what was made first until contents are well below `largest` bytes."""
        if sum(group.size for group in self.groups()) <= largest:
            return
        with self._open() as database:
            database.execute(
                "DELETE FROM entries WHERE rowid IN (SELECT rowid FROM (SELECT rowid, "
                "SUM(LENGTH(content)) OVER (ORDER BY made DESC, rowid) AS upto FROM entries) "
                "WHERE upto > ?)",
                ((1 - ROOM) * largest,),
            )

    @contextmanager
    def _open(self, *, transaction: bool = True) -> Iterator[sqlite3.Connection]:
        level: Any = "" if transaction else None
        try:
            database = sqlite3.connect(self.path, timeout=PATIENCE, isolation_level=level)
        except sqlite3.Error as error:
            raise OSError(f"{self.path}: {error}: results cannot be stored there") from error
        try:
            database.execute("PRAGMA journal_mode = WAL")
            # a process that is killed loses nothing; a power failure may lose the last commits
            database.execute("PRAGMA synchronous = NORMAL")
            database.execute(TABLE)
            with database:
                yield database
        except sqlite3.Error as error:
            # a locked file and others of its kind are subclasses
            corrupt = type(error) is sqlite3.DatabaseError
            hint = "; remove it to begin again" if corrupt else ""
            raise OSError(f"{self.path}: {error}: results cannot be stored there{hint}") from error
        finally:
            database.close()


def packed(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Arrays as the bytes of an npz file."""
    file = io.BytesIO()
    np.savez(file, allow_pickle=False, **arrays)
    return file.getvalue()


def unpacked(content: bytes) -> dict[str, NDArray[Any]]:
    """The arrays of such bytes."""
    with np.load(io.BytesIO(content), allow_pickle=False) as data:
        return {name: data[name] for name in data.files}
