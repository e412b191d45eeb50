r"""Stiffness of a clutch whose sprags are struts, with forces inclined by nu to the radius.

.. math:: \delta = (\cos\psi - \tan\nu \sin\psi)\, dx + \dots
   = \cos(\psi + \nu)\, dx / \cos\nu + \dots

has the same form as Eq. 3, with rotated angles and scaled displacements.
"""

import math
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from analytic.rotor.clutch import Array, SpragCoupling
from analytic.rotor.clutch_state import under_torque


def inclined_stiffness(clutch: SpragCoupling, *, T: float, dx: float = 0.0) -> Array:
    """Stiffness K (5, 5) under T [N m] at an offset dx [m], with forces along the struts.

    >>> from analytic.rotor.clutch import even_angles
    >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=0.1, L=1.0, k_n=3.0)
    >>> K = one.stiffness(under_torque(one, T=1.0))
    >>> round(float(inclined_stiffness(one, T=1.0)[0, 0] / K[0, 0] * math.cos(0.1) ** 2), 9)
    1.0
    """
    turned = replace(clutch, psi=clutch.psi + clutch.nu)
    dx = dx / math.cos(clutch.nu)
    K = turned.stiffness(under_torque(turned, T=T, offset=(dx, 0, 0, 0)))
    stretch = np.array([1.0, 1.0, 1.0, 1.0, math.cos(clutch.nu)]) / math.cos(clutch.nu)
    return np.asarray(K * np.outer(stretch, stretch))


def leaning(clutch: SpragCoupling, at: ArrayLike) -> float:
    """Decrease of K_tilt [N m/rad] because the contact points on the race tilt with the race.

    It is evaluated at the displacements `at` (5,). If the race rotates by w and a force along e at
    its point p retains its direction, the additional work is e . w x (w x p)/2: -N R_i cos^2 psi
    for a tilt about the y axis.
    """
    N = clutch.forces(at).sum(-1)
    return float(clutch.R_i * N @ np.cos(clutch.psi) ** 2)


def coupling_across(gone: Array, *, k: float, nu: float) -> float:
    """Stiffness K_xy [N/m] of a clutch without the sprags at the angles `gone` (m,) [rad].

    k [N/m] is the contact stiffness of the remaining sprags. `gone` is symmetric about the x axis.
    K_xy is -k tan(nu) times the sum of cos(2 psi) over `gone`; without missing sprags it is zero.
    """
    return float(-k * math.tan(nu) * np.cos(2 * gone).sum())


def coupling_with_torsion(gone: Array, *, k: float, nu: float, d_t: float) -> float:
    """Stiffness K_yz [N] of a clutch without the sprags at `gone` (m,) [rad]: tan(nu) K_xz.

    k [N/m] is the contact stiffness of the remaining sprags, d_t [m] the lever arm of their normal
    forces. `gone` is symmetric about the x axis.
    """
    lever = k * d_t
    return float(-lever * math.tan(nu) * np.cos(gone).sum())


def held_torsional_stiffness(
    *, Z: int, R_i: float, R_e: float, nu: float, k: float, N: float
) -> float:
    """Torsional stiffness K_zz [N m/rad] of Z struts that are pinned to both races.

    A strut with the force F = N/cos nu and the stiffness F' = k/cos^2 nu contributes
    F' h^2 - F (R_i R_e cos beta - h^2)/l, with h = R_i sin nu and the length l of the strut,
    l^2 = R_i^2 + R_e^2 - 2 R_i R_e cos beta. beta is the angle at the axis between the ends of a
    strut, N [N] the normal force of a sprag, k [N/m] its contact stiffness.

    Without a force, K_zz is Z k d_t^2 with d_t = R_i tan nu:

    >>> K = held_torsional_stiffness(Z=12, R_i=1.0, R_e=2.0, nu=0.1, k=2.0, N=0.0)
    >>> round(K / (12 * 2.0 * math.tan(0.1) ** 2), 12)
    1.0
    """
    h = R_i * math.sin(nu)
    beta = nu - math.asin(h / R_e)
    length = math.sqrt(R_i**2 + R_e**2 - 2 * R_i * R_e * math.cos(beta))
    bent = (R_i * R_e * math.cos(beta) - h**2) / length
    along = k / math.cos(nu) ** 2 * h**2
    return float(Z * (along - N / math.cos(nu) * bent))
