"""Data types of the verdicts of formulas (without computation)."""

from dataclasses import dataclass, field
from enum import StrEnum

# statement on errors that are only against the idealisation of the formula
SHARED = (
    "compared with a model that makes the same simplifications: the error against the real part is "
    "not known"
)


class Form(StrEnum):
    """Form of a formula to which a verdict applies."""

    PRINTED = "printed"
    CORRECTED = "corrected"


class Safe(StrEnum):
    """Side of the true value on which an estimate of a quantity leads to a safe design."""

    ABOVE = "above"  # a value above the true one
    BELOW = "below"  # a value below the true one
    NEITHER = "neither"


class Verdict(StrEnum):
    """Verdict on the use of a formula.

    `verify.verdicts.rule` derives it from errors; it is never set by a person.
    """

    EXACT = "exact"
    ACCURATE = "accurate"
    PART = "accurate in part of the range"
    CONSERVATIVE = "conservative"
    UNSAFE = "unsafe"
    WRONG = "wrong as printed"
    DEFINITION = "definition"
    UNVERIFIABLE = "cannot be verified"
    NONE = "no verdict"  # the evidence has failed, or was not run


@dataclass(frozen=True, kw_only=True)
class Side:
    """Range over which an input was varied, in `unit`.

    `ratio_ends` are the ends of the dimensionless `ratio`: `low` and `high`, each divided by powers
    of other inputs.
    """

    name: str
    symbol: str
    unit: str
    low: float
    high: float
    ratio: str = ""
    ratio_ends: tuple[float, ...] = ()


@dataclass(frozen=True, kw_only=True)
class DesignRange:
    """A range of an input over which engineers use a formula, according to `source`.

    `spanned` states whether a study of the case compares the formula over the whole range.
    """

    case: str
    words: str
    source: str
    side: Side
    spanned: bool


@dataclass(frozen=True, kw_only=True)
class VerdictRange:
    """Range in which the error of a formula is within `limit`: a description, and number of points.

    `over` are the varied inputs of the study of a case, `studied` their ranges, and `held` the
    constant inputs that differ from the default. `box` contains the ranges within the limit, one
    input at a time if `is_star`; it is empty if no point is within the limit. `interpolation` is
    the largest difference between the error at a point and a straight line between its neighbours;
    it is None if no point has two neighbours.
    """

    case: str
    limit: float
    words: str
    over: str
    box: tuple[Side, ...] = ()
    studied: tuple[Side, ...] = ()
    held: tuple[Side, ...] = ()
    is_star: bool = False
    inside: int
    points: int
    interpolation: float | None = field(default=None, compare=False)


@dataclass(frozen=True, kw_only=True)
class FormulaVerdict:
    """Verdict of one formula in one form, and its evidence; errors are relative.

    `source` cites the paper by first author and year. `error` and `U` are those of the row
    `worst_row` at the default inputs, which has the largest error. `above` and `below` are the
    largest errors of values that are too high and too low, over all points and including error
    bars. `within` is the accuracy class of the verdicts ACCURATE and PART.

    `is_of_part` is True if the formula is compared with a model of the real part, False if only
    with a model that makes the same simplifications. If it is compared with both, `model` states
    the error relative to the simplified model. `points` is the number of points of studies,
    `unsolved` the number of points without a solution. `own_only` are cases without a study, in
    which the formula is compared at the default inputs only.

    `misprint` is the change from the corrected to the printed value, None if no row has both.
    `caution` is a failure of the formula that the errors do not reveal; `caution_row` is the row
    that reveals it. `readings` is the range of the value for the readings that the paper leaves
    open.
    """

    id: str
    paper: str
    source: str
    name: str
    form: Form
    what: str
    verdict: Verdict
    words: str
    safe: Safe
    safe_reason: str = ""
    is_of_part: bool = False
    within: float | None = None
    error: float | None = None
    U: float | None = None
    worst_row: str = ""
    above: float | None = None
    below: float | None = None
    misprint: float | None = None
    ranges: tuple[VerdictRange, ...] = ()
    design: tuple[DesignRange, ...] = ()
    points: int = 0
    unsolved: int = 0
    own_only: tuple[str, ...] = ()
    model: str = ""
    caution: str = ""
    caution_row: str = ""
    readings: str = ""
    shares: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    limited_by: str = ""
    instead: str = ""
    rows: tuple[str, ...] = ()
    model_rows: tuple[str, ...] = ()
    errata: tuple[str, ...] = ()

    @property
    def cases(self) -> tuple[str, ...]:
        """Cases whose rows are the evidence of the verdict."""
        rows = self.rows + self.model_rows
        return tuple(dict.fromkeys(row.partition("/")[0] for row in rows))
