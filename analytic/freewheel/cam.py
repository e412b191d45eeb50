r"""Roller wedged between a flat and a circle (Nagler, Lohrengel, Eqs. 3 to 6, corrected).

The circular race has the radius R, the flat has the distance X from the axis. An inner cam (star)
has the flat inside, and the race is the bore of the ring. An outer cam (cup) has the flat outside,
and the race is the shaft with the radius R_s. The centre of the roller is at the angle
psi = 2 alpha from the normal of the flat, at the distance rho from the axis. y is the distance of
the centre from a line through the axis parallel to the flat:

.. math::
    \text{inner cam:}\quad & \rho = R - r + d_o, & y = X + r - d_i, \\
    \text{outer cam:}\quad & \rho = R_s + r - d_i, & y = X_o - r + d_o,

cos psi = y/rho (Eqs. 4 and 5). The two contact forces of the roller act along the line through both
contacts. The angle between this line and each normal is alpha: F_t = F_n tan(alpha). d_i and d_o
are the approaches of the roller to the inner and the outer part. Under load, the angle of an inner
cam increases. The angle of an outer cam decreases down to psi = 0, where the rollers pop through
(rollover).

All lengths have the same unit, angles are in rad; fields and arguments broadcast.

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
    """Cam with z rollers between flats and a circular race: base class of inner and outer cams.

    `race` and `flat` are R and X of either kind. `sense` is +1 if load increases the angle (inner
    cam) and -1 if load decreases it (outer cam).
    """

    sense: ClassVar[float]
    r: ArrayLike
    z: ArrayLike

    @property
    @abstractmethod
    def race(self) -> Array:
        """Radius [length] of the circular race, the lever arm of F_t."""

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
        """Sum d_i + d_o [length] at pop-through (psi = 0).

        For an inner cam, the value is negative: pop-through does not occur.
        """
        return np.asarray(-self.sense * (self.race - self.flat) + 2 * self.roller)

    @property
    def room(self) -> Array:
        """Outward shift [length] of the flats at which the unloaded wedge vanishes (psi = 0).

        It is R - 2 r - X for a star and R_s + 2 r - X for a cup.
        """
        _, y = self.centre(d_i=0.0, d_o=0.0)
        return np.asarray(self.distance(d_i=0.0, d_o=0.0) - y)

    @property
    def alpha0(self) -> Array:
        """Clamping angle [rad] without load (Eq. 4)."""
        return self.alpha(d_i=0.0, d_o=0.0)

    def distance(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Distance rho [length] of the centre of the roller from the axis."""
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
        """Position x, y [length] of the roller's centre along the flat and along its normal."""
        psi = 2 * self.alpha(d_i=d_i, d_o=d_o)
        rho = self.distance(d_i=d_i, d_o=d_o)
        return np.asarray(rho * np.sin(psi)), np.asarray(rho * np.cos(psi))

    def arc(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Arc s [length] by which the roller's centre has moved along the cam (Eq. 6).

        s is 0 without load.
        """
        turned = 2 * (self.alpha(d_i=d_i, d_o=d_o) - self.alpha0)
        return np.asarray(self.sense * self.distance(d_i=d_i, d_o=d_o) * turned)

    def torque_on_race(self, *, F_t: ArrayLike) -> Array:
        """Torque [force x length] of the tangential forces on the circular race (Eq. 3)."""
        return np.asarray(self.count * self.race * np.asarray(F_t))

    def torque_on_cam(self, *, F_n: ArrayLike, F_t: ArrayLike) -> Array:
        """Torque [force x length] of both force components on the undeformed flats (Eq. 3).

        It is z (F_n x - F_t X), where x is the distance of the normal of the flat from the axis.
        """
        x, _ = self.centre(d_i=0.0, d_o=0.0)
        return np.asarray(self.count * (np.asarray(F_n) * x - np.asarray(F_t) * self.flat))

    @property
    def corner(self) -> Array:
        """Half-length [length] of a flat, X tan(pi/z)."""
        return np.asarray(self.flat * np.tan(np.pi / self.count))

    def check_rollers(self) -> None:
        """Raise ValueError if rollers overlap or are beyond the end of their flats."""
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
