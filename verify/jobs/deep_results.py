"""Results of computations that take hours, stored in the project and valid for unchanged code.

A deep case is a `Case` without rows: its levels are parts of a larger computation at the default
inputs. Each part is solved and cached like any level: an interrupted run can be continued.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from verify.core import source_code
from verify.core.case import Case, FemResult
from verify.jobs.records import Record, Records

RECORDS = Records("deep")


@dataclass(frozen=True)
class Measured:
    """Results of all levels of a case, in the order of the levels, and the date of computation."""

    date: str
    parts: tuple[FemResult, ...]


def measured(case: Case) -> Measured | None:
    """Stored results of `case`; None if they are not from the present code and inputs."""
    return RECORDS.current(case.id, _made_by(case), _measured)


def keep(case: Case, parts: Sequence[FemResult]) -> Path:
    """Store the results of all levels of `case`; return the path of the file."""
    return RECORDS.keep(case.id, _made_by(case), [
        {"h": part.h, "values": dict(part.values), "u_it": dict(part.u_it),
         "arrays": {name: array.tolist() for name, array in part.arrays.items()}}
        for part in parts
    ])  # fmt: skip


def _made_by(case: Case) -> dict[str, Any]:
    return {"code": source_code.source_of(case.reference), "inputs": case.inputs().model_dump()}


def _measured(record: Record) -> Measured:
    return Measured(record.date, tuple(
        FemResult(
            h=part["h"], values=part["values"], u_it=part["u_it"],
            arrays={name: np.array(array) for name, array in part["arrays"].items()},
        )
        for part in record.content
    ))  # fmt: skip
