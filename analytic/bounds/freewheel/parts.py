r"""Input of the error bounds of a roller freewheel: its parts, and its state under one load.

`FreewheelParts.alpha` is a second formula. The centre of the roller is at the distance rho from the
axis, and at the distance y from a line through the axis parallel to the flat: cos(2 alpha) = y/rho,
so that

.. math:: \sin^2\alpha = \frac{\rho - y}{2\rho} .

All lengths have the same unit; arguments broadcast.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import hertz_line
from analytic.contact.checks import Array, in_plane


@dataclass(frozen=True, kw_only=True)
class FreewheelParts:
    """Rollers between flats and a round race, all parts of one material [length, stress].

    `sense` is +1 for a star with flats in a ring, whose angle increases under load, and -1 for a
    cup with flats around a shaft. `r_b` is the bore radius of the inner part, `R_a` the rim radius
    of the outer part.
    """

    sense: int
    race: float
    flat: float
    r: float
    z: int
    L: float
    r_b: float
    R_a: float
    E: float
    nu: float

    @property
    def plane(self) -> tuple[Array, Array]:
        """Elastic constants E' and nu' of plane strain."""
        return in_plane(self.E, self.nu, "plane strain")

    @property
    def corner(self) -> float:
        """Half-length [length] of a flat."""
        return float(self.flat * np.tan(np.pi / self.z))

    def distance(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Distance rho [length] of the centre of the roller from the axis."""
        to_race = d_o if self.sense > 0 else d_i
        return np.asarray(self.race - self.sense * (self.r - np.asarray(to_race)))

    def alpha(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Clamping angle [rad] with the approaches d_i, d_o; nan beyond pop-through.

        >>> more = {"L": 10.0, "r_b": 7.5, "R_a": 21.0, "E": 206e3, "nu": 0.3}
        >>> X = 14 * np.cos(np.radians(7)) - 2.5  # cos 2 alpha = (X + r)/(R - r)
        >>> star = FreewheelParts(sense=1, race=16.5, flat=X, r=2.5, z=8, **more)
        >>> round(float(np.degrees(star.alpha(d_i=0.0, d_o=0.0))), 12)
        3.5
        """
        through = -self.sense * (self.race - self.flat) + 2 * self.r
        lower = self.sense * (np.asarray(d_i) + np.asarray(d_o) - through)
        share = lower / (2 * self.distance(d_i=d_i, d_o=d_o))
        valid = (share >= 0) & (share < 1)
        return np.where(valid, np.arcsin(np.sqrt(np.where(valid, share, 0.0))), np.nan)

    def centre(self, *, d_i: ArrayLike, d_o: ArrayLike) -> tuple[Array, Array]:
        """Position x, y [length] of the roller's centre along the flat and along its normal."""
        psi = 2 * self.alpha(d_i=d_i, d_o=d_o)
        rho = self.distance(d_i=d_i, d_o=d_o)
        return np.asarray(rho * np.sin(psi)), np.asarray(rho * np.cos(psi))

    def arc(self, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
        """Arc [length] of the roller centre's motion around the cam, from the unloaded state."""
        turned = 2 * (self.alpha(d_i=d_i, d_o=d_o) - self.alpha(d_i=0.0, d_o=0.0))
        return np.asarray(self.sense * self.distance(d_i=d_i, d_o=d_o) * turned)

    def rolled(self, *, d_i: Array, d_o: Array) -> Array:
        """Relative rotation [rad] of cam and race by rolling, as d_i and d_o increase from zero.

        R dphi = (1 + cos psi) dx - sin psi dy. The terms x + y arsinh(x/y) are integrated exactly,
        the small remainder by the trapezoidal rule.
        """
        x, y = self.centre(d_i=d_i, d_o=d_o)
        G = np.arcsinh(x / y)
        steps = (G[1:] + G[:-1]) / 2 * np.diff(y)
        rest = np.concatenate([np.zeros(1), np.cumsum(steps)])
        held = x + y * G
        return np.asarray(self.sense * (held - held[:1] - rest) / self.race)

    def width_on_flat(self, P: ArrayLike) -> Array:
        """Hertz's half-width [length] of the contact on the flat under P [force/length]."""
        like = {"E_1": self.E, "nu_1": self.nu, "E_2": self.E, "nu_2": self.nu}
        E_star = hertz_line.contact_modulus(**like, assumption="plane strain")
        return np.asarray(np.sqrt(4 * np.asarray(P) * self.r / (np.pi * E_star)))


Parts = FreewheelParts  # its name in version 0.1


@dataclass(frozen=True, kw_only=True)
class Loaded:
    """State of a freewheel, as input of bounds [force, force x length, rad, length].

    `N` is the normal force of one contact, `T` the torque of the clutch, `alpha` the clamping
    angle. `d_i` and `d_o` are the approaches, `a_i` and `a_o` the half-widths of the contacts.
    """

    N: float
    T: float
    alpha: float
    d_i: float
    d_o: float
    a_i: float
    a_o: float

    @property
    def psi(self) -> float:
        """Angle psi = 2 alpha [rad] between the flat's normal and the radius to the roller."""
        return 2 * self.alpha


def approach(
    P: Array, a: Array, *, E: Array, l: float, k: Array | float, c: Array | float = 0.0  # noqa: E741
) -> Array:  # fmt: skip
    """Approach [length] of a body with constants l, k, c under P [force/length] on half-width a.

    It is P/(pi E') (2 ln(l/a) + k + c a/l), with an error of second order in a/l.
    """
    return np.asarray(P * (1 / (np.pi * E)) * (2 * np.log(l / a) + k + c * a / l))


def half_roller(parts: FreewheelParts, P: Array, a: Array) -> Array:
    """Approach [length] between a contact and the centre of the roller, with k = 2 ln 4 - 1."""
    return approach(P, a, E=parts.plane[0], l=parts.r, k=2 * np.log(4) - 1)
