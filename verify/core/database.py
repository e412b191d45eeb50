"""Connections to an SQLite file that several processes use: waiting, format, error messages."""

import sqlite3
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

PATIENCE = 30.0  # s for another process to finish its writing
PAUSE = 0.02  # s between two attempts
SETTINGS = (
    # a process that is killed loses nothing; a power failure may lose the last commits
    "PRAGMA synchronous = NORMAL",
    # overwriting removed entries would need space on a full disk
    "PRAGMA secure_delete = OFF",
)
NO_ROOM = ("full", "disk I/O")  # in messages of SQLite


@dataclass(frozen=True)
class Database:
    """An SQLite file; the statements `tables` create its tables.

    `format` is the number of the format of the file. A file with a later format causes an error.
    """

    path: Path
    tables: Sequence[str]
    format: int

    def is_there(self) -> bool:
        """Whether the file exists. Raises OSError if `path` exists but is not a regular file."""
        if self.path.is_file():
            return True
        if self.path.exists():
            raise OSError(f"{self.path}: is not a regular file: results cannot be stored there")
        return False

    @contextmanager
    def writing(self, patience: float | None = None) -> Iterator[sqlite3.Connection]:
        """Context of one transaction.

        Raises OSError if the transaction cannot begin within `patience` seconds.
        """
        with self._named_errors("stored"), _closed(self._prepared(patience)) as database, database:
            yield database

    @contextmanager
    def reading(self) -> Iterator[sqlite3.Connection]:
        """Connection for reading; it also works on a full disk and in a read-only folder."""
        with self._named_errors("read"), _closed(self._readable()) as database:
            yield database

    def compact(self) -> None:
        """Return free pages to the file system.

        This temporarily requires as much space as the file has.
        """
        with self._named_errors("stored"), _closed(self._prepared(None)) as database:
            database.isolation_level = None
            database.execute("VACUUM")

    def _prepared(self, patience: float | None) -> sqlite3.Connection:
        patience = PATIENCE if patience is None else patience
        database = sqlite3.connect(self.path, timeout=patience)
        try:
            _write_ahead(database, patience)
            for setting in SETTINGS:
                database.execute(setting)
            if self._format(database) < self.format:
                for step in (*self.tables, f"PRAGMA user_version = {self.format}"):
                    database.execute(step)
        except BaseException:
            database.close()
            raise
        return database

    def _readable(self) -> sqlite3.Connection:
        try:
            return self._prepared(None)
        except sqlite3.OperationalError:
            if (database := self._unwritten()) is None:
                raise
            return database

    def _unwritten(self) -> sqlite3.Connection | None:
        """Connection that writes nothing, not even lock files; None if this is impossible."""
        log = self.path.with_name(f"{self.path.name}-wal")
        # without a lock another process could change the file: only where it has nothing to add
        is_whole = not log.exists() or log.stat().st_size == 0
        for options in ("mode=ro", *(["immutable=1"] if is_whole else [])):
            with suppress(sqlite3.OperationalError):
                return self._as_it_is(f"{self.path.resolve().as_uri()}?{options}")
        return None

    def _as_it_is(self, address: str) -> sqlite3.Connection:
        database = sqlite3.connect(address, uri=True)
        try:
            if self._format(database) < self.format:
                raise sqlite3.OperationalError("the file has no tables")
        except BaseException:
            database.close()
            raise
        return database

    def _format(self, database: sqlite3.Connection) -> int:
        found = int(database.execute("PRAGMA user_version").fetchone()[0])
        if found > self.format:
            raise OSError(
                f"{self.path}: written by a later version (format {found}; this version reads "
                "format "
                f"{self.format}): results cannot be stored there; set FREEWHEEL_CACHE to another "
                "folder"
            )
        return found

    @contextmanager
    def _named_errors(self, done: str) -> Iterator[None]:
        try:
            yield
        except sqlite3.Error as error:
            hint = ""
            if type(error) is sqlite3.DatabaseError:  # others, such as a lock, are its subclasses
                hint = "; remove the file to begin again"
            elif any(words in str(error) for words in NO_ROOM):
                hint = "; free space on its disk, or remove the file to begin again"
            raise OSError(f"{self.path}: {error}: results cannot be {done} there{hint}") from error


@contextmanager
def _closed(database: sqlite3.Connection) -> Iterator[sqlite3.Connection]:
    try:
        yield database
    finally:
        database.close()


def _write_ahead(database: sqlite3.Connection, patience: float) -> None:
    """Set the mode in which readers and a writer can work at the same time.

    If two processes create a file at the same time, SQLite fails without waiting; therefore, this
    function tries again until `patience` seconds have passed.
    """
    end = time.monotonic() + patience
    while True:
        try:
            database.execute("PRAGMA journal_mode = WAL")
            return
        except sqlite3.OperationalError as error:
            if "locked" not in str(error) or time.monotonic() > end:
                raise
            time.sleep(PAUSE)
