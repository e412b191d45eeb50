"""Geometry of both kinds of cams: a star with flats in a ring, a cup with flats around a shaft.

All lengths have the same unit. Raises ValueError for rollers that cannot wedge. `cam` contains the
formulas.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive
from analytic.freewheel.cam import Cam
from analytic.freewheel.rules import require, rollers


@dataclass(frozen=True, kw_only=True, eq=False)
class InnerCam(Cam):
    """Star with z flats at the distance X from the axis in a ring of bore radius R [length].

    Raises ValueError for rollers that cannot wedge.

    >>> cam = InnerCam(R=16.5, r=2.5, X=14 * np.cos(np.radians(7)) - 2.5, z=8)
    >>> round(float(np.degrees(cam.alpha0)), 12)  # cos 2 alpha = (X + r)/(R - r)
    3.5
    """

    sense = 1.0
    R: ArrayLike
    X: ArrayLike

    def __post_init__(self) -> None:
        R, r = positive(self.R, "ring's bore radius R", "m"), positive(self.r, "roller's r", "m")
        X, _ = finite(self.X, "flat's distance X", "m"), rollers(self.z)
        require(R - r > 0, "roller too large: r must be below R", r=r, R=R)
        require(X + r > 0, "flat beyond the roller's centre: X + r must be positive", X=X, r=r)
        require(
            X + r < R - r, "no wedge: the roller cannot touch flat and ring unless X + 2 r < R",
            X=X, r=r, R=R,
        )  # fmt: skip
        self.check_rollers()

    @property
    def race(self) -> Array:
        return np.asarray(self.R, dtype=np.float64)

    @property
    def flat(self) -> Array:
        return np.asarray(self.X, dtype=np.float64)


@dataclass(frozen=True, kw_only=True, eq=False)
class OuterCam(Cam):
    """Cup with z inner flats at the distance X_o from the axis, on a shaft of radius R_s [length].

    Raises ValueError for rollers that cannot wedge.

    >>> cam = OuterCam(R_s=10.0, r=2.0, X_o=12 * np.cos(np.radians(8)) + 2, z=8)
    >>> round(float(np.degrees(cam.alpha0)), 12)  # cos 2 alpha = (X_o - r)/(R_s + r)
    4.0
    >>> bool(cam.alpha(d_i=0.01, d_o=0.01) < cam.alpha0)
    True
    """

    sense = -1.0
    R_s: ArrayLike
    X_o: ArrayLike

    def __post_init__(self) -> None:
        R_s, r = positive(self.R_s, "shaft's radius R_s", "m"), positive(self.r, "roller's r", "m")
        X_o, _ = positive(self.X_o, "flat's distance X_o", "m"), rollers(self.z)
        require(X_o > R_s, "flat cuts the shaft: X_o must be above R_s", X_o=X_o, R_s=R_s)
        require(X_o > r, "roller too large: r must be below X_o", r=r, X_o=X_o)
        require(
            X_o < R_s + 2 * r, "no wedge: the roller passes unless X_o < R_s + 2 r",
            X_o=X_o, R_s=R_s, r=r,
        )  # fmt: skip
        self.check_rollers()

    @property
    def race(self) -> Array:
        return np.asarray(self.R_s, dtype=np.float64)

    @property
    def flat(self) -> Array:
        return np.asarray(self.X_o, dtype=np.float64)
