r"""Race under n equal rollers or sprags: Hertz's pressure on n equally spaced patches of a ring.

On each patch, the pressure is a semi-ellipse of half-width a along the arc with the load P per unit
length. With alpha = a/r on the loaded wall, its Fourier coefficients for m = k n are

.. math:: p_0 = \frac{nP}{2\pi r}, \qquad p_m = 2 p_0\,\frac{2 J_1(m\alpha)}{m\alpha}.

`FourierRing` solves for the first waves. The omitted waves have no effect on the other wall. On the
loaded wall, their sum has a closed form in the leading order 1/m. With phi = n theta, the position
t in the patch (-1 to 1), s = theta/alpha and the mean <> over the semi-ellipse, it is

.. math::
    \sum_k \frac{2 J_1(k n\alpha)}{k n\alpha} \frac{\cos k\phi}{k}
        &= -\left\langle\ln\left|2\sin\frac{\phi - n\alpha t}{2}\right|\right\rangle, \\
    \sum_k \frac{2 J_1(k n\alpha)}{k n\alpha} \frac{\sin k\phi}{k}
        &= \arcsin s + s\sqrt{1 - s^2} - \frac{\phi}{2} \quad (|s| \le 1),

and pi/2 - phi/2 outside the patch. The hoop stress of the omitted waves is minus their pressure.
With waves up to m = 60/alpha, the remainder of the next order is below 1e-4 alpha/n of P/E'. Inside
the wall, the sum of the first waves is used without correction. It is exact to round-off at depths
of at least a. Nearer to the loaded wall, the truncation of the series causes an error of the
stresses, 7 % of the peak pressure at the end of a patch.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import j1

from analytic.contact.checks import Array, Assumption, positive
from analytic.ring.fourier_ring import NEGLIGIBLE, FourierRing, State, Wall

WAVES = 60.0  # m alpha of the last one
MOST = 6e5  # and its m at most, as 1/m² is left out: below 1e-7 of the displacement at a load
POINTS = 48  # of Gauss' rule over the patch
ON_WALL = 1e-9  # relative to the radius


@dataclass(frozen=True, kw_only=True)
class LoadedRace:
    """Ring of radii r_i, r_o with n Hertz patches on its `loaded` wall, the first at theta = 0.

    Each patch has the load `P` per unit length and the half-width `a`. Raises ValueError if patches
    overlap.

    >>> race = LoadedRace(r_i=1.0, r_o=1.5, E=1.0, nu=0.3, assumption="plane stress",
    ...                   loaded="bore", n=12, P=1.0, a=0.01)
    >>> bool(race.displacement(1.0, 0.0) > race.displacement(1.0, np.pi / 12))
    True
    """

    r_i: float
    r_o: float
    E: float
    nu: float
    assumption: Assumption
    loaded: Wall
    n: int
    P: float
    a: float

    def __post_init__(self) -> None:
        positive(self.P, "load per length", "N/m")
        positive(self.a, "half-width", "m")
        if not self.n * self.a < np.pi * self.r:
            raise ValueError(
                f"patches must not overlap, got {self.n} patches of half-width {self.a:g} m on the "
                f"radius {self.r:g} m"
            )

    @property
    def r(self) -> float:
        """Radius of the loaded wall [length]."""
        return self.r_i if self.loaded == "bore" else self.r_o

    @property
    def alpha(self) -> float:
        """Half angle of a patch [rad]."""
        return self.a / self.r

    @property
    def mean_pressure(self) -> float:
        """Mean pressure [stress] of the loads on the wall."""
        return self.n * self.P / (2 * np.pi * self.r)

    @cached_property
    def ring(self) -> FourierRing:
        """Ring under the harmonics of the load that are summed one by one."""
        top = max(min(WAVES / self.alpha, MOST), NEGLIGIBLE / np.log(self.r_o / self.r_i) + 2)
        m = self.n * np.arange(1, np.ceil(top / self.n) + 1)
        p = self.mean_pressure * np.concatenate([[1.0], 2 * share(m * self.alpha)])
        return FourierRing(
            r_i=self.r_i, r_o=self.r_o, E=self.E, nu=self.nu, assumption=self.assumption,
            loaded=self.loaded, n=self.n, p=p,
        )  # fmt: skip

    def pressure(self, theta: ArrayLike) -> Array:
        """Pressure [stress] on the loaded wall at the angles `theta` [rad]."""
        s = self._folded(theta) / self.alpha
        peak = 2 * self.P / (np.pi * self.a)
        return np.asarray(peak * np.sqrt(np.maximum(1 - s**2, 0.0)))

    def at(self, r: ArrayLike, theta: ArrayLike) -> State:
        """Displacements and stresses at the radii `r` and angles `theta` [rad]."""
        r, theta = np.broadcast_arrays(
            np.asarray(r, dtype=np.float64), np.asarray(theta, dtype=np.float64)
        )
        state = self.ring.at(r, theta)
        wall = np.abs(r - self.r) <= ON_WALL * self.r
        if not np.any(wall):
            return state
        turn = theta[wall]
        logarithm, jump, pressure = self._rest(turn)
        outward = 1.0 if self.loaded == "bore" else -1.0
        scale = self.mean_pressure * self.r / (self.n * self.ring.double_shear_modulus)
        kappa = self.ring.kappa
        u_r, u_theta, radial, hoop = (
            x.copy() for x in (state.u_r, state.u_theta, state.sigma_r, state.sigma_theta)
        )
        u_r[wall] += outward * (kappa + 1) * scale * logarithm
        u_theta[wall] -= (kappa - 1) * scale * jump
        hoop[wall] -= pressure
        radial[wall] -= pressure
        return State(u_r=u_r, u_theta=u_theta, sigma_r=radial, sigma_theta=hoop, tau=state.tau)

    def displacement(self, r: float, theta: float) -> float:
        """Radial displacement [length] at one point, positive outwards."""
        return float(self.at(r, theta).u_r)

    def _rest(self, theta: Array) -> tuple[Array, Array, Array]:
        """Sums of the waves that `ring` omits (closed form), and their pressure [stress]."""
        phi = self.n * self._folded(theta)
        beta = self.n * self.alpha
        s = phi / beta
        inside = np.clip(s, -1, 1)
        jump = np.arcsin(inside) + inside * np.sqrt(1 - inside**2) - phi / 2
        p = self.ring.p
        pressure = self.pressure(theta) - p[0]
        logarithm = _mean_logarithm(phi, beta)
        k = np.arange(1, p.size, dtype=np.float64)
        share = p[1:] / (2 * p[0])
        for j, angle in enumerate(phi):  # of one point at a time: there may be 1e5 waves
            cos, sin = np.cos(k * angle), np.sin(k * angle)
            logarithm[j] -= share / k @ cos
            jump[j] -= share / k @ sin
            pressure[j] -= p[1:] @ cos
        return logarithm, jump, pressure

    def _folded(self, theta: ArrayLike) -> Array:
        """Angle [rad] from the nearest patch."""
        pitch = 2 * np.pi / self.n
        theta = np.asarray(theta, dtype=np.float64)
        return np.asarray(theta - pitch * np.round(theta / pitch))


def share(x: ArrayLike) -> Array:
    """Mean of cos(x t) with a semi-elliptic weight over -1 < t < 1: 2 J_1(x)/x, for x > 0."""
    x = np.asarray(x, dtype=np.float64)
    return np.asarray(2 * j1(x) / x)


def _mean_logarithm(phi: Array, beta: float) -> Array:
    """Mean of -ln|2 sin((phi - beta t)/2)| over the semi-ellipse, for |phi| <= pi."""
    s = np.abs(phi) / beta
    beyond = np.maximum(s, 1.0)
    sum_ = beyond + np.sqrt(beyond**2 - 1)
    plane = np.where(s > 1, np.log(sum_ / 2) + beyond / sum_ - 0.5, s**2 - 0.5 - np.log(2))
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    weight = 2 / (POINTS + 1) * np.sin(turn) ** 2
    x = phi[:, None] - beta * np.cos(turn)
    smooth = np.log(np.sinc(x / (2 * np.pi))) @ weight  # sin(x/2)/(x/2)
    return np.asarray(-np.log(beta) - plane - smooth)
