r"""Sprag clutch as a link of two rigid races: loads and stiffness from one potential.

A sprag at :math:`\psi_j` is cut into :math:`n_s` slices along its length L. The relative
displacement :math:`q = (\Delta\delta_x, \Delta\delta_y, \Delta\gamma_x, \Delta\gamma_y,
\Delta\gamma_z)` (Eq. 1) of the inner race against the outer one presses slice k together by

.. math:: \delta_{jk} = (\Delta\delta_x + x_k \Delta\gamma_y) \cos\psi_j
   + (\Delta\delta_y - x_k \Delta\gamma_x) \sin\psi_j + d_t \Delta\gamma_z - 2 L(x_k) + i_j

(Eq. 8 with a separate direction for the tilt, and the preload's twist counted in
:math:`\Delta\gamma_z`; :math:`i_j` is an interference of one sprag). With Eq. 2 slice by slice the
potential and the derived Eqs. 9 to 11 are

.. math:: U = \frac{k_n}{n_s} \sum_{jk} \frac{\langle\delta_{jk}\rangle^{n+1}}{n+1}, \quad
   P = \frac{k_n}{n_s} \sum_{jk} \langle\delta_{jk}\rangle^n J_{jk}, \quad
   K = \frac{k_n}{n_s} \sum_{jk} n \langle\delta_{jk}\rangle^{n-1} J_{jk} J_{jk}^T

where J is the gradient of :math:`\delta_{jk}` and only loaded slices count. A torque
:math:`T = Z N R_i \tan\nu` requires :math:`d_t = R_i \tan\nu`.

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
    """Middles x_k (n_s,) [m] of the slices of a sprag of length L, from +L/2 on (Eq. 5).

    >>> slice_middles(L=9.0, n_s=3).tolist()
    [3.0, 0.0, -3.0]
    """
    if n_s < 1:
        raise ValueError(f"n_s must be at least 1 slice, got {n_s}")
    return np.asarray((n_s + 1 - 2 * np.arange(1, n_s + 1)) / 2 * _positive(L, "L", "m") / n_s)


def even_angles(*, Z: int, psi_0: float = 0.0, missing: tuple[int, ...] = ()) -> Array:
    """Angles [rad] of Z sprags, from psi_0 on, without the `missing` sprags (numbered from 0).

    >>> np.degrees(even_angles(Z=4, missing=(1,))).tolist()
    [0.0, 180.0, 270.0]
    """
    if Z < 3:
        raise ValueError(f"Z must be at least 3, got {Z}: two sprags carry no lateral load")
    if wrong := [j for j in missing if not 0 <= j < Z]:
        raise ValueError(f"missing sprags are counted from 0 to {Z - 1}, got {wrong[0]}")
    return np.asarray(psi_0 + 2 * np.pi * np.delete(np.arange(Z), list(missing)) / Z)


@dataclass(frozen=True, kw_only=True)
class SpragCoupling:
    """Z sprags at angles `psi` (Z,) [rad] on an inner race R_i [m], inclined by nu [rad] there.

    `k_n` [N/m^n] is the force of a whole sprag over the n-th power of the deflection of both its
    contacts; `crown` gives the drop L(x) [m] of one contact at x (n_s,) [m]; `interference` (Z,)
    [m] presses single sprags more, or, negative, leaves them a gap.
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
            raise ValueError("psi needs one finite angle [rad] for each sprag")
        if np.unique(np.round(np.mod(psi, 2 * np.pi), 9)).size < 3:
            raise ValueError("psi needs three different angles: two sprags carry no lateral load")
        _positive(self.R_i, "R_i", "m")
        _positive(self.k_n, "k_n", "N/m^n")
        if not 0 < self.nu < math.pi / 2:
            raise ValueError(f"nu must lie between 0 and pi/2, got {self.nu:g} rad")
        if not 1 <= self.n < 4:
            raise ValueError(f"n must be at least 1 and below 4, got {self.n:g}")
        drop = np.zeros(self.n_s) if self.crown is None else np.asarray(self.crown(self.x))
        tight = np.asarray(self.interference, dtype=np.float64)
        if drop.shape != self.x.shape or not np.isfinite(drop).all():
            raise ValueError(f"crown needs a finite drop [m] for each of {self.n_s} slices")
        if tight.shape not in ((), psi.shape) or not np.isfinite(tight).all():
            raise ValueError(f"interference needs a finite value [m] for each of {psi.size} sprags")
        object.__setattr__(self, "psi", psi)
        # Eq. 6 for both contacts, less the additional interference of one sprag
        object.__setattr__(self, "lost", 2 * drop - np.broadcast_to(tight, psi.shape)[:, None])
        c, s = np.cos(psi)[:, None], np.sin(psi)[:, None]
        one, x = np.ones((psi.size, self.n_s)), self.x
        J = np.stack([c * one, s * one, -x * s, x * c, self.d_t * one], axis=-1)
        object.__setattr__(self, "gradient", J)

    @property
    def Z(self) -> int:
        """Number of sprags that are there."""
        return int(self.psi.size)

    @property
    def x(self) -> Array:
        """Middles (n_s,) of the slices [m] (Eq. 5)."""
        return slice_middles(L=self.L, n_s=self.n_s)

    @property
    def d_t(self) -> float:
        """Deflection per twist [m/rad] (Eq. 4), the lever of Q in the torque: R_i tan(nu)."""
        return self.R_i * math.tan(self.nu)

    def deformation(self, q: ArrayLike) -> Array:
        """delta_jk (..., Z, n_s) [m] at displacements q (..., 5), negative for a gap."""
        return np.asarray(np.einsum("jki,...i->...jk", self.gradient, _five(q)) - self.lost)

    def energy(self, q: ArrayLike) -> Array:
        """Potential U (...,) [J] at displacements q (..., 5) [m, rad]."""
        delta = self.deformation(q)
        stored = self.law(delta)[0] * np.maximum(delta, 0.0) / (self.n + 1)
        return np.asarray(stored.sum((-2, -1)))

    def law(self, delta: Array) -> tuple[Array, Array]:
        """Force Q [N] of a slice and its slope [N/m] at `delta` [m], zero in a gap (Eq. 2)."""
        pressed = np.where(delta > 0, delta, 1.0)
        force = np.where(delta > 0, self.k_n / self.n_s * pressed**self.n, 0.0)
        return force, self.n * force / pressed

    def forces(self, q: ArrayLike) -> Array:
        """Normal forces Q_jk (..., Z, n_s) [N] of the slices at displacements q (..., 5)."""
        return self.law(self.deformation(q))[0]

    def slopes(self, q: ArrayLike) -> Array:
        """dQ_jk/d delta_jk (..., Z, n_s) [N/m] at displacements q (..., 5)."""
        return self.law(self.deformation(q))[1]

    def loads(self, q: ArrayLike) -> Array:
        """(F_x, F_y, M_x, M_y, M_z) (..., 5) [N, N m] for displacements q (..., 5) (Eq. 9).

        Four sprags, d_t = 1 m, pressed equally by a twist of 1 rad:

        >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
        >>> round(float(one.loads([0, 0, 0, 0, 1.0])[4]), 12)
        12.0
        """
        return np.asarray(np.einsum("...jk,jki->...i", self.forces(q), self.gradient))

    def stiffness(self, q: ArrayLike) -> Array:
        """Tangent K (..., 5, 5) at displacements q (..., 5), symmetric (Eq. 10, increments).

        >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0, n=1.0)
        >>> np.diag(one.stiffness([0, 0, 0, 0, 1.0])).round(12).tolist()
        [6.0, 6.0, 0.0, 0.0, 12.0]
        """
        J = self.gradient
        return np.asarray(np.einsum("...jk,jka,jkb->...ab", self.slopes(q), J, J, optimize=True))


Clutch = SpragCoupling  # its name in version 0.1


def with_axial(K: ArrayLike) -> Array:
    """K_s (..., 6, 6) of (x, y, z, gx, gy, gz) from K (..., 5, 5): axial row zero (Eq. 11).

    >>> with_axial(np.eye(5)).diagonal().tolist()
    [1.0, 1.0, 0.0, 1.0, 1.0, 1.0]
    """
    K = np.asarray(K, dtype=np.float64)
    if K.shape[-2:] != (5, 5):
        raise ValueError(f"K needs 5 x 5 entries, got {K.shape}")
    return np.insert(np.insert(K, AXIAL, 0.0, axis=-1), AXIAL, 0.0, axis=-2)


def _five(q: ArrayLike) -> Array:
    q = np.asarray(q, dtype=np.float64)
    if q.shape[-1:] != (5,):
        raise ValueError(f"q needs 5 displacements (Eq. 1), got shape {q.shape}")
    return q


def _positive(value: float, name: str, unit: str) -> float:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{name} must be positive and finite, got {value:g} {unit}")
    return value
