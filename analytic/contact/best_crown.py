r"""The logarithmic crown with the lowest pressure under a load among those that spare the ends.

An end that carries load has no highest pressure (`strips`), whatever few strips say of it: a crown
counts only if the last strip at each end, about as wide as the contact's half-width b, carries
nothing. (Contacts that end nearer to the roller's end can have a peak lower by some per cent, but
the least overload or tilt loads the end.) Among these the one with the lowest peak is searched for
on a lattice of K_1, K_2 and z_m that shrinks about the best point; all crowns of a lattice are
pressed at once. z_m is measured in :math:`A_1 = W/(\pi l E^*)`, the unit of Lundberg's crown, so
that the search has no scale of its own. The optimum is flat: crowns that differ by tens of per cent
in a parameter may differ by a tenth of a per cent in peak pressure.
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
STRIPS = (60, 200)  # fewest and most


@dataclass(frozen=True)
class BestCrown:
    """K_1, K_2, z_m [length] of a crown designed for the load, and its peak pressure [stress].

    `free` says whether its ends carry nothing; if no crown's do, it is the one whose ends carry
    least.
    """

    K_1: float
    K_2: float
    z_m: float
    peak: float
    free: bool


def best_crown(
    *, load: float, length: float, R: float, E_star: float, tilt: ArrayLike = 0.0
) -> BestCrown:
    """The crown for `load` of a roller of this length.

    `tilt` [rad] may be several angles: the highest peak of all counts, and every end. The range is
    K_1 from 0.5 to 100, K_2 from 0.2, z_m from 2 to 300 A_1. ValueError for what makes no sense,
    ArithmeticError where the strips fail.

    >>> straight = best_crown(load=3407.0, length=9e-3, R=2.95e-3, E_star=113e9)
    >>> straight.free, bool(1.0 < straight.peak / 2.149e9 < 1.06)  # Hertz's of an even load
    (True, True)
    """
    load, length = float(positive(load, "load", "N")), float(positive(length, "length", "m"))
    E_star = float(positive(E_star, "contact modulus", "Pa"))
    angles = finite(tilt, "tilt", "rad").ravel()
    if not angles.size:
        raise ValueError("tilt must be an angle or several [rad], got none")
    b = np.sqrt(4 * load * float(positive(R, "relative radius", "m")) / (np.pi * E_star * length))
    y = slice_centres(length=length, slices=int(np.clip(round(length / b), *STRIPS)))
    lean = np.unique(np.abs(angles))[:, None] * y  # the crown is the same at both ends
    unit = load / (np.pi * length * E_star)
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
        ends = (found.q[..., 0] + found.q[..., -1]).max(axis=-1) * length / load
        # a crown whose ends carry comes after every one whose ends do not
        best = int(np.argmin(np.where(ends > 0, (1 + ends) * peak.max(), peak)))
        centre, reach = np.log(tried[best]), SHRINK * (top - bottom) / 2
        bottom, top = np.maximum(centre - reach, low), np.minimum(centre + reach, high)
    K_1, K_2, z_m = tried[best]
    return BestCrown(
        float(K_1), min(float(K_2), 1.0), float(z_m * unit), float(peak[best]), not ends[best] > 0
    )
