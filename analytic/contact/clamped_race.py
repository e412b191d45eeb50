r"""Displacement of the bore of a ring with a fixed rim under a line load on the bore.

A pressure cos(n theta) on the bore moves it outwards by U_n cos(n theta). In polar coordinates,
Navier's equations have four solutions for each n, which are powers of r, with
:math:`\kappa = (3 - \nu')/(1 + \nu')` (Kolosov's constant):

.. math::
    (u_r, u_\theta) = (1, -1)\, r^{n-1}, \quad (1, 1)\, r^{-n-1}, \quad
    (\kappa - n - 1,\ \kappa + n + 1)\, r^{n+1}, \quad (\kappa + n - 1,\ n - 1 - \kappa)\, r^{1-n}

times cos and sin of n theta; for n = 1 the last is :math:`(2\kappa \ln r - 1, -2\kappa \ln r - 1)`.
Their sum satisfies four conditions: the given pressure and zero shear at the bore, zero
displacements at the rim. A line load P presses the bore outwards, at the angle theta from the load,
by

.. math:: u(\theta) = \frac{2P}{\pi E'}\left[-\ln\left(2 \sin\frac{\theta}{2}\right)
          + \sum_{n=0} \delta_n \cos n\theta\right], \qquad
          \delta_n = \frac{E' U_n}{2 r_i} - \frac{1}{n},

where delta_0 contains half of U_0. The logarithm is the solution of the half plane; its mean over
an elliptic pressure is ln(2 r_i/a) + 1/2.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 43.
"""

from functools import cache

import numpy as np

from analytic.contact.checks import Array, Assumption, in_plane, positive

TERMS = 4000  # the omitted part of the sum of delta_n, of the order 1/n², is below 1e-3


def approach_to_rim(
    *, P: float, a: float, r_i: float, r_o: float, E: float, nu: float, assumption: Assumption
) -> float:
    r"""Approach [length] of the middle of the contact on the bore to the fixed rim of the ring.

    .. math:: \delta = \frac{2P}{\pi E'}\left[\ln\frac{2 r_i}{a} + \frac{1}{2}
              + \sum_n \delta_n\right]

    for an elliptic pressure over the half-width a. The relative errors are of the order of (a/r_i)²
    and (a/(r_o - r_i))². The coupling of normal and tangential displacements by the curvature
    causes an error of the order a/r_i.
    """
    for value, what in ((P, "load per length"), (a, "half-width")):
        positive(value, what, "N/m" if what.startswith("load") else "m")
    E_plane, nu_plane = (float(v) for v in in_plane(positive(E, "modulus", "Pa"), nu, assumption))
    if not 0 < r_i < r_o < np.inf:
        raise ValueError(
            f"radii of a race must satisfy 0 < r_i < r_o, got r_i={r_i} m, r_o={r_o} m"
        )
    if not a < min(r_i, r_o - r_i):
        raise ValueError(
            f"the half-width must be less than the bore radius r_i and than the wall thickness, "
            f"got a={a} m, r_i={r_i} m"
        )
    bracket = np.log(2 * r_i / a) + 0.5 + _constant(r_o / r_i, nu_plane)
    return float(2 * P / (np.pi * E_plane) * bracket)


def rim_constant(*, r_i: float, r_o: float, nu: float, assumption: Assumption) -> float:
    """Sum of the terms delta_n (no unit) by which the fixed rim changes the approach.

    >>> round(rim_constant(r_i=1.0, r_o=1.4, nu=0.3, assumption="plane strain"), 3)
    -1.493
    """
    _, nu_plane = in_plane(1.0, nu, assumption)
    return _constant(r_o / r_i, float(nu_plane))


@cache
def _constant(ratio: float, nu: float) -> float:
    """Sum of delta_n; the terms decrease as 1/n², and the remainder of the series is estimated."""
    n = np.arange(2, TERMS + 1, dtype=np.float64)
    delta = np.concatenate([[_first(ratio, nu) - 1], _higher(n, ratio, nu) - 1 / n])
    tail = delta[-1] * TERMS  # sum of c/n² beyond n is c/n
    return float(_uniform(ratio, nu) / 2 + delta.sum() + tail)


def _uniform(ratio: float, nu: float) -> float:
    """Dimensionless displacement E' U_0/(2 r_i) of the bore under uniform pressure (Lamé)."""
    # u = A (r - ratio²/r), without movement at the rim, in units of r_i
    A = -(1 - nu**2) / ((1 + nu) + (1 - nu) * ratio**2)
    return float((A - A * ratio**2) / 2)


def _first(ratio: float, nu: float) -> float:
    """Dimensionless displacement E' U_1/(2 r_i); one of the four solutions contains ln r."""
    k = (3 - nu) / (1 + nu)

    def solutions(r: float) -> tuple[Array, Array, Array, Array]:
        ln = np.log(r)
        U = np.array([1.0, r**-2, (k - 2) * r**2, 2 * k * ln - 1])
        V = np.array([-1.0, r**-2, (k + 2) * r**2, -2 * k * ln - 1])
        slope_U = np.array([0.0, -2 * r**-3, 2 * (k - 2) * r, 2 * k / r])
        slope_V = np.array([0.0, -2 * r**-3, 2 * (k + 2) * r, -2 * k / r])
        return U, V, slope_U, slope_V

    U, V, dU, dV = solutions(1.0)
    rim_U, rim_V, *_ = solutions(ratio)
    pressed = dU + nu * (U + V)  # sigma_r (1 - nu²)/E' at r = 1
    sheared = dV - V - U
    c = np.linalg.solve(np.array([pressed, sheared, rim_U, rim_V]), [-(1 - nu**2), 0, 0, 0])
    return float(c @ U) / 2


def _higher(n: Array, ratio: float, nu: float) -> Array:
    """Dimensionless displacements E' U_n/(2 r_i), n >= 2.

    Powers of r that increase with r are scaled to 1 at the rim.
    """
    k, one = (3 - nu) / (1 + nu), np.ones(n.size)
    # solution by solution: U, V at r = 1 and exponents
    U = np.array([one, one, k - n - 1, k + n - 1])
    V = np.array([-one, one, k + n + 1, n - 1 - k])
    m = np.array([n - 1, -n - 1, n + 1, 1 - n], dtype=np.float64)
    at_bore = np.where(m > 0, ratio ** -np.maximum(m, 0.0), 1.0)
    at_rim = np.where(m > 0, 1.0, ratio ** np.minimum(m, 0.0))
    pressed = at_bore * (m * U + nu * (U + n * V))
    sheared = at_bore * (m * V - V - n * U)
    A = np.array([pressed, sheared, at_rim * U, at_rim * V]).transpose(2, 0, 1)
    b = np.tile([-(1 - nu**2), 0.0, 0.0, 0.0], (n.size, 1))
    c = np.linalg.solve(A, b[..., None])[..., 0]
    return np.asarray((c * (at_bore * U).T).sum(axis=1) / 2)
