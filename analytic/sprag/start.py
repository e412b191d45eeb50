r"""Start of an engagement: only the energizing spring acts, without friction at the inner race.

With T_i = 0, the tangential equilibrium of Eq. 14 gives

.. math:: T_e = -N_0\,\frac{\sin(\beta+\gamma) - \sin\gamma}{\cos\gamma}

and the moment equilibrium, in which the position of the centroid cancels except for gamma, gives

.. math:: N_0 = \frac{K_r(\alpha_{max} - \alpha)}{(h_i - h_e)
          + b_e\,\dfrac{\sin(\beta+\gamma)-\sin\gamma}{\cos\gamma}}
          = \frac{K_r(\alpha_{max} - \alpha)\cos\gamma}{OB\,[\sin(\beta+\gamma) - \sin\gamma]}.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.freewheel.rules import require
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.search import first_reach


def spring_equilibrium(
    clutch: SpragClutch, *, K_r: ArrayLike, alpha_max: ArrayLike
) -> tuple[Wedged, Array]:
    """State in equilibrium with the energizing spring, and the force T_e [N] of the outer race.

    K_r [N m/rad] and alpha_max [rad] are the stiffness and the unloaded rotation of the energizing
    spring. N and the geometry of the state are valid. Its tangential forces are those of a wedged
    strut and are not valid. Raises ValueError if the spring is already unloaded at first contact,
    ArithmeticError if no equilibrium exists.
    """
    K_r, alpha_max = positive(K_r, "spring K_r", "N m/rad"), np.asarray(alpha_max)
    first = wedged(clutch, 0.0)
    require(
        alpha_max > first.alpha, "the spring must press at first contact: alpha_max above alpha",
        "rad", alpha_max=alpha_max, alpha=first.alpha,
    )  # fmt: skip

    def pressed(N: Array) -> Array:
        now = wedged(clutch, N)
        return np.asarray(N * now.OB * drag(now) + K_r * now.alpha)

    stiff = K_r * (alpha_max - first.alpha) / (first.OB * drag(first))  # rigid contacts
    N = first_reach(pressed, np.asarray(K_r * alpha_max), start=np.asarray(stiff))
    if np.isnan(N).any():
        raise ArithmeticError(
            f"no equilibrium was found: no normal force balances energizing springs of K_r={K_r} N "
            "m/rad"
        )
    now = wedged(clutch, N)
    return now, np.asarray(-now.N * drag(now))


def drag(now: Wedged) -> Array:
    """Ratio -T_e/N_0 = (sin(beta + gamma) - sin(gamma))/cos(gamma)."""
    return np.asarray((np.sin(now.beta + now.gamma) - np.sin(now.gamma)) / np.cos(now.gamma))
