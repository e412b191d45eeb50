"""Data types of the results of a run, without computation or drawing; reports read them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from verify.core.figures import (
    Equation,
    Field,
    Figure,
    FormulaValue,
    InputValue,
    Picture,
    Sketch,
    Table,
)
from verify.core.verdicts import FormulaVerdict, Safe

NAME = "name"  # aspect of a change of the name of a row alone
SCHEMA_VERSION = 2  # version 1 had other names of rows (verify/cases/renamed.toml)

FE = "FE"  # finite elements, as method of a reference


class Kind(StrEnum):
    """Kind of claim of a row; `verify.judging.judge` states when each kind passes."""

    IDENTITY = "identity"
    ASYMPTOTIC = "asymptotic"
    APPROXIMATION = "approximation"
    TREND = "trend"
    FACT = "fact"
    EXACT = "exact"


class Status(StrEnum):
    """Status of a judged row; the members are in order from worst to best."""

    FAIL = "FAIL"
    SKIP = "SKIP"
    NOTE = "NOTE"
    CALIBRATED = "CALIBRATED"
    SHOWN = "SHOWN"
    PASS = "PASS"  # noqa: S105 - not a password


@dataclass(frozen=True, kw_only=True)
class Published:
    """A published value that is displayed with a row, in the unit of the row."""

    document: str
    id: str
    place: str
    kind: str
    printed: str
    value: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Partner:
    """Value of a row from neither the formula nor finite elements; `by` names its origin."""

    by: str
    value: float


@dataclass(frozen=True, kw_only=True)
class Grid:
    """Convergence of finite-element levels, and the data of their grid convergence index.

    `levels` are pairs of relative mesh size and value, from coarse to fine. If there is an order,
    the index is gci = factor |v3 - v2|/(r^used - 1). All fields except the orders and `factor` are
    in `unit`. `scale` is the scale of round-off. `allowed` is the limit of the index for a series
    without an order.
    """

    unit: str
    levels: tuple[tuple[float, float], ...]
    scale: float
    allowed: float
    behaviour: str
    gci: float
    u_it: float
    order: float | None = None
    formal: float | None = None
    used: float | None = None
    factor: float | None = None


@dataclass(frozen=True, kw_only=True)
class Row:
    """One judged comparison.

    Dimensional numbers are in `unit`. `detects` is the smallest relative change that is certain to
    make the row fail, `demand` the largest value of `detects` that is permitted. `method` is that
    of the reference `fem`. `interval` is the expected signed model error of an approximation.
    `levels` are the values of the reference by mesh size, from coarse to fine. `levels_u` are their
    standard uncertainties, if a limit is fitted.

    For approximations and printed numbers, `difference` is formula minus reference. For all other
    identities, for trends and for limits, it is reference minus formula, because the reference is
    judged by the formula. For a balance it is the residual, and for a fact the margin.
    `verify.core.differences.offset` is formula minus reference for all rows.

    `formula` is the key of the judged value of the case, `equation` its number in the paper or its
    source, `form` the form of the formula, and `safe` the safe side of its error. `shares` are
    assumptions and data that formula and reference have in common in addition to the inputs.
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
    method: str = FE
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
    grid: Grid | None = None
    levels_u: tuple[float, ...] = ()
    formula: str = ""
    equation: str = ""
    form: str = ""
    safe: str = ""
    shares: str = ""

    @property
    def id(self) -> str:
        """Id of the row, `case/quantity`, unique in a run."""
        return f"{self.case}/{self.quantity}"

    @property
    def by(self) -> str:
        """Name of the method that gave the reference value: FE, or the method of the partner."""
        return FE if self.partner is None or self.fem is not None else self.partner.by

    @property
    def reference(self) -> float | None:
        """Value with which the formula is compared: that of finite elements, or of the partner."""
        return self.fem if self.fem is not None or self.partner is None else self.partner.value


@dataclass(frozen=True, kw_only=True)
class CaseResult:
    """All results of one case; `name` is the name of the user's parameters, if any.

    `refused` is the reason why finite elements cannot solve these inputs; it is empty if they were
    solved. `findings` are conclusions from the formulas in words, with the verdict first. `errors`
    are the tracebacks of errors inside the case. `cells` are the numbers of cells of the `fields`,
    by name.
    """

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
    fields: Sequence[Field] = ()
    warnings: tuple[str, ...] = ()
    sketch: Sketch | None = None
    values: tuple[FormulaValue, ...] = ()
    figures: tuple[Figure, ...] = ()
    pictures: tuple[Picture, ...] = ()
    name: str = ""
    findings: tuple[str, ...] = ()
    refused: str = ""
    seconds: float = 0.0
    cached: bool = False
    command: str = ""
    errors: tuple[str, ...] = ()
    cells: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class PaperClaim:
    """A judged row that uses a printed number; its values are in the unit of this number.

    `u` is the uncertainty of the finite-element value.
    """

    row: str
    status: Status
    analytic: float | None
    fem: float | None
    u: float | None


@dataclass(frozen=True, kw_only=True)
class PaperCell:
    """A cell of a printed table; for a number, `value` is its key ("paper:id").

    `inputs` are the inputs of cases whose default is this number, `rows` the judged rows that use
    the number, and `errata` the ids of errata of the paper that concern it.
    """

    text: str
    value: str | None = None
    unit: str = ""
    inputs: tuple[str, ...] = ()
    rows: tuple[PaperClaim, ...] = ()
    errata: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class PaperTable:
    """A table as printed in a paper; if the table has no `rows`, `note` states the reason."""

    paper: str
    name: str
    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[PaperCell, ...], ...]
    note: str = ""
    errata: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class ValidityAxis:
    """An input that was varied, with its values and its nominal value in `unit`."""

    name: str
    symbol: str
    unit: str
    values: tuple[float, ...]
    nominal: float | None
    log: bool = False  # spaced in equal ratios


@dataclass(frozen=True, kw_only=True)
class ValidityLimit:
    """Region in which the error of a formula is within `limit`.

    Points are counted as inside, outside or undecided. `words` describes the largest box whose
    points are all inside, including their error bars; for a star (one input varied at a time), it
    describes the range of each input alone. `box` contains the ranges: the name of an input and two
    values in its unit.
    """

    limit: float
    inside: int
    outside: int
    undecided: int
    words: str
    box: tuple[tuple[str, float, float], ...] = ()


@dataclass(frozen=True, kw_only=True)
class ValidityRegion:
    """Measured relative errors (points,) of a formula over some inputs, and their error bars.

    The errors are on a grid of one or two `axes`, with the last index varying fastest. For a star
    (one input varied at a time), they are on the axis along which the error changes most. `breaks`
    states at which value of which input the error first exceeds the second of the `limits`.
    """

    over: str
    points: int
    unsolved: int
    problems: tuple[str, ...]
    limits: tuple[ValidityLimit, ...]
    breaks: str
    axes: tuple[ValidityAxis, ...] = ()
    error: tuple[float, ...] = ()
    U: tuple[float, ...] = ()


@dataclass(frozen=True, kw_only=True)
class ValidityCard:
    """Range of validity of one formula.

    `error` and `U` are those of its row at the default inputs. `tex` is the formula, if the case
    states it; `place` is its place in the paper.
    """

    case: str
    quantity: str
    symbol: str
    place: str
    tex: str
    error: float | None
    U: float | None
    regions: tuple[ValidityRegion, ...]


@dataclass(frozen=True, kw_only=True)
class ValidityExact:
    """A formula with its largest difference from finite elements that solve the same problem.

    `U` is the error bar of the point with this difference; both are relative. They are None if no
    point was solved.
    """

    quantity: str
    symbol: str
    largest: float | None
    U: float | None
    points: int
    unsolved: int


@dataclass(frozen=True, kw_only=True)
class Validity:
    """Ranges of validity of the formulas of one case.

    `missing` is the reason if nothing was measured. `over` describes the range over which the exact
    formulas were compared. `others` are the formulas that were not measured, and `maps` the cases
    with further maps of the formulas.
    """

    case: str
    title: str
    subject: str
    date: str = ""
    missing: str = ""
    cards: tuple[ValidityCard, ...] = ()
    exact: tuple[ValidityExact, ...] = ()
    over: str = ""
    others: tuple[str, ...] = ()
    maps: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class ScaleInput:
    """A factor in the divisor of a ratio: an input (default `own` [`unit`]), raised to `power`."""

    name: str
    symbol: str
    unit: str
    own: float
    power: float


@dataclass(frozen=True, kw_only=True)
class StudyAxis:
    """An input that a study varies; `own` is its nominal value in `unit`.

    With `log`, successive values of the input have equal ratios. `ratio` is the symbol of a
    dimensionless ratio: `factor` times the value of the input, divided by the product of the inputs
    `per` to their powers; it is empty if no ratio is declared. `scales` states whether a part of
    another size, with all inputs in proportion, has the same error at the same ratios.
    """

    name: str
    symbol: str
    unit: str
    what: str
    own: float
    log: bool = False
    whole: bool = False
    ratio: str = ""
    factor: float = 1.0
    per: tuple[ScaleInput, ...] = ()
    scales: bool = False


@dataclass(frozen=True, kw_only=True)
class StudiedFormula:
    """Relative errors of a formula at the points of a study, with error bars.

    An error is NaN if `problems` states why there is none. `by` is the name of the reference. `of`
    is the name of the magnitude to which errors are related, empty for the reference. `is_positive`
    states whether the reference is positive at the default inputs.
    """

    quantity: str
    symbol: str
    by: str
    of: str
    safe: Safe
    is_positive: bool
    error: tuple[float, ...]
    U: tuple[float, ...]
    problems: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class StoredStudy:
    """A stored study: `points` in the units of the axes, and the formulas compared at these points.

    A star varies one input at a time, starting from the default values in its first point; a grid
    contains all combinations. `held` describes the constant inputs that do not have default values;
    `at` contains their names and values in the units of the case.
    """

    case: str
    date: str
    is_star: bool
    over: str
    held: str
    at: tuple[tuple[str, float], ...]
    axes: tuple[StudyAxis, ...]
    points: tuple[tuple[float, ...], ...]
    formulas: tuple[StudiedFormula, ...]


class CrossState(StrEnum):
    """Result of a comparison with a second solver."""

    AGREES = "agrees"
    OUTSIDE = "outside"  # the difference exceeds the allowed one
    MISSING = "not measured"
    ALONE = "no second solver"


@dataclass(frozen=True, kw_only=True)
class Crosscheck:
    """One quantity, computed by the project and by a second solver with the same mesh and loads.

    `ours` and `theirs` are in `unit`. `difference` (theirs divided by ours, minus one) and
    `allowed` are relative. `why` is the cause of a difference, or the reason why nothing was
    measured or why no second solver can solve the problem. `row` is the id of the row to which the
    number belongs, if any. `seconds` are the run times of the project and of the second solver.
    """

    case: str
    problem: str
    what: str
    quantity: str
    row: str
    symbol: str
    unit: str
    solver: str
    state: CrossState
    version: str = ""
    date: str = ""
    ours: float | None = None
    theirs: float | None = None
    difference: float | None = None
    allowed: float | None = None
    why: str = ""
    seconds: tuple[float, ...] = ()
    unknowns: int = 0


@dataclass(frozen=True, kw_only=True)
class Change:
    """A change of a row since a release: its `aspect` changed from the text `was` to `now`.

    `size` is the change of the value. A loosened requirement or interval needs a stated `reason`.
    """

    row: str
    aspect: str
    was: str
    now: str
    size: str = ""
    loosened: bool = False
    reason: str = ""


@dataclass(frozen=True, kw_only=True)
class Drift:
    """Changes of rows since a `release`.

    `compared` is the number of rows that exist in both versions, `tightened` the number of those
    rows with stricter requirements. `tighter` contains the stricter requirements and intervals.
    """

    release: str
    date: str
    commit: str
    compared: int
    tightened: int
    changes: tuple[Change, ...] = ()
    tighter: tuple[Change, ...] = ()
    unused: tuple[str, ...] = ()  # reasons stated since the release that no change needs

    @property
    def unexplained(self) -> tuple[Change, ...]:
        """Changes that loosen a requirement without a stated reason; they prevent a release."""
        return tuple(c for c in self.changes if c.loosened and not c.reason)


@dataclass(frozen=True, kw_only=True)
class ReadingsTried:
    """A printed number, the formula's value by the first reading, and a search for other readings.

    `hits` combinations of readings give the number; `readings` is the best combination, with its
    `value`, and is empty if there is none. Among the combinations with at most as many changes as
    the best, `chance` is the expected number of those that give the number by chance. If nothing
    was tried, `missing` is the reason. `reference` is the key of the number or of the erratum,
    "paper:id".
    """

    reference: str
    place: str
    printed: str
    unit: str
    what: str = ""
    as_it_stands: float | None = None
    met: bool = False
    tried: int = 0
    hits: int = 0
    readings: tuple[str, ...] = ()
    value: float | None = None
    chance: float = 0.0
    is_evidence: bool = False
    errata: tuple[str, ...] = ()
    missing: str = ""


@dataclass(frozen=True, kw_only=True)
class BudgetPart:
    """Contribution of one cause to a relative difference, from a computation without this cause.

    `u` is the half-width of the uncertainty of `contribution`. Both are None if there was no such
    computation; `note` then states the reason. A cause `shared` by formula and finite elements is
    no part of their difference and is not subtracted from it.
    """

    cause: str
    what: str
    contribution: float | None
    u: float | None
    shared: bool = False
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class BudgetJoint:
    """Effect of removing two causes together, minus the sum of their single effects.

    `value` is None if it was not computed.
    """

    causes: tuple[str, str]
    value: float | None
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class RowBudget:
    """Components of the difference (formula - FE)/scale of a row, all relative.

    `remainder` is `total` minus the parts; `u` is the half-width of its uncertainty. `U` is the
    expanded numerical uncertainty of the row. For an identity, `within` states whether the
    remainder is within the tolerance of the row or within 2 `u`. `headline` rows are drawn. `apart`
    states whether computations explain a large difference; if not, `why` gives the reason.
    """

    quantity: str
    symbol: str
    kind: Kind
    total: float
    U: float | None
    parts: tuple[BudgetPart, ...]
    joints: tuple[BudgetJoint, ...]
    remainder: float
    u: float
    within: bool | None = None
    headline: bool = False
    apart: bool = True
    why: str = ""


@dataclass(frozen=True, kw_only=True)
class CaseBudget:
    """Error budgets of the rows of one case; `missing` is the reason if nothing was measured.

    `seconds` is the total time of its computations on one processor.
    """

    case: str
    title: str
    date: str = ""
    seconds: float = 0.0
    missing: str = ""
    rows: tuple[RowBudget, ...] = ()


@dataclass(frozen=True, kw_only=True)
class MutantGroup:
    """Numbers of mutants of one group.

    `all` counts all mutants, `apart` those that crashed or timed out, `tried` all other tested
    mutants. Of the latter, `rows` or `tests` count those that a row or a test detects, and
    `survived` those that were not detected.
    """

    name: str
    all: int
    tried: int
    rows: int
    tests: int
    survived: int
    apart: int

    @property
    def caught(self) -> int:
        """Number of mutants that a row or a test detects."""
        return self.rows + self.tests


@dataclass(frozen=True, kw_only=True)
class Survivor:
    """A mutant that was not detected; `reason` states why no check can detect it, or is empty."""

    group: str
    where: str
    line: int
    operator: str
    before: str
    after: str
    reason: str = ""


@dataclass(frozen=True, kw_only=True)
class Caught:
    """Numbers of inserted faults (mutants) that the suite detects, and the mutants not detected.

    If nothing was measured, `missing` is the reason. `references` contains the shares of rows that
    fail if their references are changed. `stale` lists the groups that were not measured for this
    code.
    """

    date: str = ""
    missing: str = ""
    stale: tuple[str, ...] = ()
    groups: tuple[MutantGroup, ...] = ()
    survivors: tuple[Survivor, ...] = ()
    references: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Report:
    """A complete run: judged cases, ledgers, and the origin of the numbers.

    `name` is the name of a user's parameter file; it is empty for the default inputs of the cases.
    """

    cases: tuple[CaseResult, ...]
    papers: tuple[Mapping[str, Any], ...]
    equations: tuple[Mapping[str, Any], ...]
    errata: tuple[Mapping[str, Any], ...]
    published: tuple[Mapping[str, Any], ...]
    provenance: Mapping[str, Any]
    tables: tuple[PaperTable, ...] = ()
    name: str = ""
    validity: tuple[Validity, ...] = ()
    studies: tuple[StoredStudy, ...] = ()
    drift: Drift | None = None
    searches: tuple[ReadingsTried, ...] = ()
    budgets: tuple[CaseBudget, ...] = ()
    crosschecks: tuple[Crosscheck, ...] = ()
    caught: Caught | None = None
    verdicts: tuple[FormulaVerdict, ...] = ()

    @property
    def has_ledgers(self) -> bool:
        """Whether the run reports on the papers (not on parameters or cases of a user)."""
        return not self.name and any(paper["title"] for paper in self.papers)

    @property
    def rows(self) -> tuple[Row, ...]:
        """All rows in the order of the cases."""
        return tuple(row for case in self.cases for row in case.rows)

    def count(self, status: Status) -> int:
        """Number of rows with a status."""
        return sum(row.status is status for row in self.rows)
