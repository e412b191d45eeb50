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
    """A number "module:NAME" that is another multiple of itself; an integer stays one."""

    target: str
    factor: float

    def __str__(self) -> str:
        return f"{self.target} x {self.factor:g}"


Change = Argument | Constant


def as_given(q: Any) -> Any:
    """The inputs as they are."""
    return q


@dataclass(frozen=True, kw_only=True)
class Rerun:
    """A cause of a difference and its removal; `what` describes it in words.

    Removed by other `inputs`, which formulas then take as well, by `changes` to the case's
    finite elements, or by other ones, `fem(inputs, level)`, with the case's keys. `rows` names the
    rows that it is about, * for any letters, all where empty. It is run on `levels`, coarse to
    fine: on the finer of two its effect is read, on the coarser how well; without any on the two
    coarsest of the case. A cause that means nothing while another one acts is removed `after` that
    one, given by its name: its `inputs` or `fem` lack both. An assumption of both sides is
    `shared`: no part of their difference, and listed beside it.
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
    """A formula that is replaced by a corrected one, whose value has the analytic `key`.

    Replacement for the row with this name; `what` describes its part of the difference.
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

    `finer` is a level beyond the finest, 0 where one takes too long: then the three finest are
    extrapolated. `headline` names the row that is drawn, the first approximation where empty.
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
