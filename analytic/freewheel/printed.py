"""Eqs. 3 to 7 as printed in the paper, for an inner cam, for comparison with the corrected ones.

References
----------
.. [1] N. Nagler, A. Lohrengel, Forsch. Ingenieurwes. 85(4), 2021.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.freewheel.cam import Cam
from analytic.freewheel.geometry import InnerCam


def torque_on_cam(cam: Cam, *, F_t: ArrayLike) -> Array:
    """Torque z X F_t [force x length] on the cam (Eq. 3), without the normal force of the flat."""
    return np.asarray(cam.count * cam.flat * np.asarray(F_t))


def alpha0(cam: InnerCam) -> Array:
    """Clamping angle [rad] with r in place of R in the numerator (Eq. 4)."""
    return np.asarray(np.arccos(np.sqrt((cam.roller + cam.flat) / (2 * (cam.race - cam.roller)))))


def alpha_1(cam: InnerCam, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
    """Clamping angle [rad] with all signs of the denominator reversed (Eq. 5)."""
    numerator = cam.flat - np.asarray(d_i) + cam.roller
    return np.asarray(np.arccos(numerator / (cam.race - np.asarray(d_o) + cam.roller)) / 2)


def torsion(cam: Cam, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
    """Wind-up phi = s/R + s/X [rad] with s of Eq. 6 (Eq. 7).

    It is (R + X)/(2 X) times the correct value.
    """
    s = cam.arc(d_i=d_i, d_o=d_o)
    return np.asarray(s / cam.race + s / cam.flat)
