"""Writing of files completely or not at all, even if a process is killed."""

import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

PREFIX = ".part-"


def write_whole(path: Path, write: Callable[[IO[bytes]], object]) -> None:
    """Write a new file by the function `write`; the complete file then replaces `path`.

    Raises OSError if the file cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with _temporary(path.parent) as (file, temporary):
        write(file)
        file.flush()
        temporary.chmod(0o644)
        temporary.replace(path)


def made_folder(folder: Path) -> None:
    """Make a folder if it does not exist.

    Raises OSError if this fails; if a file has the path of a folder, the message names the file.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        file = next((p for p in (folder, *folder.parents) if p.exists() and not p.is_dir()), None)
        why = f"{file}: is a file, expected a folder" if file else f"{folder}: {error.strerror}"
        raise OSError(f"{why}: results cannot be stored there") from error


@contextmanager
def _temporary(folder: Path) -> Iterator[tuple[IO[bytes], Path]]:
    handle, name = tempfile.mkstemp(dir=folder, prefix=PREFIX)
    path, file = Path(name), os.fdopen(handle, "wb")
    try:
        yield file, path
    finally:
        path.unlink(missing_ok=True)
        with suppress(OSError):  # the buffer of an abandoned file
            file.close()
