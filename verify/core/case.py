"""Definition of a case: inputs, formulas, reference, and the checks that compare them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Protocol

from numpy.typing import NDArray

from verify.core.figures import Equation, Field, Figure, Picture, Sketch, Table
from verify.core.inputs import Inputs
from verify.core.references import Method
from verify.core.results import Row

Values = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class FemResult:
    """Finite-element values of one level, in SI units.

    `h` is the mesh size relative to a constant length. `u_it` are the uncertainties of single
    values due to iteration or round-off. `arrays` are data for later checks.
    """

    h: float
    values: Values
    u_it: Values = field(default_factory=dict)
    arrays: Mapping[str, NDArray[Any]] = field(default_factory=dict)
    fields: tuple[Field, ...] = ()


@dataclass(frozen=True)
class Context:
    """Data for a check.

    `fem` contains the levels from coarse to fine; it is empty if no level was computed.
    """

    case: str
    inputs: Any
    analytic: Values
    fem: Sequence[FemResult]
    is_paper: bool  # printed numbers apply only to the paper's inputs

    @property
    def converging(self) -> bool:
        """Whether there are enough levels to estimate the uncertainty of the finest level."""
        return len(self.fem) >= 3

    def series(self, key: str) -> tuple[list[float], list[float]]:
        """Mesh sizes and finite-element values of `key`, from coarse to fine."""
        return [r.h for r in self.fem], [r.values[key] for r in self.fem]


class Check(Protocol):
    """One claim of a case; `rows` returns the judged rows (see `verify.judging.checks`)."""

    @property
    def paper_only(self) -> bool: ...

    @property
    def needs_fem(self) -> bool: ...

    def rows(self, context: Context) -> list[Row]: ...

    def skipped(self, case: str, reason: str) -> list[Row]: ...


@dataclass(frozen=True, kw_only=True)
class Output:
    """A value of the formulas that `check` prints.

    `judged` is True if a row compares it with finite elements. The last four fields are the same as
    in `verify.form.quantity.Quantity`.
    """

    key: str
    symbol: str
    unit: str
    what: str
    judged: bool = True
    equation: str = ""
    source: str = ""
    form: str = ""
    safe: str = ""

    @property
    def label(self) -> str:
        """Name of the value, with the addition "as printed" if `form` is "as printed"."""
        return f"{self.what}, as printed" if self.form == "as printed" else self.what


@dataclass(frozen=True, kw_only=True)
class Dynamic:
    """Part of a case that only `check --dynamic` computes: a simulation in time.

    `run(inputs, values)` receives the values of the formulas and returns further values in SI
    units; it imports compiled code in its body. The other functions receive the inputs and all
    values. Without a solution, each of them raises ArithmeticError or ValueError with a message of
    one line. `overall` returns the common verdict of formulas and simulation, and the findings that
    replace the first finding of the formulas.
    """

    run: Callable[[Any, Values], Values]
    outputs: tuple[Output, ...]
    what: str = "the motion in time"
    findings: Callable[[Any, Values], Sequence[str]] = lambda _inputs, _values: ()
    summary: Callable[[Any, Values], Mapping[str, Any]] = lambda _inputs, _values: {}
    figures: Callable[[Any, Values], Sequence[Figure]] = lambda _inputs, _values: ()
    overall: Callable[[Any, Values], tuple[str, Sequence[str]]] | None = None


@dataclass(frozen=True, kw_only=True)
class Portion:
    """Some finite-element values of a case, computed faster than all; for sweeps of few rows.

    `fem(inputs, level)` returns the values `keys`, which are equal to those of `fem` of the case on
    the same mesh. `levels` are at least three levels, from coarse to fine.
    """

    name: str
    fem: Callable[[Any, int], FemResult]
    levels: tuple[int, ...]
    keys: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Scan:
    """Region around the default inputs in which the formulas of a case are compared for the report.

    `vary` are axes in the form of `freewheel sweep`, such as "z=3:12:4". `only` are parts of the
    names of the rows to compare (empty: all rows). With `star`, one input at a time is varied
    instead of all combinations. `at` gives other inputs a value other than the default, such as
    "e=2mm".
    """

    vary: tuple[str, ...]
    only: tuple[str, ...] = ()
    star: bool = False
    at: tuple[str, ...] = ()


def _unknown(case_id: str) -> "Case":
    """Raise ValueError: in this process, no cases are registered."""
    raise ValueError(f"unknown case {case_id!r}")


@dataclass(frozen=True, kw_only=True)
class Case:
    """One subject of one paper, with its formulas, its reference and its checks.

    `analytic(inputs)` and `reference(inputs, level)` share no code. `reference` imports meshes and
    fem in its body, so that formulas can be evaluated without loading them; `method` is the name of
    the reference. `levels` are from coarse to fine.
    """

    finder: ClassVar[Callable[[str], "Case"]] = staticmethod(_unknown)  # the registry sets it

    id: str
    title: str
    paper: str
    place: str
    lead: str
    inputs: type[Inputs]
    analytic: Callable[[Any], Values]
    reference: Callable[[Any, int], FemResult]
    levels: tuple[int, ...]
    checks: Sequence[Check]
    outputs: Sequence[Output]
    readings: tuple[str, ...] = ()
    assumptions: tuple[str, ...] = ()
    method: Method = Method()  # noqa: RUF009 - frozen
    # conclusions for the user, in words, the verdict first
    findings: Callable[[Any, Values], Sequence[str]] = lambda _inputs, _values: ()
    # the same for programs, as JSON in addition to the values
    summary: Callable[[Any, Values], Mapping[str, Any]] = lambda _inputs, _values: {}
    warnings: Callable[[Any, Values], Sequence[str]] = lambda _inputs, _values: ()
    equations: Callable[[Any, Values], Sequence[Equation]] = lambda _inputs, _values: ()
    tables: Callable[[Context], Sequence[Table]] = lambda _context: ()
    too_large: Callable[[Any], str] = lambda _inputs: ""  # reason of a refusal
    sketch: Callable[[Any], Sketch | None] = lambda _inputs: None
    figures: Callable[[Context], Sequence[Figure]] = lambda _context: ()
    pictures: Callable[[Any], Sequence[Picture]] = lambda _inputs: ()
    dynamic: Dynamic | None = None
    portions: tuple[Portion, ...] = ()
    scans: tuple[Scan, ...] = ()
    file: Path | None = None  # that declares it, of a case outside the suite that has no name

    @property
    def named(self) -> str:
        """Name of the case in commands: its id, or the name of its file."""
        return self.file.name if self.file else self.id
