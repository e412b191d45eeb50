"""Results that took hours: kept in a file of the project, read while their code stands.

A deep case is a `Case` without rows: its levels are parts of a larger measurement on the default
inputs, each solved and cached like any level, so that an interrupted run continues where it was.
The file counts until the code that made it changes; then the case is "not measured".
"""

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from verify.core import source_code
from verify.core.case import Case, FemResult
from verify.core.files import write_whole

FOLDER = Path(__file__).parents[1] / "measured"


@dataclass(frozen=True)
class Measured:
    """Results of all parts, in the order of the case's levels, and the day they were made."""

    date: str
    parts: tuple[FemResult, ...]


def measured(case: Case, folder: Path | None = None) -> Measured | None:
    """What is kept of `case`; None where nothing was measured with the present code."""
    try:
        data = json.loads(((folder or FOLDER) / f"{case.id}.json").read_text("utf-8"))
        if (
            data["code"] != source_code.source_of(case.reference)
            or data["inputs"] != case.inputs().model_dump()
        ):
            return None
        parts = tuple(
            FemResult(
                h=part["h"], values=part["values"], u_it=part["u_it"],
                arrays={name: np.array(array) for name, array in part["arrays"].items()},
            )
            for part in data["parts"]
        )  # fmt: skip
        return Measured(data["date"], parts)
    except (OSError, ValueError, LookupError, TypeError):
        return None


def keep(case: Case, parts: Sequence[FemResult], folder: Path | None = None) -> Path:
    """Write what was measured; the file that has it."""
    data: dict[str, Any] = {
        "case": case.id,
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "code": source_code.source_of(case.reference),
        "inputs": case.inputs().model_dump(),
        "parts": [
            {"h": part.h, "values": dict(part.values), "u_it": dict(part.u_it),
             "arrays": {name: array.tolist() for name, array in part.arrays.items()}}
            for part in parts
        ],
    }  # fmt: skip
    path = (folder or FOLDER) / f"{case.id}.json"
    text = json.dumps(data, indent=1, allow_nan=False)
    write_whole(path, lambda file: file.write(text.encode("utf-8") + b"\n"))
    return path
