"""Comparisons of a user's clutch: angle, force and wind-up under load, slip, sensitivity to X."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

from analytic.bounds.freewheel.intervals import Interval
from analytic.bounds.freewheel.star import StarBounds
from analytic.bounds.freewheel.turn import Moved, of_turn
from analytic.freewheel.compliance import compliance
from analytic.freewheel.state import loaded
from verify.case import Comparison, Computed, Quantity, approximation
from verify.cases.freewheel.bounds import BRACKET, TANGENTIAL, known, of_star, parts
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Context
from verify.judging.checks import Fact

SHARED = "plane strain, small strain, the star clamped in its bore"
COULOMB = "Coulomb's law of friction"
SHARP = "accepted error of this quantity"


def expected(q: ClutchInputs) -> StarBounds:
    one = q.as_star
    return of_star(one, loaded(one.clutch, one.T))


@lru_cache(maxsize=8)
def turn(q: ClutchInputs) -> Interval:
    """Interval of the error of dalpha/dX under torque, from error bounds of contact approaches."""
    ends = [moved(q, dX) for dX in (-q.off, q.off)]
    return of_turn(ends, expected(q), off=q.off, F_t=q.T / (q.z * q.R))


def moved(q: ClutchInputs, dX: float) -> Moved:
    """Dimensions and contact approaches of a clutch with its flats `dX` [m] farther outwards."""
    bodies = compliance(q.moved(dX))

    def approaches(N: float) -> tuple[float, float]:
        d = bodies.approaches(N / q.L)
        return float(d.d_i), float(d.d_o)

    return Moved(replace(parts(q.as_star), flat=q.X + dX), approaches)


def slips_below(context: Context) -> tuple[float, float]:
    """Margin, positive if the clutch slips with friction 1 % below mu_req; uncertainty 0."""
    return float(0.5 - context.fem[-1].arrays["around"][0]), 0.0


def bears(context: Context) -> tuple[float, float]:
    """Margin, positive if the clutch holds with friction 1 % above mu_req; uncertainty 0."""
    return float(context.fem[-1].arrays["around"][1] - 0.5), 0.0


def interval(q: ClutchInputs, of: Callable[[], Interval]) -> tuple[float, float] | None:
    """Interval of the expected error; None if it is too wide for judging."""
    found = known(q.as_star, of())
    return (found.low, found.high) if found.sharp else None


def comparisons(q: ClutchInputs, case: Any) -> Iterator[Comparison]:
    """Rows of `q` under torque, with shifted flats and at slip; `case` defines the quantities."""
    judged: tuple[tuple[Quantity, str, str, Callable[[], Interval], str], ...] = (
        (case.alpha, "clamping angle under torque (Eqs. 4, 5)", "α(T)",
         lambda: expected(q).angle(), BRACKET),
        (case.N, "normal force under torque (Eqs. 2, 3)", "F_n(T)", lambda: expected(q).force(),
         BRACKET),
        (case.phi, "wind-up by exact rolling (Eq. 7, corrected), compared with the wind-up "
         "from the strain energy", "φ",
         lambda: expected(q).torsion(), TANGENTIAL),
        (case.dalpha_dX, "derivative of the clamping angle under torque with respect to X",
         "dα(T)/dX", lambda: turn(q), BRACKET),
    )  # fmt: skip
    for quantity, name, symbol, of, source in judged:
        more: Any = {"sensitivity": (0.002, SHARP)} if quantity is case.alpha else {}
        computed = Computed(partial(interval, q, of), source)
        yield approximation(quantity, name=name, symbol=symbol, expected=computed, order=2,
                            shares=SHARED, **more)  # fmt: skip
    for name, margin in (
        ("friction 1 % above μ_req transmits torque and axial load (Eqs. 8, 9)", bears),
        (
            "friction 1 % below μ_req does not transmit torque and axial load (Eqs. 8, 9)",
            slips_below,
        ),
    ):
        check = Fact(name=name, symbol="μ_req", unit="1", margin=margin)
        yield Comparison(check=check, quantity=case.mu_req, shares=COULOMB)
