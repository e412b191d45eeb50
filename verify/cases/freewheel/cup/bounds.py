"""What is expected of the formulas of a drawn cup, from rings that enclose it and from sizes.

The cup holds the ring outside its corners, X_o/cos(pi/z), and lies in the ring outside its flats,
X_o: as a ring it is softer than this one and stiffer than that one. On that one the rollers stand
on what is left of the flat, a column in which the load spreads as in a half plane: from a Hertz
patch, -2 ln(a) + 2 ln 2 + 1 of P/(pi E'), to the pressures at the depth h, -2 ln(h) + 2, and it
shortens by 2 ln(2 h/a) - nu'; together 1 - nu' more than a bore. The torque winds cup and shaft up.

At equal torque errors grow near the summit, where a little compliance costs much torque: the whole
course is followed with approaches at the corners of what they may be.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from analytic.contact.checks import Array
from analytic.freewheel import rolling, series
from analytic.freewheel.compliance import Body
from analytic.freewheel.state import State
from verify.cases.freewheel.bounds import (
    CURVED,
    LEAST,
    LOOSE,
    SIDEWAYS,
    SMALLEST,
    TIGHT,
    Interval,
    enclosed,
    of_approach,
    tilting,
    winding,
)
from verify.cases.freewheel.cup.inputs import Cup

POINTS = 4000  # of a course
FARTHER = 1.5  # normal force over that of the summit

Factors = tuple[float, float, float]


@dataclass(frozen=True)
class Course:
    """The formulas' course over N, approaches and torque times given factors."""

    q: Cup
    factors: Factors = (1.0, 1.0, 1.0)

    @cached_property
    def _states(self) -> tuple[Array, Array, Array, Array]:
        """N [N], both approaches [m], torque [N m] as far as there is an angle."""
        q, (f_i, f_o, f_T) = self.q, self.factors
        top = float(q.at_summit.N)
        N = FARTHER * top * np.linspace(0, 1, POINTS) ** 3
        d = q.bodies.approaches(N / q.L)
        d_i, d_o = f_i * d.d_i, f_o * d.d_o
        alpha = q.cam.alpha(d_i=d_i, d_o=d_o)
        known = np.isfinite(alpha)
        T = f_T * q.z * q.R_s * N * np.tan(alpha)
        return N[known], d_i[known], d_o[known], T[known]

    @property
    def summit(self) -> float:
        """Largest torque [N m]."""
        return float(self._states[3].max())

    def at(self, T: float) -> dict[str, float]:
        """N [N], alpha [rad], s [m], phi [rad] of rolling under a torque, or at the summit."""
        N, d_i, d_o, torque = self._states
        rising = slice(int(torque.argmax()) + 1)
        cam, now = self.q.cam, min(T, self.summit)
        courses = {
            "N": N, "alpha": cam.alpha(d_i=d_i, d_o=d_o), "s": cam.arc(d_i=d_i, d_o=d_o),
            "phi": rolling.torsion(cam, d_i=d_i, d_o=d_o),
        }  # fmt: skip
        return {k: float(np.interp(now, torque[rising], v[rising])) for k, v in courses.items()}


class CupBounds:
    """Intervals for formula/reference - 1 in a state."""

    def __init__(self, q: Cup, state: State) -> None:
        self.q, self.state = q, state
        P, d_i, d_o = float(state.N) / q.L, float(state.d_i), float(state.d_o)
        wide, psi = max(float(state.a_i), float(state.a_o)) / q.r, float(state.psi)
        self.hertz = max(CURVED * wide**2, LEAST)
        c = max(wide**2 / 2 + psi**2 / 16, SMALLEST)
        low, middle, high = cup_bracket(q, P)
        # not the formula's own d_o: what is expected must not move with what is judged
        self.own = {"d_i": d_i, "d_o": middle}
        x = float(q.cam.centre(d_i=d_i, d_o=d_o)[0])
        wound = winding(q, float(state.T), q.X_o, q.R_a) * x
        self.d_i = d_i * (1 - c), d_i * (1 + c)
        self.d_o = low * (1 - c) + TIGHT * wound, high * (1 + c) + LOOSE * wound
        wall = min(q.R_s - q.r_b, q.R_a - q.X_o)
        self.tilt = tilting(q, P, wall) / math.tan(float(state.alpha))

    @property
    def corners(self) -> tuple[Factors, ...]:
        """Factors of approaches and torque at the corners of what they may be."""
        d_i, d_o = float(self.state.d_i), float(self.state.d_o)
        return tuple(
            (i / d_i, o / d_o, 1 + t)
            for i, o, t in product(self.d_i, self.d_o, (-self.tilt, self.tilt))
        )

    @property
    def middle(self) -> Factors:
        """Factors of the approaches of the ring that is expected to stand for the cup."""
        return 1.0, self.own["d_o"] / float(self.state.d_o), 1.0

    def approach(self, which: str) -> Interval:
        """Of d_i or d_o."""
        return of_approach(self.own[which], getattr(self, which))

    def contact(self) -> Interval:
        """Of half-widths and pressures."""
        return -self.hertz, self.hertz

    @cached_property
    def _at_torque(self) -> tuple[dict[str, float], list[dict[str, float]]]:
        T = float(self.state.T)
        middle = Course(self.q, self.middle).at(T)
        return middle, [Course(self.q, f).at(T) for f in self.corners]

    def under_torque(self, key: str) -> Interval:
        """Of N, alpha or s at this torque."""
        own, corners = self._at_torque
        return enclosed(own[key], [c[key] for c in corners])

    def slope(self) -> Interval:
        """Of tan(alpha), at this torque."""
        own, corners = self._at_torque
        return enclosed(math.tan(own["alpha"]), [math.tan(c["alpha"]) for c in corners])

    def torsion(self) -> Interval:
        """Of phi: what rolls, the contacts' tangential way, and shaft and cup wound up."""
        q, (own, corners) = self.q, self._at_torque
        T = float(self.state.T)
        wound = winding(q, T, q.X_o, q.R_a) + winding(q, T, q.r_b, q.R_s)
        tan, tan_0 = math.tan(own["alpha"]), math.tan(float(q.cam.alpha0))
        (less, more) = SIDEWAYS[0] * tan**2, SIDEWAYS[1] * tan * tan_0
        low = min(c["phi"] for c in corners) * (1 + less) + TIGHT * wound
        high = max(c["phi"] for c in corners) * (1 + more) + LOOSE * wound
        return enclosed(own["phi"], [low, high])

    def torque(self) -> Interval:
        """Of T at this normal force."""
        cam, corners = self.q.cam, self.corners
        d_i, d_o = float(self.state.d_i), float(self.state.d_o)
        _, middle, _ = self.middle
        own = math.tan(float(cam.alpha(d_i=d_i, d_o=middle * d_o)))
        found = [t * math.tan(float(cam.alpha(d_i=i * d_i, d_o=o * d_o))) for i, o, t in corners]
        return enclosed(own, found)

    def summit(self) -> Interval:
        """Of the largest torque."""
        own = Course(self.q, self.middle).summit
        return enclosed(own, [Course(self.q, f).summit for f in self.corners])

    def force_at_angle(self, psi: float) -> Interval:
        """Of N at an angle: where the approaches leave it."""
        return enclosed(
            self._force(psi, self.middle), [self._force(psi, f) for f in self.corners]
        )  # fmt: skip

    def _force(self, psi: float, factors: Factors) -> float:
        N, d_i, d_o, _ = Course(self.q, factors)._states
        alpha = self.q.cam.alpha(d_i=d_i, d_o=d_o)
        return float(np.interp(-psi / 2, -alpha, N))


def cup_bracket(q: Cup, P: float) -> tuple[float, float, float]:
    """Least, expected and largest approach [m] of roller and cup under P = N/L [N/m].

    Expected is that of the ring whose bore encloses as much as the flats do, drawn between those of
    the rings with the bores X_o and X_o/cos(pi/z).
    """
    flats, corners = (_as_ring(q, P, bore, 0.0) for bore in (q.X_o, q.corner))
    half = math.pi / q.z
    share = (q.X_o * math.sqrt(math.tan(half) / half) - q.X_o) / (q.corner - q.X_o)
    column = 1 - float(q.clutch.outer.plane[1])
    return flats, flats + share * (corners - flats), _as_ring(q, P, q.corner, column)


def _as_ring(q: Cup, P: float, bore: float, column: float) -> float:
    """Approach [m] of roller and a ring, its constant k raised by `column`."""
    whole = q.clutch
    E, nu = whole.outer.plane
    _, a = whole.half_widths(P)
    half, _ = q.bodies.half_roller.approach(np.asarray(P), a)
    k = series.race_constant(ratio=q.R_a / bore, n=q.z, nu=nu, loaded="bore") + column
    body = Body(E=E, l=np.asarray(bore), k=k, c=series.curvature_term(nu=nu, loaded="bore"))
    return float(half + body.approach(np.asarray(P), a)[0])
