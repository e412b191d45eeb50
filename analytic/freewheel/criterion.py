r"""Required friction coefficient of a clutch under torque and axial load (Nagler, Eqs. 1, 8 to 10).

For one roller with the geometric clamping angle alpha,

.. math:: \mu_{req} = \frac{\sqrt{F_t^2 + F_a^2}}{F_n}
          = \tan\alpha \sqrt{1 + \left(\frac{F_{ax} R}{T}\right)^2},

with F_a = F_ax/z and T = z R F_t of the whole clutch (R is R_s for an outer cam). In the
paper, the left side of Eq. 8 is tan(alpha), which contradicts tan(alpha) = F_t/F_n (Eq. 1). The
paper also uses the same symbol, F_ax, for F_a and F_ax.

The criterion applies only in the locking direction (T > 0). An overrunning clutch (T < 0) is not
wedged: mu_req is nan. At T = 0, no normal force exists to transmit F_ax: mu_req is infinite. If
both T and F_ax are zero, mu_req is tan(alpha), as Eq. 1 requires. If both approach zero together
along a load path, the limit depends on the ratio F_ax/T: `required_friction_of_ratio`.

References
----------
.. [1] N. Nagler, A. Lohrengel, Forsch. Ingenieurwes. 85(4), 2021, Secs. 5 and 7.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, finite, not_negative, positive
from analytic.freewheel.rules import require

RED, GREEN = 0.8, 1.0  # mu/mu_req of Sec. 7, observed, not derived


def required_friction_of_contact(*, F_n: ArrayLike, F_t: ArrayLike, F_a: ArrayLike) -> Array:
    """Required friction coefficient mu_req from the forces [force] on one contact (Eq. 8).

    >>> float(required_friction_of_contact(F_n=100.0, F_t=3.0, F_a=4.0))
    0.05
    """
    F_n = positive(F_n, "normal force", "N")
    return np.asarray(np.hypot(finite(F_t, "F_t", "N"), finite(F_a, "F_a", "N")) / F_n)


def required_friction(*, alpha: ArrayLike, T: ArrayLike, F_ax: ArrayLike, R: ArrayLike) -> Array:
    """Required friction coefficient mu_req under T [force x length] and F_ax [force] (Eq. 9).

    >>> mu_req = required_friction(alpha=np.arctan(0.03), T=30.0, F_ax=4.0, R=10.0)
    >>> round(float(mu_req), 12)  # 0.03 sqrt(1 + (4/3)²)
    0.05
    """
    T, F_ax = finite(T, "torque", "N m"), finite(F_ax, "axial load", "N")
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where((T == 0) & (F_ax == 0), 0.0, F_ax / T)
    found = required_friction_of_ratio(alpha=alpha, ratio=ratio, R=R)
    return np.where(T < 0, np.nan, found)


def required_friction_of_ratio(*, alpha: ArrayLike, ratio: ArrayLike, R: ArrayLike) -> Array:
    """Required friction coefficient mu_req for the ratio F_ax/T [1/length]."""
    lever = np.asarray(ratio, dtype=np.float64) * positive(R, "race's radius", "m")
    return np.asarray(np.tan(np.asarray(alpha)) * np.hypot(1.0, lever))


def largest_axial_load(*, alpha: ArrayLike, T: ArrayLike, R: ArrayLike, mu: ArrayLike) -> Array:
    """Axial load F_ax [force] of the clutch at mu_req = mu (Eq. 9); nan if T alone causes slip.

    >>> round(float(largest_axial_load(alpha=np.arctan(0.03), T=30.0, R=10.0, mu=0.05)), 12)
    4.0
    """
    T, mu = not_negative(T, "torque", "N m"), friction(mu)
    spare = (mu / np.tan(np.asarray(alpha))) ** 2 - 1
    root = np.sqrt(np.where(spare >= 0, spare, np.nan))
    return np.asarray(T / positive(R, "race's radius", "m") * root)


def safety(*, mu: ArrayLike, mu_req: ArrayLike) -> Array:
    """Ratio of available to required friction, mu/mu_req (Eq. 10); a clutch holds if it is >= 1."""
    return np.asarray(friction(mu) / np.asarray(mu_req))


def traffic_light(ratio: ArrayLike, *, red: float = RED, green: float = GREEN) -> NDArray[np.str_]:
    """Class of mu/mu_req: "red" below `red`, "green" from `green` on, "yellow" between (Sec. 7).

    The class is "free" if the ratio is nan, because the clutch overruns.

    >>> traffic_light([0.79, 0.8, 1.0]).tolist()
    ['red', 'yellow', 'green']
    """
    require(0 < red <= green, "classes need 0 < red <= green", "", red=red, green=green)
    ratio = np.asarray(ratio, dtype=np.float64)
    known = [np.isnan(ratio), ratio < red, ratio < green]
    return np.select(known, ["free", "red", "yellow"], "green")


def self_releasing(*, alpha: ArrayLike, mu: ArrayLike) -> NDArray[np.bool_]:
    """True if a roller slips out of the wedge under torque alone: tan(alpha) > mu (Eq. 1)."""
    return np.asarray(np.tan(np.asarray(alpha)) > friction(mu))


def friction(mu: ArrayLike) -> Array:
    """Coefficient of friction as an array; raises ValueError unless positive."""
    return positive(mu, "coefficient of friction mu", "")
