"""The folder of a page. No files outside the folder are read or written."""

import itertools
import os
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import IO

from verify.core.files import write_whole
from verify.core.inputs import MAX_BYTES, InputError

MOST_FILES, MOST_LOOKED = 200, 5000  # that are listed; that are looked at for the list
LONGEST = 100  # characters of a file's name


class Folder:
    """Access to the files of one folder by their names."""

    def __init__(self, root: Path) -> None:
        """Raise InputError if `root` is not a folder."""
        if not root.is_dir():
            raise InputError(f"--folder {root}: is no folder; give an existing folder")
        self.root = root.resolve()

    def path(self, name: str, *suffixes: str) -> Path:
        """The path of a file in the folder or in one of its subfolders.

        Raises InputError if the file is hidden, has none of the `suffixes`, or is outside the
        folder. A link in the folder to a file outside is also refused.
        """
        parts = name.replace("\\", "/").split("/")
        if not name.strip() or len(name) > LONGEST or not name.isprintable():
            raise InputError(f"a file name must have 1 to {LONGEST} printable characters")
        if any(not part or part.startswith(".") or ":" in part for part in parts):
            raise InputError(f"{name}: only files in the folder {self.root} can be used")
        path = self.root.joinpath(*parts)
        if suffixes and path.suffix not in suffixes:
            raise InputError(f"{name}: the name must end with {' or '.join(suffixes)}")
        if not path.resolve().is_relative_to(self.root):
            raise InputError(f"{name}: leads, by a link, to a file outside the folder {self.root}")
        return path

    def names_of(self, suffix: str, *, below: bool = False) -> list[str]:
        """Sorted names of the files that end with `suffix`; with `below`, also in subfolders."""
        found, folders, looked = list[str](), [""], 0
        for folder in folders:  # which grows
            with suppress(OSError), os.scandir(self.root / folder) as entries:
                for one in itertools.islice(entries, MOST_LOOKED - looked):
                    looked += 1
                    if one.name.startswith("."):
                        continue
                    if one.is_dir(follow_symlinks=False):
                        folders += [f"{folder}{one.name}/"] if below else []
                    elif one.name.endswith(suffix):
                        found.append(f"{folder}{one.name}")
        return sorted(found, key=lambda name: (name.count("/"), name))[:MOST_FILES]

    def write(self, name: str, text: str, *suffixes: str, replace: bool = False) -> Path:
        """Write a file completely or not at all.

        Raises InputError if the file cannot be written, or if it exists and `replace` is False.
        """
        path = self.path(name, *suffixes)
        data = text.encode()
        if len(data) > MAX_BYTES:
            raise InputError(f"{name}: is larger than {MAX_BYTES:,} bytes")
        if not path.parent.is_dir():
            below = path.parent.relative_to(self.root)
            raise InputError(f"{name}: cannot be written: there is no folder {below}")
        if path.exists() and not replace:
            raise InputError(f"{name}: exists already and is not overwritten")
        try:
            write_whole(path, partial(_fill, data))
        except OSError as error:
            raise InputError(f"{name}: cannot be written: {error.strerror}") from error
        return path


def _fill(data: bytes, file: IO[bytes]) -> None:
    file.write(data)
