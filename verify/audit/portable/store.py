"""Results of the variants on disk, which count while the code and the machine stand."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from functools import lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from verify.audit.mutation.digest import digest
from verify.audit.mutation.tracing import ROOT
from verify.audit.portable.moving import Record
from verify.core.files import write_whole
from verify.jobs import cache

FILE = "rows.json"
SOURCES = ("analytic", "fem", "meshes", "verify")
DATA = ("verify/papers", "verify/measured")
LIBRARIES = (*cache.LIBRARIES, *cache.ALONE.values())


@dataclass(frozen=True, kw_only=True)
class CaseRecord:
    """The rows of one case on one machine, and the seconds that they took there.

    `fixed` are inputs that could not be perturbed, `rejected` says why none could, `errors` counts
    what went wrong inside the case.
    """

    rows: tuple[Record, ...]
    seconds: float
    fixed: tuple[str, ...] = ()
    rejected: str = ""
    errors: int = 0


@dataclass
class Results:
    """What one variant has found: its cases, and the row tests that failed, None if not run."""

    key: str
    cases: dict[str, CaseRecord] = field(default_factory=dict)
    effective: Mapping[str, Any] = field(default_factory=dict)
    row_tests: list[str] | None = None


def key_of(effective: Mapping[str, Any], seed: int | None) -> str:
    """Hexadecimal name of a variant's results: code, data, libraries, machine and seed."""
    libraries = [f"{name} {version(name)}" for name in LIBRARIES]
    parts = [_code(), *libraries, json.dumps(effective, sort_keys=True), str(seed)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


@lru_cache(1)
def _code() -> str:
    files = (path for folder in DATA for path in sorted((ROOT / folder).iterdir()))
    return digest(*SOURCES, *(str(path.relative_to(ROOT)) for path in files if path.is_file()))


def load(folder: Path, key: str) -> Results:
    """The results in a folder, without any case where there are none for this key."""
    try:
        data = json.loads((folder / FILE).read_text("utf-8"))
        if data["key"] == key:
            cases = {name: _case(one) for name, one in data["cases"].items()}
            return Results(key, cases, data["effective"], data["row_tests"])
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        pass  # absent, of a run that was killed, or of an older form
    return Results(key)


def save(folder: Path, results: Results) -> None:
    """Write the results so that no reader sees half of them; OSError where there is no room."""
    text = json.dumps(asdict(results), ensure_ascii=False, separators=(",", ":"))
    text = text.replace('},{"id"', '},\n{"id"') + "\n"
    write_whole(folder / FILE, lambda file: file.write(text.encode("utf-8")))


def _case(data: Mapping[str, Any]) -> CaseRecord:
    names = {one.name for one in fields(CaseRecord)} - {"rows"}
    rows = tuple(Record(**row) for row in data["rows"])
    found = {name: data[name] for name in names}
    return CaseRecord(rows=rows, **(found | {"fixed": tuple(found["fixed"])}))
