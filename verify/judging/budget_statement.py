"""Declaration of the causes of a difference that are rerun, and of their removal."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from fnmatch import fnmatchcase
from typing import Any

from verify.core.case import FemResult
from verify.core.inputs import Inputs


class Cause(StrEnum):
    """Possible cause of a difference of formula and finite elements, in the order of tables."""

    FORMULA = "formula"
    DISCRETISATION = "discretisation"
    ITERATION = "iteration"
    CONTACT = "contact law"
    GEOMETRY = "finite geometry"
    PLANE = "plane assumption"
    DISPLACEMENT = "small displacement"


@dataclass(frozen=True)
class Argument:
    """A function or class "module:name" that is called with other keyword arguments."""

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
    """The inputs without changes."""
    return q


@dataclass(frozen=True, kw_only=True)
class Rerun:
    """A cause of a difference and its removal; `what` describes it in words.

    It is removed by other `inputs`, which the formulas also use, by `changes` of the finite
    elements of the case, or by other finite elements, `fem(inputs, level)`, with the keys of the
    case. `rows` are names of affected rows (* stands for any letters; all rows if empty). It is run
    on `levels`, coarse to fine: the finer of two gives its effect, the coarser the uncertainty; by
    default, these are the two coarsest levels of the case. A cause that has no meaning while
    another one acts is removed `after` that cause, given by its name: its `inputs` or `fem` exclude
    both. An assumption of both sides is `shared`: it is no part of their difference and is listed
    separately.
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
        """Unique in a case."""
        return f"{self.cause}: {self.what}"

    def about(self, row: str) -> bool:
        """Whether the row of this name is meant."""
        return not self.rows or any(fnmatchcase(row, name) for name in self.rows)


@dataclass(frozen=True)
class Corrected:
    """A formula that is replaced by a corrected formula, whose value has the analytic `key`.

    Replacement for the row with this name; `what` describes its contribution to the difference.
    """

    row: str
    key: str
    what: str = "as printed, beside the corrected one"

    @property
    def name(self) -> str:
        """Name of the cause's part."""
        return f"{Cause.FORMULA}: {self.what}"


@dataclass(frozen=True)
class Left:
    """Rows, by name with * for any letters, whose difference is not split, and why."""

    rows: tuple[str, ...]
    why: str


@dataclass(frozen=True)
class Without:
    """A cause that a case does not have, and why in a word."""

    cause: Cause
    why: str


@dataclass(frozen=True, kw_only=True)
class Statement:
    """Statement of a case on its error budget.

    `finer` is a level beyond the finest; 0 if it takes too long, and the three finest are
    extrapolated. `headline` is the row that is drawn, by default the first approximation.
    `corrected` formulas precede all reruns; a large remainder is `left` with its reason.
    """

    reruns: tuple[Rerun, ...] = ()
    corrected: tuple[Corrected, ...] = ()
    left: tuple[Left, ...] = ()
    without: tuple[Without, ...] = ()
    finer: int = 0
    headline: str = ""

    def correction(self, row: str) -> Corrected | None:
        """The formula that replaces the row's formula."""
        return next((one for one in self.corrected if one.row == row), None)

    def reason(self, row: str) -> str:
        """Reason why the difference of this row is not split; empty if no reason is given."""
        return next(
            (one.why for one in self.left if any(fnmatchcase(row, name) for name in one.rows)), ""
        )


def plane_strain(target: str = "fem.plane.solve:solve_plane") -> tuple[Change, ...]:
    """Bodies that cannot strain along their axis."""
    return (Argument(target, {"assumption": "plane strain"}),)


def plane_stress(target: str = "fem.plane.solve:solve_plane") -> tuple[Change, ...]:
    """Bodies whose ends are free of stress."""
    return (Argument(target, {"assumption": "plane stress"}),)
