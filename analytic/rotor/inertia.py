"""Mass and moments of inertia of tubes and discs on one axis, as rigid bodies."""

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def tubes_inertia(*, end: Array, length: Array, d_o: Array, d_i: Array, rho: float) -> Array:
    """Total mass, polar and diametral moment of inertia (3,) of tubes that end at z = `end`.

    The diametral moment is about z = 0. Positions, lengths and diameters are arrays (e,) [m]; rho
    is the density [kg/m^3].

    >>> one = np.ones(1)
    >>> shape = {"end": one, "length": one, "d_o": one, "d_i": 0 * one}
    >>> m, polar, diametral = tubes_inertia(**shape, rho=4 / np.pi)
    >>> float(m), float(polar), round(float(diametral - 1 / 3), 12)
    (1.0, 0.125, 0.0625)
    """
    area, fourth = ((d_o**n - d_i**n) * rho * np.pi for n in (2, 4))
    cubes = (end**3 - (end - length) ** 3) / 3
    return np.array([
        (area * length).sum() / 4,
        (fourth * length).sum() / 32,
        (fourth * length / 64 + area * cubes / 4).sum(),
    ])  # fmt: skip


def discs_inertia(*, z: Array, mass: Array, polar: Array, diametral: Array) -> Array:
    """Total mass, polar and diametral moment of inertia (3,) of discs at z (k,) [m].

    The diametral moment is about z = 0.
    """
    return np.array([mass.sum(), polar.sum(), (diametral + mass * z**2).sum()])


def cylinder_inertia(
    *, d_o: float, d_i: float, width: float, rho: float, mass: float | None = None
) -> tuple[float, float, float]:
    """Mass [kg], polar and diametral moment of inertia [kg m^2] of a cylinder about its middle.

    Diameters and width are in m. If `mass` is omitted, it follows from the density rho [kg/m^3].

    >>> cylinder_inertia(d_o=2.0, d_i=0.0, width=1.0, rho=1.0, mass=12.0)  # m r^2/2
    (12.0, 6.0, 4.0)
    """
    full = rho * math.pi / 4 * (d_o**2 - d_i**2) * width
    m = full if mass is None else mass
    around = m * (d_o**2 + d_i**2) / 8
    return m, around, around / 2 + m * width**2 / 12
