"""Judged cases of the suite in the store. The key includes all data on which they depend.

A key includes the files on which the module of a case and the judging may depend, and the versions
of their libraries. An entry lists the levels from which it was judged, and is valid while these are
stored. Fields of the finest level remain in the entry of this level, and are read when needed.
"""

import hashlib
import json
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import overload

from verify.core import pickled
from verify.core.figures import Field
from verify.core.results import CaseResult
from verify.core.source_files import digest_of
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.level import Job

KIND = "judged"
FORMAT = 1
JUDGING = "verify.jobs.level"
LIBRARIES = (*cache.LIBRARIES, *cache.ALONE.values(), "pint", "pydantic")


@dataclass
class StoredFields(Sequence[Field]):
    """Fields of a level, read from the store when they are needed."""

    folder: Path
    level: str
    _read: Sequence[Field] | None = None

    @overload
    def __getitem__(self, index: int) -> Field: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Field]: ...
    def __getitem__(self, index: int | slice) -> Field | Sequence[Field]:
        return self._fields()[index]

    def __len__(self) -> int:
        return len(self._fields())

    def _fields(self) -> Sequence[Field]:
        if self._read is None:
            self._read = cache.fields_of(self.folder, self.level)
        return self._read


@dataclass(frozen=True)
class Judged:
    """A stored result with the keys of the levels from which it was judged."""

    result: CaseResult
    levels: Sequence[str]


def keys(modules: Mapping[str, str]) -> dict[str, str]:
    """Keys of the stored results of the suite's cases. `modules` are the modules of the cases."""
    libraries = [f"{name} {version(name)}" for name in LIBRARIES]
    return {
        name: hashlib.sha256(json.dumps([
            FORMAT, name, digest_of(module, JUDGING), *libraries
        ]).encode()).hexdigest()[:32]
        for name, module in modules.items()
    }  # fmt: skip


def load(folder: Path, wanted: Mapping[str, str]) -> dict[str, Judged]:
    """Stored results whose levels are all stored, too (name of the case: result)."""
    store = Store(folder)
    found: dict[str, Judged] = {}
    with suppress(OSError):
        contents = store.load(KIND, list(wanted.values()))
        for name, key in wanted.items():
            with suppress(KeyError, *pickled.UNREADABLE):
                levels, result = pickled.from_bytes(contents[key])
                if len(store.dates(cache.KIND, levels)) == len(levels):
                    fields = StoredFields(folder, levels[-1]) if result.cells else ()
                    whole = replace(result, fields=fields, cached=True)
                    found[name] = Judged(whole, levels)
    return found


def keep(folder: Path, job: Job, result: CaseResult, key: str) -> None:
    """Store a result if all its levels are stored and no error occurred."""
    levels = [cache.key(job.case, job.inputs, level) for level in job.case.levels]
    store = Store(folder)
    with suppress(OSError):  # a full disk costs the time to judge again
        if not result.errors and len(store.dates(cache.KIND, levels)) == len(levels):
            content = pickled.to_bytes((levels, replace(result, fields=())))
            store.store(KIND, result.id, {key: content})
