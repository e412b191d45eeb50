"""Contents of the project's files, and digests of all files on which a module may depend.

A module depends on its file, on the modules in its import statements (including those in
functions), on the dependencies of these modules, and on data in their folders. Import statements
are found by a text search, which takes a thousandth of the time of syntax trees. A statement in a
docstring is therefore also included.
"""

import ast
import hashlib
import os
import platform
import re
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import accumulate
from pathlib import Path

from verify.core.module_syntax import STUB, parsed, public_names
from verify.core.plain_code import PROJECT

ROOT = Path(__file__).parents[2]
NOT_READ = ("__pycache__", "out")  # folders: compiled code, and reports that were written
MEASURED, READER = "verify/measured", "verify/jobs/records.py"  # who reads the data of a folder
_COMMENT = re.compile(rb"#[^\n]*|\\\n")
_IMPORT = re.compile(
    r"^[ \t]*(?:from[ \t]+([\w.]+)[ \t]+import[ \t]*(\([^)]*\)|[^\n]*)|import[ \t]+([^\n]*))",
    re.MULTILINE,
)


@cache
def digest() -> str:
    """Digest of all files of the project's packages and of the Python version."""
    return _combined(_contents())


@cache
def digest_of(*modules: str) -> str:
    """Digest of all files on which the `modules` may depend, and of the Python version."""
    contents = _contents()
    return _combined({file: contents[file] for file in _files_of(*modules)})


def code_of(*modules: str) -> str:
    """Digest of the same files as `digest_of`, without comments and layout of Python code.

    It takes about a second.
    """
    contents, sources = _contents(), _sources()
    return _combined({
        file: _tree(sources[file]) if file.endswith(".py") else contents[file]
        for file in _files_of(*modules)
    })  # fmt: skip


def _tree(source: bytes) -> bytes:
    return hashlib.sha256(ast.dump(parsed(source.decode())).encode()).digest()


def _files_of(*modules: str) -> set[str]:
    known = _modules()
    found: set[str] = set()
    queue = list(modules)
    while queue:
        name = queue.pop()
        file = known.get(name)
        if file and file not in found:
            found |= {file, *_data().get(file, ()), *_data().get(_folder(file), ())}
            queue += [one for name in _imported(file) for one in _meant(name)]
        if parent := name.rpartition(".")[0]:
            queue.append(parent)
    return found


def _meant(name: str) -> list[str]:
    """A name in an import statement, and the names to which stubs of packages map it."""
    package, _, last = name.rpartition(".")
    public = _public(package)
    if last == "*":
        return [package, *public.values()]
    return [name, *_public(name).values(), *([public[last]] if last in public else [])]


@cache
def _public(package: str) -> Mapping[str, str]:
    """Full names of the public names of a package; empty for a package without a stub."""
    stub = _sources().get(f"{package.replace('.', '/')}/{STUB}")
    return {} if stub is None else public_names(parsed(stub.decode()))


def forget() -> None:
    """Clear stored contents, so that the files are read again."""
    for one in (digest, digest_of, _sources, _contents, _modules, _data, _imported, _public):
        one.cache_clear()


def _combined(files: Mapping[str, bytes]) -> str:
    found = hashlib.sha256(platform.python_version().encode())
    for path in sorted(files):
        found.update(f"\0{path}\0".encode() + files[path])
    return found.hexdigest()


@cache
def _contents() -> Mapping[str, bytes]:
    return {path: hashlib.sha256(text).digest() for path, text in _sources().items()}


@cache
def _sources() -> Mapping[str, bytes]:
    """Contents of all files of the packages, by path from the root of the project."""
    return {path.relative_to(ROOT).as_posix(): path.read_bytes() for path in _files()}


def _files() -> Iterator[Path]:
    for package in PROJECT:
        for folder, below, names in os.walk(ROOT / package):
            below[:] = sorted(name for name in below if name not in NOT_READ)
            yield from (Path(folder) / name for name in sorted(names))


@cache
def _modules() -> Mapping[str, str]:
    """Files of modules, by dotted module name."""
    python = (path for path in _sources() if path.endswith(".py"))
    return {path[:-3].removesuffix("/__init__").replace("/", "."): path for path in python}


@cache
def _data() -> Mapping[str, list[str]]:
    """Data files (not modules), by the folder of their package, or by the file that reads them."""
    packages = {_folder(path) for path in _modules().values()}
    found: dict[str, list[str]] = {}
    for path in _sources():
        if path.endswith(".py"):
            continue
        place = _folder(path)
        while place and place not in packages:
            place = _folder(place)
        found.setdefault(READER if path.startswith(f"{MEASURED}/") else place, []).append(path)
    return found


def _folder(path: str) -> str:
    return path.rpartition("/")[0]


@cache
def _imported(file: str) -> frozenset[str]:
    """Modules of the project, and names inside modules, in the import statements of a file."""
    text = _COMMENT.sub(b" ", _sources()[file]).decode()
    return frozenset(name for found in _IMPORT.finditer(text) for name in _named(*found.groups()))


def _named(source: str | None, names: str | None, modules: str | None) -> Iterator[str]:
    words = [word.split() for word in (names or modules or "").strip("() \n").split(",")]
    given = [word[0] for word in words if word]
    if source:
        yield from (f"{source}.{name}" for name in given)
    else:  # the packages of a module are bound as well
        yield from (part for name in given for part in accumulate(name.split("."), "{}.{}".format))
