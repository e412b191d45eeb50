"""Value types that a run produces and reports read. Nothing here computes or draws."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

SCHEMA_VERSION = 1

Array = NDArray[np.float64]


class Kind(StrEnum):
    """What a row claims; see `verify.judge` for when each passes."""

    IDENTITY = "identity"
    ASYMPTOTIC = "asymptotic"
    APPROXIMATION = "approximation"
    TREND = "trend"
    FACT = "fact"
    EXACT = "exact"


class Status(StrEnum):
    """How a row was judged, worst first."""

    FAIL = "FAIL"
    SKIP = "SKIP"
    NOTE = "NOTE"
    CALIBRATED = "CALIBRATED"
    SHOWN = "SHOWN"
    PASS = "PASS"  # noqa: S105 - not a password


@dataclass(frozen=True, kw_only=True)
class Published:
    """A printed value beside a row, in the row's unit."""

    document: str
    id: str
    place: str
    kind: str
    printed: str
    value: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Partner:
    """A value that is neither the formula nor the finite-element one."""

    by: str
    value: float


@dataclass(frozen=True, kw_only=True)
class Row:
    """One judged comparison. Dimensional numbers are in `unit`; `detects`, `demand` are relative.

    `difference` is value minus reference; `interval` holds the expected signed model error of an
    approximation; `levels` the finite-element values by mesh size, coarse to fine.
    """

    case: str
    quantity: str
    symbol: str
    unit: str
    kind: Kind
    status: Status
    reason: str = ""
    analytic: float | None = None
    fem: float | None = None
    partner: Partner | None = None
    difference: float | None = None
    scale: float | None = None
    scale_name: str = ""
    demand: float | None = None
    demand_reason: str = ""
    u_num: float | None = None
    u_ref: float | None = None
    u_input: float | None = None
    order: float | str | None = None
    formal_order: float | None = None
    tolerance: float | None = None
    detects: float | None = None
    interval: tuple[float, float] | None = None
    interval_source: str = ""
    levels: tuple[tuple[float, float], ...] = ()
    published: tuple[Published, ...] = ()

    @property
    def id(self) -> str:
        """`case/quantity`, unique in a run."""
        return f"{self.case}/{self.quantity}"


@dataclass(frozen=True, kw_only=True)
class Field:
    """A solved mesh for pictures and files: `points` (n, 2 or 3), `cells` (m, corners) and data."""

    name: str
    points: Array
    cells: NDArray[np.int64]
    point_data: Mapping[str, Array] = field(default_factory=dict)
    cell_data: Mapping[str, Array] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table to print as it stands; cells are strings or numbers."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str | float | None, ...], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Equation:
    """An equation as TeX and the same with numbers put in."""

    tex: str
    numbers: str = ""
    place: str = ""


@dataclass(frozen=True, kw_only=True)
class InputValue:
    """One input in its display unit."""

    name: str
    symbol: str
    what: str
    value: float | int | str
    unit: str


@dataclass(frozen=True, kw_only=True)
class CaseResult:
    """Everything that one case produced."""

    id: str
    title: str
    paper: str
    place: str
    lead: str
    inputs: tuple[InputValue, ...]
    equations: tuple[Equation, ...]
    assumptions: tuple[str, ...]
    readings: tuple[str, ...]
    rows: tuple[Row, ...]
    tables: tuple[Table, ...] = ()
    fields: tuple[Field, ...] = ()
    warnings: tuple[str, ...] = ()
    sketch: Mapping[str, Any] = field(default_factory=dict)
    seconds: float = 0.0
    cached: bool = False
    command: str = ""


@dataclass(frozen=True, kw_only=True)
class Report:
    """A whole run: judged cases, the ledgers and where the numbers come from."""

    cases: tuple[CaseResult, ...]
    papers: tuple[Mapping[str, Any], ...]
    equations: tuple[Mapping[str, Any], ...]
    errata: tuple[Mapping[str, Any], ...]
    published: tuple[Mapping[str, Any], ...]
    provenance: Mapping[str, Any]

    @property
    def rows(self) -> tuple[Row, ...]:
        """All rows in the order of the cases."""
        return tuple(row for case in self.cases for row in case.rows)

    def count(self, status: Status) -> int:
        """Rows of one status."""
        return sum(row.status is status for row in self.rows)
