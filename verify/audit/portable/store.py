"""Stored results of the emulated machines, valid for unchanged code and machine."""

import hashlib
import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field, fields
from functools import lru_cache
from importlib.metadata import version
from typing import Any

from verify.audit.mutation.digest import digest
from verify.audit.mutation.tracing import ROOT
from verify.audit.portable.moving import Record
from verify.core.store import Store
from verify.jobs import cache

KIND = "portable"  # of entries: their subject is the variant
MACHINE = "(machine)"  # of no case
SOURCES = ("analytic", "fem", "meshes", "verify")
DATA = ("verify/papers", "verify/measured/deep")  # data of the rows
LIBRARIES = (*cache.LIBRARIES, *cache.ALONE.values())


@dataclass(frozen=True, kw_only=True)
class CaseRecord:
    """Rows of one case on one machine, and the computation time [s].

    `fixed` lists inputs that could not be perturbed. `rejected` is the reason if no input could be
    perturbed. `errors` is the number of errors in the case.
    """

    rows: tuple[Record, ...]
    seconds: float
    fixed: tuple[str, ...] = ()
    rejected: str = ""
    errors: int = 0


@dataclass
class Results:
    """Results of one emulated machine: its cases, and the settings in effect."""

    cases: dict[str, CaseRecord] = field(default_factory=dict)
    effective: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Place:
    """Place of the stored results of a machine: store, name, and key of code and machine."""

    store: Store
    variant: str
    key: str

    def results(self) -> Results:
        """Stored results with this key.

        Raises OSError if the store cannot be read.
        """
        found: dict[str, Any] = {}
        for name, content in self.store.all(KIND, self.variant).items():
            part = name.removeprefix(f"{self.variant} {self.key} ")
            with suppress(ValueError, LookupError, TypeError, AttributeError):  # of an older form
                if part != name:
                    data = json.loads(content)
                    found[part] = data if part == MACHINE else _case(data)
        machine = found.pop(MACHINE, {})
        return Results(found, machine)

    def keep(self, part: str, data: Any) -> None:
        """Store one part: the record of a case (`part` is its id), or the settings (MACHINE).

        Raises OSError if the record cannot be written.
        """
        plain = asdict(data) if isinstance(data, CaseRecord) else data
        content = json.dumps(plain, ensure_ascii=False).encode()
        self.store.store(KIND, self.variant, {f"{self.variant} {self.key} {part}": content})


def key_of(effective: Mapping[str, Any], seed: int | None) -> str:
    """Hexadecimal key of a machine's results, from code, data, libraries, settings and seed."""
    libraries = [f"{name} {version(name)}" for name in LIBRARIES]
    parts = [_code(), *libraries, json.dumps(effective, sort_keys=True), str(seed)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


@lru_cache(1)
def _code() -> str:
    files = (path for folder in DATA for path in sorted((ROOT / folder).iterdir()))
    return digest(*SOURCES, *(str(path.relative_to(ROOT)) for path in files if path.is_file()))


def _case(data: Mapping[str, Any]) -> CaseRecord:
    names = {one.name for one in fields(CaseRecord)} - {"rows"}
    rows = tuple(Record(**row) for row in data["rows"])
    found = {name: data[name] for name in names}
    return CaseRecord(rows=rows, **(found | {"fixed": tuple(found["fixed"])}))
