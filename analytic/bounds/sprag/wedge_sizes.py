"""Input of the bounds of a wedged sprag: sizes of parts, its state, races under their loads."""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

from analytic.contact.checks import Array
from analytic.sprag.bending import Triangle


class State(Triangle, Protocol):
    """A wedged sprag under its normal force, by the closure equations; angles in rad."""

    @property
    def N_e(self) -> Array: ...
    @property
    def nu(self) -> Array: ...
    @property
    def omega(self) -> Array: ...
    @property
    def turned(self) -> Array: ...
    @property
    def alpha_b(self) -> Array: ...
    @property
    def yields(self) -> "Yields": ...


class Yields(Protocol):
    """Deflections [m]: at the inner contact, in the sprag, on the inner side, in all."""

    @property
    def contact_i(self) -> Array: ...
    @property
    def sprag(self) -> Array: ...
    @property
    def inner(self) -> Array: ...
    @property
    def H(self) -> Array: ...


class Race(NamedTuple):
    """A race under its sprags over P/E': its mean, the middle of a patch, the mean over it."""

    mean: float
    at: float
    under: float


@dataclass(frozen=True, kw_only=True)
class Sizes:
    """z sprags `b` wide, `l` long between races R_id..R_i, R_e..R_ed [m]; E' is of plane strain.

    r_i and r_e [m] are radii at first contact, nu_0 [rad] the wedge angle there.
    """

    R_id: float
    R_i: float
    R_e: float
    R_ed: float
    r_i: float
    r_e: float
    nu_0: float
    z: int
    b: float
    l: float  # noqa: E741
    E: float
    nu: float
    E_plane: float
