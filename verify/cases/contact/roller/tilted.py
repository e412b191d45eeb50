"""A crowned roller whose axis is tilted: the end that takes more."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact import strips
from analytic.contact.best_crown import BestCrown
from verify.cases.contact.roller import figures as roller_figures
from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.accepted import ENDS
from verify.cases.contact.roller.agreed import within
from verify.cases.contact.roller.case import (
    ASSUMPTIONS,
    BALANCE,
    BEST,
    BEST_ROW,
    COUPLED,
    END_PRESSURE,
    LEVELS,
    OUTPUTS,
    READINGS,
    best_top,
    best_values,
    evenly,
    sliced_rows,
    strips_rows,
    warnings,
)
from verify.cases.contact.roller.formulas import values
from verify.cases.contact.roller.half_space import pressed, result, stair, too_short
from verify.cases.contact.roller.inputs import CrownedInputs, TiltedInputs
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Array, Curve, Curves, Figure
from verify.core.references import BY_HALF_SPACE
from verify.judging.tolerance_checks import suites

TILTS = np.linspace(0.0, 2.0, 33)  # over the one given
BEST_TILTS = np.linspace(0.0, 2.0, 5)
LEAN = 5e-4  # rad, where none is given
MOMENT = 0.01  # of the tilting moment


def analytic(q: TiltedInputs) -> Values:
    return values(q) | best_values(q, best(q), q.theta)


def best(q: TiltedInputs, tilt: float | None = None) -> BestCrown:
    """The best crown for F, straight or tilted to either side."""
    from analytic.contact.best_crown import best_crown  # of both sides: what they press

    tilts = (0.0, q.theta if tilt is None else tilt)
    return best_crown(load=q.F, length=q.L, R=q.R, E_star=q.E_star, tilt=tilts)


def fem(q: TiltedInputs, level: int) -> FemResult:
    found, crown = pressed(q, level), best(q)
    straight = profiles.logarithmic(q, (crown.K_1, crown.K_2, crown.z_m), q.F)
    slope = np.tan(q.theta)
    top, u = best_top(q, level, lambda y: straight(y) - slope * y)
    arrays = {"best over tilt": best_over_tilt(q)} if level == LEVELS[-1] else {}
    u_it = stair(found, level) | {"best top": u}
    return result(found, level, u_it, {"best top": top}, arrays)


CHECKS = (
    *strips_rows(("peak", "approach")),
    *sliced_rows(("peak",)),
    within(f"tilting moment, strips within {MOMENT:.0%}", "M", "N m", "moment", MOMENT, "F l",
           suites("as far off as rows may be")),
    within(f"load within d of the pressed end, strips within {ENDS:.0%}", "F_d", "N", "high end",
           ENDS, "F", suites("as much as the subject accepts without a tilt")),
    END_PRESSURE,
    BEST_ROW,
    BALANCE,
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    return (
        roller_figures.profile(q),
        roller_figures.pressures(context),
        roller_figures.loads(context),
        over_tilt(context),
    )


def best_over_tilt(q: TiltedInputs) -> Array:
    """Peak of the best crown for each tilt over Hertz's pressure of an even load."""
    angles = BEST_TILTS * (q.theta or LEAN)
    return np.array([best(q, a).peak / evenly(q) for a in angles])


def over_tilt(context: Context) -> Figure:
    """Peak over Hertz's of an even load: this crown, and the best for each tilt to either side."""
    q = context.inputs
    y = roller_figures.centres(q, q.n)
    straight, angles = CrownedInputs.gap(q, y), TILTS * (q.theta or LEAN)
    roller: dict[str, Any] = {"length": q.L, "R": q.R, "E_star": q.E_star, "load": q.F}
    curves = roller_figures.over(
        [strips.press(straight - a * y, **roller) for a in angles], np.degrees(angles),
        [evenly(q)] * len(angles),
    )  # fmt: skip
    least = context.fem[-1].arrays.get("best over tilt") if context.fem else None
    if least is not None:
        at = np.degrees(BEST_TILTS * (q.theta or LEAN))
        curves.append(Curve(name="best crown for ±θ", x=at, y=least, style="dashes", colour=2))
    return Curves(
        title="Largest pressure over the tilt", x_label="θ [°]", y_label="p_max/p_0",
        curves=tuple(curves), y_top=2.2, y_bottom=0.95,
        note=f"p_0: Hertz's pressure of the load spread evenly; ends included, {q.n} strips. A "
        "crown for tilt is deeper than one for a straight roller.",
    )  # fmt: skip


TILTED = Case(
    id="contact-roller-tilted",
    title="Tilted crowned roller on a race",
    paper="huang2018",
    place="Eqs. 1-5, with the roller's axis tilted",
    lead="Races deflect and sprags lean: the same roller with its axis out of parallel. Strips "
    "and slices are told the gap that the tilt leaves and must find the end that takes more.",
    inputs=TiltedInputs,
    analytic=analytic,
    method=BY_HALF_SPACE, reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("theta=0.01deg,0.03deg,0.06deg",), star=True),
    ),
    checks=CHECKS,
    outputs=(
        *OUTPUTS,
        Output(key="strips moment", symbol="M", unit="N m",
               what="tilting moment about mid-length, strips"),
        *(replace(out, what=out.what.replace("for F", "for F at 0 and ±θ")) for out in BEST),
    ),
    readings=(*READINGS, COUPLED, "θ turns the roller about mid-length and adds −θ y to the gap"),
    assumptions=ASSUMPTIONS,
    warnings=warnings,
    equations=roller_figures.equations,
    sketch=roller_figures.sketch,
    figures=figures,
    pictures=roller_figures.pictures,
    too_large=too_short,
)  # fmt: skip
