"""A crowned roller whose axis is tilted: the end that takes more."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import strips
from analytic.contact.best_crown import BestCrown, best_crown
from verify.case import Case, Context, FemResult, Output, Values
from verify.cases import contact_roller_profiles as profiles
from verify.cases import contact_roller_shown as shown
from verify.cases.contact_roller import (
    ASSUMPTIONS,
    BALANCE,
    BEST,
    BEST_ROW,
    COUPLED,
    OUTPUTS,
    READINGS,
    best_top,
    best_values,
    sliced_rows,
    strips_rows,
    warnings,
)
from verify.cases.contact_roller_accepted import ENDS, Accepted, within
from verify.cases.contact_roller_formulas import values
from verify.cases.contact_roller_half_space import pressed, result, stair, too_short
from verify.cases.contact_roller_inputs import CrownedInputs, TiltedInputs
from verify.shown import Curve, Curves, Figure

TILTS = np.linspace(0.0, 2.0, 9)  # over the one given
MOMENT = 0.01  # of the tilting moment


def analytic(q: TiltedInputs) -> Values:
    return values(q) | best_values(q, best(q), q.theta)


def best(q: TiltedInputs) -> BestCrown:
    """The best crown for F, straight or tilted to either side."""
    return best_crown(load=q.F, length=q.L, R=q.R, E_star=q.E_star, tilt=(0.0, q.theta))


def fem(q: TiltedInputs, level: int) -> FemResult:
    found, crown = pressed(q, level), best(q)
    straight = profiles.logarithmic(q, (crown.K_1, crown.K_2, crown.z_m), q.F)
    slope = np.tan(q.theta)
    top, u = best_top(q, level, lambda y: straight(y) - slope * y)
    return result(found, level, stair(found, level) | {"best top": u}, {"best top": top})


CHECKS = (
    *strips_rows(("peak", "approach")),
    *sliced_rows(("peak",)),
    Accepted(name=f"tilting moment, strips within {MOMENT:.0%}", symbol="M", unit="1",
             margin=within("moment", MOMENT, "F l")),
    Accepted(name=f"load within d of the pressed end, strips within {ENDS:.0%}", symbol="F_d",
             unit="1", margin=within("high end", ENDS, "F")),
    BEST_ROW,
    BALANCE,
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    return (shown.profile(q), shown.pressures(context), shown.loads(context), over_tilt(q))


def over_tilt(q: TiltedInputs) -> Figure:
    """Peak over Hertz's of an even load: this crown, and the best for each tilt to either side."""
    y = shown.centres(q, q.n)
    straight = CrownedInputs.gap(q, y)
    angles = TILTS * (q.theta or 5e-4)
    kept, least = [], []
    roller: dict[str, Any] = {"length": q.L, "R": q.R, "E_star": q.E_star, "load": q.F}
    even = np.sqrt(q.F / q.L * q.E_star / (np.pi * q.R))
    for angle in angles:
        kept.append(float(strips.press(straight - angle * y, **roller).peak / even))
        least.append(best_crown(**roller, tilt=(0.0, angle)).peak / even)
    return Curves(
        title="Effect of tilt on the best crown", x_label="θ [°]", y_label="p_max/p_0",
        curves=(
            Curve(name="this crown", x=np.degrees(angles), y=np.array(kept)),
            Curve(name="best crown for ±θ", x=np.degrees(angles), y=np.array(least),
                  style="dashes", colour=2),
        ),
        note=f"p_0: Hertz's pressure of the load spread evenly; ends included, {q.n} strips. A "
        "crown for tilt is deeper than one for a straight roller.",
        y_top=2.2, y_bottom=0.95,
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
    fem=fem,
    levels=(16, 24, 32),
    checks=CHECKS,
    outputs=(
        *OUTPUTS,
        Output(key="strips moment", symbol="M", unit="N m",
               what="tilting moment about mid-length, strips"),
        *BEST,
    ),
    readings=(*READINGS, COUPLED, "θ turns the roller about mid-length and adds −θ y to the gap"),
    assumptions=ASSUMPTIONS,
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=figures,
    pictures=shown.pictures,
    too_large=too_short,
)  # fmt: skip
