"""Results of references in the store; the key includes all data on which they depend.

The key includes the case, its inputs, the level, the code on which the reference depends, and the
versions of the libraries. This code is the function of the reference, the code that it uses in its
module, and the modules of fem and meshes that it imports, directly or indirectly. Therefore, a
change of a formula or of a rule of judging does not require a new finite-element solution. Modules
of analytic are included if the reference imports them, for example a half-space. The content of an
entry is an npz file with its structure in JSON.
"""

import hashlib
import json
import os
import struct
import zipfile
import zlib
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from verify.core.case import Case, FemResult
from verify.core.figures import Field
from verify.core.inputs import Inputs
from verify.core.source_code import COMPILED, modules_of, source_of
from verify.core.store import Store, packed, unpacked

LIBRARIES = ("gmsh", "scikit-fem", "numpy", "scipy")
ALONE = {  # who imports them
    COMPILED: "numba", "analytic.surrogate.length_scales": "scikit-learn", "fem.cholesky": "cvxopt",
}  # fmt: skip
FORMAT = 1
KIND = "level"  # of entries: a case's result on one mesh
# errors of numpy and zipfile for incomplete or changed files
UNREADABLE = (
    OSError, ValueError, LookupError, EOFError, RuntimeError, TypeError, AttributeError,
    zipfile.BadZipFile, zlib.error, struct.error,
)  # fmt: skip


def default_folder() -> Path:
    """Folder of the cache of this checkout.

    The environment variable FREEWHEEL_CACHE selects another folder (~ is the home folder).
    """
    named = os.environ.get("FREEWHEEL_CACHE")
    if named:
        return Path(os.path.expanduser(named))  # noqa: PTH111 - pathlib's raises without a home
    return Path(__file__).parents[2] / ".cache" / "fem"


def key(case: Case, inputs: Inputs, level: int) -> str:
    """Hexadecimal key of one result."""
    canonical = json.dumps(inputs.model_dump(), sort_keys=True)
    parts = [str(FORMAT), case.id, canonical, str(level), source_of(case.reference)]
    parts += [f"{name} {version(name)}" for name in libraries_of(case.reference)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def load(folder: Path, case: Case, inputs: Inputs, level: int) -> FemResult | None:
    """Stored result; None if there is none or it cannot be read."""
    content = Store(folder).one(KIND, key(case, inputs, level))
    try:
        return None if content is None else _result(unpacked(content))
    except UNREADABLE:
        return None


def fields_of(folder: Path, name: str) -> tuple[Field, ...]:
    """Fields of the stored result with the key `name`. Raises OSError if it cannot be read."""
    content = Store(folder).load(KIND, [name]).get(name)
    if content is None:
        raise OSError(f"{folder}: a solved level is no longer stored: repeat the run")
    return _result(unpacked(content)).fields


def store(folder: Path, case: Case, inputs: Inputs, level: int, result: FemResult) -> None:
    """Store the result. Raises OSError if the store cannot be written."""
    content = packed(_arrays(result))
    Store(folder).store(KIND, case.id, {key(case, inputs, level): content})


def _arrays(result: FemResult) -> dict[str, Any]:
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
    arrays: dict[str, Any] = {"head": np.array(json.dumps(head))}
    arrays |= {f"a{i}": array for i, array in enumerate(result.arrays.values())}
    for i, f in enumerate(result.fields):
        arrays |= {f"f{i}p": f.points, f"f{i}c": f.cells}
        arrays |= {f"f{i}p{j}": a for j, a in enumerate(f.point_data.values())}
        arrays |= {f"f{i}c{j}": a for j, a in enumerate(f.cell_data.values())}
    return arrays


def _result(data: dict[str, Any]) -> FemResult:
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
    """Libraries whose version can change a result of a `fem` function."""
    reached = modules_of(function)
    return (*LIBRARIES, *(library for module, library in ALONE.items() if module in reached))
