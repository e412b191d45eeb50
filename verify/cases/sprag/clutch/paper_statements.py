"""Statements of the paper on its clutch and its engagements, against computed values."""

import math
from itertools import pairwise
from typing import Any

import numpy as np

from analytic.sprag.work_balance import at_rest as static_turn
from verify.cases.sprag.clutch.paper_fem import PRINTED
from verify.cases.sprag.engagement.model import wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.statements import FITTED, Beside, Noted, OfPaper, measured
from verify.core.case import Check, Context
from verify.judging.published_checks import Adopted
from verify.judging.tolerance_checks import Agreement, Pair, suites

RESTS = 1e-3  # relative to the force; N_e = N_i has half of this effect
ROUNDED = {"m_g": 0.05e-3, "I_g": 0.005e-8}  # kg, kg m²: half of the last digit in Table 1
ON_FIT: dict[str, Any] = {"bound": 0.02, "fitted": FITTED}  # for rows of fitted values


def rectangle(q: EngagementInputs) -> tuple[float, float]:
    """Width and length [m] of a rectangular sprag that has the given mass and inertia."""
    h = q.R_e - q.R_i
    w = math.sqrt(12 * q.I_g / q.m_g - h**2)
    return w, q.m_g / (q.density * h * w)


def length(context: Context) -> tuple[float, float, str]:
    """Relative distance of l from the nearer bound of the length of a rectangular sprag.

    The bounds follow from the rounding of the printed m_g and I_g. The uncertainty and the text of
    the row are also returned.
    """
    q = context.inputs
    w, l = rectangle(q)  # noqa: E741
    (_, low), (_, high) = corners(q)
    mass = q.m_g / (q.density * (q.R_e - q.R_i) * q.b)
    words = (
        f"a rectangular sprag with m_g and I_g has the width {w * 1e3:.3g} mm and the length "
        f"{l * 1e3:.4g} mm; their rounding permits lengths from {low * 1e3:.1f} to "
        f"{high * 1e3:.1f} mm (largest relative deviation {max(high - l, l - low) / l:.2f}); with "
        f"the width b = {q.b * 1e3:g} mm, m_g alone gives the length {mass * 1e3:.2g} mm"
    )
    return min(q.l - low, high - q.l) / q.l, 0.0, words


def corners(q: EngagementInputs) -> tuple[tuple[float, float], tuple[float, float]]:
    """(Width, length) [m] of the shortest and longest rectangle within the rounding of m_g, I_g."""
    found = [
        rectangle(q.model_copy(update={"m_g": q.m_g + a * ROUNDED["m_g"],
                                       "I_g": q.I_g + b * ROUNDED["I_g"]}))
        for a in (-1, 1) for b in (-1, 1)
    ]  # fmt: skip
    in_length = sorted(found, key=lambda one: one[1])
    return in_length[0], in_length[-1]


def width(context: Context) -> tuple[float, float, str]:
    """Positive margin if N_max changes by less than 0.5 % with b set to the width of `rectangle`.

    The uncertainty and the text of the row are also returned.
    """
    narrow = float(measured(context)["narrow"][0])
    change = narrow / float(measured(context)["N_max"][0]) - 1
    w, _ = rectangle(context.inputs)
    (high, _), (low, _) = corners(context.inputs)
    words = (
        f"a rectangular sprag with m_g and I_g has the width {w * 1e3:.3g} mm; their rounding "
        f"permits {low * 1e3:.1f} to {high * 1e3:.1f} mm; with this width as b, N_max changes by "
        f"{change:+.2%}"
    )
    return 0.005 - abs(change), 0.0, words


def preload(context: Context) -> tuple[float, float, str]:
    """Amount by which the ratio of spring force to static force is below 0.01.

    The uncertainty and the text of the row are also returned.
    """
    share = context.analytic["N_0"] / context.analytic["N"]
    return 0.01 - share, 0.0, f"the normal force by the springs alone is {share:.2%} of N"


def at_rest(context: Context) -> Pair:
    """Pair of forces [N] with springs: static, and at the end of a strongly damped engagement."""
    found, N = measured(context), context.analytic["N"]
    clutch, damped = wedge(context.inputs), float(found["damped"][0])
    sprung = float(clutch.force()(static_turn(clutch, context.inputs.T)))
    words = (
        f"the final force is {damped:.1f} N; it differs by {damped / sprung - 1:+.3%} from the "
        f"static force {sprung:.1f} N, because the equations of motion assume N_e = N_i; the "
        f"springs change the static force by {sprung / N - 1:+.2%} of {N:.1f} N"
    )
    return Pair(sprung, damped, 0.0, words)


def first_is_largest(context: Context) -> tuple[float, float, str]:
    """Relative amount by which the second peak of the force is below the first peak.

    The uncertainty and the text of the row are also returned.
    """
    found = measured(context)
    share = found["second peak"] / found["first peak"]
    words = (
        f"the ratio of the second to the first peak is {share[0]:.3f} at 25 N m and "
        f"{share[1]:.3f} at 40 N m"
    )
    return float(1 - share.max()), 1e-3, words


def deeper_is_lower(context: Context) -> tuple[float, float, str]:
    """Relative reduction of p_max from K_1 = 1 to K_1 = 3 (Fig. 13).

    The uncertainty and the text of the row are also returned.
    """
    shallow, deep = measured(context)["Fig. 13"] / 1e6
    return (
        float(1 - deep / shallow),
        1e-3,
        f"p_max is {shallow:.0f} MPa with K_1 = 1 and {deep:.0f} MPa with K_1 = 3",
    )


def ends_carry(context: Context) -> tuple[float, float, str]:
    """Relative amount by which the end pressure exceeds the pressure at mid-length.

    Both are pressures at the peak, without a crown. The uncertainty and the text of the row are
    also returned.
    """
    end, middle = measured(context)["flat, ends"] / 1e6
    return (
        float(end / middle - 1),
        1e-3,
        f"the pressure is {end:.0f} MPa at the ends and {middle:.0f} MPa at mid-length",
    )


def grows(context: Context) -> tuple[float, float, str]:
    """Positive margin if each doubling of the slices raises p_max by more than the previous one.

    p_max is the largest pressure without a crown. The uncertainty and the text of the row are also
    returned.
    """
    found = measured(context)
    n, p = found["flat, counts"], found["flat, peaks"]
    rise = [float(np.interp(2 * k, n, p) / np.interp(k, n, p) - 1) for k in (11, 20.5, 40.5, 80.5)]
    slope = math.log(p[-1] / p[-2]) / math.log(n[-1] / n[-2])
    words = (
        f"the peak pressure is {p[0] / 1e6:.0f} MPa with {n[0]:.0f} slices and "
        f"{p[-1] / 1e6:.0f} MPa with {n[-1]:.0f} slices; between the two largest numbers of "
        f"slices, it is proportional to the number of slices to the power {slope:.2f}"
    )
    return min(b - a for a, b in pairwise(rise)), 0.0, words


def ratios(context: Context) -> tuple[float, float, str]:
    """Distance of a computed ratio of forces from the nearer of two required ratios.

    It is the ratio of the force at 40 N m to that at 25 N m. The printed pressures without and with
    the optimal crown require two ratios; the result is positive between them. The uncertainty and
    the text of the row are also returned.
    """
    found = measured(context)
    computed = float(found["N_max"][1] / found["N_max"][0])
    flat, best = ((PRINTED[40.0][k] / PRINTED[25.0][k]) ** 2 for k in (0, 1))
    words = (
        f"the force at 40 N m divided by the force at 25 N m must be {flat:.2f} according to the "
        f"pressures printed without a crown and {best:.2f} according to those printed with the "
        f"optimal crowns; the computed ratio is {computed:.3f}"
    )
    return min(flat - computed, computed - best), 0.02, words


def _peak(T: int, crown: int, name: str, words: str, **more: Any) -> Beside:
    """Row on p_max without (0) or with (1) the optimal crown, calibrated at 25 N m."""
    kind = ("unmodified", "optimised")[crown]
    return Beside(name=name, symbol="p_max", unit="MPa", words=words,
                  value=lambda c: float(measured(c)[f"pair {T}"][crown]),
                  figure=PRINTED[float(T)][crown], printed=(f"huang2018:stress-{T}nm-{kind}",),
                  **more)  # fmt: skip


LITTLE_SPRUNG = OfPaper(
    name="normal force by the springs alone is less than 1 % of the static normal force",
    symbol="N_0/N",
    unit="1",
    margin=preload,
    fem_needed=False,
    fitted=FITTED,
)
OF_THE_PAPER: tuple[Check, ...] = (
    Agreement(name="final force of a damped engagement is the static force within 0.1 %",
              paper_only=True, symbol="N", unit="N", pair=at_rest, accepted=RESTS,
              source=suites("one tenth of the required sensitivity (1 %)"),
              by="Runge-Kutta steps"),
    OfPaper(name="length of the sprags is consistent with m_g and I_g of Table 1", symbol="l",
             unit="1", margin=length, fem_needed=False, fitted=FITTED),
    OfPaper(name="N_max changes by less than 0.5 % if b is the width of a rectangular sprag",
             symbol="b", unit="1", margin=width, fitted=FITTED),
    Beside(name="wedge angle that gives the pressure printed for 25 N m with the optimal crown",
           symbol="ν_0", unit="deg",
           value=lambda c: float(measured(c)["fitted"][0]), figure=EngagementInputs().nu_0,
           figure_is="input", bound=0.03, words="the wedge angle of the inputs is the reference",
           fitted=FITTED),
    _peak(25, 1, "p_max at 25 N m with the optimal crown, wedge angle fitted",
          "the wedge angle is fitted to this pressure", **ON_FIT),
    _peak(25, 0, "p_max at 25 N m without a crown, number of slices fitted",
          "the number of slices is fitted to this pressure", **ON_FIT),
    _peak(40, 1, "p_max at 40 N m with the optimal crown, predicted from 25 N m",
          "this prediction is not judged, because the printed pairs of pressures contradict each "
          "other"),
    _peak(40, 0, "p_max at 40 N m without a crown, predicted from 25 N m",
          "this prediction uses the number of slices fitted at 25 N m and is not judged"),
    Noted(name="ratio of the forces at 40 and 25 N m differs between the printed pairs of "
          "pressures",
          symbol="p_max", unit="MPa",
          erratum="huang2018:sec-4-2-force-ratio", margin=ratios,
          printed=("huang2018:stress-25nm-optimised", "huang2018:stress-40nm-optimised")),
    Noted(name="peak pressure without a crown grows with the number of slices",
          symbol="p_max", unit="MPa", erratum="huang2018:sec-4-2-unmodified-peak", margin=grows,
          printed=("huang2018:stress-25nm-unmodified",)),
    OfPaper(name="the first peak of the force is the largest, at 25 and 40 N m (Figs. 8, 13)",
         symbol="N_max", unit="1", margin=first_is_largest, fitted=FITTED),
    OfPaper(name="without a crown the largest pressure is at the ends (Fig. 16)", symbol="p_max",
         unit="1", margin=ends_carry, fitted=FITTED),
    OfPaper(name="p_max is lower with K_1 = 3 than with K_1 = 1 (Fig. 13)", symbol="p_max",
         unit="1",
         margin=deeper_is_lower, fitted=FITTED,
         printed=("huang2018:fig13a-k1", "huang2018:fig13b-k1")),
    Adopted(name="I_1 of Table 1", symbol="I_1", unit="kg m^2", reference="huang2018:table1-i-1",
            why="the paper neither explains I_1 nor uses it in an equation; the case does not use "
            "it"),
    Adopted(name="C_f of Table 1", symbol="C_f", unit="N m", reference="huang2018:table1-c-f",
            why="the paper neither explains C_f nor uses it in an equation; the case does not use "
            "it"),
)  # fmt: skip
