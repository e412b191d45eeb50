r"""Sensitivity of the wedge angle of a given sprag to the dimensions of sprag and races.

A logarithmic spiral is self-similar. Therefore, the angles at first contact depend only on R_i,
R_e, m and the outer radius r_e of the sprag, with OC_e = R_e - r_e. The position of the contact
along the spiral has no effect on the angles. With c = AB,

.. math::
    d\nu_0 &= \frac{R_e(R_e - R_i\cos\beta)}{c^2}\,d\beta
             + \frac{\sin\beta}{c^2}\,(R_e\,dR_i - R_i\,dR_e), \\
    d\beta &= \tan\eta\left(\frac{dR_e - dr_e}{OC_e} - \frac{dR_i}{R_i}\right)
             + \left[1 - \frac{R_i}{OC_e\sqrt{1+m^2}\cos\eta}\right]\frac{dm}{1+m^2}.
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array
from analytic.sprag.geometry import LogSprag, strut, triangle

STEP = 1e-6  # relative to a radius, for slopes


@dataclass(frozen=True, kw_only=True, eq=False)
class Sensitivities:
    """Derivatives of the wedge angle nu_0 by R_i, R_e and r_e [rad/length] and by m [rad]."""

    R_i: Array
    R_e: Array
    r_e: Array
    m: Array


def wedge_angle_sensitivities(sprag: LogSprag) -> Sensitivities:
    """Derivatives of the wedge angle nu_0 by one dimension each; all others are constant."""
    R_i, R_e, m = (np.asarray(x, dtype=np.float64) for x in (sprag.R_i, sprag.R_e, sprag.m))
    beta, eta, OC_e = sprag.beta_0, sprag.eta_0, sprag.OC_e
    c2 = R_i**2 + R_e**2 - 2 * R_i * R_e * np.cos(beta)
    by_beta = R_e * (R_e - R_i * np.cos(beta)) / c2
    across = np.sin(beta) / c2
    spiral = (1 - R_i / (OC_e * np.hypot(1, m) * np.cos(eta))) / (1 + m**2)
    return Sensitivities(
        R_i=np.asarray(-by_beta * np.tan(eta) / R_i + across * R_e),
        R_e=np.asarray(by_beta * np.tan(eta) / OC_e - across * R_i),
        r_e=np.asarray(-by_beta * np.tan(eta) / OC_e),
        m=np.asarray(by_beta * spiral),
    )


sensitivities = wedge_angle_sensitivities  # its name in version 0.1


def first_contact(sprag: LogSprag, *, dR_i: float = 0.0, dR_e: float = 0.0) -> tuple[float, float]:
    """Wedge angle and rotation [rad] of a sprag at first contact with races of other radii.

    dR_i and dR_e [m] are the deviations of the radii R_i and R_e.

    >>> sprag = LogSprag(R_i=11.11, R_e=19.44, m=0.08490, r_i=4.02)
    >>> nu, turned = first_contact(sprag, dR_i=-0.02)  # until it touches the smaller race
    >>> bool(turned > 0), bool(abs(nu - sprag.nu_0) < 1e-3)
    (True, True)
    """
    OA, OB = float(np.asarray(sprag.R_i)) + dR_i, float(np.asarray(sprag.R_e)) + dR_e
    found = triangle(OA=OA, OC_e=OB - float(sprag.r_e), m=sprag.m)
    nu, _ = strut(OA=OA, OB=OB, beta=found.beta)
    turned = np.log(found.rho / sprag.rho_0) / sprag.m - (found.eta - sprag.eta_0)
    return float(nu), float(turned)


def slope(sprag: LogSprag, radius: str) -> tuple[float, float]:
    """Derivatives [rad/m] of wedge angle and sprag rotation by `radius`, "dR_i" or "dR_e"."""
    h = STEP * float(np.asarray(sprag.R_i))
    low, high = (first_contact(sprag, **{radius: s * h}) for s in (-1, 1))
    return (high[0] - low[0]) / (2 * h), (high[1] - low[1]) / (2 * h)
