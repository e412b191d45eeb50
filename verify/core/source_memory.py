"""Stored hashes of sources, each valid until a file on which the source may depend changes.

The hash of the code on which a function depends requires the syntax trees of hundreds of modules:
about ten seconds for all cases. Therefore, hashes are stored with a digest of these files.
"""

import atexit
import json
import sys
from collections.abc import Callable, Collection
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

from verify.core.plain_code import PROJECT
from verify.core.source_files import ROOT, digest_of
from verify.core.store import Store

T = TypeVar("T")
KIND, SUBJECT, KEY = "sources", "project", "hashes"  # of the entry of the store
HASHES = "verify.core.source_code"  # whose change changes all
_used: list["Memory"] = []


class Memory:
    """Named hashes in a folder, each stored with the digest of the files on which it depends."""

    def __init__(self, folder: Path) -> None:
        self._store = Store(folder)
        self._found = self._stored()
        self._new: dict[str, Any] = {}

    def remembered(self, name: str, modules: Collection[str], make: Callable[[], T]) -> T:
        """Result of `make` (a JSON value), stored as `name`.

        It is reused until a file changes on which the `modules` may depend.
        """
        files = digest_of(*sorted({*modules, HASHES}))
        known, value = self._found.get(name, ("", None))
        if known != files:
            value = make()
            self._found[name] = self._new[name] = [files, value]
        found: T = value
        return found

    def keep(self) -> None:
        """Write new entries.

        An error of the store is ignored; the next process then computes these entries again.
        """
        if self._new:
            with suppress(OSError):
                content = json.dumps(self._stored() | self._new).encode()
                self._store.store(KIND, SUBJECT, {KEY: content})
                self._new = {}

    def _stored(self) -> dict[str, Any]:
        content = self._store.one(KIND, KEY)
        return {} if content is None else dict(json.loads(content))


def use(folder: Path) -> None:
    """Store hashes in a folder, and reuse stored hashes until the process ends."""
    if not _used:
        _used.append(Memory(folder))
        atexit.register(share)


def forget() -> None:
    """Write new entries and clear the memory of this process."""
    share()
    _used.clear()


def share() -> None:
    """Write new entries now, for processes that start later."""
    for memory in _used:
        memory.keep()


def remembered(name: str, function: Any, make: Callable[[], T], modules: Collection[str] = ()) -> T:
    """Result of `make`; for a function of the project, it is stored if `use` was called before.

    The result may depend on the imports of the function's module, or on the imports of `modules`.
    """
    module = str(getattr(function, "__module__", ""))
    if not _used or not _is_of_project(module):
        return make()
    full = getattr(function, "__qualname__", None) or function.__name__
    return _used[0].remembered(f"{name} {module} {full}", modules or (module,), make)


def _is_of_project(module: str) -> bool:
    file = getattr(sys.modules.get(module), "__file__", None)
    return module.partition(".")[0] in PROJECT and Path(file or "/").is_relative_to(ROOT)
