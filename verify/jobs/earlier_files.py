"""Results that an earlier version stored as files of their own move into the store."""

import re
import shutil
from contextlib import suppress
from pathlib import Path

from verify.core.store import Store
from verify.jobs import cache

NAME = re.compile(r"[0-9a-f]{32}\.npz")
PICTURES = "pictures"  # a folder of what is drawn again in a minute
KINDS = {"design-sprag": "engagement"}  # of files by their folder; in those of cases levels


def adopt(folder: Path) -> int:
    """Move such files into the folder's store, and return how many they were.

    A file is removed after its content is stored: nothing is lost where this is interrupted.
    OSError where the store takes none.
    """
    shutil.rmtree(folder / PICTURES, ignore_errors=True)
    files = [p for p in folder.glob("*/*.npz") if NAME.fullmatch(p.name)]
    for path in files:
        kind = KINDS.get(path.parent.name, cache.KIND)
        with suppress(FileNotFoundError):  # another run was faster
            content, made = path.read_bytes(), path.stat().st_mtime
            Store(folder).store(kind, path.parent.name, {path.stem: content}, made)
            path.unlink(missing_ok=True)
    for place in {path.parent for path in files}:
        for half in place.glob(".part-*"):  # of a writer that was killed
            half.unlink(missing_ok=True)
        with suppress(OSError):  # it has other files
            place.rmdir()
    return len(files)
