"""What second solvers found, as a small file of the project that counts while its code stands."""

import hashlib
import json
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from functools import lru_cache
from pathlib import Path
from typing import Any

from verify.cases.registry import find
from verify.core import source_code
from verify.core.files import write_whole
from verify.studies.crosscheck.statement import CALCULIX, Cross

FILE = Path(__file__).parents[2] / "measured" / "crosscheck.json"
HERE = Path(__file__).parent
DIGITS = 9  # significant, of numbers of both sides


@dataclass(frozen=True, kw_only=True)
class Found:
    """One comparison as it came out: numbers of both sides in SI units, seconds, unknowns."""

    id: str
    code: str
    solver: str
    version: str
    date: str
    ours: Mapping[str, float]
    theirs: Mapping[str, float]
    seconds: tuple[float, float]
    unknowns: int


def code_of(cross: Cross) -> str:
    """Hash of all that a comparison's numbers come from, at both sides.

    Sources of the project's own side, of what poses the problem and reads its answer, the case's
    inputs, and the rows that it stands beside.
    """
    pose = getattr(cross.pose, "func", cross.pose)
    case = find(cross.case)
    told = [
        source_code.source_of(pose), source_code.source_of(case.reference),
        posing(cross.solver, pose.__module__), json.dumps(case.inputs().model_dump()), cross.id,
    ]  # fmt: skip
    told += [f"{q.name} {q.row} {q.unit}" for q in cross.quantities]
    return hashlib.sha256("\0".join(told).encode()).hexdigest()[:16]


@lru_cache(64)
def posing(solver: str, module: str) -> str:
    """Hash of the code, without comments and layout, that writes decks and reads answers."""
    shared = HERE / "comparisons"
    files = [shared / f"{module.rpartition('.')[2]}.py"]
    if solver == CALCULIX:
        files += [shared / "plane.py", shared / "touching.py", *(HERE / "calculix").glob("*.py")]
    else:
        files += [HERE / "rotors.py", *(HERE / "external").glob("*.py")]
    told = sorted(source_code.text_hash(path.read_text("utf-8")) for path in files)
    return hashlib.sha256("\0".join(told).encode()).hexdigest()


def found_of(
    cross: Cross, version: str, ours: Mapping[str, float], theirs: Mapping[str, float],
    seconds: tuple[float, float], unknowns: int,
) -> Found:  # fmt: skip
    return Found(
        id=cross.id, code=code_of(cross), solver=cross.solver, version=version,
        date=time.strftime("%Y-%m-%d", time.gmtime()), ours=_short(cross, ours),
        theirs=_short(cross, theirs), seconds=(round(seconds[0], 3), round(seconds[1], 3)),
        unknowns=unknowns,
    )  # fmt: skip


def kept(file: Path | None = None) -> dict[str, Found]:
    """All that is kept, whatever code made it, by id; nothing where the file cannot be read."""
    names = {field.name for field in fields(Found)}
    try:
        data = json.loads((file or FILE).read_text("utf-8"))["comparisons"]
        made = [Found(**{k: v for k, v in one.items() if k in names}) for one in data]
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return {}
    return {one.id: one for one in made}


def current(cross: Cross, known: Mapping[str, Found]) -> Found | None:
    """What is kept of a comparison if its code still stands."""
    one = known.get(cross.id)
    return one if one is not None and one.code == code_of(cross) else None


def keep(found: Sequence[Found], file: Path | None = None) -> None:
    """Write what was found in the place of what is kept of the same comparisons; OSError."""
    together = kept(file) | {one.id: one for one in found}
    record: dict[str, Any] = {"comparisons": [asdict(together[k]) for k in sorted(together)]}
    text = json.dumps(record, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    text = text.replace('},{"id"', '},\n{"id"') + "\n"  # a line for each: what changed shows
    write_whole(file or FILE, lambda out: out.write(text.encode("utf-8")))


def _short(cross: Cross, values: Mapping[str, float]) -> dict[str, float]:
    return {q.name: float(f"{values[q.name]:.{DIGITS}g}") for q in cross.quantities}
