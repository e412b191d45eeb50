"""Solved points on disk: one database a case, a point under the hash of its inputs.

Every commit is whole: whatever is killed, a point is there or it isn't, and never twice. A point
is read again while the code stands that solved it, each side for itself.
"""

import hashlib
import json
import sqlite3
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from sys import intern
from typing import Any

from verify.core.case import Portion
from verify.core.inputs import Inputs
from verify.studies.sweep.point import Solution

FORMAT = 1
PATIENCE = 30.0  # s for another sweep to finish its writing
AT_ONCE = 500  # keys in one question
TABLE = (
    "CREATE TABLE IF NOT EXISTS points (key TEXT PRIMARY KEY, formulas TEXT NOT NULL, "
    "fe TEXT NOT NULL, solution TEXT NOT NULL)"
)


class Store:
    """The solved points of one case's portion; `code` are the hashes of its two sides' sources."""

    def __init__(self, path: Path, part: Portion, code: tuple[str, str], versions: str) -> None:
        self.path, self.part, self.code, self.versions = path, part, code, versions
        _made(path.parent)
        with self._open() as database:
            database.execute(TABLE)

    def key(self, inputs: Inputs) -> str:
        """The name of a point."""
        canonical = json.dumps(inputs.model_dump(), sort_keys=True)
        parts = (str(FORMAT), self.part.name, str(self.part.levels), canonical)
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:40]

    def load(self, keys: Sequence[str]) -> dict[str, Solution]:
        """What is there of the points, without the sides that other code has solved."""
        found: dict[str, Solution] = {}
        with self._open() as database:
            for k in range(0, len(keys), AT_ONCE):
                some = keys[k : k + AT_ONCE]
                marks = ",".join("?" * len(some))
                rows = database.execute(
                    f"SELECT key, formulas, fe, solution FROM points WHERE key IN ({marks})",  # noqa: S608 - question marks
                    some,
                )
                for key, formulas, fe, text in rows:
                    if one := self._valid(formulas, fe, text):
                        found[key] = one
        return found

    def store(self, solved: Mapping[str, Solution]) -> None:
        """Write the points, all or none."""
        formulas, fe = self._stamps()
        rows = [(key, formulas, fe, json.dumps(asdict(one))) for key, one in solved.items()]
        with self._open() as database:
            database.executemany("INSERT OR REPLACE INTO points VALUES (?, ?, ?, ?)", rows)

    def _stamps(self) -> tuple[str, str]:
        return f"{self.code[0]} {self.versions}", f"{self.code[1]} {self.versions}"

    def _valid(self, formulas: str, fe: str, text: str) -> Solution | None:
        try:
            one = _solution(json.loads(text))
        except (ValueError, TypeError, LookupError, AttributeError):
            return None
        ours = self._stamps()
        if formulas != ours[0]:
            one = replace(one, formulas={}, problem_formulas="")
        if fe != ours[1]:
            one = replace(one, h=(), fe={}, u_it={}, problem_fe="")
        return one

    @contextmanager
    def _open(self) -> Iterator[sqlite3.Connection]:
        database = sqlite3.connect(self.path, timeout=PATIENCE)
        try:
            database.execute("PRAGMA journal_mode = WAL")
            # a process that is killed loses nothing; a power failure may lose the last commits
            database.execute("PRAGMA synchronous = NORMAL")
            with database:
                yield database
        except sqlite3.Error as error:
            # others of its kind, such as a locked one, are subclasses
            corrupt = type(error) is sqlite3.DatabaseError
            hint = "; move it away to start anew" if corrupt else ""
            said = f"{self.path}: {error}: solved points cannot be kept there{hint}"
            raise OSError(said) from error
        finally:
            database.close()


def _made(folder: Path) -> None:
    """The folder is there; OSError that names what is in its way."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        file = next((p for p in (folder, *folder.parents) if p.exists() and not p.is_dir()), None)
        why = f"{file}: is a file, expected a folder" if file else f"{folder}: {error.strerror}"
        raise OSError(f"{why}: solved points cannot be kept there") from error


def _solution(data: Mapping[str, Any]) -> Solution:
    # all points have the same names: one of each serves them all
    return Solution(
        formulas={intern(k): float(v) for k, v in data["formulas"].items()},
        h=tuple(map(float, data["h"])),
        fe={intern(k): tuple(map(float, v)) for k, v in data["fe"].items()},
        u_it={intern(k): float(v) for k, v in data["u_it"].items()},
        problem_formulas=str(data["problem_formulas"]), problem_fe=str(data["problem_fe"]),
        seconds=float(data["seconds"]),
    )  # fmt: skip


def lacking(found: Solution | None) -> tuple[bool, bool]:
    """Whether formulas and finite elements are still to be solved."""
    if found is None:
        return True, True
    return (
        not (found.formulas or found.problem_formulas),
        not (found.h or found.problem_fe),
    )


def joined(old: Solution | None, new: Solution) -> Solution:
    """A solution with the sides of both, the new one's first."""
    if old is None:
        return new
    formulas = new if new.formulas or new.problem_formulas else old
    fe = new if new.h or new.problem_fe else old
    return Solution(
        formulas.formulas, fe.h, fe.fe, fe.u_it, formulas.problem_formulas, fe.problem_fe,
        new.seconds if fe is new else old.seconds,
    )  # fmt: skip
