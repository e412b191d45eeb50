"""Rows of a sprag clutch: its state by a numerical profile, its pressures by strips."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from verify.case import Comparison, Quantity, State, identity
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.model import fast, low_friction
from verify.cases.sprag.clutch.paper_statements import LITTLE_SPRUNG, OF_THE_PAPER
from verify.cases.sprag.statements import BY_STRIPS, PLACE, WIDER, sliced
from verify.core.case import Check, Context
from verify.core.results import Row
from verify.form.comparisons import key_of
from verify.judging.checks import Identity
from verify.judging.profile_checks import Estimated

LAW = 2e-5  # standard relative error of N and tan(nu) by the cubic between loads of a law
LAW_ALPHA = 1e-3  # likewise for rotations and deflections, at most 0.15 % of the contacts' share
DRAWN = "numerical profile, same deflection laws"
FROM_DRAWN = 1e-3, "u_ref includes the error of interpolation of the tabulated contact laws"
SLIPS = 0.01
SAME_CONTACT = "line contacts, radius of the inner contact under load"
SAME_LAWS = "deflections by the laws of Eqs. 2-8"


@dataclass(frozen=True, kw_only=True)
class ByDrawn(Identity):
    """Row on a value against the numerical profile, if value and profile exist."""

    by: str = DRAWN

    def rows(self, context: Context) -> list[Row]:
        sides = (context.analytic, *(level.values for level in context.fem))
        keys = (self.analytic, *[self.fem] * len(context.fem))
        there = all(key in side for key, side in zip(keys, sides, strict=True))
        return super().rows(context) if there else []


def by_drawn(
    q: Quantity, name: str, symbol: str, law: float = LAW_ALPHA, state: State | None = None,
    **more: Any,
) -> Comparison:  # fmt: skip
    """Row on a quantity against the numerical profile; `law` is the error of the contact law."""
    key, numbers = key_of(q, state), {f"uncertainty of {name}": law} if law else {}
    check = ByDrawn(name=name, symbol=symbol, unit=q.unit, analytic=key, fem=key, formal=2,
                    residual=next(iter(numbers), ""), **more)  # fmt: skip
    if state and state.case:
        numbers[key] = getattr(state.case, q.name)
    return Comparison(check=check, quantity=q, state=state, numbers=numbers, shares=SAME_LAWS)


def drawn_states(clutch: Any) -> Iterator[Comparison]:
    """Rows on rolling, rigid races, printed Eqs. 9 and 10, and two variants of the clutch."""
    c, paper = ClutchFormulas, clutch.is_default
    yield by_drawn(c.theta, "wind-up of the races, by finite steps of rolling", "θ(T)")
    yield by_drawn(c.N_Liu, "normal force with rigid races (Liu)", "N_L", LAW)
    yield by_drawn(c.alpha_Liu, "rotation of the sprags with rigid races (Liu)", "α_L")
    yield by_drawn(c.theta_Liu, "wind-up with rigid races (Liu), by finite steps of rolling", "θ_L")
    yield by_drawn(c.alpha_printed, "rotation of the sprags, Eqs. 9 and 10 as printed", "α_9,10")
    mu = low_friction(clutch) if paper else math.nan
    weak = clutch.model_copy(update={"mu_s": mu}) if paper else None
    yield by_drawn(c.T_slip, "torque at which the contacts slip at low friction", "T_μ",
                   LAW * (mu / (mu - clutch.mu_0)), State(weak, "low", "at low friction"),
                   demand=SLIPS,
                   demand_reason="the wedge angle hardly depends on the torque, so that a small "
                   "error of tan ν changes this torque much")  # fmt: skip
    quick = State(fast(clutch) if paper else None, "fast", "at 20,000 r/min")
    yield by_drawn(c.d_ce, "growth of the outer race at 20,000 r/min", "δ_ce", 0.0, quick)
    yield by_drawn(c.alpha, "rotation of the sprags at 20,000 r/min", "α(n)", state=quick)
    yield by_drawn(c.theta, "wind-up of the races at 20,000 r/min, by rolling", "θ(n)", state=quick)


def pressures(clutch: Any) -> Iterator[Comparison]:
    """Rows that compare pressures by slices with those by strips, under N/2 (ends unloaded)."""
    c, half = ClutchFormulas, State(None, "half", "under N/2")
    for k, (race, symbol, mid, peak) in enumerate(
        (("inner", "p_i", c.p_i_mid, c.p_i), ("outer", "p_o", c.p_o_mid, c.p_o))
    ):
        for q, what in ((mid, "pressure at mid-length"), (peak, "largest pressure")):
            key = key_of(q, half)
            check = Estimated(
                name=f"{what}, {race} race, under N/2, by slices", symbol=symbol, unit="MPa",
                analytic=key, fem=key, by=BY_STRIPS, interval=sliced, source=PLACE, demand=WIDER,
                demand_reason="about twice the sum of the accepted errors of slices (2 %) and of "
                "strips (0.3 %)",
            )  # fmt: skip
            pressure = partial(clutch.half_pressure, k, mid=q is mid)
            yield Comparison(check=check, quantity=q, state=half, numbers={key: pressure},
                             shares=SAME_CONTACT)  # fmt: skip


def stated(clutch: Any) -> Iterator[Comparison | Check]:
    """Rows on the state under torque, on pressures and on the statements of the paper."""
    c = ClutchFormulas
    common: dict[str, Any] = {"order": 2, "by": DRAWN, "shares": SAME_LAWS}
    yield identity(c.N, name="normal force under torque", symbol="N(T)", uncertainty=LAW,
                   sensitivity=FROM_DRAWN, **common)  # fmt: skip
    yield identity(c.mu_req, name="required friction coefficient under torque, tan ν",
                   uncertainty=LAW, sensitivity=FROM_DRAWN, **common)  # fmt: skip
    yield identity(c.alpha, name="rotation of the sprags under torque", uncertainty=LAW_ALPHA,
                   **common)  # fmt: skip
    yield identity(c.H, name="sum of the five deflections", uncertainty=LAW_ALPHA, **common)
    yield from drawn_states(clutch)
    yield from pressures(clutch)
    yield Comparison(check=LITTLE_SPRUNG, quantity=c.N_0)
    yield from OF_THE_PAPER
