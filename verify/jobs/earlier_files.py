"""Results that an earlier version stored as files of their own move into the store."""

import re
import shutil
from contextlib import suppress
from itertools import groupby
from pathlib import Path

from verify.core.store import Store
from verify.jobs import cache

NAME = re.compile(r"[0-9a-f]{32}\.npz")
PICTURES = "pictures"  # a folder of what is drawn again in a minute
KINDS = {"design-sprag": "engagement"}  # of files by their folder; in those of cases levels
AT_ONCE = 20  # files in one writing


def adopt(folder: Path) -> int:
    """Move such files into the folder's store, and return how many they were.

    A file is removed after its content is stored: nothing is lost where this is interrupted.
    OSError where the store takes none.
    """
    shutil.rmtree(folder / PICTURES, ignore_errors=True)
    files = sorted(p for p in folder.glob("*/*.npz") if NAME.fullmatch(p.name))
    for place, some in groupby(files, key=lambda path: path.parent):
        kind, own = KINDS.get(place.name, cache.KIND), list(some)
        for k in range(0, len(own), AT_ONCE):
            _move(Store(folder), kind, place.name, own[k : k + AT_ONCE])
        for half in place.glob(".part-*"):  # of a writer that was killed
            half.unlink(missing_ok=True)
        with suppress(OSError):  # it has other files
            place.rmdir()
    return len(files)


def _move(store: Store, kind: str, subject: str, files: list[Path]) -> None:
    found: dict[str, bytes] = {}
    for path in files:
        with suppress(FileNotFoundError):  # another run was faster
            found[path.stem] = path.read_bytes()
    store.store(kind, subject, found)
    for path in files:
        path.unlink(missing_ok=True)
