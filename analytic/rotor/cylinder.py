r"""Whirl of a rotating solid or hollow cylinder in three-dimensional elasticity.

The ends at z = 0 and L are fixed in the transverse direction and free axially. Then, mode j is
exactly a sine,

.. math:: u = (U(r)\sin kz,\ -iV(r)\sin kz,\ W(r)\cos kz)\,e^{i(\varphi - wt)},\quad k = j\pi/L,

and the problem is one-dimensional. U, V and W are polynomials whose coefficients make the action

.. math::
    \int \sigma:\varepsilon + \rho\,[2wW(U^2+V^2+2UV+W^2) - w^2(U^2+V^2+W^2)]\,r\,dr

stationary; W in front of the bracket is the rotational speed. The solutions are smooth: each
additional power adds at least one correct digit. Terms with the square of the speed and the
stiffening by centrifugal stress are neglected; they cancel each other where a section rotates like
a rigid body.

References
----------
.. [1] L. Meirovitch, Computational Methods in Structural Dynamics, Sijthoff & Noordhoff (1980),
   chapters 3 (gyroscopic systems) and 8 (Rayleigh-Ritz).
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.linalg import eigh

Array = NDArray[np.float64]
POWERS = 13  # of each amplitude: two more change no frequency by 1e-9 for r_i > 0.05 r_o, k r_o < 3


@dataclass(frozen=True, kw_only=True)
class Cylinder:
    """Cylinder with radii r_o, r_i [length], E [stress], nu, rho [mass/volume].

    `powers` is the number of powers in the polynomial of an amplitude. Raises ValueError unless
    0 <= r_i < r_o, E and rho are positive and -1 < nu < 0.5.

    >>> steel = Cylinder(r_o=1.0, E=1.0, nu=0.3, rho=1.0)
    >>> ahead, behind = steel.whirl(0.02, count=1)
    >>> round(float(ahead[0]) / 0.02**2, 3)  # of a thin bar, sqrt(E I/(rho A)) = r_o/2
    0.5
    """

    r_o: float
    E: float
    nu: float
    rho: float
    r_i: float = 0.0
    powers: int = POWERS

    def __post_init__(self) -> None:
        if not 0 <= self.r_i < self.r_o < np.inf:
            raise ValueError(
                f"radii of a cylinder must satisfy 0 <= r_i < r_o, got r_i={self.r_i:g} m, "
                f"r_o={self.r_o:g} m"
            )
        if not (0 < self.E < np.inf and 0 < self.rho < np.inf and -1 < self.nu < 0.5):
            raise ValueError(
                f"a cylinder must have E > 0, rho > 0 and -1 < nu < 0.5, got E={self.E:g} Pa, "
                f"rho={self.rho:g} kg/m^3, nu={self.nu:g}"
            )
        if self.powers < 2:
            raise ValueError(
                "`powers`, the number of powers in the polynomial of an amplitude, must be at "
                f"least 2, got {self.powers}"
            )

    def whirl(self, k: float, *, Omega: float = 0.0, count: int = 1) -> tuple[Array, Array]:
        """Lowest angular frequencies (count,), forward and backward, at the wave number k.

        The first frequency is that of bending. Raises ValueError unless k > 0.
        """
        K, M, G = self._matrices(k)
        zero = np.zeros_like(K)
        left = np.block([[K, zero], [zero, M]])
        right = np.block([[-Omega * G, M], [M, zero]])
        inverse = eigh(right, left, eigvals_only=True)  # w diag(..) x = ..: 1/w
        return 1 / inverse[::-1][:count], -1 / inverse[:count]

    def critical_speeds(self, k: float, *, count: int = 1, backward: bool = False) -> Array:
        """Critical speeds (at most `count`) [1/time] of forward or backward whirl."""
        K, M, G = self._matrices(k)
        inverse = eigh(M + G if backward else M - G, K, eigvals_only=True)[::-1][:count]
        return np.asarray(1 / np.sqrt(inverse[inverse > 0]))

    def _matrices(self, k: float) -> tuple[Array, Array, Array]:
        """Stiffness, mass and gyroscopic matrices per unit length."""
        if not 0 < k < np.inf:
            raise ValueError(f"the wave number must be positive, got k={k:g} 1/m")
        u, du, weight, r = self._amplitudes()
        (U, V, W), (dU, dV, dW) = u, du
        lam = self.E * self.nu / ((1 + self.nu) * (1 - 2 * self.nu))
        mu = self.E / (2 * (1 + self.nu))
        around = (U + V) / r  # U cancels
        direct = np.array([dU, around, -k * W])  # along r, around, along z
        shears = np.array([dV - around, k * V - W / r, k * U + dW])
        volume = direct.sum(axis=0)
        K = lam * _square(volume, weight) + sum(
            2 * mu * _square(strain, weight) for strain in direct
        )
        K = K + sum(mu * _square(strain, weight) for strain in shears)
        M = self.rho * sum(_square(part, weight) for part in (U, V, W))
        G = 2 * self.rho * (_square(U + V, weight) + _square(W, weight))
        scale = 1 / np.sqrt(np.diag(K))
        return tuple(scale[:, None] * part * scale for part in (K, M, G))  # type: ignore[return-value]

    def _amplitudes(self) -> tuple[Array, Array, Array, Array]:
        """Amplitudes U, V, W and slopes, (3, points, coefficients) each; weights times r; radii.

        With polynomials f, g, h: U = f, V = -f + c g, W = b h. For a solid cylinder, they are
        polynomials in r^2 with c = (r/r_o)^2, b = r/r_o, so that displacements and strains are
        single-valued on the axis. For a hollow cylinder, they are polynomials in ln r, because
        Bessel's functions are entire in ln r, and c = b = 1.
        """
        p = self.powers
        x, w = legendre.leggauss(2 * p + 4)
        if self.r_i:
            span = np.log(self.r_o / self.r_i)
            r = self.r_o * np.exp(span * (x - 1) / 2)
            dx, b, db, c, dc = 2 / (span * r), np.ones_like(r), 0 * r, np.ones_like(r), 0 * r
        else:
            b = np.sqrt((x + 1) / 2)
            r, c, db = self.r_o * b, b**2, np.full_like(b, 1 / self.r_o)
            dx, dc = 4 * r / self.r_o**2, 2 * r / self.r_o**2
        f = legendre.legvander(x, p - 1)
        slope = [legendre.legval(x, legendre.legder(row)) for row in np.eye(p)]
        df = np.column_stack(slope) * dx[:, None]
        none = np.zeros_like(f)
        b, db, c, dc = (part[:, None] for part in (b, db, c, dc))
        U, dU = np.hstack([f, none, none]), np.hstack([df, none, none])
        V, dV = np.hstack([-f, c * f, none]), np.hstack([-df, c * df + dc * f, none])
        W, dW = np.hstack([none, none, b * f]), np.hstack([none, none, b * df + db * f])
        return np.array([U, V, W]), np.array([dU, dV, dW]), w * r / dx, r[:, None]


def _square(strain: Array, weight: Array) -> Array:
    return np.asarray(strain.T @ (strain * weight[:, None]))
