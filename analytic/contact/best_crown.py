r"""The logarithmic crown with the lowest peak pressure under a load, by strips.

Too little crown loads the ends, too much of it the middle: the best one just unloads the ends.
K_1, K_2 and z_m are searched on a lattice that shrinks about the best point; all crowns of a
lattice are pressed at once. z_m is measured in :math:`A_1 = W/(\pi l E^*)`, the unit of
Lundberg's crown, so that the search has no scale of its own. The optimum is flat: crowns that
differ by tens of per cent in a parameter may differ by a tenth of a per cent in peak pressure.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact import strips
from analytic.contact.checks import finite, positive
from analytic.contact.crown import logarithmic, slice_centres

LOW = (0.5, 0.2, 2.0)  # K_1, K_2, z_m/A_1
HIGH = (100.0, 1.0, 300.0)  # a light load far out of parallel would rather have a parabola
POINTS = 4  # of the lattice along each axis
ROUNDS = 12
SHRINK = 0.65


@dataclass(frozen=True)
class BestCrown:
    """K_1, K_2, z_m [length] of a crown designed for the load, and its peak pressure [stress]."""

    K_1: float
    K_2: float
    z_m: float
    peak: float


def best_crown(
    *, load: float, length: float, R: float, E_star: float, tilt: ArrayLike = 0.0, n: int = 60
) -> BestCrown:
    """The crown for `load` of a roller of this length, with n strips.

    `tilt` [rad] may be several angles: the highest peak of all counts. The range is K_1 from 0.5 to
    100, K_2 from 0.2, z_m from 2 to 300 A_1; in it the peak is the lowest to 0.1 %. ValueError for
    what makes no sense, ArithmeticError where the strips fail.

    >>> straight = best_crown(load=3407.0, length=9e-3, R=2.95e-3, E_star=113e9)
    >>> bool(1.0 < straight.peak / 2.149e9 < 1.04)  # Hertz's pressure of a uniform load
    True
    """
    load, length = float(positive(load, "load", "N")), float(positive(length, "length", "m"))
    unit = load / (np.pi * length * float(positive(E_star, "contact modulus", "Pa")))
    y = slice_centres(length=length, slices=n)
    angles = finite(tilt, "tilt", "rad").ravel()
    if not angles.size:
        raise ValueError("tilt must be an angle or several [rad], got none")
    lean = angles[:, None] * y
    low, high = np.log(LOW), np.log(HIGH)
    bottom, top = low, high
    for _ in range(ROUNDS):
        axes = [np.linspace(a, b, POINTS) for a, b in zip(bottom, top, strict=True)]
        tried = np.exp(np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)).reshape(-1, 3)
        K_1, K_2, z_m = tried.T[:, :, None]
        z = logarithmic(
            y, K_1=K_1, K_2=np.minimum(K_2, 1.0), z_m=z_m * unit, load=load, length=length,
            E_star=E_star,
        )  # fmt: skip
        found = strips.press(
            z[:, None] + lean, length=length, R=R, E_star=E_star, load=load, tolerance=1e-8
        )
        peak = found.peak.max(axis=-1)
        best = int(np.argmin(peak))
        centre, reach = np.log(tried[best]), SHRINK * (top - bottom) / 2
        bottom, top = np.maximum(centre - reach, low), np.minimum(centre + reach, high)
    K_1, K_2, z_m = tried[best]
    return BestCrown(float(K_1), min(float(K_2), 1.0), float(z_m * unit), float(peak[best]))
