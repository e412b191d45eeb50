"""Files that are whole or not there, whoever is killed when.

A file is written under a temporary name, on which the writer holds a lock that ends with its
process, however that ends; a temporary file without one is abandoned.
"""

import fcntl
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

PREFIX = ".part-"


def write_whole(path: Path, write: Callable[[IO[bytes]], object]) -> None:
    """Have `write` fill a file that then takes the place of `path`; OSError where it can't."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with _temporary(path.parent) as (file, temporary):
        write(file)
        file.flush()
        temporary.chmod(0o644)
        temporary.replace(path)


def made_folder(folder: Path) -> None:
    """The folder exists; OSError that names a file that is in its place."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        file = next((p for p in (folder, *folder.parents) if p.exists() and not p.is_dir()), None)
        why = f"{file}: is a file, expected a folder" if file else f"{folder}: {error.strerror}"
        raise OSError(f"{why}: results cannot be stored there") from error


def remove_abandoned(folder: Path) -> None:
    """Remove temporary files in `folder` whose writers are dead, leaving those of live ones."""
    for path in folder.glob(f"{PREFIX}*"):
        with suppress(OSError), path.open("rb") as file:  # gone, another's, or being written
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            path.unlink()


@contextmanager
def _temporary(folder: Path) -> Iterator[tuple[IO[bytes], Path]]:
    while True:
        handle, name = tempfile.mkstemp(dir=folder, prefix=PREFIX)
        path, file = Path(name), os.fdopen(handle, "wb")
        try:
            with suppress(OSError):  # a file system without locks: nobody removes its files
                fcntl.flock(handle, fcntl.LOCK_EX)
            if os.fstat(handle).st_nlink == 0:  # removed by another run before it was locked
                continue
            yield file, path
            return
        finally:
            path.unlink(missing_ok=True)
            with suppress(OSError):  # what is left in the buffer of a file that is given up
                file.close()
