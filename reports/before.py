"""Files that an earlier run wrote into a folder, and their validity."""

import json
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

FILE = ".written.json"


class Before:
    """Parts of a report in a folder that are still valid.

    A part consists of files that are made from the same data; a digest identifies these data. A
    part is valid if its digest is equal to that of the earlier run and no file of it has changed.
    """

    def __init__(self, folder: Path, digests: Mapping[str, str]) -> None:
        self._folder, self._digests = folder, digests
        known = self._read()
        self._kept = {
            part: known[part] for part, digest in digests.items()
            if part in known and known[part]["of"] == digest and self._is_whole(known[part])
        }  # fmt: skip

    def __contains__(self, part: object) -> bool:
        return part in self._kept

    @property
    def files(self) -> set[str]:
        """Files that need not be written again."""
        return {name for part in self._kept.values() for name in part["files"]}

    def about(self, part: str) -> Any:
        """Data that were stored with a part."""
        return self._kept[part]["about"]

    def note(self, written: Mapping[str, Iterable[str]], about: Mapping[str, Any]) -> None:
        """Record the files of newly written parts, in addition to those of earlier runs."""
        new = {
            part: {
                "of": self._digests[part], "about": about.get(part),
                "files": {name: self._state(name) for name in files},
            }
            for part, files in written.items() if part in self._digests
        }  # fmt: skip
        with suppress(OSError):  # the next run writes all
            (self._folder / FILE).write_text(json.dumps(self._kept | new), "utf-8")

    def _read(self) -> dict[str, Any]:
        try:
            return dict(json.loads((self._folder / FILE).read_text("utf-8")))
        except (OSError, ValueError, TypeError):  # none, or not whole
            return {}

    def _is_whole(self, part: Mapping[str, Any]) -> bool:
        try:
            return all(self._state(name) == state for name, state in part["files"].items())
        except OSError:
            return False

    def _state(self, name: str) -> list[int]:
        """Size and modification time of a file."""
        found = (self._folder / name).stat()
        return [found.st_size, found.st_mtime_ns]
