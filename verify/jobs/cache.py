"""Finite-element results on disk, keyed by everything that they depend on.

The key covers the case, its inputs, the level, the sources of exactly the fem and meshes modules
that the case's `fem` function reaches, that function with the module-level names it uses, and the
versions of the libraries. A changed formula or judging rule therefore reruns no finite elements.
Analytic modules count where such a function itself imports one, as its reference (a half-space).
Files are JSON inside npz, written under a temporary name and renamed.
"""

import hashlib
import io
import json
import os
import struct
import time
import zipfile
import zlib
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from verify.core.case import Case, FemResult
from verify.core.figures import Field
from verify.core.files import write_whole
from verify.core.inputs import Inputs
from verify.core.source_code import COMPILED, parts_of, source_of

LIBRARIES = ("gmsh", "scikit-fem", "numpy", "scipy")
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
    return Path(__file__).parents[2] / ".cache" / "fem"


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
    parts = [str(FORMAT), case.id, canonical, str(level), source_of(case.reference)]
    parts += [f"{name} {version(name)}" for name in libraries_of(case.reference)]
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
