"""Rows on friction of a sprag clutch: limit of locking, sliding states, check of the time step."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from verify.case import Comparison, Computed, approximation, identity
from verify.cases.sprag.engagement.comparisons import BY, LSODA, Partnered
from verify.cases.sprag.friction.formulas import FrictionFormulas
from verify.cases.sprag.friction.reference import NARROW
from verify.core.case import Check, Context
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.checks import Accepted
from verify.judging.tolerance_checks import (
    SUBJECT,
    Agreement,
    Deviation,
    Pair,
    demanded,
    farthest,
    suites,
)

BOUNDARY, GUARDED = 0.02, 1e-3  # accepted
CLOSURE = "closure of Eqs. 9 and 10, static normal force"
SPREAD = 0.1  # least spread, relative to the correct force, for nearly equal torques
WEAK = "the springs have the stiffness K_r/25, with which the sprags slip at the start"
UNEQUAL = "Eqs. 14-16 assume N_e = N_i; statics requires N_e/N_i = cos ω/cos ν"


@dataclass(frozen=True, kw_only=True)
class Ended(Partnered):
    """Row on the time at which slip at the start ends, by Runge-Kutta steps and by LSODA.

    For a user's inputs, a difference of three time steps is accepted. If no contact slides, the
    status is SHOWN.
    """

    def rows(self, context: Context) -> list[Row]:
        if context.fem[-1].values[self.analytic] > 0:
            return super().rows(context)
        verdict = judge.Verdict(Status.SHOWN, "no sprag slides at the start")
        row = self._row(context.case, self.kind, verdict)
        return [row, self._convergence_row(context.case, verdict)]

    def demanded(self, context: Context) -> float:
        q, t = context.inputs, context.fem[-1].values[self.analytic]
        return self.demand if context.is_paper else max(super().demanded(context), 3 * q.dt / t)


def at_tan(context: Context) -> Pair:
    """Pair: smallest friction coefficient that locks, divided by tan(nu), and its expected value 1.

    The ratio is taken at the one of three torques where it differs most from 1.
    """
    T, ratio, half = context.fem[-1].arrays["boundaries"].T
    words = ", ".join(
        f"{r - 1:+.2%} relative to tan ν at {t:.4g} N m" for t, r in zip(T, ratio, strict=True)
    )
    found = farthest(np.ones_like(ratio), ratio, 0.0)
    return replace(found, U=float(half.max()), words=words)


def refused(context: Context) -> tuple[float, float, str]:
    """Margin: +1 if the check of the time step rejects the narrow speed band, otherwise -1.

    The uncertainty and the text of the row are also returned.
    """
    refuses, _ = context.fem[-1].arrays["narrow"]
    return (
        2 * refuses - 1,
        0.0,
        "the check rejects the band" if refuses else "the check does not reject the band",
    )


def unguarded(context: Context) -> tuple[float, float, str]:
    """Positive margin if N_max without the check of the time step varies by more than SPREAD.

    The variation is that over nearly equal torques, divided by the correct force. The uncertainty
    and the text of the row are also returned.
    """
    found = context.fem[-1].arrays
    share = found["unguarded"] / found["narrow"][1]
    words = (
        f"under nearly equal torques, N_max is {share.min():.0%} to {share.max():.0%} of the "
        "correct force, without an error message"
    )
    return float(np.ptp(share)) - SPREAD, GUARDED, words


def never_wrong(context: Context) -> tuple[float, float, str]:
    """Largest relative error of N_max over all accepted pairs of speed band and time step.

    The uncertainty and the text of the row are also returned.
    """
    passed = context.fem[-1].arrays["guard"]
    passed = passed[passed[:, 3] == 0]
    worst = float(np.abs(passed[:, 4]).max())
    return (
        worst,
        0.0,
        f"the check accepts {len(passed)} pairs of band and time step; the largest error of N_max "
        f"is {worst:.1e}",
    )


def never_idle(context: Context) -> tuple[float, float, str]:
    """Positive margin if N_max has an error above GUARDED in every rejected pair of band and step.

    The pairs consist of a speed band and a time step; their error is the median over nearly equal
    torques. The uncertainty and the text of the row are also returned.
    """
    all_of_them = context.fem[-1].arrays["guard"]
    stopped = all_of_them[all_of_them[:, 3] == 1]
    least = float(np.abs(stopped[:, 4]).min()) if len(stopped) else np.inf
    words = (
        f"the check rejects {len(stopped)} of {len(all_of_them)} pairs of band and time step; "
        f"the error of N_max of each rejected pair, median over nearly equal torques, is at least "
        f"{least:.0%}"
    )
    return min(least, 1.0) - GUARDED, 0.0, words if len(stopped) else "the check rejects no pair"


def by_default(context: Context) -> Pair:
    """Pair: N_max [N] by LSODA and with the automatic speed band, where both differ most."""
    _, _, ours, theirs = context.fem[-1].arrays["sweep"].T
    found = farthest(theirs, ours, 0.0)
    off = abs(found.value / found.reference - 1)
    words = (
        f"the check of the time step rejects none of {len(ours)} computed engagements; the largest "
        f"difference of N_max is {off:.1e}"
    )
    return replace(found, words=words)


def comparisons(q: FrictionFormulas) -> Iterator[Comparison | Check]:
    """All rows of the case, in the order of the page."""
    yield from _limits(q)
    yield from _partners()
    yield from _guard()


def _limits(q: FrictionFormulas) -> Iterator[Comparison]:
    def boundary() -> tuple[float, float]:
        """Interval of the error of Eqs. 14-16, which assume equal forces at both contacts."""
        return -2 * q.unequal, 2 * q.unequal

    yield approximation(
        FrictionFormulas.mu_b,
        expected=Computed(boundary, f"{UNEQUAL}; effect on the friction coefficient of either "
                          "contact"),
        name="friction coefficient above which the clutch locks, T/(n_s OA N)", by=BY,
        shares=CLOSURE,
    )  # fmt: skip
    locks = Agreement(name="friction coefficient above which the sprags lock is tan ν within "
                      f"{BOUNDARY:.0%}",
                      symbol="μ_b/tan ν", unit="1", pair=at_tan, accepted=BOUNDARY,
                      source=SUBJECT, by=BY,
                      **demanded(BOUNDARY))  # fmt: skip
    yield Comparison(check=locks, quantity=FrictionFormulas.tan, shares=CLOSURE)
    yield identity(
        FrictionFormulas.N_slides, symbol="N", by=BY, shares=CLOSURE,
        name="normal force of driven sprags that slide, μ = 0.9 tan ν_0",
        own=(0.02, "the force continues to oscillate without damping"),
    )  # fmt: skip
    yield identity(FrictionFormulas.N_overruns, symbol="N", by=BY, shares=CLOSURE,
                   name="normal force of the sprags while the race overruns")  # fmt: skip


def _partners() -> Iterator[Check]:
    force: dict[str, Any] = {"symbol": "N_max", "unit": "N", "residual": "LSODA residual",
                             "demand": LSODA}  # fmt: skip
    weak: dict[str, Any] = force | {"formal": 2, "demand_reason": WEAK}
    time: dict[str, Any] = {"symbol": "t", "unit": "ms"}
    yield Partnered(name="largest force after slip at the start with weak springs: Runge-Kutta "
                    "steps and LSODA",
                    fem="N_max", analytic="LSODA N_max", **weak)  # fmt: skip
    yield Partnered(name="largest force after slip at the start with weak springs under 1.6 T: "
                    "Runge-Kutta steps and LSODA",
                    fem="N_max more", analytic="LSODA N_max more", **weak)  # fmt: skip
    yield Ended(name="time at which slip at the start ends: Runge-Kutta steps and LSODA",
                fem="sticks", analytic="LSODA sticks", own_demand=0.02,
                own_reason="slip ends within a band of speeds by Runge-Kutta steps, at an event "
                "by LSODA", **time)  # fmt: skip
    yield Partnered(name="time at which slip begins if μ is sufficient at rest but not at the "
                    "force peak: Runge-Kutta steps and LSODA",
                    fem="slips", analytic="LSODA slips", **time)  # fmt: skip
    yield Partnered(name="largest force if μ is sufficient at rest but not at the force peak: "
                    "Runge-Kutta steps and LSODA",
                    fem="N_max slipped", analytic="LSODA N_max slipped",
                    demand_reason="accepted error of this quantity", **force)  # fmt: skip


def _guard() -> Iterator[Check]:
    yield Agreement(name="N_max by Runge-Kutta steps with automatic speed bands agrees with "
                    f"N_max by LSODA within {GUARDED:.1%}",
                    symbol="N_max", unit="N", pair=by_default, accepted=GUARDED, source=SUBJECT,
                    by=BY)  # fmt: skip
    yield Accepted(name=f"the check of the time step rejects the speed band D_V = {NARROW:g} m/s "
                   "under 1.6 T with weak springs",
                   symbol="D_V", unit="1", margin=refused)  # fmt: skip
    yield Accepted(name="largest force without the check of the time step is ill-conditioned",
                   symbol="N_max", unit="1", margin=unguarded)  # fmt: skip
    yield Deviation(name=f"N_max is correct to {GUARDED:.1%} if the check accepts the time step",
                    symbol="ΔN_max/N_max", unit="1", size=never_wrong, accepted=GUARDED,
                    source=suites("same tolerance as between Runge-Kutta steps and LSODA"),
                    whole="correct force", by=BY)  # fmt: skip
    yield Accepted(name="N_max is wrong if the check rejects the time step", symbol="N_max",
                   unit="1", margin=never_idle)  # fmt: skip
