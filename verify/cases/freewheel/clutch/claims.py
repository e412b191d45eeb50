"""The claims about one's own clutch: angle, force and torsion at its load, slip, a few µm of X."""

from collections.abc import Callable
from functools import lru_cache
from itertools import product

import numpy as np
from scipy.optimize import brentq

from analytic.freewheel.compliance import compliance
from analytic.freewheel.state import loaded
from verify.cases.freewheel.bounds import BRACKET, SMALLEST, Bounds, Interval, known
from verify.cases.freewheel.clutch.fem import off, star
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Context, Values
from verify.judging.checks import Approximation, Fact

SHARP = "acceptance of the subject"
FAR = 5.0  # the normal force is searched within this factor of the formula's


def expected(q: ClutchInputs) -> Bounds:
    one = star(q)
    return Bounds(one, loaded(one.clutch, one.T))


@lru_cache(maxsize=8)
def turn(q: ClutchInputs) -> Interval:
    """Of dalpha/dX at the torque, with approaches anywhere within their bounds."""
    enclosed = expected(q)
    own = float(enclosed.state.d_i), float(enclosed.state.d_o)
    factors = [[end / d for end in ends]
               for d, ends in zip(own, (enclosed.d_i, enclosed.d_o), strict=True)]  # fmt: skip
    ratio = [turned(q, 1.0, 1.0) / turned(q, *pair) - 1 for pair in product(*factors)]
    return min(*ratio, -SMALLEST), max(*ratio, SMALLEST)


def turned(q: ClutchInputs, f_i: float, f_o: float) -> float:
    """dalpha/dX [rad/m] between X ± off, with approaches `f_i`, `f_o` times the formula's."""
    ends = [angle(q, dX, f_i, f_o) for dX in (-off(q), off(q))]
    return (ends[1] - ends[0]) / (2 * off(q))


def angle(q: ClutchInputs, dX: float, f_i: float, f_o: float) -> float:
    """The angle [rad] at the torque with the flats moved by `dX` [m]."""
    moved = q.moved(dX)
    cam, bodies = moved.cam, compliance(moved)
    F_t, N = q.T / (q.z * q.R), float(expected(q).state.N)

    def at(force: float) -> float:
        d = bodies.approaches(force / q.L)
        return float(cam.alpha(d_i=f_i * d.d_i, d_o=f_o * d.d_o))

    force = brentq(lambda x: x * np.tan(at(x)) / F_t - 1, N / FAR, FAR * N, rtol=1e-13)
    return at(force)


def lets_go(context: Context) -> tuple[float, float]:
    """With friction a per cent below mu_req the limit of slip is below the axial load."""
    return float(0.5 - context.fem[-1].arrays["around"][0]), 0.0


def bears(context: Context) -> tuple[float, float]:
    """And a per cent above it is higher."""
    return float(context.fem[-1].arrays["around"][1] - 0.5), 0.0


def within(of: Callable[[ClutchInputs], Interval]) -> Callable[..., Interval | None]:
    """An interval as a claim takes it; none where it is too wide to judge by."""

    def interval(q: ClutchInputs, _values: Values) -> Interval | None:
        found = known(star(q), of(q))
        return (found.low, found.high) if found.sharp else None

    return interval


CHECKS = (
    Approximation(name="clamping angle under torque (Eqs. 4, 5)", symbol="α(T)", unit="deg",
                  analytic="alpha", fem="alpha", formal=2, source=BRACKET, demand=0.002,
                  demand_reason=SHARP, interval=within(lambda q: expected(q).angle())),
    Approximation(name="normal force under torque (Eqs. 2, 3)", symbol="F_n(T)", unit="N",
                  analytic="N", fem="N", formal=2, source=BRACKET,
                  interval=within(lambda q: expected(q).force())),
    Approximation(name="torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)", symbol="φ",
                  unit="deg", analytic="phi", fem="phi", formal=2,
                  interval=within(lambda q: expected(q).torsion()),
                  source=f"{BRACKET}, tangential deformation of 0.5 to 1 tan²α"),
    Approximation(name="turn of the loaded angle by X", symbol="dα(T)/dX", unit="deg/mm",
                  analytic="dalpha/dX", fem="dalpha/dX", formal=2, source=BRACKET,
                  interval=within(turn)),
    Fact(name="friction 1 % above μ_req bears torque and axial load (Eqs. 8, 9)", symbol="μ_req",
         unit="1", margin=bears),
    Fact(name="friction 1 % below μ_req does not (Eqs. 8, 9)", symbol="μ_req", unit="1",
         margin=lets_go),
)  # fmt: skip
