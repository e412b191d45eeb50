"""Finite-element results on disk, keyed by everything that they depend on.

The key covers the case, its inputs, the level, the sources of exactly the fem and meshes modules
that the case's `fem` function reaches, that function with the module-level names it uses, and the
versions of the libraries. A changed formula or judging rule therefore reruns no finite elements.
Analytic modules count where such a function itself imports one, as its reference (a half-space).
Files are JSON inside npz, written under a temporary name and renamed.
"""

import ast
import hashlib
import inspect
import io
import json
import os
import struct
import sys
import time
import zipfile
import zlib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from verify.case import Case, FemResult
from verify.files import write_whole
from verify.inputs import Inputs
from verify.shown import Field

LIBRARIES = ("gmsh", "scikit-fem", "numpy", "scipy")
COMPILED = "analytic.sprag.engagement"
OF_BOTH = ("_inputs", "_description")  # ends of names of modules that make what both sides take
ALONE = {COMPILED: "numba", "analytic.surrogate.length_scales": "scikit-learn"}  # who imports them
FORMAT = 1
LARGEST = 2e9  # bytes
ROOM = 0.2  # of it, made free at once
# what numpy and zipfile raise on files that were torn or changed
UNREADABLE = (
    OSError, ValueError, LookupError, EOFError, RuntimeError, TypeError, AttributeError,
    zipfile.BadZipFile, zlib.error, struct.error,
)  # fmt: skip


def default_folder() -> Path:
    """The cache of this checkout; FREEWHEEL_CACHE names another place (~ is one's home)."""
    named = os.environ.get("FREEWHEEL_CACHE")
    if named:
        return Path(os.path.expanduser(named))  # noqa: PTH111 - pathlib's raises without a home
    return Path(__file__).parent.parent / ".cache" / "fem"


def picture_folder() -> Path:
    """Where drawn pictures and equations are kept."""
    return default_folder() / "pictures"


def trim(folder: Path, largest: float = LARGEST) -> None:
    """Remove what was used least recently until the folder is well below `largest` bytes."""
    files = [(path.stat(), path) for path in folder.rglob("*.npz")]
    excess = sum(stat.st_size for stat, _ in files) - largest
    if excess <= 0:
        return
    excess += ROOM * largest
    for stat, path in sorted(files, key=lambda file: file[0].st_atime):
        path.unlink(missing_ok=True)
        excess -= stat.st_size
        if excess <= 0:
            return


def key(case: Case, inputs: Inputs, level: int) -> str:
    """Hexadecimal name of one result."""
    canonical = json.dumps(inputs.model_dump(), sort_keys=True)
    parts = [str(FORMAT), case.id, canonical, str(level), source_of(case.fem)]
    parts += [f"{name} {version(name)}" for name in libraries_of(case.fem)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def load(folder: Path, case: Case, inputs: Inputs, level: int) -> FemResult | None:
    """The stored result, or None where there is none or it can't be read."""
    path = folder / case.id / f"{key(case, inputs, level)}.npz"
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as data:
            found = _unpack({name: data[name] for name in data.files})
        # used: what is not, goes first where room is made
        os.utime(path, ns=(time.time_ns(), path.stat().st_mtime_ns))
        return found
    except UNREADABLE:
        return None


def store(folder: Path, case: Case, inputs: Inputs, level: int, result: FemResult) -> None:
    """Write the result so that no reader ever sees half a file; OSError where there is no room."""
    path = folder / case.id / f"{key(case, inputs, level)}.npz"
    packed = _pack(result)
    write_whole(path, lambda file: np.savez(file, allow_pickle=False, **packed))


def _pack(result: FemResult) -> dict[str, Any]:
    head = {
        "h": result.h,
        "values": dict(result.values),
        "u_it": dict(result.u_it),
        "arrays": list(result.arrays),
        "fields": [
            {"name": f.name, "units": dict(f.units), "point": list(f.point_data),
             "cell": list(f.cell_data)}
            for f in result.fields
        ],
    }  # fmt: skip
    packed: dict[str, Any] = {"head": np.array(json.dumps(head))}
    packed |= {f"a{i}": array for i, array in enumerate(result.arrays.values())}
    for i, f in enumerate(result.fields):
        packed |= {f"f{i}p": f.points, f"f{i}c": f.cells}
        packed |= {f"f{i}p{j}": a for j, a in enumerate(f.point_data.values())}
        packed |= {f"f{i}c{j}": a for j, a in enumerate(f.cell_data.values())}
    return packed


def _unpack(data: dict[str, Any]) -> FemResult:
    head = json.loads(str(data["head"]))
    fields = tuple(
        Field(
            name=f["name"], units=f["units"], points=data[f"f{i}p"], cells=data[f"f{i}c"],
            point_data={n: data[f"f{i}p{j}"] for j, n in enumerate(f["point"])},
            cell_data={n: data[f"f{i}c{j}"] for j, n in enumerate(f["cell"])},
        )
        for i, f in enumerate(head["fields"])
    )  # fmt: skip
    arrays = {name: data[f"a{i}"] for i, name in enumerate(head["arrays"])}
    return FemResult(
        h=head["h"], values=head["values"], u_it=head["u_it"], arrays=arrays, fields=fields
    )


@cache
def libraries_of(function: Any) -> tuple[str, ...]:
    """Libraries whose version may change a result of a `fem` function."""
    reached = parts_of(function)[1]
    return (*LIBRARIES, *(library for module, library in ALONE.items() if module in reached))


@cache
def source_of(function: Any) -> str:
    """Hash of a `fem` function: itself, the names of its module it uses, the modules it reaches."""
    used, reached = parts_of(function)
    text = "\n".join([*(used[n] for n in sorted(used)), *(f"{m} {_read(m)[0]}" for m in reached)])
    return hashlib.sha256(text.encode()).hexdigest()


@cache
def whole_source_of(function: Any) -> str:
    """Hash of a function, the names of its module it uses, and all formulas these reach."""
    used, start = _used(function, whole=True)
    reached = sorted(_reached(start, whole=True))
    text = "\n".join([*(used[n] for n in sorted(used)), *(f"{m} {_read(m)[0]}" for m in reached)])
    return hashlib.sha256(text.encode()).hexdigest()


def parts_of(function: Any) -> tuple[dict[str, str], list[str]]:
    """Code of a `fem` function and of the names of its module it uses, and modules it reaches.

    Where it reaches COMPILED, its results are the formulas' own and all formulas count.
    """
    used, start = _used(function, whole=False)
    reached = _reached(start, whole=False)
    if COMPILED in reached:
        used, start = _used(function, whole=True)
        reached = _reached(start, whole=True)
    return used, sorted(reached)


def _used(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """Code of the names that a function's module gives it, and the modules that these import."""
    module = inspect.getmodule(function)
    if module is None or module.__file__ is None:
        return {}, set()
    tree = ast.parse(Path(module.__file__).read_text("utf-8"))
    own = {name: node for node in tree.body for name in _defined(node)}
    borrowed: dict[str, set[str]] = {}  # names that the module's own imports bind
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            for alias in node.names:
                name = (alias.asname or alias.name).partition(".")[0]
                found = _imported(node, module.__name__)
                found = (m for m in found if whole or not _is_formula(m))
                borrowed.setdefault(name, set()).update(found)
    used: dict[str, str] = {}
    start: set[str] = set()
    queue = [function.__name__]
    while queue:
        name = queue.pop()
        if name in borrowed:  # a helper of another case module: all of that module
            start |= borrowed[name]
        elif name in own and name not in used:
            used[name] = _plain(own[name])
            queue += [n.id for n in ast.walk(own[name]) if isinstance(n, ast.Name)]
            start.update(_imported(own[name], module.__name__))
    return used, start


def _defined(node: ast.stmt) -> list[str]:
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [node.name]
    targets = node.targets if isinstance(node, ast.Assign) else []
    targets = [node.target] if isinstance(node, ast.AnnAssign) else targets
    return [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]


def _imported(node: ast.AST, importer: str, *, whole: bool = False) -> Iterator[str]:
    """Modules of analytic, fem, meshes and the cases that `node`, a part of `importer`, imports.

    But for `whole`, without what a module imports of analytic at its top: the other side's. Modules
    of inputs are both sides': sizes and loads that they compute act on finite elements, too.
    """
    formulas = set(node.body) if isinstance(node, ast.Module) else set()
    if whole or importer.startswith("analytic.") or importer.endswith(OF_BOTH):
        formulas = set()
    for item in ast.walk(node):
        names: list[str] = []
        if isinstance(item, ast.Import):
            names = [alias.name for alias in item.names]
        elif isinstance(item, ast.ImportFrom):
            parent = importer.rsplit(".", item.level)[0] if item.level else ""
            source = ".".join(filter(None, (parent, item.module)))
            names = [source, *(f"{source}.{alias.name}" for alias in item.names)]
        kept = (n for n in names if not (item in formulas and _is_formula(n)))
        yield from (n for n in kept if _counts(n))


def _is_formula(name: str) -> bool:
    return name.partition(".")[0] == "analytic"


def _counts(name: str) -> bool:
    """Whether `name` is a module on which a finite-element result may depend."""
    package = name.partition(".")[0]
    if not (package in ("analytic", "fem", "meshes") or name.startswith("verify.cases.")):
        return False
    parent = find_spec(name.rpartition(".")[0] or name)
    if parent is None or parent.submodule_search_locations is None:
        return False  # the last part is a name inside a module, which asking would import
    return find_spec(name) is not None


def _reached(start: set[str], *, whole: bool) -> set[str]:
    found: set[str] = set()
    queue = list(start)
    while queue:
        name = queue.pop()
        if name not in found:
            found.add(name)
            queue += _read(name, whole=whole)[1]
    return found


@cache
def _read(module: str, *, whole: bool = False) -> tuple[str, tuple[str, ...]]:
    """Hash of a module's code, and the modules that count among what it imports."""
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    tree = ast.parse(Path(spec.origin).read_text("utf-8"))
    imported = tuple(_imported(tree, module, whole=whole))
    return hashlib.sha256(_plain(tree).encode()).hexdigest(), imported


def _plain(node: ast.AST) -> str:
    """The code without comments, layout and docstrings, which leave `node`, too."""
    for item in ast.walk(node):
        body = getattr(item, "body", None)
        if (
            isinstance(body, list) and body and isinstance(body[0], ast.Expr)
            and isinstance(body[0].value, ast.Constant) and isinstance(body[0].value.value, str)
        ):  # fmt: skip
            item.body = body[1:] or [ast.Pass()]  # type: ignore[attr-defined]
    return dump(node)


def dump(node: ast.AST) -> str:
    """Text of a syntax tree, the same in every version of Python from 3.11 on.

    Python 3.12 added `type_params`, and 3.13 leaves empty fields out unless `show_empty` is set.
    """
    whole: dict[str, Any] = {"show_empty": True} if sys.version_info >= (3, 13) else {}
    return ast.dump(node, **whole).replace(", type_params=[]", "")
