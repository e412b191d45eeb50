"""Statements of Figs. 12 to 14 on crowns, verified on this clutch: margins and texts."""

from collections.abc import Mapping

import numpy as np

from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.crown.formulas import label
from verify.cases.sprag.crown.paper_fem import FIG_12, FIG_14
from verify.cases.sprag.engagement.model import crowned_for
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.checks import Margin

MPa = 1e6
AT = {10: 0, 25: 1, 30: 2, 40: 3}  # index by torque [N m]
STEP = 1e-3  # relative error of a pressure: tables of the engagements, fits of N_max
NEAR = 0.01
LEVEL = 1.0  # step of K_1 in the factorial


def arrays(context: Context) -> Mapping[str, Array]:
    return context.fem[-1].arrays


def number(crown: tuple[float, float, float]) -> int:
    return DESIGNS.index(crown)


def ordered(found: Mapping[str, Array], by: str) -> Array:
    """Mask (forces,), true if p_max is lowest for the optimal and highest for the worst crown."""
    p = found[f"swept, {by}"]
    best, worst = map(number, FIG_12)
    return np.asarray((p.argmin(axis=0) == best) & (p.argmax(axis=0) == worst))


def window(found: Mapping[str, Array], by: str) -> str:
    """Text on the range of swept forces at which the crowns have the order of Fig. 12."""
    N = found["swept"][ordered(found, by)] / 1e3
    return f"from {N.min():.2f} to {N.max():.2f} kN by {by}" if N.size else f"at no force by {by}"


def first_peaks(found: Mapping[str, Array]) -> str:
    """Text: torques at whose first force peaks the crowns have the order of Fig. 12, by slices."""
    N, peaks = found["swept"][ordered(found, "slices")], found["named N"][number(FIG_12[0])]
    T = np.interp(N, [0.0, *peaks], [0.0, *found["torques"]])
    return f"with {T.min():.0f} to {T.max():.0f} N m" if T.size else "with no torque"


def highest_and_lowest(context: Context) -> tuple[float, float, str]:
    """Smallest margin of the statement that crowns have the order of Fig. 12 under static load.

    The optimal crown must have the lowest pressure of all printed crowns and the worst crown the
    highest, both by slices and by strips. The uncertainty and the text of the row are also
    returned.
    """
    found, N = arrays(context), context.inputs.N
    best, worst = map(number, FIG_12)
    margins = []
    for by in ("slices", "strips"):
        p = np.array([np.interp(N, found["swept"], one) for one in found[f"swept, {by}"]])
        others = np.delete(p, [best, worst])
        margins.append(min(others.min() / p[best], p[worst] / others.max()) - 1)
    forces = ", ".join(window(found, by) for by in ("slices", "strips"))
    words = (
        f"of {len(DESIGNS)} printed crowns, the optimal crown of Fig. 12 has the lowest p_max and "
        "its worst crown the highest; p_max of every other crown differs from that of both "
        f"crowns by at least {margins[0]:.1%} by slices and {margins[1]:.1%} by strips; these "
        "values apply "
        f"under {N:.0f} N, the static load at 25 N m; this order holds {forces}; by slices, it "
        f"also holds for the first force peaks of engagements {first_peaks(found)}"
    )
    return float(min(margins)), 0.0, words


def in_other_order(context: Context) -> tuple[float, float, str]:
    """Ratio of p_max of the optimal crown of Fig. 12 to p_max of its worst crown, minus 1.

    Both are pressures at the first force peak at 25 N m. The uncertainty and the text of the row
    are also returned.
    """
    found = arrays(context)
    best, worst = (float(found["named p"][number(c), AT[25]]) for c in FIG_12)
    N = float(found["named N"][number(FIG_12[0]), AT[25]])
    words = (
        f"p_max is {best / MPa:.0f} MPa with crown {label(FIG_12[0])} and {worst / MPa:.0f} MPa "
        f"with crown {label(FIG_12[1])} under {N:.0f} N"
    )
    return best / worst - 1, STEP, words


def first_and_trough(context: Context) -> tuple[float, float, str]:
    """Smaller margin of two statements on the pressure at the ends with K_1 = 1.

    At the first force peak, the pressure is higher at the ends than at mid-length; at the
    next force minimum, it is lower. The uncertainty and the text of the row are also returned.
    """
    peak, trough = (p[[0, p.size // 2]] / MPa for p in arrays(context)["Fig. 13"][0])
    words = (
        f"at the first force peak, the pressure is {peak[0]:.0f} MPa at the ends and "
        f"{peak[1]:.0f} MPa at mid-length; at the next force minimum, it is {trough[0]:.0f} MPa "
        f"at the ends and {trough[1]:.0f} MPa at mid-length"
    )
    return float(min(peak[0] / peak[1], trough[1] / trough[0])) - 1, STEP, words


def uneven(p: Array) -> float:
    """Fraction of the load above the mean line load; the line load is proportional to p²."""
    return float(np.abs(p**2 / (p**2).mean() - 1).mean() / 2)


def more_even(context: Context) -> tuple[float, float, str]:
    """Relative reduction of `uneven`, a fraction of the load, if K_1 increases from 1 to 3."""
    shallow, deep = (uneven(p[0]) for p in arrays(context)["Fig. 13"])
    words = (
        f"the part of the load that exceeds a uniform load is {shallow:.1%} with K_1 = 1 and "
        f"{deep:.1%} with K_1 = 3"
    )
    return 1 - deep / shallow, STEP, words


def order_at(which: int) -> Margin:
    """Function: ratio of p_max of the other crown of Fig. 14 to that of crown `which`, minus 1.

    Crown 0 is compared at 10 N m, crown 1 at 30 N m.
    """
    T = (10, 30)[which]

    def margin(context: Context) -> tuple[float, float, str]:
        p = arrays(context)["named p"][:, AT[T]]
        named, other = (float(p[number(c)]) for c in (FIG_14[which], FIG_14[1 - which]))
        words = (
            f"p_max is {named / MPa:.0f} MPa; with crown {label(FIG_14[1 - which])}, it is "
            f"{other / MPa:.0f} MPa"
        )
        return other / named - 1, STEP, words

    return margin


def above_lowest(context: Context, which: int) -> tuple[float, str]:
    """Ratio of p_max of crown `which` (Fig. 14) to the lowest p_max of crowns of Eq. 19, minus 1.

    The text of the row is also returned.
    """
    T, found = (10, 30)[which], arrays(context)
    p = found["many p"][:, AT[T]]
    named, k = float(found["named p"][number(FIG_14[which]), AT[T]]), int(p.argmin())
    lower = int((p < named).sum())
    words = (
        f"p_max of the crown of Fig. 14 is {named / MPa:.0f} MPa; of {p.size} crowns of Eq. 19, "
        f"crown {label(tuple(found['box'][k]))} has the lowest p_max; p_max of the crown of Fig. "
        f"14 exceeds the lowest by {named / p[k] - 1:.1%}; {lower} of the crowns of Eq. 19 have a "
        "lower p_max than the crown of Fig. 14"
    )
    return named / float(p[k]) - 1, words


def lowest_at_10(context: Context) -> tuple[float, float, str]:
    above, words = above_lowest(context, 0)
    return NEAR - above, STEP, words


def not_lowest_at_30(context: Context) -> tuple[float, float, str]:
    """Ratio of p_max of Fig. 14's crown for 30 N m to the lowest p_max at 30 N m, minus 1.

    The uncertainty and the text of the row are also returned.
    """
    above, words = above_lowest(context, 1)
    N = arrays(context)["many N"][:, AT[30]].mean() / crowned_for(context.inputs)
    return above, STEP, f"{words}; N_max/Q = {N:.2f}"


def lowest(context: Context) -> Array:
    """Crown of Eq. 19 with the lowest pressure at each torque, shape (torques, 3)."""
    found = arrays(context)
    return np.asarray(found["box"][found["many p"].argmin(axis=0)])


def grows_with_torque(context: Context) -> tuple[float, float, str]:
    """Increase of K_1 of the crown with the lowest p_max from the smallest to the largest torque.

    If K_1 decreases between two torques, the largest decrease is returned instead. The uncertainty
    and the text of the row are also returned.
    """
    found, best = arrays(context), lowest(context)
    ratio = found["many N"].mean(axis=0) / crowned_for(context.inputs)
    words = "; ".join(
        f"at {T:g} N m: K_1 = {c[0]:g}, z_m = {c[2] * 1e6:g} µm and N_max/Q = {r:.2f}"
        for T, c, r in zip(found["torques"], best, ratio, strict=True)
    )
    steps = np.diff(best[:, 0])
    rise = float(best[-1, 0] - best[0, 0]) if steps.min() >= 0 else float(steps.min())
    return rise, LEVEL, words
