r"""Line contact under a tangential force that alternates between -Q_max and Q_max (Mindlin).

After a reversal at Q_max, the traction is that at Q_max minus twice the traction of a first loading
by half the change of force: where the contact slides back, friction changes from mu p to -mu p.
From Q_max on,

.. math:: q = q_1(Q_{max}) - 2\, q_1\!\left(\frac{Q_{max} - Q}{2}\right)

with the traction q_1 of the first loading (`partial_slip`). Slip and displacement are superposed in
the same manner. From -Q_max on, all signs are opposite. After one cycle, the states repeat.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, ch. 7.
.. [2] R. D. Mindlin, H. Deresiewicz, Elastic spheres in contact under varying oblique forces,
   Journal of Applied Mechanics 20 (1953) 327-344.
"""

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import hyp2f1

from analytic.contact import partial_slip
from analytic.contact.checks import Array, positive

Branch = Literal["unloading", "reloading"]


def traction(
    x: ArrayLike,
    *,
    Q: ArrayLike,
    Q_max: ArrayLike,
    P: ArrayLike,
    mu: ArrayLike,
    a: ArrayLike,
    branch: Branch,
) -> Array:
    """Shear traction [stress] at x and force Q, during unloading or reloading.

    >>> load = {"Q_max": 0.75 * np.pi / 2, "P": np.pi / 2, "mu": 1.0, "a": 1.0}  # p_0 = 1
    >>> traction(0.8, Q=-0.75 * np.pi / 2, branch="unloading", **load).round(12).tolist()
    -0.6
    """
    sign, back = _reversal(Q, Q_max, branch)
    first = partial_slip.traction(x, Q=Q_max, P=P, mu=mu, a=a)
    return np.asarray(sign * (first - 2 * partial_slip.traction(x, Q=back, P=P, mu=mu, a=a)))


def slip(
    x: ArrayLike,
    *,
    Q: ArrayLike,
    Q_max: ArrayLike,
    P: ArrayLike,
    mu: ArrayLike,
    a: ArrayLike,
    E_star: ArrayLike,
    branch: Branch,
) -> Array:
    """Relative slip [length] at x and force Q, measured from the unloaded state."""
    sign, back = _reversal(Q, Q_max, branch)
    first = partial_slip.slip(x, Q=Q_max, P=P, mu=mu, a=a, E_star=E_star)
    undone = partial_slip.slip(x, Q=back, P=P, mu=mu, a=a, E_star=E_star)
    return np.asarray(sign * (first - 2 * undone))


def rigid_displacement_beyond_stick(
    *,
    Q: ArrayLike,
    Q_max: ArrayLike,
    P: ArrayLike,
    mu: ArrayLike,
    E_star: ArrayLike,
    branch: Branch,
) -> Array:
    """Tangential displacement [length] of the bodies, minus the value for complete stick."""
    sign, back = _reversal(Q, Q_max, branch)
    load = {"P": P, "mu": mu, "E_star": E_star}
    first = partial_slip.rigid_displacement_beyond_stick(Q=Q_max, **load)
    undone = partial_slip.rigid_displacement_beyond_stick(Q=back, **load)
    return np.asarray(sign * (first - 2 * undone))


def beyond_chord(share: ArrayLike, *, Q_max: float, P: float, mu: float, E_star: float) -> Array:
    """Displacements (2n,) [length] minus the straight line that joins the two reversals of Q.

    Each branch is evaluated at the n values Q/Q_max = `share`, which increase from -1 to 1 (in
    reversed order for unloading).

    >>> load = {"Q_max": 0.5, "P": 1.0, "mu": 1.0, "E_star": 1.0}
    >>> down, up = np.split(beyond_chord([-1.0, 0.0, 1.0], **load), 2)
    >>> bool(np.allclose(down[[0, 2]], 0) and down[1] == -up[1] > 0)
    True
    """
    s = np.asarray(share, dtype=np.float64)
    load = {"Q_max": Q_max, "P": P, "mu": mu, "E_star": E_star}
    rigid = rigid_displacement_beyond_stick
    top = rigid(Q=Q_max, branch="unloading", **load)
    down = rigid(Q=s[::-1] * Q_max, branch="unloading", **load) - s[::-1] * top
    up = rigid(Q=s * Q_max, branch="reloading", **load) - s * top
    return np.concatenate([down, up])


def dissipation(*, Q_max: ArrayLike, P: ArrayLike, mu: ArrayLike, E_star: ArrayLike) -> Array:
    r"""Energy dissipated in one cycle per unit length of the contact [force].

    It is the area of the hysteresis loop of force and displacement. With k = Q_max/(mu P)

    .. math:: W = \frac{2(\mu P)^2}{\pi E^*}\left[k(2-k) + 2(1-k)\ln(1-k)\right],

    which is :math:`\frac{2(\mu P)^2}{3\pi E^*} k^3` for small k.

    >>> load = {"P": 1.0, "mu": 1.0, "E_star": 2 / np.pi}  # k = 1/2: 3/4 - ln 2
    >>> round(float(dissipation(Q_max=0.5, **load) + np.log(2)), 12)
    0.75
    """
    # a first loading by Q_max raises for wrong values, so that k < 1
    partial_slip.rigid_displacement_beyond_stick(Q=Q_max, P=P, mu=mu, E_star=E_star)
    limit = np.asarray(mu, dtype=np.float64) * np.asarray(P)
    k = np.asarray(Q_max) / limit
    bracket = k**3 / 3 * hyp2f1(1, 2, 4, k)  # the same without cancellation at small k
    return np.asarray(2 * limit**2 / (np.pi * np.asarray(E_star)) * bracket)


def _reversal(Q: ArrayLike, Q_max: ArrayLike, branch: Branch) -> tuple[int, Array]:
    """Sign of the force at the start of the branch, and half the change of force since then."""
    if branch not in get_args(Branch):
        raise ValueError(f"branch must be one of {', '.join(get_args(Branch))}, got {branch!r}")
    Q, Q_max = np.asarray(Q, dtype=np.float64), positive(Q_max, "amplitude of the force", "N/m")
    if not np.all(np.abs(Q) <= Q_max):
        raise ValueError(f"Q must lie between -Q_max and Q_max = {Q_max} N/m, got {Q} N/m")
    sign = 1 if branch == "unloading" else -1
    return sign, np.asarray((Q_max - sign * Q) / 2)
