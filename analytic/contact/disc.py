r"""Disc pressed between two rigid, frictionless, parallel flats, without Hertz's simplifications.

Two unit forces press the ends of the vertical chord at x'. By the complex potentials of a disc
under boundary forces (Muskhelishvili), the upper rim moves upwards by 2/(pi E') times the sum of
yy'/R² and ln(d_1/d_2); d_1 and d_2 are the distances from the nearer and the more distant force.
The mean of this and of the displacement by the mirror chord at -x' is the kernel of the half plane
plus an analytic remainder:

.. math::
    k(x, x') = \frac{2}{\pi E'}\left[\ln|x - x'| - \ln(y + y') + \frac{y y'}{R^2}\right],
    \qquad y = \sqrt{R^2 - x^2}

Poisson's ratio has an effect only through E'. The flats act along y only: the rim is in contact
where its height after loading equals the height of the flat. With the pressure q per unit length of
the flat, this condition is

.. math:: y(x) + \int_{-a}^{a} k(x, x')\, q(x')\, dx' = R - \delta, \qquad |x| \le a.

The series q = sqrt(1 - s²) sum b_k U_2k(s), s = x/a, vanishes at the edges, and the integral of the
logarithm becomes algebraic. The remainder of the kernel is analytic. Therefore, the series
converges geometrically with the ratio :math:`(R/a + \sqrt{R^2/a^2 - 1})^{-2}`. The solution is
exact within linear elasticity on the undeformed circle.

The solution is also valid for a column of equal discs, which touch along flat planes by symmetry.
It is not valid for a disc with a support other than an opposite contact (a rigid core, a support
distributed over the opposite side). Such a support changes the leading order of the correction to
Hertz.

References
----------
.. [1] N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity,
   Noordhoff 1953: the disc under concentrated forces on its boundary.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from analytic.contact.checks import Array, finite, positive

TERMS = 40
WIDEST = 0.9  # a/R up to which the last of 40 terms is round-off


@dataclass(frozen=True)
class PressedDisc:
    """Solution for a disc between flats under one load, in the caller's units."""

    R: float
    a: float
    P: float
    p_0: float
    approach: float  # of one flat and the centre
    coefficients: Array  # b_k [stress]

    @property
    def moment_width(self) -> float:
        """Half-width [length] 2 sqrt(int q x² / int q) from the moments of the pressure.

        For Hertz's pressure, it equals a. For the disc, it exceeds a by the fraction 1/16 (a/R)²,
        because the pressure distribution is flatter than Hertz's.
        """
        return float(self.a * np.sqrt(1 + self.coefficients[1] / self.coefficients[0]))

    def pressure(self, x: ArrayLike) -> Array:
        """Contact pressure [stress]: force over area of the flat; 0 outside the contact.

        The force per unit length of the circle is sqrt(1 - x²/R²) times this pressure; both are
        equal in the middle.
        """
        s = finite(x, "position", "m") / self.a
        turn = np.arccos(np.clip(s, -1, 1))[..., None]
        waves = np.sin((2 * np.arange(TERMS) + 1) * turn)  # sqrt(1 - s²) U_2k(s)
        return np.where(np.abs(s) < 1, waves @ self.coefficients, 0.0)


def disc_in_contact(*, a: float, R: float, E_plane: float) -> PressedDisc:
    """Disc of radius R and modulus E' with a contact of half-width a, at most 0.9 R.

    E' = `E_plane` is E in plane stress, E/(1 - nu²) in plane strain.

    >>> disc = disc_in_contact(a=0.1, R=1.0, E_plane=1.0)
    >>> hertz = float(np.sqrt(disc.P / np.pi))
    >>> round(disc.p_0 / hertz - 1, 5)  # 3/16 a² + ...
    0.00188
    """
    _check(R, E_plane)
    positive(a, "half-width", "m")
    if a > WIDEST * R:
        raise ValueError(f"the half-width must be at most {WIDEST} R, got a={a:g} m, R={R:g} m")
    ratio = a / R
    b, sinking = _solve(ratio)
    signs = (-1.0) ** np.arange(TERMS)
    q = E_plane * ratio * b
    return PressedDisc(
        R=R,
        a=a,
        P=float(np.pi / 2 * a * q[0]),
        p_0=float(signs @ q),
        approach=R * ratio**2 * sinking,
        coefficients=q,
    )


def disc_under_load(*, P: float, R: float, E_plane: float) -> PressedDisc:
    """Disc of radius R and modulus E' pressed by the load P per unit length.

    >>> disc = disc_under_load(P=1.0, R=1.0, E_plane=100.0)
    >>> round(disc.P, 12)
    1.0
    """
    _check(R, E_plane)
    positive(P, "load per length", "N/m")
    load = P / (E_plane * R)
    hertz = np.sqrt(4 * load / np.pi)  # above the true a/R, by 5/16 (a/R)² of it

    def excess(ratio: float) -> float:
        b, _ = _solve(ratio)
        return float(np.pi / 2 * ratio**2 * b[0] / load - 1)

    if excess(WIDEST) < 0:
        raise ValueError(
            f"the load must be lower: the half-width must be at most a = {WIDEST} R, got "
            f"P/(E' R) = {load:g} (no unit)"
        )
    ratio = brentq(excess, hertz / 2, min(hertz, WIDEST), xtol=1e-15 * hertz, rtol=1e-14)
    return disc_in_contact(a=ratio * R, R=R, E_plane=E_plane)


def _check(R: float, E_plane: float) -> None:
    positive(R, "radius", "m")
    positive(E_plane, "modulus", "Pa")


def _solve(ratio: float) -> tuple[Array, float]:
    """Coefficients divided by E' a/R and approach divided by a²/R, by Chebyshev collocation."""
    s = np.cos((2 * np.arange(TERMS + 1) + 1) * np.pi / (4 * (TERMS + 1)))
    y = np.sqrt(1 - (ratio * s) ** 2)
    rows = np.ones((TERMS + 1, TERMS + 1))  # the last column: the flat's approach
    rows[:, :TERMS] = 2 / np.pi * (_logarithm(s, ratio) + _smooth(y, ratio))
    solution = np.linalg.solve(rows, s**2 / (1 + y))
    return solution[:TERMS], float(solution[TERMS])


def _logarithm(s: Array, ratio: float) -> Array:
    """Integrals of ln(a/R |s - t|) sqrt(1 - t²) U_2k(t) over (-1, 1), shape (points, terms)."""
    n = 2 * np.arange(1, TERMS)
    turn = np.arccos(s)[:, None]
    first = np.pi / 2 * (np.log(ratio) - np.log(2) + np.cos(2 * turn) / 2)
    return np.hstack([first, np.pi / 2 * (np.cos((n + 2) * turn) / (n + 2) - np.cos(n * turn) / n)])


def _smooth(y: Array, ratio: float) -> Array:
    """Integrals of the analytic remainder of the kernel, by Gauss-Chebyshev quadrature."""
    count = 4 * TERMS
    turn = np.arange(1, count + 1) * np.pi / (count + 1)
    y_t = np.sqrt(1 - (ratio * np.cos(turn)) ** 2)
    kernel = np.outer(y, y_t) - np.log(np.add.outer(y, y_t))
    waves = np.sin(np.outer(turn, 2 * np.arange(TERMS) + 1)) * np.sin(turn)[:, None]
    return np.asarray(np.pi / (count + 1) * kernel @ waves)
