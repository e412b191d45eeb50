"""Rows that compare Runge-Kutta steps of an engagement with LSODA, energies and simple models."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.bounds.sprag.engagement import ENERGY, Bounds, Interval
from analytic.sprag.work_balance import stored, undamped
from verify.case import Comparison, Computed, approximation, balance
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.engagement.model import gap, in_slices, parts, wedge
from verify.cases.sprag.engagement.quantities import EngagementFormulas
from verify.cases.sprag.engagement.quantities import EngagementFormulas as Of
from verify.cases.sprag.engagement.reference import ORDER
from verify.core.case import Check, Context
from verify.core.results import Row
from verify.judging.checks import Accepted, Approximation, Fact, Identity
from verify.judging.convergence import fit_order
from verify.judging.tolerance_checks import SUBJECT, Agreement, Deviation, Pair, suites

BY = "Runge-Kutta steps"
CLOSURE = "closure of Eqs. 9 and 10, static normal force"
LSODA, HALVING, CROWN, CENTROID, SLICES = 1e-3, 1e-4, 0.03, 1e-3, 2e-3  # accepted
ROLLED = 1e-4  # relative to the work, with cubics of the deflections
LOADS = 13  # number of loads at which the contacts' pressures are compared
NEAR = 0.5  # tolerance of the order, which is then closest to 4
FITTED = (
    "length, width and wedge angle of the sprags and the stiffness of the support are "
    "identified, not printed"
)
UNEQUAL = "Eqs. 14-16 assume N_e = N_i; statics requires N_e/N_i = cos ω/cos ν"


@dataclass(frozen=True, kw_only=True)
class Partnered(Identity):
    """Row that compares Runge-Kutta steps with LSODA; only the finest level has LSODA results."""

    by: str = BY

    def rows(self, context: Context) -> list[Row]:
        return super().rows(replace(context, analytic=context.fem[-1].values))


@dataclass(frozen=True, kw_only=True)
class AtPeak(Approximation):
    """Row that compares the work on the deflections up to the peak force with the supplied work."""

    def rows(self, context: Context) -> list[Row]:
        N = context.fem[-1].values["N_1 strut"]
        own = {**context.analytic, "stored": stored(wedge(context.inputs), N)}
        return super().rows(replace(context, analytic=own))


def conjugate(context: Context) -> Pair:
    """Pair: work of the torque over work of the normal forces on deflections; expected value 1.

    Both works use the same geometric closure.
    """
    turning = context.inputs.number("by turning")
    return Pair(turning, 1.0, 0.0, f"relative difference of the work {turning - 1:+.1e}")


def bounds(q: EngagementFormulas) -> Bounds:
    """Intervals of the expected errors of the rows."""
    return Bounds(
        unequal=q.number("unequal"), passed_on=q.number("passed on"), inertia=q.number("inertia"),
        left_out=q.number("left out"), turns=bool(q.w_i),
    )  # fmt: skip


def expected(
    q: EngagementFormulas, bound: Callable[[Bounds], Interval | None], source: str
) -> Computed:
    return Computed(lambda: bound(bounds(q)), source)


def along(context: Context) -> tuple[float, float, str]:
    """Largest difference between N(t) by Runge-Kutta steps and by LSODA, divided by N_max.

    The uncertainty and the text of the row are also returned.
    """
    last = context.fem[-1]
    d = last.arrays["LSODA beside"] - last.arrays["LSODA N"]
    worst = float(np.abs(d).max() / last.values["N_max"])
    squares = (np.trapezoid(x**2, last.arrays["LSODA t"]) for x in (d, last.arrays["LSODA N"]))
    mean = float(np.sqrt(np.divide(*squares)))
    return (
        worst,
        0.0,
        f"the largest difference is {worst:.1e} N_max; the relative difference in the L2 norm is "
        f"{mean:.1e}",
    )


def halving(context: Context) -> Pair:
    """Pair: largest force [N] with the given time step, and with half of this time step."""
    whole, half = (r.values["N_max"] for r in context.fem[:2])
    return Pair(whole, half, 0.0, f"N_max changes by {abs(half / whole - 1):.1e}")


def order(context: Context) -> tuple[float, float, str]:
    """Positive margin if the convergence order of N(t) differs from 4 by less than NEAR.

    The cubics of the force table have a discontinuous curvature, which changes the order. The
    uncertainty and the text of the row are also returned.
    """
    fit = fit_order(list(ORDER), context.fem[-1].arrays["order"].tolist())
    return NEAR - abs(fit.order - 4), 2 * fit.u, f"the order is {fit.order:.2f}, in theory 4"


def crowns(context: Context) -> tuple[float, float, str]:
    """Positive margin if the paper's crowns change the largest force by less than CROWN.

    The uncertainty and the text of the row are also returned.
    """
    none, *with_one = context.fem[-1].arrays["crowns"]
    share = np.array(with_one) / none - 1
    words = (
        f"relative to no crown, N_max changes by {share.min():+.1%} to {share.max():+.1%} "
        f"with {len(DESIGNS)} crowns"
    )
    return CROWN - float(np.abs(share).max()), HALVING, words


def centroids(context: Context) -> tuple[float, float, str]:
    """Positive margin if two other positions of the centroid change N_max by less than CENTROID.

    The uncertainty and the text of the row are also returned.
    """
    v = context.fem[-1]
    worst = float(np.abs(v.arrays["centroids"] / v.values["N_max"] - 1).max())
    return CENTROID - worst, 0.0, f"N_max changes by at most {worst:.1e} with two other positions"


def balanced(context: Context) -> Pair:
    """Pair: first peak [N] of the force without damping, by energy and by Runge-Kutta steps.

    Both take the ratio N_e/N_i from statics.
    """
    v, last = context.analytic, context.fem[-1]
    N_max, free = last.arrays["balanced"]
    off, change = free / v["N_undamped"] - 1, N_max / last.values["N_max"] - 1
    words = (
        f"the first peaks differ by {off:+.1e}; N_e/N_i by statics, in place of 1, changes N_max "
        f"by {change:+.1e}"
    )
    return Pair(v["N_undamped"], float(free), 0.0, words)


def sliced(context: Context) -> Pair:
    """Pair: largest force [N] with half of the slices, and with all slices."""
    half, whole = (r.values["N_max sliced"] for r in context.fem[-2:])
    change = abs(whole / half - 1)
    words = f"N_max changes by {change:.1e} from half of the slices to all slices"
    return Pair(half, whole, 0.0, words)


def liu(context: Context) -> tuple[float, float, str]:
    """Relative increase of the largest force if the races are rigid instead of elastic.

    The uncertainty and the text of the row are also returned.
    """
    q, v, w = context.inputs, context.fem[-1].values, wedge(context.inputs)
    now = w.states.yields
    share = float((now.race_i + now.race_e)[-1] / now.H[-1])
    stiff = wedge(q, rigid=True)
    free = float(stiff.force()(undamped(stiff, q.T))) / context.analytic["N_undamped"] - 1
    words = (
        f"rigid races change the largest force by {v['rigid'] - 1:+.1%}, without damping by "
        f"{free:+.1%}; with rigid races, the period of oscillation is shorter, so that damping "
        f"reduces the first peak less; the races account for {share:.0%} of the total deflection"
    )
    return v["rigid"] - 1, LSODA, words


def first(context: Context) -> tuple[float, float, str]:
    """Relative amount by which the highest later peak of the force is below the first peak.

    The uncertainty and the text of the row are also returned.
    """
    v = context.fem[-1].values
    share = v["later peak"] / v["first peak"]
    return 1 - share, LSODA, f"the highest later peak is {share:.3f} times the first peak"


def inner(context: Context) -> tuple[float, float]:
    """Smallest ratio of inner to outer peak pressure over all loads, minus 1; its uncertainty."""
    q, v = context.inputs, context.analytic
    whole, N = parts(q), v["N_max"] * np.linspace(0, 1, LOADS)[1:]
    both = [in_slices(q, gap(q), float(R), N) for R in (whole.R_contact_i, whole.R_contact_e)]
    p_i, p_o = (found.peak_pressure.max(axis=-1) for found in both)
    return float((p_i / p_o).min()) - 1, 1e-6


def rolling(context: Context) -> Pair:
    """Pair: largest force [N] with contacts that always roll, and with contacts that may slip."""
    last = context.fem[-1]
    always = float(last.arrays["rolling"][0])
    off = last.values["N_max"] / always - 1
    words = (
        f"N_max differs by {off:.1e}; contacts slip during {last.values['slides']:.1%} of the time"
    )
    return Pair(always, last.values["N_max"], 0.0, words)


def partnered(name: str, symbol: str, unit: str, key: str, **more: Any) -> Partnered:
    return Partnered(name=f"{name}: Runge-Kutta steps and LSODA", symbol=symbol, unit=unit,
                     fem=key, analytic=f"LSODA {key}", formal=4, residual="LSODA residual",
                     demand=LSODA, demand_reason="accepted error of this quantity",
                     **more)  # fmt: skip


def comparisons(q: EngagementFormulas) -> Iterator[Comparison | Check]:
    """All rows of the case, in the order of the page."""
    yield from _partners()
    yield from _energies(q)
    yield from _models(q)
    yield from _findings()


def _partners() -> Iterator[Check]:
    yield partnered("largest force", "N_max", "N", "N_max", printed=("huang2018:time-step",))
    yield partnered("time of the largest force", "t_max", "ms", "t_max")
    yield partnered("largest force with rigid races (Liu)", "N_max", "N", "N_max rigid")
    yield partnered("largest force under 1.6 T", "N_max", "N", "N_max more",
                    printed=("huang2018:torque-40",))  # fmt: skip
    yield partnered("ratio of the largest forces under 1.6 T and T", "r", "1", "ratio")
    yield Deviation(name=f"N(t): Runge-Kutta steps and LSODA agree within {LSODA:.1%}", symbol="ΔN",
                    unit="1", size=along, accepted=LSODA, source=SUBJECT, whole="N_max",
                    by=BY)  # fmt: skip
    yield Agreement(name=f"N_max changes by less than {HALVING:.2%} with half the time step",
                    symbol="N_max", unit="N", pair=halving, accepted=HALVING, source=SUBJECT,
                    by=f"{BY}, half the time step")  # fmt: skip
    yield Accepted(name=f"convergence order of N(t) over the time step is 4 within {NEAR:g}",
                   symbol="p", unit="1", margin=order,
                   printed=("huang2018:runge-kutta-order",))  # fmt: skip


def _energies(q: EngagementFormulas) -> Iterator[Comparison]:
    cubics: dict[str, Any] = {"of": {"work": q.number("work")}, "bound": ENERGY,
                              "because": "cubic interpolation of the force table"}  # fmt: skip
    yield balance("missing", "balance of energies, including damping and friction", "ΔE", "J",
                  **cubics)  # fmt: skip
    yield balance("missing undamped", "balance of energies without damping", "ΔE", "J", **cubics)
    yield approximation(
        Of.N_undamped, expected=expected(q, Bounds.energy, f"{UNEQUAL}; effect on the work"),
        order=4, by=BY,
        name="first peak of the force without damping, from the work balance of torque and sprags "
        "with rolling contacts",
        shares=CLOSURE,
    )  # fmt: skip
    name = (
        "if N_e/N_i is that of statics, the first peak of the force without damping agrees with "
        f"the work balance within {HALVING:.2%}"
    )
    strut = Agreement(name=name, symbol="N_1", unit="N", pair=balanced, accepted=HALVING,
                      source=suites("same tolerance as for a run with half the time step"),
                      by=BY)  # fmt: skip
    yield Comparison(check=strut, quantity=Of.N_undamped, shares=CLOSURE)
    work = AtPeak(
        name="work up to the first force peak, T θ = n_s ∫(N dH_i + N_e dH_e)", symbol="W_1",
        unit="J", fem="W_1 strut", analytic="stored", formal=2, by=BY,
        interval=lambda *_: bounds(q).radially(),
        demand=1e-3, demand_reason="closures that violate the work balance have far larger errors",
        source="radial motion of the centroid, neglected by Eq. 14; cubic interpolation of the "
        "force table",
    )  # fmt: skip
    yield Comparison(check=work, quantity=Of.W_1, shares=CLOSURE)
    turning = Agreement(
        name=f"work ∫T dθ with rolling contacts and n_s ∫(N dH_i + N_e dH_e) agree within "
        f"{ROLLED:.2%}",
        symbol="W", unit="1", pair=conjugate, accepted=ROLLED,
        source=suites("limit of the error of cubic interpolation between the tabulated states"),
        by="work on the deflections", fem_needed=False,
    )  # fmt: skip
    yield Comparison(check=turning, quantity=Of.W_1, shares=CLOSURE)


def _models(q: EngagementFormulas) -> Iterator[Comparison]:
    more: dict[str, Any] = {"by": BY, "shares": CLOSURE}
    yield approximation(Of.N, expected=expected(q, Bounds.statics, UNEQUAL), order=4,
                        name="normal force at rest, after a slow rise of the torque",
                        **more)  # fmt: skip
    yield approximation(
        Of.f,
        expected=expected(
            q, lambda b: b.either_way(1), f"{UNEQUAL}; effect on the square root of dT/dθ"
        ),
        order=2, name="frequency of small oscillations, √(k/I)", **more,
    )  # fmt: skip
    yield approximation(
        Of.N_max,
        expected=expected(q, Bounds.spring,
                          f"{UNEQUAL}; the model neglects the mass of the sprags"), order=4,
        name="largest force by the model of two races on a spring", **more,
    )  # fmt: skip
    yield approximation(
        Of.ratio, expected=expected(q, Bounds.both, f"{UNEQUAL}; effect on both forces"), order=4,
        name="ratio of the largest forces under 1.6 T and T by the model of two races on a spring",
        **more,
    )  # fmt: skip
    asked = f"{UNEQUAL}; effect on the friction coefficient of either contact"
    yield approximation(
        Of.mu_asked, "asked", expected=expected(q, lambda b: b.either_way(2), asked), order=4,
        name="friction coefficient required for rolling, tan ν", symbol="μ", **more,
    )  # fmt: skip


def _findings() -> Iterator[Check]:
    force: dict[str, Any] = {"symbol": "N_max", "unit": "1", "fitted": FITTED}
    yield Agreement(name=f"N_max changes by less than {LSODA:.1%} if the contacts always roll "
                    "(Xu, Liu)",
                    symbol="N_max", unit="N", pair=rolling, accepted=LSODA,
                    source=suites("same tolerance as between Runge-Kutta steps and LSODA"),
                    by=f"{BY}, contacts may slip")  # fmt: skip
    yield Accepted(name="rigid races (Liu) increase the largest force", margin=liu, **force)
    yield Accepted(name="the first peak of the force is the largest", symbol="N_2/N_1", unit="1",
                   margin=first, fitted=FITTED)  # fmt: skip
    yield Fact(name="pressure at the inner contact exceeds that at the outer, at any force",
               symbol="p_i/p_o", unit="1", margin=inner, fem_needed=False)  # fmt: skip
    yield Accepted(name=f"crowns change N_max by {CROWN:.0%} at most", margin=crowns, **force)
    yield Agreement(name=f"N_max changes by less than {SLICES:.1%} with half the number of slices",
                    symbol="N_max", unit="N", pair=sliced, accepted=SLICES,
                    source=suites("one fifth of the required sensitivity (1 %)"),
                    by="all slices")  # fmt: skip
    yield Accepted(name="position of the centroid of the sprags changes N_max by "
                   f"{CENTROID:.1%} at most",
                   margin=centroids, **force)  # fmt: skip
