"""The bodies of a sprag clutch by vectors: the sprag's outline, and where it lies between races.

Seen along the axis, O below and the sprag above it; angles count clockwise from the line through O
and the pole. The sprag turns clockwise into the wedge.
"""

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Protocol

import numpy as np
from scipy.optimize import brentq

if TYPE_CHECKING:
    from meshes.sprag.profile import Placed, Sprag

GROWTHS = 1e-5, 0.95  # of the spiral, between which that of a wedge angle is looked for


class OneClutch(Protocol):
    """Sprags `b` wide between races `R_id`..`R_i` and `R_e`..`R_ed`, SI."""

    @property
    def R_id(self) -> float: ...
    @property
    def R_i(self) -> float: ...
    @property
    def R_e(self) -> float: ...
    @property
    def R_ed(self) -> float: ...
    @property
    def r_i(self) -> float: ...
    @property
    def nu_0(self) -> float: ...
    @property
    def z(self) -> int: ...
    @property
    def b(self) -> float: ...
    @property
    def E(self) -> float: ...
    @property
    def nu(self) -> float: ...


@dataclass(frozen=True)
class FirstContact:
    """Where pole and contacts lie [m] as a spiral of growth `m` touches, its own point on +y."""

    R_i: float
    R_e: float
    r_i: float
    m: float

    @property
    def rho(self) -> float:
        """From the pole to the inner contact, whose radius of curvature is r_i."""
        return self.r_i / math.hypot(1, self.m)

    @property
    def pole(self) -> tuple[float, float]:
        """A spiral's radius and its normal differ by arctan m."""
        x = math.hypot(1, self.m)
        return -self.rho * self.m / x, self.R_i + self.rho / x

    @property
    def wedge(self) -> float:
        """Angle nu_0 between the line through both contacts and the inner contact's normal."""
        x, y = self.pole
        share = self.R_e / math.hypot(x, y)
        return math.atan2(-share * x, share * y - self.R_i)

    @property
    def theta(self) -> float:
        """Angle at the pole between O and the inner contact."""
        x, y = self.pole
        return math.atan2(x * (y - self.R_i) - y * x, x * x + y * (y - self.R_i))


@lru_cache(64)
def first_contact(R_i: float, R_e: float, r_i: float, nu_0: float) -> FirstContact:
    """With the wedge angle `nu_0` [rad]; ValueError where no spiral has it."""

    def missing(m: float) -> float:
        return FirstContact(R_i, R_e, r_i, m).wedge - nu_0

    low, high = GROWTHS
    if not missing(low) < 0 < missing(high):
        raise ValueError(f"no spiral between the races has the wedge angle {nu_0:.4g} rad")
    return FirstContact(R_i, R_e, r_i, brentq(missing, low, high, xtol=1e-15))


def fem_sprag(q: OneClutch) -> "Sprag":
    from meshes.sprag.profile import Sprag

    first = first_contact(q.R_i, q.R_e, q.r_i, q.nu_0)
    return Sprag(first.rho, first.theta, first.m, q.R_e - math.hypot(*first.pole), q.b)


@dataclass(frozen=True)
class Place:
    """Where the sprag is: turned by `alpha` [rad], its pole at the distance `D` [m] from O.

    `shares` are what the races take of the overlaps of the inner and of the outer contact, the
    sprag taking the rest: bodies are drawn as they are compressed, so that forces act where they
    do. `bends` [m] are how much of the overlaps is drawn, as the curved surfaces are that far from
    each other on the average over the pressure.
    """

    q: OneClutch
    alpha: float
    D: float
    shares: tuple[float, float] = (0.6, 0.8)
    bends: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def overlapping(cls, q: OneClutch, alpha: float) -> "Place":
        """Turned by `alpha`, both contacts overlapping by about as much."""
        D = q.R_e - fem_sprag(q).r_e
        return cls(q, alpha, D + cls(q, alpha, D).overlaps[0] / 2)

    @cached_property
    def fem_free(self) -> "Placed":
        """The sprag without loads, as it overlaps both races."""
        from meshes.sprag.profile import Placed

        return Placed(fem_sprag(self.q), (0.0, self.D), self.alpha)

    @cached_property
    def overlaps(self) -> tuple[float, float]:
        """Of both contacts without loads [m]: all that yields there."""
        at = self.fem_free
        return self.q.R_i - math.hypot(*at.inner), math.hypot(*at.outer) - self.q.R_e

    @property
    def H(self) -> float:
        """All that yields [m]."""
        return sum(self.overlaps)

    @property
    def OA(self) -> float:
        """Radius [m] at which the inner contact's force acts."""
        return self.q.R_i - self.shares[0] * self.overlaps[0]

    @property
    def OB(self) -> float:
        """Radius [m] at which the outer contact's force acts."""
        return self.q.R_e + self.shares[1] * self.overlaps[1]

    @property
    def beta(self) -> float:
        """Angle AOB [rad]."""
        (x_i, y_i), (x_e, y_e) = self.fem_free.inner, self.fem_free.outer
        return math.atan2(x_i * y_e - y_i * x_e, x_i * x_e + y_i * y_e)

    @property
    def strut(self) -> tuple[float, float]:
        """Angles nu and omega [rad] of the line AB against OA and OB."""
        x, y = self.OB * math.sin(self.beta), self.OB * math.cos(self.beta)
        nu = math.atan2(x, y - self.OA)
        return nu, nu - self.beta

    @cached_property
    def fem_drawn(self) -> "Placed":
        """The compressed sprag, whose ends have moved along their normals."""
        from dataclasses import replace

        from meshes.sprag.profile import Placed

        at, (x_i, y_i) = self.fem_free, self.fem_free.inner
        inwards = (self.OA - self.bends[0]) / math.hypot(x_i, y_i) - 1
        pole = x_i * inwards, self.D + y_i * inwards
        away = -pole[0], self.OB + self.bends[1] - at.sprag.r_e - pole[1]
        c, s = math.cos(self.alpha), math.sin(self.alpha)
        centre = c * away[0] - s * away[1], s * away[0] + c * away[1]
        return Placed(replace(at.sprag, centre=centre), pole, self.alpha)

    @property
    def fem_core(self) -> tuple[float, float]:
        """The point of the column's middle beside the pole."""
        at = self.fem_drawn
        low, high = np.array(at.sprag.middle)
        along = (high - low) / np.hypot(*(high - low))
        x, y = at.placed(low - (low @ along) * along)
        return float(x), float(y)
