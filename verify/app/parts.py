"""Stored parts of a report; a part is computed again if anything on which it depends changes."""

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

from verify.core import pickled
from verify.core.source_files import digest_of
from verify.core.store import Store

KIND = "report part"
FORMAT = 1
T = TypeVar("T")


class Parts:
    """Parts of one report, stored with the `keys` of the judged cases of the report.

    A part is computed again if a key of its cases is missing, or if there is no `folder`.
    """

    def __init__(self, folder: Path | None = None, keys: Mapping[str, str] | None = None) -> None:
        self._folder, self.keys = folder, keys or {}

    def of_cases(
        self, name: str, module: str, cases: Sequence[str], make: Callable[[str], T]
    ) -> dict[str, T]:
        """Results of `make` (name of the case: result); `module` contains the code of `make`."""
        return self.by_group(name, module, {case: [case] for case in cases}, make)

    def by_group(
        self, name: str, module: str, groups: Mapping[str, Sequence[str]], make: Callable[[str], T]
    ) -> dict[str, T]:
        """Results of `make` (name of the group: result); `module` contains the code of `make`."""
        keys = {group: self._key(name, module, group, cases) for group, cases in groups.items()}
        found = dict(self._stored(keys))
        new: dict[str, bytes] = {}
        for group, key in keys.items():
            if group not in found:
                found[group] = make(group)
                if key:
                    new[key] = pickled.to_bytes(found[group])
        if new and self._folder:
            with suppress(OSError):  # a full disk costs the time to make them again
                Store(self._folder).store(KIND, name, new)
        return {group: found[group] for group in groups}

    def of_all(self, name: str, module: str, cases: Sequence[str], make: Callable[[], T]) -> T:
        """Result of `make` for all cases together; `module` contains the code of `make`."""
        return self.by_group(name, module, {"all": cases}, lambda _: make())["all"]

    def _key(self, name: str, module: str, group: str, cases: Sequence[str]) -> str:
        """Key of a part; "" if the part cannot be stored."""
        if self._folder is None or any(case not in self.keys for case in cases):
            return ""
        made_of = [FORMAT, name, digest_of(module), group, *(self.keys[case] for case in cases)]
        return hashlib.sha256(json.dumps(made_of).encode()).hexdigest()[:32]

    def _stored(self, keys: Mapping[str, str]) -> Iterator[tuple[str, Any]]:
        wanted = [key for key in keys.values() if key]
        if not wanted or self._folder is None:
            return
        with suppress(OSError):
            contents = Store(self._folder).load(KIND, wanted)
            for group, key in keys.items():
                with suppress(KeyError, *pickled.UNREADABLE):
                    yield group, pickled.from_bytes(contents[key])
