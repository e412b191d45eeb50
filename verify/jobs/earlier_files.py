"""Moves results that an earlier version stored as separate files into the store."""

import re
from contextlib import suppress
from pathlib import Path

from verify.core.store import Store, unpacked
from verify.jobs import cache

NAME = re.compile(r"[0-9a-f]{32}\.npz")
# kind of entries and the array that each file of it has; other folders belong to cases
KINDS = {"design-sprag": ("engagement", "N")}
LEVEL = cache.KIND, "head"
PICTURES = "pictures"  # a folder whose files are drawn again in a minute: they stay where they are


def adopt(folder: Path) -> int:
    """Move files of earlier versions into the store of the folder; returns their number.

    A file is removed after its content is stored: nothing is lost by an interruption. Files that
    are no results are not moved. Raises OSError if the store cannot be written.
    """
    files = [p for p in folder.glob("*/*.npz") if NAME.fullmatch(p.name)]
    moved = [path for path in files if path.parent.name != PICTURES and _move(path, folder)]
    for place in {path.parent for path in moved}:
        for half in place.glob(".part-*"):  # of a writer that was killed
            half.unlink(missing_ok=True)
        with suppress(OSError):  # it has other files
            place.rmdir()
    return len(moved)


def _move(path: Path, folder: Path) -> bool:
    """Move one file to the store if it is a result of an earlier version; True if it was moved."""
    kind, array = KINDS.get(path.parent.name, LEVEL)
    try:
        content, made = path.read_bytes(), path.stat().st_mtime
        if array not in unpacked(content):
            return False
    except cache.UNREADABLE:  # no such file, or one that another run has moved
        return False
    Store(folder).store(kind, path.parent.name, {path.stem: content}, made)
    path.unlink(missing_ok=True)
    return True
