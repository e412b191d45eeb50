r"""Eqs. 12, 13, 17, 20 and 21 of Belcin et al. as printed, for comparison with the corrected ones.

Eqs. 13, 17, 20 and 21 contain the arc of a side, :math:`\pi d_i/z`, in place of its chord,
:math:`d_i \sin(\pi/z)`. Eq. 21 counts one side in place of z sides. Eq. 12 contains K twice.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 12-21.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.polyhedral.forces import corners


def arc_over_chord(z: ArrayLike) -> Array:
    """Ratio of arc to chord of one of z sides, by which force and torque as printed are too large.

    >>> round(float(arc_over_chord(6)), 6)  # (pi/6)/sin(pi/6)
    1.047198
    """
    half = np.pi / corners(z)
    return np.asarray(half / np.sin(half))


def required_pressure(*, p_t: ArrayLike, p_1r: ArrayLike, z: ArrayLike) -> Array:
    """Total pressure [stress] by Eqs. 17 and 18 as printed, from the correct `p_t` and p_1r.

    p_1r is the pressure at which the ring reaches the rollers. The result is infinite if the
    correct pressure is infinite.
    """
    touching = positive(p_1r, "pressure p_1r", "Pa")
    return np.asarray(touching + (np.asarray(p_t) - touching) / arc_over_chord(z))


def first_torque(*, M_t: ArrayLike, z: ArrayLike) -> Array:
    """Torque [force x length] by Eq. 21 as printed, from the correct M_t of the first design."""
    return np.asarray(np.asarray(M_t) * arc_over_chord(z) / corners(z))


def mean_hoop_stress(*, sigma_t: ArrayLike, K: ArrayLike) -> Array:
    """Hoop stress [stress] of the polygonal ring by Eq. 12 as printed: K² sigma_t.

    >>> float(mean_hoop_stress(sigma_t=100.0, K=1.1).round(9))
    121.0
    """
    return np.asarray(np.asarray(sigma_t) * np.asarray(K) ** 2)
