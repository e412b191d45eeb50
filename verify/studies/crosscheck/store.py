"""Stored results of second solvers; a record is valid for unchanged code."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path

from verify.cases.registry import find
from verify.core import source_code
from verify.jobs.records import Record, Records, today
from verify.studies.crosscheck.statement import CALCULIX, Cross

RECORDS = Records("crosscheck")
HERE = Path(__file__).parent
DIGITS = 9  # significant, of numbers of both sides


@dataclass(frozen=True, kw_only=True)
class Found:
    """Result of one comparison: quantities of both solvers [SI], times [s], number of unknowns."""

    solver: str
    version: str
    date: str
    ours: Mapping[str, float]
    theirs: Mapping[str, float]
    seconds: tuple[float, float]
    unknowns: int


def code_of(cross: Cross) -> str:
    """Hash of all data and code on which the compared quantities of `cross` depend.

    It includes the project's solver, the code that writes the deck and reads its results, the
    inputs of the case, and the names of the rows.
    """
    pose = getattr(cross.pose, "func", cross.pose)
    case = find(cross.case)
    parts = [
        source_code.source_of(pose), source_code.source_of(case.reference),
        posing(cross.solver, pose.__module__), json.dumps(case.inputs().model_dump()), cross.id,
    ]  # fmt: skip
    parts += [f"{q.name} {q.row} {q.unit}" for q in cross.quantities]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


@lru_cache(64)
def posing(solver: str, module: str) -> str:
    """Hash of the code that writes decks and reads results, without comments and layout."""
    here = __package__
    if solver == CALCULIX:
        shared = [f"{here}.comparisons.plane", f"{here}.comparisons.touching"]
        package = "calculix"
    else:
        shared, package = [f"{here}.rotors"], "external"
    files = [path.stem for path in (HERE / package).glob("*.py") if path.stem != "__init__"]
    own = f"{here}.comparisons.{module.rpartition('.')[2]}"
    return source_code.group_hash([own, *shared, *(f"{here}.{package}.{name}" for name in files)])


def found_of(
    cross: Cross, version: str, ours: Mapping[str, float], theirs: Mapping[str, float],
    seconds: tuple[float, float], unknowns: int,
) -> Found:  # fmt: skip
    return Found(
        solver=cross.solver, version=version, date=today(), ours=_short(cross, ours),
        theirs=_short(cross, theirs), seconds=(round(seconds[0], 3), round(seconds[1], 3)),
        unknowns=unknowns,
    )  # fmt: skip


def current(cross: Cross) -> Found | None:
    """Stored results of a comparison; None if the code has changed."""
    return RECORDS.current(cross.file, _made_by(cross), read)


def read(record: Record) -> Found:
    """Results of a comparison from its record."""
    values = dict(record.content)
    return Found(date=record.date, seconds=tuple(values.pop("seconds")), **values)


def keep(cross: Cross, found: Found) -> None:
    """Store the results of a comparison.

    Raises OSError if the record cannot be written.
    """
    content = {name: value for name, value in asdict(found).items() if name != "date"}
    RECORDS.keep(cross.file, _made_by(cross), content)


def _made_by(cross: Cross) -> dict[str, str]:
    return {"code": code_of(cross)}


def _short(cross: Cross, values: Mapping[str, float]) -> dict[str, float]:
    return {q.name: float(f"{values[q.name]:.{DIGITS}g}") for q in cross.quantities}
