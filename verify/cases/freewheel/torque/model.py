"""Formulas of a roller freewheel under torque (Nagler, Lohrengel, Eqs. 2 to 7), and their errors.

What is expected of them comes from bodies that enclose the star and from sizes. The star's approach
lies among those of a layer and of two discs (`analytic.freewheel.star_bracket`), and the torque
winds the star up on its bore, which lowers the flat under the roller; everything else follows from
the approaches. Round bodies that Hertz takes for parabolas on half planes err by some (a/r)².
Surfaces tilt under N as far as a half plane does at the depth of its wall. Tangential forces deform
the contacts, too, and turn the ring further by tan² alpha, times the tangential compliance over the
normal one, which is somewhat below 1.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np

from analytic.freewheel import printed
from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.star_bracket import between_discs, expected_approach
from analytic.freewheel.state import State, at_angle, at_normal_force, loaded
from verify.cases.freewheel.inputs import StarInputs
from verify.core.case import Values

GIVEN = 10.0  # N_0/(L E'): both approaches together at the angle that is given
CURVED = 4.0  # bound of what Hertz neglects of pressures, over (a/r)²; between flats it is 3/16
LEAST = 7e-3  # and no less is asked of them: 1 % is accepted, meshes take 0.3
ROUNDED = 2e-5  # of a value: nothing finer is asked, splines and meshes take half of it
SMALLEST = 2e-3  # nor of approaches that others follow from
ASKED = 4e-3  # nor of approaches themselves
TIGHT, LOOSE = 0.8, 1.2  # of the winding of a ring: corners stand beyond it, some without shear
SIDEWAYS = 0.5, 1.0  # bounds of the tangential over the normal compliance, of like logarithms
STRAIGHT = 0.01  # of phi: what the printed angle's ratio changes by along its arc
STEEPER = 1.15  # d ln(N)/d ln(approach) at most

Interval = tuple[float, float]


@lru_cache(maxsize=8)
def clutch(q: StarInputs) -> Clutch:
    steel = Material(E=q.E, nu=q.nu)
    return Clutch(
        cam=q.cam, L=q.L, r_b=q.r_b, R_a=q.R_a, roller=steel, inner=steel, outer=steel
    )  # fmt: skip


def rigid_normal_force(q: StarInputs) -> float:
    """N_0 [N] of a clutch that keeps its angle alpha_0."""
    return float(q.T / (q.z * q.R * np.tan(q.cam.alpha0)))


def state_under(q: StarInputs, T: float) -> State:
    """The state under the torque T [N m]; ValueError where the rollers are past their flats."""
    state = loaded(clutch(q), T)
    if not np.isfinite(state.N):
        raise ValueError(
            f"under T = {T:g} N m the contacts are wider than half the rollers' radius: these "
            "formulas end there"
        )
    x, half = float(q.cam.centre(d_i=state.d_i, d_o=state.d_o)[0]), float(q.cam.corner)
    if x >= half:
        raise ValueError(
            f"under T = {T:g} N m the rollers are past the corners of their flats: "
            f"{x * 1e3:.4g} mm from the middle of flats that end at {half * 1e3:.4g} mm"
        )
    return state


def analytic(q: StarInputs) -> Values:
    whole, N_0 = clutch(q), rigid_normal_force(q)
    under, same = state_under(q, q.T), at_normal_force(whole, N_0)
    d = GIVEN * N_0 / q.L * (1 - q.nu**2) / q.E
    y = q.X + q.r - d / 2
    given = at_angle(whole, math.acos(y / (q.R - q.r + d / 2)))
    if not np.all(np.isfinite([same.N, given.N])):
        raise ValueError(
            f"under N = T/(z R tan α_0) = {N_0:.4g} N, a rigid clutch's, the contacts are "
            "wider than half the rollers' radius: these formulas end there"
        )
    values: dict[str, Any] = {
        "alpha_0": q.cam.alpha0, "alpha": under.alpha, "N": under.N, "F_t": under.F_t,
        "F_t/N": np.tan(under.alpha), "s": under.s, "phi": under.phi,
        "phi printed": under.phi_printed, "phi small": under.phi_small, "d_i": under.d_i,
        "d_o": under.d_o, "a_i": under.a_i, "a_o": under.a_o, "p_i": under.p_i, "p_o": under.p_o,
        "one": 1.0, "N_0": N_0, "d_i at N": same.d_i, "d_o at N": same.d_o, "a_i at N": same.a_i,
        "a_o at N": same.a_o, "p_i at N": same.p_i, "p_o at N": same.p_o, "T at N": same.T,
        "T printed at N": printed.torque_on_cam(q.cam, F_t=same.F_t), "N at angle": given.N,
    }  # fmt: skip
    return {key: float(value) for key, value in values.items()}


class Expected:
    """Intervals for formula/FE - 1, from approaches that may be within bounds."""

    def __init__(self, q: StarInputs, state: State) -> None:
        self.q, self.state = q, state
        self.P = float(state.N) / q.L
        wide = max(float(state.a_i), float(state.a_o)) / q.r
        self.hertz = max(CURVED * wide**2, LEAST)
        # a roller's loads stand psi off its diameter, and the roller is half of an approach
        c = max(wide**2 / 2 + float(state.psi) ** 2 / 16, SMALLEST)
        d_i, d_o = float(state.d_i), float(state.d_o)
        low, high = (float(d) for d in expected_approach(clutch(q), self.P))
        wound = winding(q, float(state.T)) * float(q.cam.centre(d_i=d_i, d_o=d_o)[0])
        low, high = low * (1 - c), high * (1 + c)
        # not the formula's own d_i: what is expected must not move with what is judged
        self.own = {"d_i": float(between_discs(clutch(q), self.P)), "d_o": d_o}
        self.d_i = low + TIGHT * wound, high + LOOSE * wound
        self.d_o = d_o * (1 - c), d_o * (1 + c)
        self.size = sum(self.own.values())
        wall = min(q.X - q.r_b, q.R_a - q.R)
        angle = 2 * self.P * (1 - q.nu**2) / (math.pi * q.E * wall)
        self.tilt = angle / math.tan(float(state.alpha))

    def approach(self, which: str) -> Interval:
        own, (low, high) = self.own[which], getattr(self, which)
        return min(own / high - 1, -ASKED), max(own / low - 1, ASKED)

    def contact(self) -> Interval:
        """Of half-widths and pressures."""
        return -self.hertz, self.hertz

    def angle(self) -> Interval:
        return self._of(lambda **d: float(self.q.cam.alpha(**d)))

    def way(self) -> Interval:
        return self._of(lambda **d: float(self.q.cam.arc(**d)))

    def slope(self, *, tilted: bool = False) -> Interval:
        """Of tan(alpha), where `tilted` also as one contact alone has it."""
        low, high = self._of(lambda **d: math.tan(float(self.q.cam.alpha(**d))))
        more = self.tilt if tilted else 0.0
        return low - more, high + more

    def force(self) -> Interval:
        """Of N at a torque, which goes as 1/tan(alpha)."""
        low, high = self.slope(tilted=True)
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def torsion(self) -> Interval:
        """Of phi, which goes as the way of the rollers and is added to by tangential forces."""
        (low, high), square = self.way(), math.tan(float(self.state.alpha)) ** 2
        less, more = (share * square for share in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def force_at_angle(self) -> Interval:
        """Of N at an angle, which says what both approaches are together."""
        low, high = (sum(ends) / self.size for ends in zip(self.d_i, self.d_o, strict=True))
        return low**STEEPER - 1, high**STEEPER - 1

    def _of(self, value: Callable[..., float]) -> Interval:
        own = value(**self.own)
        corners = [value(d_i=d_i, d_o=d_o) for d_i, d_o in product(self.d_i, self.d_o)]
        return own / max(corners) - 1 - ROUNDED, own / min(corners) - 1 + ROUNDED


def winding(q: StarInputs, T: float) -> float:
    """Angle [rad] by which a hollow shaft from the star's bore to its flats is wound up."""
    G = q.E / (2 * (1 + q.nu))
    return T / q.L / (4 * math.pi * G) * (1 / q.r_b**2 - 1 / q.X**2)


def under_torque(q: StarInputs) -> Expected:
    return Expected(q, loaded(clutch(q), q.T))


def under_force(q: StarInputs) -> Expected:
    return Expected(q, at_normal_force(clutch(q), rigid_normal_force(q)))


def times(interval: Interval, ratio: float, spread: float = 0.0) -> Interval:
    """The interval of a formula that is `ratio` times another, within `spread` of that."""
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1
