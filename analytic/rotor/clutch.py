r"""Sprag clutch as a coupling of two rigid races: loads and stiffness from one potential.

A sprag at the angle :math:`\psi_j` is divided into :math:`n_s` slices along its length L. The
displacement of the inner race relative to the outer race is
:math:`q = (\Delta\delta_x, \Delta\delta_y, \Delta\gamma_x, \Delta\gamma_y, \Delta\gamma_z)` (Eq.
1). It compresses slice k by

.. math:: \delta_{jk} = (\Delta\delta_x + x_k \Delta\gamma_y) \cos\psi_j
   + (\Delta\delta_y - x_k \Delta\gamma_x) \sin\psi_j + d_t \Delta\gamma_z - 2 L(x_k) + i_j

(Eq. 8, but displacement and tilt have independent directions; :math:`\Delta\gamma_z` includes the
twist by the preload, :math:`i_j` is the interference of one sprag). With Eq. 2 for each slice, the
potential and the derived Eqs. 9 to 11 are

.. math:: U = \frac{k_n}{n_s} \sum_{jk} \frac{\langle\delta_{jk}\rangle^{n+1}}{n+1}, \quad
   P = \frac{k_n}{n_s} \sum_{jk} \langle\delta_{jk}\rangle^n J_{jk}, \quad
   K = \frac{k_n}{n_s} \sum_{jk} n \langle\delta_{jk}\rangle^{n-1} J_{jk} J_{jk}^T

where J is the gradient of :math:`\delta_{jk}`, and :math:`\langle\delta\rangle` is :math:`\delta`
if positive, otherwise 0. The torque :math:`T = Z N R_i \tan\nu` requires :math:`d_t = R_i \tan\nu`.

References
----------
.. [1] C. Huang, Y. Zhao, G. Jin, Finite element modeling and vibration analysis of sprag
   clutch-flexible rotor system, J. Harbin Inst. Technol. (New Ser.) 29(2) (2022) 13-23,
   doi:10.11916/j.issn.1005-9113.2020093, Eqs. 1-11.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
LINE_CONTACT = 10 / 9  # n of Eq. 2
AXIAL = 2  # place of the axial displacement in Eq. 11


def slice_middles(*, L: float, n_s: int) -> Array:
    """Centres x_k [m] of the slices of a sprag of length L, from +L/2 downwards, (n_s,) (Eq. 5).

    >>> slice_middles(L=9.0, n_s=3).tolist()
    [3.0, 0.0, -3.0]
    """
    if n_s < 1:
        raise ValueError(f"the number of slices n_s must be at least 1, got {n_s}")
    return np.asarray((n_s + 1 - 2 * np.arange(1, n_s + 1)) / 2 * _positive(L, "L", "m") / n_s)


def even_angles(*, Z: int, psi_0: float = 0.0, missing: tuple[int, ...] = ()) -> Array:
    """Angles [rad] of Z equally spaced sprags from psi_0, without those numbered in `missing`.

    The number of the first sprag is 0.

    >>> np.degrees(even_angles(Z=4, missing=(1,))).tolist()
    [0.0, 180.0, 270.0]
    """
    if Z < 3:
        raise ValueError(
            f"the number of sprags Z must be at least 3, got {Z}: two sprags cannot transmit every "
            "lateral load"
        )
    if wrong := [j for j in missing if not 0 <= j < Z]:
        raise ValueError(
            f"numbers of missing sprags must lie between 0 and {Z - 1}, got {wrong[0]}"
        )
    return np.asarray(psi_0 + 2 * np.pi * np.delete(np.arange(Z), list(missing)) / Z)


@dataclass(frozen=True, kw_only=True)
class SpragCoupling:
    """Clutch with Z sprags at angles `psi` (Z,) [rad] on an inner race R_i [m]; wedge angle nu.

    `k_n` [N/m^n] is the force of a whole sprag divided by the n-th power of the deflection of both
    its contacts. `crown` is a function that returns the drop L(x) [m] of one contact at x (n_s,)
    [m]. `interference` (Z,) [m] increases the deflection of single sprags; negative values are
    gaps.
    """

    psi: Array
    R_i: float
    nu: float
    L: float
    k_n: float
    n: float = LINE_CONTACT
    n_s: int = 1
    crown: Callable[[Array], ArrayLike] | None = None
    interference: ArrayLike = 0.0
    lost: Array = field(init=False, repr=False)  # (Z, n_s), by crowns and gaps
    gradient: Array = field(init=False, repr=False)  # J (Z, n_s, 5): delta_jk by Eq. 1

    def __post_init__(self) -> None:
        psi = np.atleast_1d(np.asarray(self.psi, dtype=np.float64))
        if psi.ndim != 1 or not np.isfinite(psi).all():
            raise ValueError("psi must have one finite angle [rad] per sprag")
        if np.unique(np.round(np.mod(psi, 2 * np.pi), 9)).size < 3:
            raise ValueError(
                "psi must have at least three different angles: two sprags cannot transmit every "
                "lateral load"
            )
        _positive(self.R_i, "R_i", "m")
        _positive(self.k_n, "k_n", "N/m^n")
        if not 0 < self.nu < math.pi / 2:
            raise ValueError(f"nu must lie between 0 and pi/2, got {self.nu:g} rad")
        if not 1 <= self.n < 4:
            raise ValueError(f"the exponent n must be at least 1 and below 4, got {self.n:g}")
        drop = np.zeros(self.n_s) if self.crown is None else np.asarray(self.crown(self.x))
        tight = np.asarray(self.interference, dtype=np.float64)
        if drop.shape != self.x.shape or not np.isfinite(drop).all():
            raise ValueError(f"crown must return a finite drop [m] for each of {self.n_s} slices")
        if tight.shape not in ((), psi.shape) or not np.isfinite(tight).all():
            raise ValueError(
                f"interference must have one finite value [m] for each of {psi.size} sprags"
            )
        object.__setattr__(self, "psi", psi)
        # Eq. 6 for both contacts, less the additional interference of one sprag
        object.__setattr__(self, "lost", 2 * drop - np.broadcast_to(tight, psi.shape)[:, None])
        c, s = np.cos(psi)[:, None], np.sin(psi)[:, None]
        one, x = np.ones((psi.size, self.n_s)), self.x
        J = np.stack([c * one, s * one, -x * s, x * c, self.d_t * one], axis=-1)
        object.__setattr__(self, "gradient", J)

    @property
    def Z(self) -> int:
        """Number of existing sprags."""
        return int(self.psi.size)

    @property
    def x(self) -> Array:
        """Centres of the slices [m], (n_s,) (Eq. 5)."""
        return slice_middles(L=self.L, n_s=self.n_s)

    @property
    def d_t(self) -> float:
        """Length R_i tan(nu): deflection per twist [m/rad] (Eq. 4), and lever arm [m] of Q."""
        return self.R_i * math.tan(self.nu)

    def deformation(self, q: ArrayLike) -> Array:
        """Deflections delta_jk [m] at the displacements q (..., 5); negative for a gap.

        Shape (..., Z, n_s).
        """
        return np.asarray(np.einsum("jki,...i->...jk", self.gradient, _five(q)) - self.lost)

    def energy(self, q: ArrayLike) -> Array:
        """Potential U (...,) [J] at displacements q (..., 5) [m, rad]."""
        delta = self.deformation(q)
        stored = self.law(delta)[0] * np.maximum(delta, 0.0) / (self.n + 1)
        return np.asarray(stored.sum((-2, -1)))

    def law(self, delta: Array) -> tuple[Array, Array]:
        """Force Q [N] of a slice and its slope [N/m] at `delta` [m]; zero in a gap (Eq. 2)."""
        pressed = np.where(delta > 0, delta, 1.0)
        force = np.where(delta > 0, self.k_n / self.n_s * pressed**self.n, 0.0)
        return force, self.n * force / pressed

    def forces(self, q: ArrayLike) -> Array:
        """Normal forces Q_jk (..., Z, n_s) [N] of the slices at displacements q (..., 5)."""
        return self.law(self.deformation(q))[0]

    def slopes(self, q: ArrayLike) -> Array:
        """Slopes dQ_jk/d delta_jk [N/m] at the displacements q (..., 5), shape (..., Z, n_s)."""
        return self.law(self.deformation(q))[1]

    def loads(self, q: ArrayLike) -> Array:
        """Loads (F_x, F_y, M_x, M_y, M_z) (..., 5) [N, N m] at displacements q (..., 5) (Eq. 9).

        Example: a twist of 1 rad deflects four sprags with d_t = 1 m equally.

        >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
        >>> round(float(one.loads([0, 0, 0, 0, 1.0])[4]), 12)
        12.0
        """
        return np.asarray(np.einsum("...jk,jki->...i", self.forces(q), self.gradient))

    def stiffness(self, q: ArrayLike) -> Array:
        """Symmetric tangent stiffness K (..., 5, 5) at displacements q (..., 5) (Eq. 10).

        >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0, n=1.0)
        >>> np.diag(one.stiffness([0, 0, 0, 0, 1.0])).round(12).tolist()
        [6.0, 6.0, 0.0, 0.0, 12.0]
        """
        J = self.gradient
        return np.asarray(np.einsum("...jk,jka,jkb->...ab", self.slopes(q), J, J, optimize=True))


Clutch = SpragCoupling  # its name in version 0.1


def with_axial(K: ArrayLike) -> Array:
    """Stiffness K_s (..., 6, 6) of (x, y, z, gx, gy, gz) from K (..., 5, 5); axial part 0 (Eq. 11).

    >>> with_axial(np.eye(5)).diagonal().tolist()
    [1.0, 1.0, 0.0, 1.0, 1.0, 1.0]
    """
    K = np.asarray(K, dtype=np.float64)
    if K.shape[-2:] != (5, 5):
        raise ValueError(f"K must have the shape (..., 5, 5), got {K.shape}")
    return np.insert(np.insert(K, AXIAL, 0.0, axis=-1), AXIAL, 0.0, axis=-2)


def _five(q: ArrayLike) -> Array:
    q = np.asarray(q, dtype=np.float64)
    if q.shape[-1:] != (5,):
        raise ValueError(
            f"q must have 5 displacements (Eq. 1) along its last axis, got shape {q.shape}"
        )
    return q


def _positive(value: float, name: str, unit: str) -> float:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{name} must be positive and finite, got {value:g} {unit}")
    return value
