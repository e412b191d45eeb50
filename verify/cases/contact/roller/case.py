"""A crowned roller on its race: strips and slices beside the half-space."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import strips
from analytic.contact.best_crown import BestCrown
from analytic.contact.crown import logarithmic
from verify.cases.contact.line.checks import about
from verify.cases.contact.roller import figures as shown
from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.accepted import (
    ENDS,
    SHARE,
    Estimated,
    elsewhere,
    ends,
    nearer,
    within,
)
from verify.cases.contact.roller.formulas import interval, strip_values, values
from verify.cases.contact.roller.half_space import pressed, result, stair, too_short
from verify.cases.contact.roller.inputs import CrownedInputs, RollerInputs
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Array, Curve, Curves, Figure
from verify.core.references import Method
from verify.judging.checks import Accepted, Approximation, Exact

HALF_SPACE = "half-space"
ACCEPTED = "acceptance figure of the finite line contact"
ESTIMATE = (
    "derived: from half to twice of what strips neglect, and what is left of their number, of "
    "first order, 1e-4 at least (own numbers: 1e-3)"
)
PALMGREN = "Palmgren's fit is of measured approaches: no interval is known beforehand"
SHARPEST = {"peak": 3e-3, "mid": 3e-3, "approach": 3e-3}
LEVELS = (16, 24, 32)
SLICED = 0.02  # acceptance of the slicing technique's pressures
SETTLED = 5e-3  # twice the strips may change pressures without a word
PLANE_NU = 0.3  # of the disc, of which E/(1 − ν²) alone counts
BEST_AT = np.geomspace(0.2, 2.5, 6)  # loads over F
FINE_AT = np.geomspace(0.2, 2.5, 40)


def analytic(q: CrownedInputs) -> Values:
    return values(q) | best_values(q, best(q))


def best(q: CrownedInputs, load: float = 1.0) -> BestCrown:
    """The best crown for a load [of F]."""
    from analytic.contact.best_crown import best_crown  # of both sides: what they press

    return best_crown(load=load * q.F, length=q.L, R=q.R, E_star=q.E_star)


def best_values(q: CrownedInputs, best: BestCrown, tilt: float = 0.0) -> dict[str, float]:
    """The best crown and its strips, by the name "best"."""

    def gap(y: Array) -> Array:
        made = {"load": q.F, "length": q.L, "E_star": q.E_star}
        return logarithmic(y, K_1=best.K_1, K_2=best.K_2, z_m=best.z_m, **made) - tilt * y

    parameters = {"best K_1": best.K_1, "best K_2": best.K_2, "best z_m": best.z_m}
    return strip_values(q, "best", gap) | parameters | {"best free": float(best.free)}


def fem(q: CrownedInputs, level: int) -> FemResult:
    found = pressed(q, level)
    top, u = best_top(q, level, profiles.logarithmic(q, best_design(q), q.F))
    more = plane_at_middle(q, level) | {"best top": top}
    arrays = {"best over load": best_over_load(q)} if level == LEVELS[-1] else {}
    return result(found, level, stair(found, level) | {"best top": u}, more, arrays)


def best_top(q: CrownedInputs, level: int, gap: profiles.Gap) -> tuple[float, float]:
    """Largest pressure of the best crown, ends included, and what other grids make of it."""
    found = pressed(q, level, crown=gap)
    return found.values["top"], stair(found, level, crown=gap)["top"]


def best_design(q: CrownedInputs) -> tuple[float, float, float]:
    """K_1, K_2, z_m of the best crown for F."""
    found = best(q)
    return found.K_1, found.K_2, found.z_m


def plane_at_middle(q: CrownedInputs, level: int) -> dict[str, float]:
    """A disc of the relative radius on a rigid flat, plane strain, under the strips' load there."""
    from analytic.contact.crown import slice_centres
    from analytic.contact.strips import press
    from verify.cases.contact.line.bodies import disc_fem
    from verify.cases.contact.line.inputs import FlatInputs

    gap = q.gap(slice_centres(length=q.L, slices=q.n))
    solved = press(gap, length=q.L, R=q.R, E_star=q.E_star, load=q.F)
    P = float(solved.mid**2 * np.pi * q.R / q.E_star)
    disc = FlatInputs(R=q.R, E=q.E_star * (1 - PLANE_NU**2), nu=PLANE_NU, F=P * q.L, L=q.L)
    found = disc_fem(disc, P, disc.guess, level // 4)
    return {"plane p0": found.peak, "plane b": found.half_width}


def plane_interval(coefficient: float) -> Any:
    """What Hertz neglects of a disc, (a/R)²; the next term, (a/R)⁴, counts once."""

    def found(q: RollerInputs, v: Values) -> tuple[float, float] | None:
        e = v["strips b mid"] / q.R
        return about(coefficient * e**2, e**4)

    return found


def accepted(q: RollerInputs, _: Values) -> tuple[float, float] | None:
    """Interval of the slices' pressures for the paper's roller; none is known for others."""
    return None if q.own else (-SLICED, SLICED)


def strips_rows(keys: Sequence[str]) -> tuple[Estimated, ...]:
    """Strips beside the half-space, as sharp as the acceptance figures."""
    return tuple(
        Estimated(
            name=f"{NAMES[key][0]}, strips", symbol=NAMES[key][1], unit=NAMES[key][2], fem=key,
            analytic=f"strips {key}", formal=1, by=HALF_SPACE, interval=interval(key),
            source=ESTIMATE, demand=SHARPEST[key], demand_reason=ACCEPTED,
        )
        for key in keys
    )  # fmt: skip


def sliced_rows(keys: Sequence[str]) -> tuple[Estimated | Accepted, ...]:
    """Slices beside the half-space and beside uncoupled slices; their approach is shown."""
    return (
        *(
            Estimated(
                name=f"{NAMES[key][0]}, {words}", symbol=NAMES[key][1], unit=NAMES[key][2],
                fem=key, analytic=f"{name} {key}", formal=1, by=HALF_SPACE,
                interval=accepted if judged else None, source=ACCEPTED if judged else PALMGREN,
                demand=2 * SLICED, demand_reason="as wide as the acceptance figure is both ways",
            )
            for name, words in (("slices", "slices"), ("lamina", "uncoupled slices"))
            for key in keys
            for judged in (name == "slices" and key != "approach",)
        ),
        Accepted(name=f"load that slices put elsewhere than the half-space, below {SHARE:.0%}",
                 symbol="ΔF/F", unit="1", margin=elsewhere("slices")),
        Accepted(name="slices put less load elsewhere than uncoupled slices", symbol="ΔF/F",
                 unit="1", margin=nearer),
    )  # fmt: skip


NAMES = {
    "peak": ("largest pressure beyond d of the ends", "p_max", "MPa"),
    "mid": ("pressure at mid-length", "p", "MPa"),
    "approach": ("approach", "δ", "µm"),
}
BALANCE = Exact(
    name="balance of forces, half-space", symbol="ΣF", unit="N", fem="balance", scale="F",
    bound=1e-10, bound_reason="the load is held by every iteration",
)  # fmt: skip

END_PRESSURE = Accepted(
    name=f"pressure of the mean load within d, strips within {ENDS / 2:.0%}", symbol="p_d",
    unit="1", margin=within("end pressure", ENDS / 2, "Hertz p0"),
)  # fmt: skip
END_ROWS = (
    Accepted(name=f"load within d of the ends, strips within {ENDS:.0%}", symbol="F_d", unit="1",
             margin=ends),
    END_PRESSURE,
)  # fmt: skip
BEST_ROW = Estimated(
    name="largest pressure of the best crown, ends included, strips", symbol="p_max", unit="MPa",
    fem="best top", analytic="best top", formal=1, by=HALF_SPACE, interval=interval("top", "best"),
    source=ESTIMATE, demand=1e-2,
)  # fmt: skip

CHECKS = (
    *strips_rows(("peak", "mid", "approach")),
    *sliced_rows(("peak", "mid", "approach")),
    *END_ROWS,
    Approximation(name="pressure at mid-length, plane finite elements under the strips' load",
                  symbol="p", unit="MPa", fem="plane p0", analytic="strips mid", formal=2,
                  interval=plane_interval(-3 / 16),
                  source="derived series of the disc; its next term counts once, 3e-4 at least",
                  demand=5e-3, demand_reason=ACCEPTED),
    Approximation(name="half-width at mid-length, plane finite elements under the strips' load",
                  symbol="b", unit="µm", fem="plane b", analytic="strips b mid", formal=2,
                  interval=plane_interval(1 / 4),
                  source="derived series of the disc; its next term counts once, 3e-4 at least",
                  demand=5e-3, demand_reason=ACCEPTED),
    BEST_ROW,
    BALANCE,
)  # fmt: skip

OUTPUTS = (
    Output(key="R", symbol="R", unit="mm", what="relative radius", judged=False),
    Output(key="E*", symbol="E*", unit="GPa", what="contact modulus", judged=False),
    Output(key="strips peak", symbol="p_max", unit="MPa",
           what="largest pressure beyond d of the ends, strips"),
    Output(key="strips mid", symbol="p", unit="MPa", what="pressure at mid-length, strips"),
    Output(key="strips end pressure", symbol="p_d", unit="MPa",
           what="Hertz's pressure of the mean line load within d of the more loaded end, strips"),
    Output(key="share of the ends", symbol="F_d/F", unit="1",
           what="share of the load within d of both ends, strips"),
    Output(key="strips largest", symbol="p_n", unit="MPa",
           what="largest pressure of n strips, ends included: it grows with n if they carry",
           judged=False),
    Output(key="strips approach", symbol="δ", unit="µm", what="approach, strips"),
    Output(key="strips contact", symbol="l_c", unit="mm", what="length in contact, strips",
           judged=False),
    Output(key="slices peak", symbol="p_max", unit="MPa",
           what="largest pressure beyond d of the ends, slices"),
    Output(key="lamina peak", symbol="p_max", unit="MPa",
           what="largest pressure beyond d of the ends, uncoupled slices"),
    Output(key="Hertz p0", symbol="p_0", unit="MPa",
           what="Hertz's pressure of a load spread evenly", judged=False),
)  # fmt: skip
BEST = (
    Output(key="best K_1", symbol="K_1*", unit="1", judged=False,
           what="best crown for F whose ends carry nothing, Q = F; a flat optimum"),
    Output(key="best K_2", symbol="K_2*", unit="1", what="its crowned part", judged=False),
    Output(key="best z_m", symbol="z_m*", unit="mm", what="its drop at the ends", judged=False),
    Output(key="best top", symbol="p_max", unit="MPa",
           what="its largest pressure, ends included, strips"),
)  # fmt: skip
READINGS = (
    "E' of Eq. 1 is E/(1 − ν²) for steel on steel: 2 E*",
    "y counts from mid-length, and the crown is the same at both ends",
    "s of Eq. 5 is Palmgren's constant to the power 1/0.9, for the whole length",
)
COUPLED = "the weights w of Eq. 3 are a half-space's on Hertz's width: slices deflect each other"
ASSUMPTIONS = (
    "length and loads are not printed: 9 mm and the static load at 25 N m for a wedge angle of "
    "3.15° are identified (CALIBRATED); models are compared on them, and the paper is not judged",
    "no friction, small strain; both bodies half-spaces of E*, which go on beyond the ends",
    "the largest pressure is that farther than d from the ends: a loaded end has no highest "
    "pressure in a half-space",
    "the half-space is refined like a mesh, in cells across and along the roller; what its "
    "neighbouring grids differ by counts as iteration",
    "weights w as Love has them for an even pressure on Hertz's width of the mean load, and the "
    "exponent 10/9 of Palmgren's law: other kernels of that width, or an exponent of 1 through the "
    "same approach, change pressures by less than these rows can tell",
)


def warnings(q: RollerInputs, v: Values) -> Sequence[str]:
    """What an engineer should know before trusting these pressures."""
    found = []
    loaded = v["strips loaded ends"] > 0
    largest, inner = v["strips largest"], v["strips peak"]
    if loaded and largest > 1.005 * inner:
        found.append(
            f"an end carries load: its pressure ({largest / 1e6:.4g} MPa with {q.n} strips) grows "
            "with every refinement, and yields in truth; judge by p_d and the share of the ends; a "
            "free end face takes about a quarter off it (contact-roller-end)"
        )
    if v["strips contact"] < 0.98 * q.L * (1 - 1 / q.n):
        found.append(
            f"only {v['strips contact'] * 1e3:.4g} mm of l = {q.L * 1e3:.4g} mm are in contact"
        )
    change = max((abs(v[f"strips twice {key}"] / p - 1) for key in ("peak", "mid")
                 if (p := v[f"strips {key}"]) > 0), default=0.0)  # fmt: skip
    if change > SETTLED and q.n < 401 and not loaded:  # under loaded ends more are no better
        found.append(
            f"{q.n} strips are few: with twice as many the pressure changes by {change:.1%}"
        )
    if v.get("best free", 1.0) < 1:
        found.append(
            "no crown keeps both ends free of load: the best one told is whose ends carry least"
        )
    if max(largest, inner) > 4e9:
        found.append(
            f"{max(largest, inner) / 1e6:.4g} MPa is beyond 4000 MPa, the static rating of "
            "hardened rollers (ISO 76): expect lasting dents"
        )
    if v["Hertz b"] > 0.05 * q.R_1:
        found.append(
            f"b = {v['Hertz b'] * 1e3:.4g} mm is {v['Hertz b'] / q.R_1:.1%} of the roller's "
            f"radius of {q.R_1 * 1e3:.4g} mm: a half-space it hardly is"
        )
    if min(q.E_1, q.E_2) < 180e9 or max(q.E_1, q.E_2) > 230e9:
        found.append(
            "Palmgren's law behind the slices is of steel on steel, which these bodies are not: "
            "take the strips"
        )
    return found


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    return (shown.profile(q), shown.pressures(context), shown.loads(context), over_load(context))


def evenly(q: RollerInputs | CrownedInputs, share: float = 1.0) -> float:
    """Hertz's pressure [Pa] of a share of F spread evenly."""
    return float(np.sqrt(share * q.F / q.L * q.E_star / (np.pi * q.R)))


def best_over_load(q: CrownedInputs) -> Array:
    """Peak of the best crown at each load over Hertz's pressure of it."""
    return np.array([best(q, k).peak / evenly(q, k) for k in BEST_AT])


def over_load(context: Context) -> Figure:
    """Peak over Hertz's pressure of an even load: this crown, and the best at each load."""
    q = context.inputs
    y = shown.centres(q, q.n)
    curves = shown.over(
        [strips.press(q.gap(y), load=k * q.F, length=q.L, R=q.R, E_star=q.E_star) for k in FINE_AT],
        FINE_AT, [evenly(q, k) for k in FINE_AT],
    )  # fmt: skip
    best = context.fem[-1].arrays.get("best over load") if context.fem else None
    if best is not None:
        curves.append(Curve(name="best crown for each load", x=BEST_AT, y=best, style="dashes",
                            colour=2))  # fmt: skip
    return Curves(
        title="Largest pressure over the load", x_label="load/F", y_label="p_max/p_0",
        curves=tuple(curves), y_top=1.6, y_bottom=0.95,
        note=f"p_0: Hertz's pressure of the load spread evenly; ends included, {q.n} strips. The "
        "best crown of a load just spares the ends under it. Dots: this crown's ends carry, and "
        "the pressure there has no limit.",
    )  # fmt: skip


ROLLER = Case(
    id="contact-roller",
    title="Crowned roller on a race",
    paper="huang2018",
    place="Eqs. 1-5",
    lead="The sprag's nose as a roller of finite length with the paper's crown for 25 N m. Strips "
    "with Hertz's ellipse across and the slicing technique of the paper are judged by boundary "
    "elements on a half-space, and their middle by plane finite elements. What strips neglect is "
    "derived, and the half-space must agree.",
    inputs=CrownedInputs,
    analytic=analytic,
    method=Method("half-space; finite elements at mid-length", "half-space"),
    reference=fem,
    levels=LEVELS,
    scans=(Scan(vary=("F=1500N,3407N,6000N", "L=6mm,9mm"), star=True),),
    checks=CHECKS,
    outputs=(*OUTPUTS, *BEST),
    readings=READINGS,
    assumptions=(
        *ASSUMPTIONS,
        "plane finite elements: a disc of the relative radius on a rigid flat, with the line load "
        "that strips have at mid-length",
    ),
    warnings=warnings,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=figures,
    pictures=shown.pictures,
    too_large=too_short,
)
