r"""Roller wedged between a flat and a circle (Nagler, Lohrengel, Eqs. 3 to 6, corrected).

The circular race has the radius R, the flat the distance X from the axis. An inner cam (star) has
the flat inside and the race is the ring's bore; an outer cam (cup) has the flat outside and the
race is the shaft R_s. The roller's centre stands at the angle psi = 2 alpha from the flat's normal,
at the distance rho from the axis and at the height y over the flat's parallel through the axis:

.. math::
    \text{inner cam:}\quad & \rho = R - r + d_o, & y = X + r - d_i, \\
    \text{outer cam:}\quad & \rho = R_s + r - d_i, & y = X_o - r + d_o,

cos psi = y/rho (Eqs. 4 and 5). The roller's two contact forces are on the line through both
contacts, which makes alpha with each normal: F_t = F_n tan(alpha). d_i and d_o are how far the
roller approaches the inner and the outer part. Load widens an inner cam's angle and narrows an
outer cam's, down to psi = 0, where the rollers pop through (rollover).

Lengths in any one unit, angles in rad; fields and arguments broadcast against each other.

References
----------
.. [1] N. Nagler, A. Lohrengel, Improved design criterion for frictionally engaged contacts in
   overrunning clutches, Forsch. Ingenieurwes. 85(4), 2021, doi 10.1007/s10010-021-00496-5.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.freewheel.rules import require


@dataclass(frozen=True, kw_only=True, eq=False)
class Cam(ABC):
    """z rollers between flats and a circular race: base of both kinds.

    `race` and `flat` are R and X of either kind, `sense` is +1 where load widens the angle (inner
    cam) and -1 where it narrows it (outer cam).
    """

    sense: ClassVar[float]
    r: ArrayLike
    z: ArrayLike

    @property
    @abstractmethod
    def race(self) -> Array:
        """Radius [length] of the circular race, the lever of F_t."""

    @property
    @abstractmethod
    def flat(self) -> Array:
        """Distance [length] of the flats from the axis."""

    @property
    def roller(self) -> Array:
        """Radius [length] of the rollers."""
        return np.asarray(self.r, dtype=np.float64)

    @property
    def count(self) -> Array:
        """Number of rollers."""
        return np.asarray(self.z, dtype=np.float64)

    @property
    def pop_through(self) -> Array:
        """The sum d_i + d_o [length] at which psi is 0; negative: an inner cam never gets there."""
        return np.asarray(-self.sense * (self.race - self.flat) + 2 * self.roller)

    @property
    def room(self) -> Array:
        """Distance [length] from the loss of the wedge, R - 2 r - X, of a cup R_s + 2 r - X."""
        _, y = self.centre(d_i=0.0, d_o=0.0)
        return np.asarray(self.distance(d_i=0.0, d_o=0.0) - y)

    @property
    def alpha0(self) -> Array:
        """Clamping angle [rad] without load (Eq. 4)."""
        return self.alpha(d_i=0.0, d_o=0.0)

    def distance(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Distance rho [length] of the roller's centre from the axis."""
        to_race = d_o if self.sense > 0 else d_i
        return np.asarray(self.race - self.sense * (self.roller - np.asarray(to_race)))

    def alpha(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Clamping angle [rad] with the approaches d_i, d_o (Eq. 5); nan beyond pop-through."""
        # sin² alpha = (1 - cos psi)/2 with the difference rho - y, exact where alpha is small
        lower = self.sense * (np.asarray(d_i) + np.asarray(d_o) - self.pop_through)
        share = lower / (2 * self.distance(d_i=d_i, d_o=d_o))
        valid = (share >= 0) & (share < 1)
        return np.where(valid, np.arcsin(np.sqrt(np.where(valid, share, 0.0))), np.nan)

    def centre(self, *, d_i: ArrayLike, d_o: ArrayLike) -> tuple[Array, Array]:
        """Roller's centre x, y [length] along the flat and along its normal."""
        psi = 2 * self.alpha(d_i=d_i, d_o=d_o)
        rho = self.distance(d_i=d_i, d_o=d_o)
        return np.asarray(rho * np.sin(psi)), np.asarray(rho * np.cos(psi))

    def arc(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Arc s [length] of the roller's centre relative to the cam, from no load on (Eq. 6)."""
        turned = 2 * (self.alpha(d_i=d_i, d_o=d_o) - self.alpha0)
        return np.asarray(self.sense * self.distance(d_i=d_i, d_o=d_o) * turned)

    def torque_on_race(self, *, F_t: ArrayLike) -> Array:
        """Torque [force x length] of the tangential forces on the circular race (Eq. 3)."""
        return np.asarray(self.count * self.race * np.asarray(F_t))

    def torque_on_cam(self, *, F_n: ArrayLike, F_t: ArrayLike) -> Array:
        """Torque [force x length] of both forces of the contacts on the flats without load (Eq. 3).

        z (F_n x - F_t X): the flat's normal misses the axis by x.
        """
        x, _ = self.centre(d_i=0.0, d_o=0.0)
        return np.asarray(self.count * (np.asarray(F_n) * x - np.asarray(F_t) * self.flat))

    @property
    def corner(self) -> Array:
        """Half the length [length] of a flat, X tan(pi/z)."""
        return np.asarray(self.flat * np.tan(np.pi / self.count))

    def check_rollers(self) -> None:
        """ValueError if rollers overlap or are beyond the end of their flats."""
        rho, (x, _) = self.distance(d_i=0.0, d_o=0.0), self.centre(d_i=0.0, d_o=0.0)
        pitch = rho * np.sin(np.pi / self.count)
        require(
            pitch > self.roller,
            "rollers touch each other: r must be below half the distance of two rollers' centres",
            r=self.roller, half=pitch,
        )  # fmt: skip
        require(
            x < self.corner,
            "roller beyond the corner of its flat: it stands at x, half a flat is X tan(pi/z)",
            x=x, half=self.corner,
        )  # fmt: skip
