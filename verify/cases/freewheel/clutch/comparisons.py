"""The claims about one's own clutch: angle, force and torsion at its load, slip, a few µm of X."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Any

from analytic.bounds.freewheel.intervals import Interval
from analytic.bounds.freewheel.star import StarBounds
from analytic.bounds.freewheel.turn import Moved, of_turn
from analytic.freewheel.compliance import compliance
from analytic.freewheel.state import loaded
from verify.case import Comparison, Quantity
from verify.cases.freewheel.bounds import BRACKET, TANGENTIAL, known, of_star, parts
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Context, Values
from verify.judging.checks import Approximation, Fact

SHARED = "plane strain, small strain, the star clamped in its bore"
COULOMB = "Coulomb's law of friction"
SHARP = "acceptance of the subject"


def expected(q: ClutchInputs) -> StarBounds:
    one = q.as_star
    return of_star(one, loaded(one.clutch, one.T))


@lru_cache(maxsize=8)
def turn(q: ClutchInputs) -> Interval:
    """Of dalpha/dX at the torque, with approaches anywhere within their bounds."""
    ends = [moved(q, dX) for dX in (-q.off, q.off)]
    return of_turn(ends, expected(q), off=q.off, F_t=q.T / (q.z * q.R))


def moved(q: ClutchInputs, dX: float) -> Moved:
    """The clutch with the flats moved by `dX` [m]."""
    bodies = compliance(q.moved(dX))

    def approaches(N: float) -> tuple[float, float]:
        d = bodies.approaches(N / q.L)
        return float(d.d_i), float(d.d_o)

    return Moved(replace(parts(q.as_star), flat=q.X + dX), approaches)


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
