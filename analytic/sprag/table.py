r"""Force and geometry of one sprag tabulated over its rotation alpha.

The closure equations give all quantities explicitly as functions of N. An engagement needs them as
functions of alpha, four times per step. The table has equal intervals of s = sqrt(alpha) from the
first contact (alpha = 0, N = 0) to the largest alpha. It contains the value and the slope d/ds of
each column. Between the points, columns are interpolated by cubic Hermite polynomials with
continuous slope. An engagement begins at a ten-thousandth of the final alpha, under a few newtons
of the energizing springs, and the range near this alpha determines if the sprag slips. Equal
intervals of alpha would be too coarse there.

The columns are those of the equations of motion,

    N, OA, OB, OC_g, b_i, b_e, h = h_i - h_e, and W = \int N h d\alpha.

W is the elastic energy of one sprag in the equations of motion. It equals U = \int N dH except for
the terms that Eqs. 14-16 omit. The paper has one normal force, N_e = N_i = N. Then, the tangential
forces are not in equilibrium: the static force is higher than that of the two-force strut by the
fraction 4e-4, and it changes by 1.4e-3 if the centroid moves by 0.5 mm. With `balanced`, N_e = N
cos(omega)/cos(nu) and h = h_i - h_e N_e/N. Then, the static equilibrium is exactly that of the
strut for every position of the centroid.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicHermiteSpline, CubicSpline, PchipInterpolator

from analytic.contact.checks import Array, positive
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch

COLUMNS = ("N", "OA", "OB", "OC_g", "b_i", "b_e", "h", "W")
INTERVALS = 2000
STATES = 4001  # of the closure equations, closely spaced at small forces
FEWEST = 100
BISECTIONS = 40


@dataclass(frozen=True, kw_only=True, eq=False)
class Table:
    """Table of a clutch at equal steps of s = sqrt(alpha): `values` and their `slopes` d/ds.

    Both have the shape (columns, intervals + 1). The `step` of s is in rad^(1/2). alpha is measured
    from the first contact. In a rotating clutch, the sprag rotation at first contact is larger
    by `origin` than at standstill.
    """

    n_s: int
    origin: float  # rotation [rad] of first contact relative to that of the clutch at rest
    step: float
    values: Array
    slopes: Array

    @property
    def end(self) -> float:
        """Largest tabulated alpha [rad]: the end of the profile."""
        return float(self.step * (self.values.shape[1] - 1)) ** 2

    @cached_property
    def _curve(self) -> CubicHermiteSpline:
        knots = self.step * np.arange(self.values.shape[1])
        return CubicHermiteSpline(knots, self.values.T, self.slopes.T)

    def at(self, alpha: ArrayLike) -> dict[str, Array]:
        """Columns by name at `alpha` [rad]; as at first contact for alpha < 0, nan beyond `end`."""
        alpha = np.asarray(alpha, dtype=np.float64)
        inside = np.clip(alpha, 0.0, self.end)
        found = np.where((alpha > self.end)[..., None], np.nan, self._curve(np.sqrt(inside)))
        return dict(zip(COLUMNS, np.moveaxis(found, -1, 0), strict=True))

    def static_ratio(self, alpha: ArrayLike) -> Array:
        r"""Ratio T_i/N in equilibrium (Eq. 14) without energizing springs.

        .. math:: \frac{T_i}{N} = \frac{h\,OB}{OA\, b_e + OB\, b_i}
        """
        g = self.at(alpha)
        return np.asarray(g["h"] * g["OB"] / (g["OA"] * g["b_e"] + g["OB"] * g["b_i"]))

    def static_torque(self, alpha: ArrayLike) -> Array:
        """Torque [N m] of the clutch in equilibrium at the sprag rotation `alpha` [rad]."""
        g = self.at(alpha)
        return np.asarray(self.n_s * g["N"] * self.static_ratio(alpha) * g["OA"])


def table(
    *,
    n_s: int,
    alpha: ArrayLike,
    N: ArrayLike,
    OA: ArrayLike,
    OB: ArrayLike,
    OC_g: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    N_e_over_N: ArrayLike = 1.0,
    intervals: int = INTERVALS,
) -> Table:
    """Table from states of the closure equations; angles in rad, SI units.

    The states must begin at N = 0 with increasing N. Raises ValueError if a larger force does not
    rotate the sprag further.
    """
    alpha, N, OA, OB, OC_g, beta, gamma = (
        np.asarray(x, dtype=np.float64) for x in (alpha, N, OA, OB, OC_g, beta, gamma)
    )
    if N[0] != 0 or np.any(np.diff(N) <= 0) or np.any(np.diff(alpha) <= 0):
        raise ValueError("states of a table must begin at N = 0 N, and N and alpha must increase")
    h = OC_g * (np.sin(beta + gamma) - np.asarray(N_e_over_N) * np.sin(gamma))
    b_i, b_e = OC_g * np.cos(beta + gamma) - OA, OB - OC_g * np.cos(gamma)
    root = np.sqrt(alpha - alpha[0])
    knots = np.linspace(0.0, root[-1], intervals + 1)
    force = PchipInterpolator(root, N)  # an overshoot of a spline could be a force that pulls
    curves = [force, *(CubicSpline(root, x) for x in (OA, OB, OC_g, b_i, b_e, h))]
    values = [curve(knots) for curve in curves]
    slopes = [curve(knots, 1) for curve in curves]
    power = 2 * knots * values[0] * values[-1]  # N h dalpha/ds
    rate = CubicSpline(knots, power)
    work = rate.antiderivative()(knots)
    return Table(
        n_s=n_s,
        origin=float(alpha[0]),
        step=float(knots[1]),
        values=np.ascontiguousarray([*values, work]),
        slopes=np.ascontiguousarray([*slopes, power]),
    )


def tabulated(
    clutch: SpragClutch,
    *,
    N_end: float,
    intervals: int = INTERVALS,
    theta_max: float = np.inf,
    balanced: bool = False,
) -> Table:
    """Table of a clutch up to the normal force `N_end` [N] or the spiral angle `theta_max` [rad].

    Raises ValueError if the sprag has no equilibrium under small forces, or if a larger force does
    not rotate the sprag further.
    """
    N = float(positive(N_end, "normal force at the end", "N")) * np.linspace(0, 1, STATES) ** 2
    states = wedged(clutch, N)
    whole = np.isfinite(states.alpha) & (states.turned <= theta_max)
    count = len(N) if whole.all() else int(np.argmin(whole))
    if count < FEWEST:
        raise ValueError(
            f"the sprag has no equilibrium under normal forces between 0 and {N[FEWEST]:.4g} N"
        )
    if count < len(N):  # the end lies between two states: come near it, then tabulate to there
        inside = N[count - 1]
        gap = N[count] - inside
        for _ in range(BISECTIONS):
            gap /= 2
            one = wedged(clutch, np.array(inside + gap))
            inside += gap if np.isfinite(one.alpha) and one.turned <= theta_max else 0.0
        states = wedged(clutch, inside * np.linspace(0, 1, STATES) ** 2)
    return table(
        n_s=clutch.n_s, alpha=states.alpha, N=states.N, OA=states.OA, OB=states.OB,
        OC_g=states.OC_g, beta=states.beta, gamma=states.gamma, intervals=intervals,
        N_e_over_N=np.cos(states.omega) / np.cos(states.nu) if balanced else 1.0,
    )  # fmt: skip
