r"""Wind-up of the clutch from the rolling of its rollers (Nagler, Lohrengel, Eq. 7, corrected).

A roller that rolls on the flat and on the race rotates the parts relative to each other by

.. math:: R\,d\varphi = \pm\left[(1 + \cos\psi)\,dx - \sin\psi\,dy\right],

with + for an inner cam and - for an outer cam. With x = y tan(psi), all terms except for the change
of y can be integrated,

.. math:: R\,\varphi = \pm\left(\left[x + y\,G\right] - \int G\,dy\right),
          \qquad G = \operatorname{arsinh}\tan\psi .

With the constraint of Eq. 5, this equals R dphi = (dd_i + dd_o)/tan(alpha): the work T dphi of the
torque equals the increase dU of the strain energy.

The formula contains only rolling. F_t causes an additional wind-up of contacts and parts. As the
tangential compliance of a contact is about its normal compliance, the additional wind-up is
tan(alpha) (d_i + d_o)/R, the fraction tan²(alpha) of phi (0.4 % at 3.7 deg).
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.freewheel.cam import Cam


def integrated(cam: Cam, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
    """Change of x + y G [length] from zero load on: a part of R phi of an inner cam."""
    (x_0, y_0), (x, y) = cam.centre(d_i=0.0, d_o=0.0), cam.centre(d_i=d_i, d_o=d_o)
    return np.asarray(x - x_0 + y * np.arcsinh(x / y) - y_0 * np.arcsinh(x_0 / y_0))


def torsion(cam: Cam, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
    """Wind-up phi [rad] along a path of approaches (..., points) that starts without load.

    The result is cumulative and has the shape of the path. The integral of G dy, which is small, is
    computed by the trapezoidal rule. The fields of the cam must broadcast against a last axis of
    points.
    """
    d_i, d_o = np.broadcast_arrays(np.asarray(d_i, np.float64), np.asarray(d_o, np.float64))
    x, y = cam.centre(d_i=d_i, d_o=d_o)
    G = np.arcsinh(x / y)
    steps = (G[..., 1:] + G[..., :-1]) / 2 * np.diff(y, axis=-1)
    rest = np.concatenate([np.zeros_like(y[..., :1]), np.cumsum(steps, axis=-1)], axis=-1)
    held = x + y * G
    rolled = held - held[..., :1] - rest
    return np.asarray(cam.sense * rolled / cam.race)


def small_angle_torsion(cam: Cam, *, d_i: ArrayLike, d_o: ArrayLike) -> Array:
    """Wind-up phi [rad] for small angles, 2 s/R with s of Eq. 6."""
    return np.asarray(2 * cam.arc(d_i=d_i, d_o=d_o) / cam.race)
