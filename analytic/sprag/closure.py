r"""State of a wedged sprag: all lengths and angles as functions of its normal force (Eqs. 6 to 11).

The paper computes the normal force from the rotation by iteration. The inverse is explicit: N
determines the deflections, the deflections determine the triangle, and the triangle determines the
rotation. The forces act at A and B (Eq. 9, with the growth of the outer race, which is missing in
its third line),

.. math::
    OA &= R_i - \delta_{BI} - \delta_{HI}/2, \qquad
    OB = R_e + \delta_{BE} + \delta_{HE}/2 + \delta_{ce}, \\
    OC_e &= R_e - r_e + \delta_{BE} + \delta_{HE} + \delta_g/2 + \delta_{ce},

and the unstrained spiral intersects the normal through O at

.. math:: OA_s = R_i - \delta_{BI} - \delta_{HI} - \delta_g/2.

The triangle with the sides OA_s and OC_e has the angles beta, eta and the side rho. These give the
rotation relative to OB,

.. math:: \alpha_B = \theta - \theta_0 - (\eta - \eta_0), \qquad
          \theta - \theta_0 = \ln(\rho/\rho_0)/m.

With OA_s and OC_e, the work of the forces on the rotation of the races equals the work on the
deflections (`course`). With OA in place of OA_s (`printed`), both works differ. Only two forces act
on a sprag. Therefore, they act along AB: T_i = N tan(nu), T_e = N_e tan(omega), N_e = N
cos(omega)/cos(nu). As in the paper, the deflections of both contacts are those under N; N_e is
larger by the fraction (nu² - omega²)/2.

alpha = alpha_b + gamma - gamma_0 is the rotation relative to the azimuth of the centroid, positive
in the locking direction. SI units; arguments broadcast; nan where no equilibrium exists.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.compliance import Yields
from analytic.sprag.geometry import strut, triangle
from analytic.sprag.search import first_reach


@dataclass(frozen=True, kw_only=True, eq=False)
class Wedged:
    """State of each sprag [N, N m, m, rad]; `turned` is theta - theta_0, `T` the clutch torque."""

    N: Array
    N_e: Array
    T_i: Array
    T_e: Array
    T: Array
    yields: Yields
    OA: Array
    OA_s: Array
    OB: Array
    OC_e: Array
    rho: Array
    beta: Array
    eta: Array
    nu: Array
    omega: Array
    turned: Array
    alpha_b: Array
    alpha: Array
    gamma: Array
    OC_g: Array

    @property
    def b_i(self) -> Array:
        """Lever arm [m] of T_i about the centroid (Eq. 15)."""
        return np.asarray(self.OC_g * np.cos(self.beta + self.gamma) - self.OA)

    @property
    def b_e(self) -> Array:
        """Lever arm [m] of T_e about the centroid (Eq. 15)."""
        return np.asarray(self.OB - self.OC_g * np.cos(self.gamma))

    @property
    def h_i(self) -> Array:
        """Lever arm [m] of N about the centroid (in Eq. 15, printed as h)."""
        return np.asarray(self.OC_g * np.sin(self.beta + self.gamma))

    @property
    def h_e(self) -> Array:
        """Lever arm [m] of N_e about the centroid (Eq. 15)."""
        return np.asarray(self.OC_g * np.sin(self.gamma))


def wedged(clutch: SpragClutch, N: ArrayLike) -> Wedged:
    """State of each sprag under the normal force N [N] on the inner race."""
    N = np.asarray(N, dtype=np.float64)
    not_negative(np.where(np.isnan(N), 0.0, N), "normal force", "N")
    sprag, yields = clutch.sprag, clutch.compliance.yields(N)
    OA_s = np.asarray(np.asarray(sprag.R_i) - yields.inner)
    OA = np.asarray(np.asarray(sprag.R_i) - yields.race_i - yields.contact_i / 2)
    return closed(clutch, N, yields, OA_s=OA_s, OA=OA)


def closed(clutch: SpragClutch, N: Array, yields: Yields, *, OA_s: Array, OA: Array) -> Wedged:
    """State of sprags whose spiral touches the circle of radius `OA_s` [m].

    The contact forces on the inner race act at the radius `OA` [m].
    """
    sprag = clutch.sprag
    OB = np.asarray(np.asarray(sprag.R_e) + yields.race_e + yields.contact_e / 2 + yields.d_ce)
    OC_e = np.asarray(sprag.OC_e + yields.outer + yields.d_ce)
    found = triangle(OA=OA_s, OC_e=OC_e, m=sprag.m)
    nu, omega = strut(OA=OA, OB=OB, beta=found.beta)
    N = np.where(np.isfinite(nu), N, np.nan)
    turned = np.asarray(np.log(found.rho / sprag.rho_0) / sprag.m)
    alpha_b = np.asarray(turned - (found.eta - sprag.eta_0))
    gamma, OC_g = _centroid(clutch, OC_e, alpha_b)
    gamma_0, _ = _centroid(clutch, sprag.OC_e, np.zeros(()))
    N_e = np.asarray(N * np.cos(omega) / np.cos(nu))
    T_i = np.asarray(N * np.tan(nu))
    return Wedged(
        N=N, N_e=N_e, T_i=T_i, T_e=np.asarray(N_e * np.tan(omega)),
        T=np.asarray(clutch.n_s * T_i * OA), yields=yields, OA=OA, OA_s=OA_s, OB=OB, OC_e=OC_e,
        rho=found.rho, beta=found.beta, eta=found.eta, nu=nu, omega=omega, turned=turned,
        alpha_b=alpha_b, alpha=np.asarray(alpha_b + gamma - gamma_0), gamma=gamma, OC_g=OC_g,
    )  # fmt: skip


def at_torque(clutch: SpragClutch, T: ArrayLike) -> Wedged:
    """State with the smallest normal force under the clutch torque T [N m]."""
    T = not_negative(T, "torque", "N m")
    sprag = clutch.sprag
    start = np.asarray(T / (clutch.n_s * np.asarray(sprag.R_i) * np.tan(sprag.nu_0)))
    return wedged(clutch, first_reach(lambda N: wedged(clutch, N).T, T, start=start))


def at_rotation(clutch: SpragClutch, alpha: ArrayLike) -> Wedged:
    """State at the rotation alpha [rad]; unloaded if alpha is smaller than at first contact."""
    alpha = finite(alpha, "rotation alpha", "rad")
    alpha = np.maximum(alpha, wedged(clutch, 0.0).alpha)
    start = np.where(alpha > wedged(clutch, 0.0).alpha, 1.0, 0.0)
    return wedged(clutch, first_reach(lambda N: wedged(clutch, N).alpha, alpha, start=start))


def _centroid(clutch: SpragClutch, OC_e: Array, alpha_b: Array) -> tuple[Array, Array]:
    """Angle gamma [rad] from OB to the centroid, positive away from A, and its radius OC_g [m]."""
    c_x, c_y = clutch.centroid
    x = c_x * np.cos(alpha_b) + c_y * np.sin(alpha_b)
    y = OC_e - c_x * np.sin(alpha_b) + c_y * np.cos(alpha_b)
    return np.asarray(np.arctan2(-x, y)), np.asarray(np.hypot(x, y))
