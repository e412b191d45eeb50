"""Hashes of sources, stored while no file of the project changes.

To hash the code that a function depends on takes the syntax trees of hundreds of modules, some ten
seconds for all cases. What was found is stored under a digest of the content of every file.
"""

import atexit
import hashlib
import json
import os
import platform
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from verify.core.plain_code import PROJECT
from verify.core.store import Store

T = TypeVar("T")
ROOT = Path(__file__).parents[2]
KIND = "sources"
NOT_READ = ("__pycache__", "out")  # folders: compiled code, and reports that were written
_used: list["Memory"] = []


class Memory:
    """What was found for the present files, in the store of a folder."""

    def __init__(self, folder: Path) -> None:
        self._store, self._key = Store(folder), digest()
        content = self._store.one(KIND, self._key)
        self._found: dict[str, Any] = {} if content is None else json.loads(content)
        self._is_new = False

    def remembered(self, name: str, make: Callable[[], T]) -> T:
        """What `make` returns, a value of JSON, stored by a name."""
        if name not in self._found:
            self._found[name] = make()
            self._is_new = True
        found: T = self._found[name]
        return found

    def keep(self) -> None:
        """Write what is new; a store that takes nothing costs only time."""
        if self._is_new:
            with suppress(OSError):
                self._store.store(KIND, "project", {self._key: json.dumps(self._found).encode()})
                self._is_new = False


def use(folder: Path) -> None:
    """Remember in the store of a folder until the process ends."""
    if not _used:
        _used.append(Memory(folder))
        atexit.register(share)


def forget() -> None:
    """End the memory of this process: what is hashed next is read from the files."""
    share()
    _used.clear()


def share() -> None:
    """Write what is new now, for processes that are started."""
    for memory in _used:
        memory.keep()


def remembered(name: str, function: Any, make: Callable[[], T]) -> T:
    """What `make` returns for a function of the project, from the memory where one is in use."""
    module = str(getattr(function, "__module__", ""))
    if not _used or not _is_of_project(module):
        return make()
    own = getattr(function, "__qualname__", None) or function.__name__
    return _used[0].remembered(f"{name} {module} {own}", make)


def _is_of_project(module: str) -> bool:
    file = getattr(sys.modules.get(module), "__file__", None)
    return module.partition(".")[0] in PROJECT and Path(file or "/").is_relative_to(ROOT)


@cache
def digest() -> str:
    """Digest of the content of all files of the project's packages and of the Python version."""
    found = hashlib.sha256(platform.python_version().encode())
    for path in _files():
        content = hashlib.sha256(path.read_bytes()).digest()
        found.update(f"\0{path.relative_to(ROOT)}\0".encode() + content)
    return found.hexdigest()


def _files() -> Iterator[Path]:
    for package in PROJECT:
        for folder, below, names in os.walk(ROOT / package):
            below[:] = sorted(name for name in below if name not in NOT_READ)
            yield from (Path(folder) / name for name in sorted(names))
