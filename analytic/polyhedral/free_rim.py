r"""Polyhedral ring with a free rim: potential for given forces on the bore.

With Kolosov's and Muskhelishvili's potentials [1]_

.. math:: f = \phi + \zeta\overline{\phi'} + \overline{\psi} = i\int (t_x + i t_y)\,ds, \qquad
          2\mu\,(u + i v) = \kappa\phi - \zeta\overline{\phi'} - \overline{\psi}.

The rim |zeta| = r_e is free of forces (f = 0) if and only if phi is continued across it by

.. math:: \psi(\zeta) = -\overline{\phi}\!\left(\frac{r_e^2}{\zeta}\right)
          - \frac{r_e^2}{\zeta}\,\phi'(\zeta).

Thus, one potential remains, which is analytic in the ring and in its image beyond the rim
(`basis`). Its coefficients follow from f on the bore by least squares; by symmetry, there are no
constants. On a free rim, :math:`u + i v = 4\phi/E'`: Poisson's ratio has an effect only through E'.

The residual is the largest error of f/zeta between the fitted points, divided by the largest given
f/zeta. It is an indication, not an error bound: displacements are more accurate by one to three
digits, the stress in the fillet is less accurate by one or two digits.

References
----------
.. [1] N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity,
   Noordhoff 1953, ch. 5 to 7; the continuation across a circle in ch. 18 and 20.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.polyhedral.basis import CLOSEST, Basis, basis_of
from analytic.polyhedral.sector import Complex, Sector

DENSITIES = (5.0, 7.0)
POINTS = 6  # per pole
OFFSET = 0.382  # offset of evenly spaced points from corners, middles and round shares
CUT = 1e-14  # omitted singular values, relative to the largest
GOOD, WORST = 1e-6, 1e-4  # residual that ends the refinement, residual that is refused


class Values(NamedTuple):
    """Potentials phi and psi [stress times length] and phi' [stress] at points of the ring."""

    phi: Complex
    dphi: Complex
    psi: Complex

    def plus(self, other: "Values") -> "Values":
        """Potentials of both loads together."""
        return Values(self.phi + other.phi, self.dphi + other.dphi, self.psi + other.psi)

    def force(self, zeta: Complex) -> Complex:
        """Force function f; the change of f along an arc is i times the force on this arc."""
        return self.phi + zeta * np.conj(self.dphi) + np.conj(self.psi)


@dataclass(frozen=True)
class FreeRim:
    """Potential of a ring with a free rim; stresses have the unit of the load."""

    sector: Sector
    basis: Basis
    coefficients: Array
    residual: float

    def __call__(self, zeta: Complex) -> Values:
        """Potentials at the points zeta of the ring."""
        xi = np.asarray(zeta) / self.sector.r_e
        omega = xi**self.basis.z
        F, zoF = (part @ self.coefficients for part in self.basis.values(omega))
        image = self.basis.values(1 / omega)[0] @ self.coefficients
        psi = -(image + F + zoF) / xi * self.sector.r_e
        return Values(self.sector.r_e * xi * F, F + zoF, psi)

    def rim_displacement(self, theta: ArrayLike) -> Complex:
        """Displacements u_r + i u_theta of the rim times E' [load times length] at theta [rad]."""
        turn = np.exp(1j * np.atleast_1d(np.asarray(theta, dtype=np.float64)))
        return np.asarray(4 * self(self.sector.r_e * turn).phi / turn)


def free_rim(sector: Sector, load: Callable[[Complex, Array], Complex]) -> FreeRim:
    """Potential of a ring whose force function f at the bore points zeta(s) is zeta*load(zeta, s).

    Raises ArithmeticError if the residual exceeds 1e-4 after two refinements.
    """
    for density in DENSITIES:
        fit = _fit(sector, density)
        asked = load(fit.zeta, fit.s)
        scale = np.abs(asked).max()
        coefficients = fit.coefficients(asked[fit.used])
        residual = float(np.abs(fit.rows @ coefficients - asked).max() / scale)
        if residual < GOOD:
            break
    if not residual < WORST:
        raise ArithmeticError(
            f"the series is not accurate for this ring: its error is {residual:.1e} of the load "
            f"on the bore, permissible {WORST:g}, got z={sector.z}, d_e={sector.d_e:g} m, "
            f"d_i={sector.d_i:g} m, rho={sector.rho:g} m"
        )
    return FreeRim(sector, fit.basis, coefficients, residual)


class _Fit(NamedTuple):
    basis: Basis
    s: Array
    zeta: Complex
    used: slice  # the points that are fitted; the others verify
    rows: Complex
    left: Array  # of the singular value decomposition of the rows' scaled parts
    right: Array  # with the singular values and scales divided out

    def coefficients(self, asked: Complex) -> Array:
        """Least-squares coefficients; for accuracy, no pseudoinverse is formed."""
        return np.asarray(self.right @ (self.left.T @ np.concatenate([asked.real, asked.imag])))


@lru_cache(maxsize=8)
def _fit(sector: Sector, density: float) -> _Fit:
    basis = basis_of(sector, density=density)
    s = _arc_lengths(sector, density)
    zeta = sector.bore(s)
    xi = zeta / sector.r_e
    F, zoF = basis.values(xi**sector.z)
    image, _ = basis.values(xi**-sector.z)
    inward = 1 / np.abs(xi[:, None]) ** 2
    rows = F + (1 - inward) * np.conj(F + zoF) - inward * np.conj(image)
    used = slice(None, None, 2)
    parts = np.vstack([rows[used].real, rows[used].imag])
    norms = np.linalg.norm(parts, axis=0)
    U, sigma, Vt = np.linalg.svd(parts / norms, full_matrices=False)
    kept = sigma > CUT * sigma[0]
    right = (Vt[kept] / sigma[kept, None]).T / norms[:, None]
    return _Fit(basis, s, zeta, used, rows, U[:, kept], right)


def _arc_lengths(sector: Sector, density: float) -> Array:
    """Arc lengths of points on flat and fillet: equally spaced, denser near the tangent point."""
    arc = sector.rho * sector.half_angle
    even = (np.arange(int(36 * density)) + OFFSET) / int(36 * density)
    side = min(arc, sector.straight)
    near = np.geomspace(CLOSEST, 1, int(POINTS * density * np.log(1 / CLOSEST) / 2))
    far = np.geomspace(
        side, sector.straight, int(POINTS * density * np.log(sector.straight / side))
    )
    flat = sector.straight - np.concatenate([side * near, far, sector.straight * even])
    return np.unique(np.concatenate([flat, sector.straight + arc * np.append(near[:-1], even)]))
