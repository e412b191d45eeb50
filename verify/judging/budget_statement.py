"""Declaration of the causes of a difference, and of the computations that remove each cause."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from fnmatch import fnmatchcase
from typing import Any

from verify.core.case import FemResult
from verify.core.inputs import Inputs


class Cause(StrEnum):
    """Causes of a difference between formula and finite elements, in the order used in tables."""

    FORMULA = "formula"
    DISCRETISATION = "discretisation"
    ITERATION = "iteration"
    CONTACT = "contact law"
    GEOMETRY = "finite geometry"
    PLANE = "plane assumption"
    DISPLACEMENT = "small displacement"


@dataclass(frozen=True)
class Argument:
    """A function or class "module:name" that is called with changed keyword arguments."""

    target: str
    keywords: Mapping[str, Any]

    def __str__(self) -> str:
        return f"{self.target}({', '.join(f'{k}={v!r}' for k, v in self.keywords.items())})"


@dataclass(frozen=True)
class Constant:
    """A number "module:NAME" that is multiplied by a factor; an integer remains an integer."""

    target: str
    factor: float

    def __str__(self) -> str:
        return f"{self.target} x {self.factor:g}"


Change = Argument | Constant


def as_given(q: Any) -> Any:
    """The inputs without change."""
    return q


@dataclass(frozen=True, kw_only=True)
class Rerun:
    """A cause of a difference, described by `what`, and the computation without this cause.

    The cause is removed by one of three methods: by other `inputs`, which the formulas also use; by
    `changes` in the finite elements of the case; or by other finite elements `fem(inputs, level)`
    with the keys of the case. `rows` are names of affected rows (* stands for any letters; all rows
    if empty).

    The computation is run on `levels`, from coarse to fine. The finer of two levels gives the
    effect, the coarser one its uncertainty. By default, these are the two coarsest levels of the
    case.

    Some causes have no meaning while another cause acts. Such a cause is removed `after` the other
    cause, which is given by its name; its `inputs` or `fem` then exclude both causes. With
    `shared`, the cause is an assumption of both formula and reference: it is no part of their
    difference and is listed separately.
    """

    cause: Cause
    what: str
    rows: tuple[str, ...] = ()
    inputs: Callable[[Any], Inputs] = as_given
    changes: tuple[Change, ...] = ()
    fem: Callable[[Any, int], FemResult] | None = None
    levels: tuple[int, ...] = ()
    after: str = ""
    shared: bool = False

    @property
    def name(self) -> str:
        """Name of the cause, which is unique in a case."""
        return f"{self.cause}: {self.what}"

    def about(self, row: str) -> bool:
        """Whether the cause affects the row with this name."""
        return not self.rows or any(fnmatchcase(row, name) for name in self.rows)


@dataclass(frozen=True)
class Corrected:
    """A printed formula that is replaced by a corrected formula.

    `row` is the name of the row, and `key` the analytic key of the corrected value. `what`
    describes the contribution of the replacement to the difference.
    """

    row: str
    key: str
    what: str = "printed form instead of the corrected form"

    @property
    def name(self) -> str:
        """Name of the cause, for tables."""
        return f"{Cause.FORMULA}: {self.what}"


@dataclass(frozen=True)
class Left:
    """Rows whose difference is not split into causes, and the reason.

    Rows are given by name; * stands for any letters.
    """

    rows: tuple[str, ...]
    why: str


@dataclass(frozen=True)
class Without:
    """A cause that does not exist in a case; `why` is a short reason."""

    cause: Cause
    why: str


@dataclass(frozen=True, kw_only=True)
class Statement:
    """Statement of a case on its error budget.

    `finer` is a level beyond the finest level; it is 0 if that level takes too long, and the three
    finest levels are then extrapolated. `headline` is the name of the row that is drawn, by default
    the first approximation. `corrected` formulas are applied before all reruns. Rows whose large
    remainder is not explained are in `left`, with the reason.
    """

    reruns: tuple[Rerun, ...] = ()
    corrected: tuple[Corrected, ...] = ()
    left: tuple[Left, ...] = ()
    without: tuple[Without, ...] = ()
    finer: int = 0
    headline: str = ""

    def correction(self, row: str) -> Corrected | None:
        """Correction of the formula of this row; None if there is none."""
        return next((one for one in self.corrected if one.row == row), None)

    def reason(self, row: str) -> str:
        """Reason why the difference of this row is not split; empty if no reason is given."""
        return next(
            (one.why for one in self.left if any(fnmatchcase(row, name) for name in one.rows)), ""
        )


def plane_strain(target: str = "fem.plane.solve:solve_plane") -> tuple[Change, ...]:
    """Change of the finite elements to plane strain (no axial strain)."""
    return (Argument(target, {"assumption": "plane strain"}),)


def plane_stress(target: str = "fem.plane.solve:solve_plane") -> tuple[Change, ...]:
    """Change of the finite elements to plane stress (end faces free of stress)."""
    return (Argument(target, {"assumption": "plane stress"}),)
