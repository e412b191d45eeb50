"""Input of the bounds of a wedged sprag: dimensions, state, and races under their loads."""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

from analytic.contact.checks import Array
from analytic.sprag.bending import Triangle


class State(Triangle, Protocol):
    """State of a wedged sprag under its normal force, by the closure equations; angles in rad."""

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
    """Deflections [m] of a sprag: inner contact, sprag, sum of inner side, sum of both sides."""

    @property
    def contact_i(self) -> Array: ...
    @property
    def sprag(self) -> Array: ...
    @property
    def inner(self) -> Array: ...
    @property
    def H(self) -> Array: ...


class Race(NamedTuple):
    """Deflections of a race, in units of P/E'.

    `mean` is the mean over the circumference, `at` the value in the middle of a contact patch,
    `under` the mean over the patch.
    """

    mean: float
    at: float
    under: float


@dataclass(frozen=True, kw_only=True)
class Sizes:
    """Dimensions [m] of z sprags (width b, length l) and of both races.

    The inner race has the radii R_id and R_i, the outer race the radii R_e and R_ed. E_plane is E'
    of plane strain. r_i and r_e [m] are the radii of the sprag at first contact, nu_0 [rad] is the
    wedge angle at first contact.
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
