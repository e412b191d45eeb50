"""A roller without crown: what converges, and the peak at its ends that does not."""

from collections.abc import Sequence

import numpy as np

from analytic.contact import strips
from verify.cases.contact.roller import figures as roller_figures
from verify.cases.contact.roller.agreed import within
from verify.cases.contact.roller.case import (
    ASSUMPTIONS,
    BALANCE,
    COUPLED,
    END_ROWS,
    NAMES,
    OUTPUTS,
    sliced_rows,
    warnings,
)
from verify.cases.contact.roller.formulas import values
from verify.cases.contact.roller.half_space import pressed, result, too_short
from verify.cases.contact.roller.inputs import RollerInputs
from verify.core.case import Case, Context, FemResult, Scan, Values
from verify.core.figures import Curve, Curves, Figure, Refinement
from verify.core.references import BY_HALF_SPACE
from verify.judging.checks import Order

SLOPE = 0.5  # of 1/peak over the cell: pressure grows as 1/sqrt(distance) towards the end
ALONG = 128  # cells along the roller, a level: no more than b/12 long
COUNTS = (41, 57, 81, 115, 161, 229, 321)
FLAT = 5e-3  # acceptance of pressures and approach without a crown


def analytic(q: RollerInputs) -> Values:
    return values(q)


def fem(q: RollerInputs, level: int) -> FemResult:
    return result(pressed(q, level, along=ALONG * level), level, {})


def inverse_peaks(context: Context) -> tuple[list[float], list[float]]:
    """Cell sizes and mean line load over the largest pressure, which tends to nothing."""
    h, peaks = context.series("largest")
    return h, [context.analytic["Hertz p0"] / p for p in peaks]


CHECKS = (
    *(
        within(f"{NAMES[key][0]}, strips as wide as the contact within {FLAT:.1%}",
               *NAMES[key][1:], key, FLAT, scale)
        for key, scale in (("mid", "Hertz p0"), ("approach", "Palmgren"))
    ),
    *END_ROWS,
    Order(name="slope of 1/peak over the cell: the end's pressure has no limit", symbol="p",
          unit="1", errors=inverse_peaks, order=SLOPE),
    *sliced_rows(("mid",)),
    BALANCE,
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    found = [roller_figures.pressures(context), roller_figures.loads(context), over_strips(context)]
    if context.converging:
        found.append(peaks(context))
    return found


def peaks(context: Context) -> Figure:
    """Largest pressure over the cell, log-log: a line that goes on."""
    q, p_0 = context.inputs, context.analytic["Hertz p0"]
    cells = np.array([len(r.arrays["y"]) for r in context.fem]) * context.analytic["Hertz b"] / q.L
    cells = np.round(cells, 1)
    values_ = {key: np.array(context.series(key)[1]) / p_0 for key in ("largest", "mid")}
    return Refinement(
        title="The peak at the end never stops growing", x_label="cells on Hertz's half-width",
        y_label="p/p_0", cells=cells,
        errors=(("peak", values_["largest"]),), order=-0.5,
        note="Dots: largest pressure of a cell over Hertz's pressure of an even load; line: slope "
        "1/2. At mid-length p/p_0 stays at "
        f"{values_['mid'][-1]:.4f}.",
    )  # fmt: skip


def over_strips(context: Context) -> Figure:
    """Strips narrower than the contact is wide make too much of a loaded end."""
    q = context.inputs
    found = []
    for n in COUNTS:
        gap = q.gap(roller_figures.centres(q, n))
        solved = strips.press(gap, length=q.L, R=q.R, E_star=q.E_star, load=q.F)
        share = np.clip(q.d * n / q.L - np.arange(n), 0.0, 1.0)
        found.append(2 * float(share @ solved.q) * q.L / n / q.F)
    curves = [Curve(name="strips", x=np.array(COUNTS, float), y=np.array(found))]
    if context.fem:
        share_ = context.series("ends")[1][-1] / q.F
        curves.append(
            Curve(name="half-space", x=np.array([COUNTS[0], COUNTS[-1]], float),
                  y=np.array([share_, share_]), style="dashes", colour=4)
        )  # fmt: skip
    return Curves(
        title="Share of the ends over the number of strips", x_label="n", y_label="F_d/F",
        curves=tuple(curves), y_bottom=0.9 * min(found),
        note="Strips narrower than the contact is wide no longer settle where an end carries: "
        f"take about l/b = {q.L / q.b:.0f} of them.",
    )  # fmt: skip


UNCROWNED = Case(
    id="contact-roller-flat",
    title="Roller without crown on a race",
    paper="huang2018",
    place="Eqs. 2-5, without profile modification",
    lead="A cylinder that simply ends. In a half-space the pressure at its ends is infinite, so no "
    "peak that a model prints for it means anything without its number of slices; what converges "
    "is judged, and the slope with which the peak grows.",
    inputs=RollerInputs,
    analytic=analytic,
    method=BY_HALF_SPACE,
    reference=fem,
    levels=(8, 11, 16, 22, 32),
    scans=(Scan(vary=("F=1000N,3407N,10000N", "L=4mm,9mm,18mm", "R_1=2mm,4.02mm,8mm"), star=True),),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(COUPLED,),
    assumptions=ASSUMPTIONS,
    warnings=warnings,
    equations=roller_figures.equations,
    sketch=roller_figures.sketch,
    figures=figures,
    pictures=roller_figures.pictures,
    too_large=too_short,
)
