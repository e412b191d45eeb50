"""State of a sprag from points of its outline, by a second method without the triangle of Eq. 10.

The spiral is a set of points. It touches the inner race at the point nearest to the axis, which is
found by a parabola through three points. Deflections are computed independently, by rings under
uniform pressure, a bar, and slices.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

from analytic.contact import slices
from analytic.contact.checks import Array

AROUND = 0.6  # rad of spiral on either side of the possible contact
AROUND_IT = np.array([-1.0, 0.0, 1.0])  # of the points' distance: abscissae of the parabola
REFINEMENTS = 6  # about the lowest place: no error by the position of the points
POWER = 3  # of the path's steps in the force: near no load a small force causes a large rotation
FAR = 6.0  # rad, more than any sprag turns


def middles(length: float, n: int) -> Array:
    """Positions [m] of the centres of n equal parts of a length, relative to its middle.

    >>> middles(3.0, 3).tolist()
    [-1.0, 0.0, 1.0]
    """
    edges = np.linspace(-length / 2, length / 2, n + 1)
    return np.asarray((edges[:-1] + edges[1:]) / 2)


def crown_drop(y: Array, *, length: float, A: float, K_2: float, z_m: float) -> Array:
    """Drop [m] of a crown of depth A [m] at the distance y [m] from mid-length (by Eq. 1)."""
    crowns = K_2 * length / 2
    t = np.clip((np.abs(y) - (length / 2 - crowns)) / crowns, 0.0, 1.0)
    return np.asarray(-A * np.log(1 - (1 - math.exp(-z_m / A)) * t**2))


@dataclass(frozen=True, kw_only=True, eq=False)
class Sizes:
    """Dimensions of a clutch: z sprags between the rings from R_id to R_i and from R_e to R_ed [m].

    The sprags have the spiral growth `m`, the width b and the length l [m]. r_i [m] is the radius
    of curvature of the spiral at first contact, `gap` [m] the drop of the crown at the slices. The
    outer race rotates at `omega` [rad/s].
    """

    R_id: float
    R_i: float
    R_e: float
    R_ed: float
    r_i: float
    m: float
    z: int
    l: float  # noqa: E741
    b: float
    E: float
    nu: float
    density: float
    omega: float
    gap: Array


@dataclass(frozen=True)
class Touching:
    """State of a sprag under the force N [N]: angles [rad], and torque T [N m] of the clutch.

    `A` and `B`, the points of both forces, and the pole `C` are positions (2,) [m]; B is above O.
    """

    N: float
    alpha: float
    turned: float
    nu: float
    T: float
    A: Array
    B: Array
    C: Array


@dataclass(frozen=True)
class Drawn:
    """Sprag of a clutch whose spiral has `points` points per radian.

    With `rigid`, the races have no ring deflection (Liu). With `printed`, a part of the inner
    deflection is omitted, as in the printed Eqs. 9 and 10.
    """

    q: Sizes
    points: int
    rigid: bool = False
    printed: bool = False

    @cached_property
    def start(self) -> float:
        """Angle [rad] at the pole between the rays to the axis and to the first contact."""
        return float(brentq(lambda psi: self._near(psi, 0.0, self._OC)[0] - self.q.R_i, -0.6, 0.6,
                            xtol=1e-15))  # fmt: skip

    @cached_property
    def growth(self) -> float:
        """Growth m of the spiral."""
        return self.q.m

    @property
    def _OC(self) -> float:
        """Distance [m] of the pole from the axis at first contact.

        The pole is r_i/sqrt(1 + m²) from A, at the angle arctan(m) from the normal there.
        """
        off = math.atan(self.growth)
        return math.hypot(self.q.R_i + self._rho_0 * math.cos(off), self._rho_0 * math.sin(off))

    @property
    def _rho_0(self) -> float:
        return self.q.r_i / math.hypot(1, self.growth)

    def _near(self, psi: float, alpha: float, OC: float) -> tuple[float, float, float]:
        """Distance [m] from the axis to the nearest point of the spiral, and its angles [rad].

        The angles are the azimuth about the axis and the polar angle of the spiral.
        """
        h = 1 / self.points
        centre = round(alpha / h)
        around = round(AROUND / h)
        theta: Array = h * (centre + np.arange(-around, around + 1, dtype=np.float64))
        x, y = self._at(theta, psi - alpha, OC)
        far = np.hypot(x, y)
        k = int(np.clip(np.argmin(far), 1, len(far) - 2))
        at = theta[k]
        for _ in range(REFINEMENTS):
            left, low, right = np.hypot(*self._at(at + h * AROUND_IT, psi - alpha, OC))
            at += h * (left - right) / (2 * (left - 2 * low + right))
        x_k, y_k = self._at(np.array([at]), psi - alpha, OC)
        return float(np.hypot(x_k, y_k)[0]), math.atan2(x_k[0], y_k[0]), float(at)

    def _at(self, theta: Array, turn: float, OC: float) -> tuple[Array, Array]:
        rho = self._rho_0 * np.exp(self.growth * theta)
        return rho * np.sin(turn + theta), OC - rho * np.cos(turn + theta)

    def yields(self, N: float) -> dict[str, float]:
        """Deflections [m] by name under the normal force N [N]."""
        q = self.q
        smeared = N * q.z / (2 * math.pi * q.l)  # times 1/r is a pressure
        inner, outer = q.R_id / q.R_i, q.R_e / q.R_ed
        E_star = q.E / (2 * (1 - q.nu**2))
        r_e = q.R_e - self._OC
        found = {"BI": 0.0, "BE": 0.0} if self.rigid else {
            "BI": smeared / q.E * ((1 + inner**2) / (1 - inner**2) - q.nu),
            "BE": smeared / q.E * ((1 + outer**2) / (1 - outer**2) + q.nu),
        }  # fmt: skip
        found["g"] = N * (q.R_e - q.R_i) / (q.E * q.b * q.l)
        for name, r, R in (("HI", q.r_i, q.R_i), ("HE", r_e, -q.R_e)):
            given = {"length": q.l, "R": r * R / (r + R), "E_star": E_star}
            found[name] = float(slices.press_slices(q.gap, load=N, **given).approach) if N else 0.0
        return found

    def under(self, N: float) -> Touching:
        """State of the sprag under the normal force N [N]."""
        q, d = self.q, self.yields(N)
        grown = self.grown()
        OC = self._OC + d["BE"] + d["HE"] + d["g"] / 2 + grown
        lost = (d["HI"] + d["g"]) / 2 if self.printed else 0.0
        meets = q.R_i - d["BI"] - d["HI"] - d["g"] / 2 + lost
        first = self.start
        alpha = float(brentq(lambda a: self._near(first, a, OC)[0] - meets, -FAR, FAR, xtol=1e-14))
        _, beta, turned = self._near(first, alpha, OC)
        OA, OB = q.R_i - d["BI"] - d["HI"] / 2, q.R_e + d["BE"] + d["HE"] / 2 + grown
        A = OA * np.array([math.sin(beta), math.cos(beta)])
        B, C = np.array([0.0, OB]), np.array([0.0, OC])
        strut = B - A
        along, across = float(strut @ A) / OA, float(A[0] * strut[1] - A[1] * strut[0]) / OA
        nu = math.atan2(across, along)
        return Touching(N, alpha, turned, nu, q.z * N * math.tan(nu) * OA, A, B, C)

    def grown(self) -> float:
        """Growth [m] of the bore of the outer race by rotation; a hollow disc in plane stress."""
        q = self.q
        return float(q.R_e * q.density * q.omega**2 / (4 * q.E)
                     * ((3 + q.nu) * q.R_ed**2 + (1 - q.nu) * q.R_e**2))  # fmt: skip

    def at_torque(self, T: float, near: float) -> Touching:
        """State under the torque T [N m]; its normal force must lie within 50 % of `near` [N]."""
        N = brentq(lambda N: self.under(N).T - T, 0.5 * near, 1.5 * near, rtol=1e-13)
        return self.under(float(N))

    def at_friction(self, mu: float, near: float) -> Touching:
        """State with the required friction coefficient mu; N must lie within 50 % of `near` [N]."""
        N = brentq(lambda N: math.tan(self.under(N).nu) - mu, 0.5 * near, 1.5 * near, rtol=1e-12)
        return self.under(float(N))

    def rolled(self, N: float, steps: int) -> float:
        """Rotation [rad] of the inner race from no load to N [N]; the outer race is at rest.

        In each step, contact B moves along a path on the sprag. The sprag rolls so that the
        material point in the middle of this path retains its azimuth. The inner race rotates with
        the material point in the middle of the path of contact A.
        """
        way = [self.under(N * (k / steps) ** POWER) for k in range(steps + 1)]
        return math.fsum(_taken(one, two) for one, two in pairwise(way))


def _taken(one: Touching, two: Touching) -> float:
    """Angle [rad] by which the sprag rotates the inner race from one state to the next."""
    B = (_on_sprag(one, one.B) + _on_sprag(two, two.B)) / 2
    A = (_on_sprag(one, one.A) + _on_sprag(two, two.A)) / 2
    swung = _azimuth(one, B) - _azimuth(two, B)  # counter-clockwise, of the line OB
    return swung + _azimuth(two, A) - _azimuth(one, A)


def _on_sprag(now: Touching, place: Array) -> Array:
    c, s = math.cos(now.alpha), math.sin(now.alpha)
    return np.array([[c, -s], [s, c]]) @ (place - now.C)


def _azimuth(now: Touching, point: Array) -> float:
    c, s = math.cos(now.alpha), math.sin(now.alpha)
    x, y = now.C + np.array([[c, s], [-s, c]]) @ point
    return math.atan2(y, x)
