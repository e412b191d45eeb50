r"""State of a clutch under torque: clamping angle, forces, approaches, pressures and wind-up.

All quantities follow from the normal force N of one contact: d_i, d_o from `compliance`, psi from
Eq. 5, F_t = N tan(alpha), T = z R F_t (Eq. 3). N is computed from the torque or the angle by
Newton's method for ln N. The logarithms of torque and approach are nearly linear in ln N (slope 1
to 1.5 for an inner cam).

The torque of an outer cam has a maximum, beyond which the rollers pop through; no equilibrium
exists at a larger torque. Hertz's theory is not applied if a half-width exceeds r/2. In both cases,
the state is nan; `limits` gives the limiting torques.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative
from analytic.freewheel import printed, rolling
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.compliance import Compliance, compliance

WIDEST = 0.5  # half-width over roller's radius beyond which there is no result
STEPS = 60
CONVERGED = 1e-13
POINTS = 20  # of Gauss' rule for the wind-up


@dataclass(frozen=True, kw_only=True, eq=False)
class RollerClutchState:
    """State of a clutch [rad, force, force x length, length, stress]; arrays have the load's shape.

    `N` and `F_t` are forces of one contact of one roller, `T` is the torque of the clutch.
    """

    bodies: Compliance
    N: Array
    F_t: Array
    T: Array
    alpha: Array
    d_i: Array
    d_o: Array
    a_i: Array
    a_o: Array
    p_i: Array
    p_o: Array

    @property
    def psi(self) -> Array:
        """Angle psi = 2 alpha [rad] of the roller's centre from the normal of the flat."""
        return np.asarray(2 * self.alpha)

    @property
    def s(self) -> Array:
        """Arc s [length] by which the roller's centre has moved along the cam (Eq. 6)."""
        return self.bodies.clutch.cam.arc(d_i=self.d_i, d_o=self.d_o)

    @property
    def phi_printed(self) -> Array:
        """Wind-up (angle of twist) [rad] as printed in Eq. 7."""
        return printed.torsion(self.bodies.clutch.cam, d_i=self.d_i, d_o=self.d_o)

    @property
    def phi_small(self) -> Array:
        """Wind-up [rad] for small angles, 2 s/R."""
        cam = self.bodies.clutch.cam
        return rolling.small_angle_torsion(cam, d_i=self.d_i, d_o=self.d_o)

    @cached_property
    def phi(self) -> Array:
        """Wind-up [rad] by exact rolling along the load path from 0 to N (Eq. 7, corrected)."""
        clutch, cam = self.bodies.clutch, self.bodies.clutch.cam
        x, w = np.polynomial.legendre.leggauss(POINTS)
        known, rest = np.where(np.isfinite(self.N), self.N, 0.0), np.zeros(self.N.shape)
        for u, weight in zip((1 + x) / 2, w / 2, strict=True):
            # the logarithm at no load is smooth in u
            d = self.bodies.approaches(known * u**3 / np.asarray(clutch.L))
            x_c, y_c = cam.centre(d_i=d.d_i, d_o=d.d_o)
            slope = d.slope_i if cam.sense > 0 else d.slope_o
            dy = -cam.sense * slope / np.asarray(clutch.L)
            rest = rest + weight * 3 * u**2 * known * np.arcsinh(x_c / y_c) * dy
        rolled = rolling.integrated(cam, d_i=self.d_i, d_o=self.d_o) - rest
        return np.asarray(cam.sense * rolled / cam.race)


State = RollerClutchState  # its name in version 0.1


def loaded(clutch: RollerClutch, T: ArrayLike) -> RollerClutchState:
    """State under the torque T [force x length], at least 0; nan without an equilibrium."""
    bodies, T = compliance(clutch), not_negative(T, "torque", "N m")
    F_t = T / (clutch.cam.count * clutch.cam.race)

    def residual(N: Array) -> tuple[Array, Array]:
        tangent, slope = bodies.tangent(N)
        return np.log(N * tangent / F_t), 1 + N * slope / tangent

    return _state(bodies, _newton(residual, F_t / np.tan(clutch.cam.alpha0), clutch))


def at_normal_force(clutch: RollerClutch, N: ArrayLike) -> RollerClutchState:
    """State at the normal force N [force] of one contact; nan without an equilibrium."""
    N = not_negative(N, "normal force", "N")
    return _state(compliance(clutch), np.where(_widest(clutch) >= N, N, np.nan))


def at_angle(clutch: RollerClutch, psi: ArrayLike) -> RollerClutchState:
    """State at the angle psi [rad] of the roller's centre; nan if no load causes it."""
    bodies, cam = compliance(clutch), clutch.cam
    cos = np.cos(finite(psi, "angle", "rad"))
    # y = rho cos(psi) leaves for the approaches: d of the flat + cos(psi) d of the race
    reach = cam.sense * (cam.flat - cam.race * cos) + cam.roller * (1 + cos)
    reach = np.where(np.abs(reach) < 1e-15 * cam.race, 0.0, reach)
    E, _ = clutch.roller.plane

    def residual(N: Array) -> tuple[Array, Array]:
        L = np.asarray(clutch.L)
        d = bodies.approaches(N / L)
        on_flat, on_race = (1.0, cos) if cam.sense > 0 else (cos, 1.0)
        whole = on_flat * d.d_i + on_race * d.d_o
        slope = (on_flat * d.slope_i + on_race * d.slope_o) / L
        return np.log(whole / reach), N * slope / whole

    start = np.where(reach >= 0, reach, np.nan) * E * np.asarray(clutch.L) / 10
    return _state(bodies, _newton(residual, start, clutch))


def _newton(
    residual: Callable[[Array], tuple[Array, Array]], start: Array, clutch: RollerClutch
) -> Array:
    """Normal force N [force] at which `residual` is zero; 0 remains 0.

    `residual` returns its value at N and the derivative by ln N.
    """
    N, ceiling = np.minimum(start, _widest(clutch)), _widest(clutch)
    with np.errstate(divide="ignore", invalid="ignore"):
        for _ in range(STEPS):
            value, slope = residual(np.where(N > 0, N, 1.0))
            step = np.where(slope > 0, -value / slope, np.nan)
            N = np.minimum(N * np.exp(np.clip(step, -5, 5)), ceiling)
            if not np.any(np.abs(step) > CONVERGED):
                break
        value, _ = residual(np.where(N > 0, N, 1.0))
    return np.where((start == 0) | (np.abs(value) < 1e3 * CONVERGED), N, np.nan)


def _widest(clutch: RollerClutch) -> Array:
    """Normal force N [force] at which the wider contact reaches the limit of Hertz's theory."""
    return np.asarray(
        clutch.L * np.minimum(*clutch.loads_at_half_width(WIDEST * clutch.cam.roller))
    )


def _state(bodies: Compliance, N: Array) -> RollerClutchState:
    clutch, cam = bodies.clutch, bodies.clutch.cam
    known = np.isfinite(N)
    P = np.where(known, N, 0.0) / np.asarray(clutch.L)
    d = bodies.approaches(P)
    alpha = np.where(known, cam.alpha(d_i=d.d_i, d_o=d.d_o), np.nan)
    known = np.isfinite(alpha)
    N = np.where(known, N, np.nan)
    F_t = N * np.tan(alpha)
    found = [
        np.where(known, value, np.nan)
        for value in (d.d_i, d.d_o, *clutch.half_widths(P), *clutch.pressures(P))
    ]
    d_i, d_o, a_i, a_o, p_i, p_o = found
    return RollerClutchState(
        bodies=bodies, N=N, F_t=F_t, T=cam.torque_on_race(F_t=F_t), alpha=alpha,
        d_i=d_i, d_o=d_o, a_i=a_i, a_o=a_o, p_i=p_i, p_o=p_o,
    )  # fmt: skip
