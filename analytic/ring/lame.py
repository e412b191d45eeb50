r"""Thick-walled ring under internal and external pressure (Lamé).

.. math::
    \sigma_{r,\theta} = A \mp \frac{B}{r^2}, \qquad
    A = \frac{p_i r_i^2 - p_o r_o^2}{r_o^2 - r_i^2}, \quad
    B = \frac{(p_i - p_o)\, r_i^2 r_o^2}{r_o^2 - r_i^2}

Pressures are positive in compression, stresses in tension. Any consistent units. The stresses in
the plane are equal for all end conditions:

"plane stress"  thin ring, no axial stress;
"plane strain"  long ring between rigid end walls, no axial strain;
"closed ends"   pressure vessel: the axial stress A carries the pressure on the end caps.

Range: linear elasticity, small strain; exact within it.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed.,
   McGraw-Hill 1970, art. 28.
"""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Ends = Literal["plane stress", "plane strain", "closed ends"]


def stresses(
    r: ArrayLike, *, r_i: ArrayLike, r_o: ArrayLike, p_i: ArrayLike, p_o: ArrayLike = 0.0
) -> tuple[Array, Array]:
    """Radial and hoop stress [stress] at the radii `r`; all arguments are broadcast.

    >>> sigma_r, sigma_t = stresses([1.0, 2.0], r_i=1.0, r_o=2.0, p_i=3.0)
    >>> sigma_t.tolist()  # bore: p (r_o² + r_i²) / (r_o² - r_i²) = 5/3 p
    [5.0, 2.0]
    """
    r = _radii_in_wall(r, r_i, r_o)
    A, B = _constants(r_i, r_o, p_i, p_o)
    return A - B / r**2, A + B / r**2


def axial_stress(
    *, r_i: ArrayLike, r_o: ArrayLike, p_i: ArrayLike, p_o: ArrayLike = 0.0, nu: float, ends: Ends
) -> Array:
    """Uniform axial stress [stress]: 0 (plane stress), 2 nu A (plane strain) or A (closed ends)."""
    _radii_in_wall(r_i, r_i, r_o)
    A, _ = _constants(r_i, r_o, p_i, p_o)
    return _axial_factor(nu, ends) * A


def radial_displacement(
    r: ArrayLike,
    *,
    r_i: ArrayLike,
    r_o: ArrayLike,
    p_i: ArrayLike,
    p_o: ArrayLike = 0.0,
    E: ArrayLike,
    nu: float,
    ends: Ends,
) -> Array:
    r"""Radial displacement [length] at the radii `r`; outward is positive.

    .. math:: u_r = \frac{1}{E}\left[(1-\nu) A r + (1+\nu)\frac{B}{r} - \nu\,\sigma_z r\right]

    with the axial stress :math:`\sigma_z` of the end condition.
    """
    r = _radii_in_wall(r, r_i, r_o)
    _elastic(E, nu)
    A, B = _constants(r_i, r_o, p_i, p_o)
    sigma_z = _axial_factor(nu, ends) * A
    return np.asarray(((1 - nu) * A * r + (1 + nu) * B / r - nu * sigma_z * r) / np.asarray(E))


def strain_energy(
    *,
    r_i: float,
    r_o: float,
    p_i: float,
    p_o: float = 0.0,
    E: float,
    nu: float,
    ends: Literal["plane stress", "plane strain"],
) -> float:
    r"""Strain energy [force] of the whole ring per unit length, by integration of the stresses.

    .. math::
        U = \frac{\pi}{E}\left[\left(1 - \nu - \nu\, k\right) A^2 (r_o^2 - r_i^2)
            + (1+\nu) B^2 \left(r_i^{-2} - r_o^{-2}\right)\right], \qquad k = \sigma_z / A

    >>> wall = dict(r_i=1.0, r_o=2.0, p_i=1.0, E=1.0, nu=0.25, ends="plane stress")
    >>> work = 2 * np.pi * radial_displacement(1.0, **wall) / 2  # p_i 2 pi r_i u(r_i) / 2
    >>> bool(np.isclose(strain_energy(**wall), work, rtol=1e-15))
    True
    """
    _radii_in_wall(r_i, r_i, r_o)
    _elastic(E, nu)
    A, B = _constants(r_i, r_o, p_i, p_o)
    k = _axial_factor(nu, ends)
    uniform = (1 - nu - nu * k) * A**2 * (r_o**2 - r_i**2)
    return float(np.pi / E * (uniform + (1 + nu) * B**2 * (1 / r_i**2 - 1 / r_o**2)))


def _constants(
    r_i: ArrayLike, r_o: ArrayLike, p_i: ArrayLike, p_o: ArrayLike
) -> tuple[Array, Array]:
    r_i, r_o, p_i, p_o = (np.asarray(x, dtype=np.float64) for x in (r_i, r_o, p_i, p_o))
    if not (np.all(np.isfinite(p_i)) and np.all(np.isfinite(p_o))):
        raise ValueError(f"pressures must be finite, got p_i={p_i} Pa, p_o={p_o} Pa")
    wall = r_o**2 - r_i**2
    return (p_i * r_i**2 - p_o * r_o**2) / wall, (p_i - p_o) * r_i**2 * r_o**2 / wall


def _axial_factor(nu: float, ends: Ends) -> float:
    factors = {"plane stress": 0.0, "plane strain": 2 * nu, "closed ends": 1.0}
    if ends not in factors:
        raise ValueError(f"ends must be one of {', '.join(factors)}, got {ends!r}")
    return factors[ends]


def _elastic(E: ArrayLike, nu: float) -> None:
    E = np.asarray(E, dtype=np.float64)
    if not np.all((E > 0) & np.isfinite(E)):
        raise ValueError(f"Young's modulus must be positive and finite, got E={E} Pa")
    if not -1 < nu < 0.5:
        raise ValueError(f"Poisson's ratio must lie in (-1, 0.5), got nu={nu:g}")


def _radii_in_wall(r: ArrayLike, r_i: ArrayLike, r_o: ArrayLike) -> Array:
    r, low, high = (np.asarray(x, dtype=np.float64) for x in (r, r_i, r_o))
    if not np.all((low > 0) & (low < high) & np.isfinite(high)):
        raise ValueError(
            f"radii of a ring must satisfy 0 < r_i < r_o, got r_i={low} m, r_o={high} m"
        )
    slack = 1e-12 * high  # a radius computed by the caller may miss the wall by round-off
    if not np.all((r >= low - slack) & (r <= high + slack)):
        raise ValueError(f"r must lie in the wall [{low}, {high}] m, got {r} m")
    return r
