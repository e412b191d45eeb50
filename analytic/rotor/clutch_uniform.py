r"""Stiffness of a clutch of Z >= 3 equally spaced and loaded sprags without crown, in closed form.

.. math:: N = \frac{T}{Z d_t}, \quad \delta_0 = \left(\frac{N}{k_n}\right)^{1/n}, \quad
   k = n k_n \delta_0^{n-1}

Over equally spaced angles, the sums of cos^2 and sin^2 are Z/2 each; the sums of cos, sin and their
product are zero. Hence

.. math:: K_{xx} = K_{yy} = \frac{Z k}{2}, \quad K_{zz} = Z k d_t^2, \quad
   K_{tilt} = \frac{Z k}{2} \frac{L^2}{12} \left(1 - \frac{1}{n_s^2}\right)

and all off-diagonal elements are zero. The stiffness is proportional to :math:`T^{1 - 1/n}`,
exponent 0.1 for n = 10/9.

References
----------
.. [1] C. Huang, Y. Zhao, G. Jin, J. Harbin Inst. Technol. (New Ser.) 29(2) (2022) 13-23, Eqs. 2-11.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from analytic.rotor.clutch import LINE_CONTACT, Array


def normal_force(*, T: ArrayLike, Z: int, d_t: ArrayLike) -> Array:
    """Normal force N [N] of each of Z sprags under the torque T [N m]: T/(Z d_t).

    >>> float(normal_force(T=15.0, Z=12, d_t=0.5e-3))
    2500.0
    """
    if Z < 3:
        raise ValueError(
            f"the number of sprags Z must be at least 3, got {Z}: two sprags cannot transmit every "
            "lateral load"
        )
    return np.asarray(_positive(T, "T", "N m") / (Z * _positive(d_t, "d_t", "m")))


def approach(*, N: ArrayLike, k_n: ArrayLike, n: float = LINE_CONTACT) -> Array:
    """Deflection delta_0 [m] of a sprag, the sum over both contacts, under N [N] (Eq. 2).

    >>> float(approach(N=8.0, k_n=1.0, n=3.0))
    2.0
    """
    return np.asarray((_positive(N, "N", "N") / _positive(k_n, "k_n", "N/m^n")) ** (1 / n))


def contact_stiffness(*, N: ArrayLike, k_n: ArrayLike, n: float = LINE_CONTACT) -> Array:
    """Contact stiffness k [N/m] of a sprag: n N/delta_0 = n k_n delta_0^(n-1).

    >>> float(contact_stiffness(N=8.0, k_n=1.0, n=3.0))  # 3 2^2
    12.0
    """
    return np.asarray(n * np.asarray(N, dtype=np.float64) / approach(N=N, k_n=k_n, n=n))


def radial_stiffness(*, Z: int, k: ArrayLike) -> Array:
    """Radial stiffness K_xx = K_yy [N/m] of Z sprags with contact stiffness k [N/m]: Z k/2.

    >>> float(radial_stiffness(Z=12, k=2.0))
    12.0
    """
    return np.asarray(_number(Z) * _positive(k, "k", "N/m") / 2)


def torsional_stiffness(*, Z: int, k: ArrayLike, d_t: ArrayLike) -> Array:
    """Torsional stiffness K_zz [N m/rad] of Z sprags: Z k d_t^2.

    >>> float(torsional_stiffness(Z=12, k=2.0, d_t=0.5))
    6.0
    """
    return np.asarray(_number(Z) * _positive(k, "k", "N/m") * _positive(d_t, "d_t", "m") ** 2)


def tilting_stiffness(*, Z: int, k: ArrayLike, L: ArrayLike, n_s: float = math.inf) -> Array:
    """Tilting stiffness K_tilt [N m/rad] with n_s slices: (Z k/2)(L^2/12)(1 - 1/n_s^2).

    The default is an infinite number of slices. The centres of two slices are at +-L/4, and
    (L/4)^2 = (L^2/12)(3/4):

    >>> float(tilting_stiffness(Z=4, k=2.0, L=4.0, n_s=2))
    4.0
    """
    if not n_s >= 1:
        raise ValueError(f"the number of slices n_s must be at least 1, got {n_s:g}")
    L = _positive(L, "L", "m")
    return np.asarray(radial_stiffness(Z=Z, k=k) * L**2 / 12 * (1 - 1 / n_s**2))


def offset_coupling(
    *, Z: int, k: ArrayLike, d_t: ArrayLike, dx: ArrayLike, delta_0: ArrayLike,
    n: float = LINE_CONTACT,
) -> Array:  # fmt: skip
    r"""Coupling stiffness K_xz [N] due to a static offset dx [m]: (Z/2) k (n - 1) dx d_t/delta_0.

    This is the first term of a series in dx/delta_0. It is not valid for dx > delta_0, where sprags
    lose contact. The contact stiffness of each sprag is proportional to delta^(n-1):

    .. math:: \sum_j k \left(1 + (n-1) \frac{dx}{\delta_0} \cos\psi_j\right) d_t \cos\psi_j

    >>> float(offset_coupling(Z=12, k=2.0, d_t=0.5, dx=0.25, delta_0=1.0, n=3.0))
    3.0
    """
    share = np.asarray(dx, dtype=np.float64) / _positive(delta_0, "delta_0", "m")
    radial = radial_stiffness(Z=Z, k=k)
    return np.asarray(radial * (n - 1) * share * _positive(d_t, "d_t", "m"))


def secant_over_tangent(*, n: float = LINE_CONTACT) -> float:
    """Ratio 1/n of secant to tangent stiffness, as loads are homogeneous functions of degree n.

    >>> round(secant_over_tangent(), 12)
    0.9
    """
    return 1 / n


def _number(Z: int) -> int:
    if Z < 3:
        raise ValueError(
            f"the number of sprags Z must be at least 3, got {Z}: two sprags cannot transmit every "
            "lateral load"
        )
    return Z


def _positive(value: ArrayLike, name: str, unit: str) -> Array:
    value = np.asarray(value, dtype=np.float64)
    if not (np.isfinite(value).all() and (value > 0).all()):
        raise ValueError(f"{name} must be positive and finite, got {np.min(value):g} {unit}")
    return value
