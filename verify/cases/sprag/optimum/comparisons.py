"""Rows of the optimal crown: printed values, nearly optimal crowns, maps, effect of the torque."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from verify.case import Comparison
from verify.cases.sprag.clutch.paper_fem import PRINTED
from verify.cases.sprag.optimum.crown_claims import at_rest, pressed
from verify.cases.sprag.optimum.ends_fem import SLICED
from verify.cases.sprag.optimum.surrogate_claims import SURROGATE, Displayed
from verify.cases.sprag.statements import FITTED, Beside, OfPaper, measured
from verify.core.case import Check, Context
from verify.core.figures import Array

NEAR = 0.01  # pressures are equal if they exceed that of the optimal crown by less (relative)
ON_BOUND = 1e-3  # distance relative to the range within which a parameter is at its bound
FLAT = 0.005  # relative excess of the pressure that bounds the nearly optimal crowns
SURE = 1e-3  # relative accuracy of pressures by computed engagements


def best(context: Context) -> float:
    return float(measured(context)["best true"][0])


def printed_crown(context: Context) -> tuple[float, float, str]:
    """Positive margin if p_max of the printed crown exceeds the lowest p_max by less than NEAR.

    The uncertainty and the text of the row are also returned.
    """
    p, found = float(measured(context)["at hand: pressures"][0].max()), measured(context)["best"]
    words = (
        f"p_max of the printed crown is {p / 1e6:.0f} MPa, {p / best(context) - 1:+.2%} relative "
        f"to {best(context) / 1e6:.0f} MPa of the optimal crown {crowned(found)}"
    )
    return NEAR - (p / best(context) - 1), 0.0, words


def crowned(crown: Array) -> str:
    K_1, K_2, z_m = crown
    return f"K_1 = {K_1:.2f}, K_2 = {K_2:.3f}, z_m = {z_m * 1e6:.1f} µm"


def valley(context: Context, within: float = FLAT) -> dict[str, tuple[float, float]]:
    """Interval of each parameter, by name, within which nearly the lowest pressure can be reached.

    For each value in the range, the other parameters can be chosen so that the pressure is at most
    the fraction `within` above the lowest.
    """
    found = measured(context)
    low = found["whole"] <= found["whole"].min() * (1 + within)
    sides = {}
    for axis, name in enumerate(("K_1", "K_2", "z_m")):
        there = found[name][low.any(axis=tuple(k for k in range(3) if k != axis))]
        sides[name] = (float(there[0]), float(there[-1]))
    return sides


def flat(context: Context) -> str:
    sides, found = valley(context), measured(context)
    share = float(np.mean(found["whole"] <= found["whole"].min() * (1 + FLAT)))
    z_m = tuple(x * 1e6 for x in sides["z_m"])
    return (
        f"p_max is within {FLAT:.1%} of the lowest for {share:.1%} of the crowns of Eq. 19; for "
        f"these crowns, K_1 is {sides['K_1'][0]:.2f} to {sides['K_1'][1]:.2f}, K_2 is "
        f"{sides['K_2'][0]:.2f} to {sides['K_2'][1]:.2f}, and z_m is {z_m[0]:.1f} to "
        f"{z_m[1]:.1f} µm{bound(context)}"
    )


def bound(context: Context) -> str:
    """Text that lists the bounds of Eq. 19 on which the optimal crown lies; may be empty."""
    box = context.inputs.box
    u = box.to_unit(measured(context)["best"][None])[0]
    on = [
        f"{name} = {(low, high)[int(x > 0.5)] * (1e6 if name == 'z_m' else 1):g}"
        + (" µm" if name == "z_m" else "")
        for name, x, low, high in zip(("K_1", "K_2", "z_m"), u, box.low, box.high, strict=True)
        if min(x, 1 - x) < ON_BOUND
    ]
    return f"; the optimum lies on the bound {', '.join(on)}" if on else ""


def lundberg(context: Context) -> tuple[float, float, str]:
    """Positive margin if p_max of Lundberg's crown differs by less than FLAT from the lowest.

    Lundberg's crown is that for N_max (K_1 = N_max/Q). The uncertainty and the text of the row are
    also returned.
    """
    K_1, _, _, p = measured(context)["Lundberg"]
    low, high = valley(context)["K_1"]
    words = (
        f"with K_1 = N_max/Q = {K_1:.2f}, p_max differs by {p / best(context) - 1:+.2%} from that "
        f"of the optimal crown; the optimal K_1 is {measured(context)['best'][0]:.2f}; p_max is "
        f"within {FLAT:.1%} of the lowest for every K_1 from {low:.2f} to {high:.2f}, which makes "
        f"this row weak evidence for K_1 = N_max/Q"
    )
    return FLAT - abs(float(p) / best(context) - 1), 0.0, words


def turns(lines: Array) -> Array:
    """Relative rise from the minimum of each line of pressures to its lower end value, shape (n,).

    The end values are the first and the last pressure of a line.
    """
    lowest = lines.min(axis=1)
    return np.asarray(np.minimum(lines[:, 0], lines[:, -1]) / lowest - 1)


def factorial(context: Context) -> Array:
    """Pressures [Pa] of computed engagements over K_1 and K_2 (Figs. 15, 17).

    z_m is the level of the factorial that is nearest to 10 µm.
    """
    found, n = measured(context), context.inputs.levels
    largest = np.maximum(found["end"][:, 0], found["inside"][:, 0]).reshape(n, n, n)
    return np.asarray(largest[:, :, int(np.argmin(np.abs(found["X"][:n, 2] - 10e-6)))])


def over_K_1(context: Context) -> tuple[float, float, str]:
    """Smallest of the relative rises (`turns`) of the pressure over K_1.

    The lines over K_1 are those of both maps, without the line of the lowest z_m. The uncertainty
    and the text of the row are also returned.
    """
    shallow, *deeper = measured(context)["true K_1, z_m"][0].T
    found = turns(np.vstack([factorial(context).T, *deeper]))
    words = (
        f"on {len(found)} lines of constant K_2 and z_m, p_max at both ends of the line exceeds "
        f"the minimum of the line by at least {found.min():.2%}; the line at z_m = "
        f"{context.inputs.z_m_low * 1e6:g} µm in the map of K_1 and z_m is not judged: on this "
        f"line, p_max {course(shallow)}"
    )
    return float(found.min()), SURE, words


def over_K_2(context: Context) -> str:
    return counted(context, factorial(context))


def over_z_m(context: Context) -> str:
    return counted(context, measured(context)["true K_1, z_m"][0])


def counted(context: Context, lines: Array) -> str:
    """Text: number of `lines` of constant K_1 on which the pressure has a minimum between the ends.

    The text also states how the pressure changes along the line nearest to the optimal crown.
    """
    found, q = turns(lines), context.inputs
    K_1 = np.linspace(q.K_1_low, q.K_1_high, q.levels)
    near = int(np.argmin(np.abs(K_1 - measured(context)["best"][0])))
    return (
        f"on {np.sum(found > SURE)} of {len(found)} lines of constant K_1, p_max falls, then "
        f"rises by {found.max():.2%} at most; at K_1 = {K_1[near]:g}, the value of the factorial "
        f"nearest to the optimum, p_max {course(lines[near])}"
    )


def course(line: Array) -> str:
    """Text: whether the pressure falls, rises, or has a minimum; rises up to SURE are ignored."""
    if (turn := float(turns(line[None])[0])) > SURE:
        return f"falls, then rises by {turn:.2%}"
    return f"only {'falls' if line[-1] < line[0] else 'rises'} (changes up to {SURE:.1%} ignored)"


def larger_K_1(context: Context) -> tuple[float, float, str]:
    """Relative excess of p_max above its minimum, if K_1 is that optimal for the smaller torque.

    K_2 and z_m are optimal for this K_1. The excess has a negative sign if the optimal K_1 of the
    smaller torque exceeds that of the larger torque.
    """
    found = measured(context)
    K_1, other = float(found["best"][0]), float(found["less"][0])
    over = found["whole"].min(axis=(1, 2))
    costs = float(np.interp(other, found["K_1"], over) / over.min() - 1)
    words = (
        f"the optimal K_1 is {other:.2f} at 25 N m ({band(found['K_1'], found['less over K_1'])}; "
        f"kriging without infill) and {K_1:.2f} at 40 N m ({band(found['K_1'], over)}); at 40 N m, "
        f"p_max with the optimal K_1 for 25 N m differs by {costs:+.1%} from the lowest"
    )
    return math.copysign(costs, K_1 - other), FLAT, words


def band(K_1: Array, over: Array) -> str:
    """Text: interval of K_1 in which the pressure exceeds its lowest value by at most FLAT."""
    near = K_1[over <= over.min() * (1 + FLAT)]
    return f"from {near[0]:.2f} to {near[-1]:.2f}, p_max is within {FLAT:.1%} of the lowest"


def steeper_z_m(context: Context) -> tuple[float, float, str]:
    """Mean relative variation of p_max over z_m at the larger torque, minus that at the smaller."""
    more, less = (
        float(np.mean(p.max(axis=1) / p.min(axis=1) - 1))
        for p in measured(context)["true K_1, z_m"]
    )
    return (
        more - less,
        SURE,
        f"over the range of z_m, p_max varies by {more:.1%} at 40 N m and by {less:.1%} at 25 N m "
        "(means over all K_1)",
    )


def reductions(found: Any) -> Array:
    """Relative reductions of p_max from no crown to the optimal crown, one for each torque."""
    crowns = [float(found["best: pressures"][0].max())]
    crowns += [float(found["less"][4])] if "less" in found else []
    flat_ones = found["none: pressures"].max(axis=1)
    return np.asarray(1 - np.array(crowns) / flat_ones)


def improves(context: Context) -> tuple[float, float, str]:
    """Relative reduction of p_max by the optimal crown, minus the reduction at the smaller torque.

    The uncertainty and the text of the row are also returned.
    """
    more, less = reductions(measured(context))
    return (
        float(more - less),
        SURE,
        f"the optimal crown reduces p_max by {more:.1%} at 40 N m and by {less:.1%} at 25 N m, "
        f"with {context.inputs.slices} slices",
    )


def made_for(context: Context) -> tuple[float, float, str]:
    """Ratio of p_max with the optimal crown of the other torque to the lowest p_max, minus 1.

    The uncertainty and the text of the row are also returned.
    """
    p = float(measured(context)["less"][3])
    return (
        p / best(context) - 1,
        SURE,
        f"p_max of the optimal crown for 25 N m differs by {p / best(context) - 1:+.1%} from that "
        "of the optimal crown for 40 N m",
    )


def taken_off(context: Context) -> str:
    """Text: reductions of the pressure by the optimal crown, for several numbers of slices."""
    best, none = (by_number(context, crown) for crown in ("best", "none"))
    shares = ", ".join(
        f"{1 - p / flat:.1%} with {n} slices ({flat / 1e6:.0f} to {p / 1e6:.0f} MPa)"
        for n, p, flat in zip(SLICED, best, none, strict=True)
    )
    return (
        f"relative to no crown, p_max is reduced by {shares}; the pressure at the ends grows with "
        "the number of slices"
    )


def by_number(context: Context, crown: str) -> Array:
    """Largest pressures [Pa] for each number of slices in SLICED."""
    found = measured(context)
    given = np.array(SLICED) == context.inputs.slices
    return np.where(given, found[f"{crown}: pressures"][0].max(), found[f"{crown}: sliced"])


def beside(name: str, value: Callable[[Context], float], T: int, **more: Any) -> Beside:
    return Beside(name=name, symbol="Pre_max", unit="MPa", value=value,
                  figure=PRINTED[float(T)][1],
                  printed=(f"huang2018:stress-{T}nm-optimised",), **more)  # fmt: skip


def _best(context: Context) -> float:
    return float(measured(context)["best true"][0])


def _fitted(context: Context) -> float:
    return float(measured(context)["fitted"][2])


def checks(T: int) -> tuple[Any, ...]:
    """All claims at the torque T [N m]."""
    optimum = tuple(f"huang2018:optimum-{T}nm-{key}" for key in ("k1", "k2", "zm"))
    fitted = FITTED if T == 25 else ""
    why = (
        ""
        if T == 25
        else "; this prediction is not judged, because the printed pressures contradict each other"
    )
    found = (
        *SURROGATE,
        beside(f"p_max with the optimal crown, {T} N m", _best, T, fitted=fitted,
               bound=2 * NEAR, words=f"the wedge angle is that of the inputs{why}"),
        beside(f"p_max with the optimal crown, {T} N m, wedge angle fitted", _fitted, T,
               fitted=fitted, bound=NEAR,
               words=f"the wedge angle is fitted to the pressure printed at 25 N m{why}"),
        Displayed(name="reduction of the largest pressure by the optimal crown", symbol="Pre_max",
             unit="%", words=taken_off, printed=(f"huang2018:stress-{T}nm-reduction",)),
        OfPaper(name=f"largest pressure of the printed crown is within {NEAR:.0%} of the lowest",
                symbol="Pre_max", unit="1", margin=printed_crown, fitted=FITTED, printed=optimum),
        Displayed(name="range of crowns with nearly the lowest p_max", symbol="Pre_max", unit="1",
                  words=flat),
        OfPaper(name=f"largest pressure with K_1 = N_max/Q is within {FLAT:.1%} of the lowest",
                symbol="K_1", unit="1", margin=lundberg, fitted=FITTED, printed=optimum[:1]),
        OfPaper(name="with increasing K_1, p_max falls, then rises", symbol="Pre_max", unit="1",
                margin=over_K_1, fitted=FITTED,
                printed=(f"huang2018:fig{15 if T == 25 else 17}a-zm",)),
        Displayed(name="change of p_max with increasing z_m", symbol="Pre_max", unit="1",
                  words=over_z_m, printed=(f"huang2018:fig{15 if T == 25 else 17}b-k2",)),
    )  # fmt: skip
    return (*found, *(AT_25 if T == 25 else AT_40))


def stated(q: Any) -> Iterator[Comparison | Check]:
    """Claims on surrogates and searches, on statements of the paper at this torque, on contacts."""
    yield from checks(q.torque)
    yield at_rest(type(q).static_mid, "pressure at mid-length")
    yield at_rest(type(q).static_peak, "largest pressure")
    yield from pressed(q.torque)


AT_25 = (
    Displayed(name="change of p_max with increasing K_2", symbol="Pre_max", unit="1",
              words=over_K_2, printed=("huang2018:fig15a-zm",)),
)  # fmt: skip
AT_40 = (
    OfPaper(name="the optimal K_1 is larger than at 25 N m", symbol="K_1", unit="1",
            margin=larger_K_1, fitted=FITTED, printed=("huang2018:optimum-40nm-k1",)),
    OfPaper(name="z_m changes p_max more than at 25 N m", symbol="Pre_max", unit="1",
            margin=steeper_z_m, fitted=FITTED, printed=("huang2018:fig17b-k2",)),
    OfPaper(name="the optimal crown reduces p_max more than at 25 N m", symbol="Pre_max",
            unit="1", margin=improves, fitted=FITTED, printed=("huang2018:stress-40nm-reduction",)),
    OfPaper(name="the optimal crown for 25 N m is not optimal for 40 N m", symbol="Pre_max",
            unit="1", margin=made_for, fitted=FITTED),
)  # fmt: skip
