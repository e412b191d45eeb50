r"""Ring under a periodic pressure on one wall; the other wall is free (Michell's Fourier series).

The pressure sum p_m cos(m theta), m = 0, n, 2n, ..., acts on the bore or on the rim; m = 0 is
Lamé's ring. For m >= 2, Michell's stress functions r^m, r^(m+2), r^-m, r^(2-m) times cos(m theta)
are combined in pairs: A, C decay from the rim, B, D decay from the bore. With rho = r/r_o,
s = r_i/r, the stresses (sigma_r, sigma_theta, tau), times (cos, cos, sin), are

.. math::
    A:\ & (1, -1, -1)\,\rho^{m-2}, &
    C:\ & (2, 2, 0)\,\rho^m + m\,(1, -1, -1)(\rho^{m-2} - \rho^m), \\
    B:\ & (-1, 1, -1)\,s^{m+2}, &
    D:\ & (-2, -2, 0)\,s^m + m\,(-1, 1, -1)(s^m - s^{m+2}),

and the displacements (u_r, u_theta) times 2G, with Kolosov's constant kappa, are

.. math::
    A:\ & r_o \frac{\rho^{m-1}}{m-1} (1, -1), &
    C:\ & r_o \left[\rho^{m-1}\left(1 - \rho^2 + \tfrac{1}{m-1}\right)(1, -1)
          + \frac{\kappa\rho^{m+1}}{m+1} (1, 1)\right], \\
    B:\ & r_i \frac{s^{m+1}}{m+1} (1, 1), &
    D:\ & r_i \left[s^{m-1}\left(1 - s^2 + \tfrac{s^2}{m+1}\right)(1, 1)
          + \frac{\kappa s^{m-1}}{m-1} (1, -1)\right].

No power of rho or s exceeds 1, so that m may be as large as a narrow patch requires. C and D do not
contain the parts that would be nearly equal to A and B. Therefore, the four equations of the wall
tractions are well conditioned: the tractions (sigma_r, tau) on the respective wall are (1, -1) for
A, (2, 0) for C, (-1, -1) for B and (-2, 0) for D. The solution is exact for a finite sum of p_m,
within plane linear elasticity.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 43.
.. [2] J. R. Barber, Elasticity, 3rd ed., Springer 2010, tables 8.1 and 9.1 (Michell's solution).
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, in_plane, positive
from analytic.ring import lame

Wall = Literal["bore", "rim"]
NEGLIGIBLE = 40.0  # -ln of the share below which one wall does not affect the other
CHUNK = 1_000_000  # cosines that are held at once


@dataclass(frozen=True, kw_only=True)
class State:
    """Displacements [length] and stresses [stress] at points, in the shape of the points."""

    u_r: Array
    u_theta: Array
    sigma_r: Array
    sigma_theta: Array
    tau: Array


@dataclass(frozen=True, kw_only=True)
class FourierRing:
    """Ring whose pressure on the `loaded` wall is the sum of p[k] cos(k n theta).

    `p` (K + 1,) [stress] is positive in compression. n must be at least 2, because the loads with
    n = 1 are not in equilibrium. Raises ValueError for impossible radii.

    >>> ring = FourierRing(r_i=1.0, r_o=2.0, E=1.0, nu=0.25, assumption="plane stress",
    ...                    loaded="bore", n=2, p=np.array([3.0, 0.0]))
    >>> float(ring.at(1.0, 0.0).sigma_theta)  # Lamé: 5/3 p
    5.0
    """

    r_i: float
    r_o: float
    E: float
    nu: float
    assumption: Assumption
    loaded: Wall
    n: int
    p: Array

    def __post_init__(self) -> None:
        if not 0 < self.r_i < self.r_o < np.inf:
            raise ValueError(
                f"radii of a ring must satisfy 0 < r_i < r_o, got r_i={self.r_i} m, r_o={self.r_o} "
                "m"
            )
        if self.n < 2:
            raise ValueError(
                f"n must be at least 2, so that the loads are in equilibrium, got n={self.n}"
            )
        if self.loaded not in ("bore", "rim"):
            raise ValueError(f"the loaded wall must be 'bore' or 'rim', got {self.loaded!r}")
        positive(self.E, "Young's modulus", "Pa")
        if not np.all(np.isfinite(self.p)):
            raise ValueError("pressures must be finite")

    @property
    def plane(self) -> tuple[float, float]:
        """Elastic constants E' and nu' of Hooke's law in the plane."""
        E, nu = in_plane(self.E, self.nu, self.assumption)
        return float(E), float(nu)

    @property
    def kappa(self) -> float:
        """Kolosov's constant (3 - nu')/(1 + nu')."""
        _, nu = self.plane
        return (3 - nu) / (1 + nu)

    @property
    def double_shear_modulus(self) -> float:
        """Twice the shear modulus, 2G [stress]."""
        return self.E / (1 + self.nu)

    def at(self, r: ArrayLike, theta: ArrayLike) -> State:
        """State at the radii `r` and the angles `theta` [rad] from the middle of a patch."""
        radii, angles = np.broadcast_arrays(
            np.asarray(r, dtype=np.float64), np.asarray(theta, dtype=np.float64)
        )
        flat, turn = radii.ravel(), angles.ravel()
        sums = self._mean(flat)
        for radius in np.unique(flat):
            here = np.flatnonzero(flat == radius)
            waves = self._waves(float(radius))
            step = max(1, CHUNK // max(waves.shape[1], 1))
            for part in np.split(here, range(step, here.size, step)):
                sums[:, part] += self._summed(waves, turn[part])
        u_r, u_theta, *stresses = (row.reshape(radii.shape) for row in sums)
        return State(
            u_r=u_r, u_theta=u_theta, sigma_r=stresses[0], sigma_theta=stresses[1], tau=stresses[2]
        )

    def mean_displacement(self, r: float) -> float:
        """Mean of the radial displacement [length] over the circle of radius r."""
        return float(self._mean(np.array([r]))[0, 0])

    @property
    def _m(self) -> Array:
        return self.n * np.arange(1.0, self.p.size)

    def _mean(self, r: Array) -> Array:
        """Fields (5, points) under the mean pressure: Lamé's ring."""
        wall = {"r_i": self.r_i, "r_o": self.r_o, "p_i": 0.0, "p_o": 0.0}
        wall["p_i" if self.loaded == "bore" else "p_o"] = float(self.p[0])
        radial, hoop = lame.stresses(r, **wall)
        u = lame.radial_displacement(r, E=self.E, nu=self.nu, ends=self.assumption, **wall)
        return np.array([u, np.zeros_like(r), radial, hoop, np.zeros_like(r)])

    @cached_property
    def _amplitudes(self) -> Array:
        """Amplitudes (4, K) of the stress functions A, B, C, D [stress]."""
        m, p = self._m, np.asarray(self.p[1:], dtype=np.float64)
        rim = self.loaded == "rim"
        zero = np.zeros_like(p)
        own = [zero, zero, -p / 2, zero] if rim else [zero, zero, zero, p / 2]
        found = np.array(own)  # as on a disc, or around a hole
        far = np.log(self.r_o / self.r_i)
        coupled = m[(m - 2) * far < NEGLIGIBLE]
        b = np.zeros((coupled.size, 4))  # sigma_r, tau at the rim; at the bore
        b[:, 0 if rim else 2] = -p[: coupled.size]
        A = _wall_tractions(coupled, far)
        found[:, : coupled.size] = np.linalg.solve(A, b[..., None])[..., 0].T
        return found

    def _waves(self, r: float) -> Array:
        """Amplitudes (5, K) of u_r, u_theta, sigma_r, sigma_theta, tau of the waves at radius r.

        Waves that have decayed at this distance from the loaded wall are omitted.
        """
        way = np.log(r / self.r_i) if self.loaded == "bore" else np.log(self.r_o / r)
        m = self._m[(self._m - 2) * way < NEGLIGIBLE]
        factors = self._amplitudes[:, None, : m.size]
        moved = _displacements(m, r, self.r_i, self.r_o, self.kappa) / self.double_shear_modulus
        stresses = _stresses(m, r / self.r_o, self.r_i / r)
        return np.asarray((factors * np.concatenate([moved, stresses], axis=1)).sum(axis=0))

    def _summed(self, waves: Array, theta: Array) -> Array:
        """Displacements and stresses (5, points): sums of `waves` (5, K) at `theta` (points,)."""
        turn = np.outer(self._m[: waves.shape[1]], theta)
        even, odd = waves[[0, 2, 3]] @ np.cos(turn), waves[[1, 4]] @ np.sin(turn)
        return np.array([even[0], odd[0], even[1], even[2], odd[1]])


def _stresses(m: Array, rho: float, s: float) -> Array:
    """Stresses (4, 3, K) of the stress functions A, B, C, D."""
    a, b, c, d = rho ** (m - 2), s ** (m + 2), rho**m, s**m
    grown = m * a * (1 - rho) * (1 + rho)
    fallen = m * d * (1 - s) * (1 + s)
    return np.array([
        [a, -a, -a],
        [-b, b, -b],
        [2 * c + grown, 2 * c - grown, -grown],
        [-2 * d - fallen, -2 * d + fallen, -fallen],
    ])  # fmt: skip


def _displacements(m: Array, r: float, r_i: float, r_o: float, kappa: float) -> Array:
    """Displacements (4, 2, K) of the stress functions A, B, C, D times 2G."""
    rho, s = r / r_o, r_i / r
    a, b = r_o * rho ** (m - 1) / (m - 1), r_i * s ** (m + 1) / (m + 1)
    c = r_o * rho ** (m - 1) * ((1 - rho) * (1 + rho) + 1 / (m - 1))
    c_k = kappa * r_o * rho ** (m + 1) / (m + 1)
    d = r_i * s ** (m - 1) * ((1 - s) * (1 + s) + s**2 / (m + 1))
    d_k = kappa * r_i * s ** (m - 1) / (m - 1)
    return np.array([[a, -a], [b, b], [c + c_k, c_k - c], [d + d_k, d - d_k]])


def _wall_tractions(m: Array, far: float) -> Array:
    """Tractions (K, 4, 4) of A, B, C, D: sigma_r, tau at the rim, then at the bore.

    `far` is ln(r_o/r_i).
    """
    q = np.exp(-far * m)
    up, down = np.exp(-far * (m - 2)), np.exp(-far * (m + 2))
    grown, fallen = -m * up * np.expm1(-2 * far), -m * q * np.expm1(-2 * far)
    one, zero = np.ones_like(m), np.zeros_like(m)
    rows = [
        [one, -down, 2 * one, -2 * q - fallen],
        [-one, -down, zero, -fallen],
        [up, -one, 2 * q + grown, -2 * one],
        [-up, -one, -grown, zero],
    ]
    return np.array(rows).transpose(2, 0, 1)
