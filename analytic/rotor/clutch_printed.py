r"""Equations 9 to 11 as printed, to quantify the effect of their misprints.

References
----------
.. [1] C. Huang, Y. Zhao, G. Jin, J. Harbin Inst. Technol. (New Ser.) 29(2) (2022) 13-23,
   Eqs. 9-11.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.rotor.clutch import Array, SpragCoupling


def radial_force(clutch: SpragCoupling, q: ArrayLike, *, i: int = 0) -> float:
    """Radial force F_r [N] of Eq. 9 as printed: the cosine of sprag i applies to every sprag.

    Four sprags with 3 N each give 12 N without any lateral displacement:

    >>> from analytic.rotor.clutch import even_angles
    >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
    >>> round(radial_force(one, [0, 0, 0, 0, 1.0]), 12)
    12.0
    """
    return float(np.sum(clutch.forces(q)) * np.cos(clutch.psi[i]))


def radial_stiffness(clutch: SpragCoupling, q: ArrayLike, *, i: int = 0) -> float:
    """Radial stiffness dF_r/d delta_r [N/m] as printed; it is zero for a uniform clutch.

    >>> from analytic.rotor.clutch import even_angles
    >>> one = SpragCoupling(psi=even_angles(Z=4), R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
    >>> abs(radial_stiffness(one, [0, 0, 0, 0, 1.0])) < 1e-12
    True
    """
    slopes = clutch.slopes(q).sum(-1)
    return float(np.sum(slopes * np.cos(clutch.psi)) * np.cos(clutch.psi[i]))


def stiffness_with_lever(clutch: SpragCoupling, q: ArrayLike, *, lever: float) -> Array:
    """Stiffness K (5, 5) with the lever arm `lever` [m] of the torque in place of d_t.

    The last row is multiplied by lever/d_t.

    >>> from analytic.rotor.clutch import even_angles
    >>> psi = even_angles(Z=4, missing=(0,))
    >>> gap = SpragCoupling(psi=psi, R_i=1.0, nu=np.pi / 4, L=1.0, k_n=3.0)
    >>> K = stiffness_with_lever(gap, [0, 0, 0, 0, 1.0], lever=2.0)
    >>> round(float(K[4, 0] / K[0, 4]), 12)
    2.0
    """
    K = clutch.stiffness(q)
    K[..., 4, :] *= lever / clutch.d_t
    return K
