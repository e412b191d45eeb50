"""The claims about one's own clutch: angle, force and torsion at its load, slip, a few µm of X."""

from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np
from scipy.optimize import brentq

from analytic.freewheel.compliance import compliance
from analytic.freewheel.state import loaded
from verify.case import Comparison, Quantity
from verify.cases.freewheel.bounds import (
    BRACKET,
    SMALLEST,
    TANGENTIAL,
    Bounds,
    Interval,
    known,
)
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Context, Values
from verify.judging.checks import Approximation, Fact

SHARED = "plane strain, small strain, the star clamped in its bore"
COULOMB = "Coulomb's law of friction"
SHARP = "acceptance of the subject"
FAR = 5.0  # the normal force is searched within this factor of the formula's


def expected(q: ClutchInputs) -> Bounds:
    one = q.as_star
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
    ends = [angle(q, dX, f_i, f_o) for dX in (-q.off, q.off)]
    return (ends[1] - ends[0]) / (2 * q.off)


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
        found = known(q.as_star, of(q))
        return (found.low, found.high) if found.sharp else None

    return interval


def comparisons(case: Any) -> Iterator[Comparison]:
    """Of the class of the case: under its torque, about slip, and with the flats moved."""
    more: Any = {"formal": 2, "source": BRACKET}
    judged: list[tuple[Quantity, Approximation]] = [
        (case.alpha, Approximation(
            name="clamping angle under torque (Eqs. 4, 5)", symbol="α(T)", unit="deg",
            analytic="alpha", fem="alpha", demand=0.002, demand_reason=SHARP,
            interval=within(lambda q: expected(q).angle()), **more)),
        (case.N, Approximation(
            name="normal force under torque (Eqs. 2, 3)", symbol="F_n(T)", unit="N",
            analytic="N", fem="N", interval=within(lambda q: expected(q).force()), **more)),
        (case.phi, Approximation(
            name="torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)", symbol="φ",
            unit="deg", analytic="phi", fem="phi",
            interval=within(lambda q: expected(q).torsion()), formal=2, source=TANGENTIAL)),
        (case.dalpha_dX, Approximation(
            name="turn of the loaded angle by X", symbol="dα(T)/dX", unit="deg/mm",
            analytic="dalpha_dX", fem="dalpha_dX", interval=within(turn), **more)),
    ]  # fmt: skip
    for quantity, check in judged:
        yield Comparison(check=check, quantity=quantity, shares=SHARED)
    for name, margin in (
        ("friction 1 % above μ_req bears torque and axial load (Eqs. 8, 9)", bears),
        ("friction 1 % below μ_req does not (Eqs. 8, 9)", lets_go),
    ):
        fact = Fact(name=name, symbol="μ_req", unit="1", margin=margin)
        yield Comparison(check=fact, quantity=case.mu_req, shares=COULOMB)
