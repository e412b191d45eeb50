r"""Eqs. 12, 13, 17, 20 and 21 of Belcin et al. as printed, to compare with the corrected ones.

Eqs. 13, 17, 20 and 21 take the arc of a side, :math:`\\pi d_i/z`, for its chord
:math:`d_i \\sin(\\pi/z)`; Eq. 21 counts one side for all z; Eq. 12 multiplies by K twice.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 12-21.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.polyhedral.forces import corners


def arc_over_chord(z: ArrayLike) -> Array:
    """Arc of one of z sides of the bore over its chord: force and torque are that much too large.

    >>> round(float(arc_over_chord(6)), 6)  # (pi/6)/sin(pi/6)
    1.047198
    """
    half = np.pi / corners(z)
    return np.asarray(half / np.sin(half))


def required_pressure(*, p_t: ArrayLike, p_1r: ArrayLike, z: ArrayLike) -> Array:
    """Total pressure [stress] by Eqs. 17 and 18, from the correct `p_t` and the touching pressure.

    Infinite if the right one is.
    """
    touching = positive(p_1r, "pressure p_1r", "Pa")
    return np.asarray(touching + (np.asarray(p_t) - touching) / arc_over_chord(z))


def first_torque(*, M_t: ArrayLike, z: ArrayLike) -> Array:
    """Torque [force x length] by Eq. 21, from the right one of the same first design `M_t`."""
    return np.asarray(np.asarray(M_t) * arc_over_chord(z) / corners(z))


def mean_hoop_stress(*, sigma_t: ArrayLike, K: ArrayLike) -> Array:
    """Hoop stress [stress] of the polygonal ring by Eq. 12, K p_1r/p_1 = K squared times sigma_t.

    >>> float(mean_hoop_stress(sigma_t=100.0, K=1.1).round(9))
    121.0
    """
    return np.asarray(np.asarray(sigma_t) * np.asarray(K) ** 2)
