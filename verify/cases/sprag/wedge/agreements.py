"""Compared values and margins of a wedged sprag, for rows with tolerances stated beforehand."""

from collections.abc import Callable

import numpy as np

from analytic.sprag.closure import wedged
from verify.cases.sprag.wedge.formulas import KEYS, STROKE
from verify.cases.sprag.wedge.model import bounds
from verify.core.case import Context
from verify.judging.tolerance_checks import Pair

Function = Callable[[Context], Pair]

RATIO, WORK = 2e-3, 5e-3  # accepted of force ratios and torque, and of the work
LIGHT, SLIDES = 1e-4, 1e-3  # accepted without load, and of the friction that just holds


def no_load(context: Context) -> Pair:
    """Pair: ratio of tan(nu) by Eq. 10 to T_i/N_i at the lowest load, and its expected value 1."""
    clutch, found = context.inputs.clutch, []
    for result in context.fem[-2:]:
        N, _, share, *_ = result.arrays["loads"][:, 0]
        found.append(float(np.tan(wedged(clutch, N).nu) / share - 1))
    words = f"the ratio of both differs from 1 by {found[1]:+.1e} under {N:.3g} N, 1e-4 accepted"
    return Pair(1 + found[1], 1.0, 2 * abs(found[1] - found[0]), words)


def ratio(key: str, most: float, what: str, *, of_fem: bool = False) -> Function:
    """Function that returns a pair: ratio of formula to reference, and its expected value 1.

    The value `key` of the reference is this ratio minus 1, or the inverse ratio minus 1 if
    `of_fem`. The uncertainty is twice the difference between the last two meshes.
    """

    def pair(context: Context) -> Pair:
        before, now = (r.values[key] for r in context.fem[-2:])
        words = f"{what} {now:+.3%}, {most:.1%} accepted"
        return Pair(1 / (1 + now) if of_fem else 1 + now, 1.0, 2 * abs(now - before), words)

    return pair


def force_ratio(key: str) -> Function:
    """Function that returns a pair: `key` by formula and by reference, where they differ most.

    Only states up to N_0 are compared.
    """
    names = [f"{key}_{KEYS[point]}" for point, share in STROKE.items() if share <= 1]

    def pair(context: Context) -> Pair:
        off = [{name: r.values[name] / context.analytic[name] - 1 for name in names}
               for r in context.fem[-2:]]  # fmt: skip
        before, now = (max(x.values(), key=abs) for x in off)
        worst = max(names, key=lambda name: abs(off[-1][name]))
        words = f"the largest difference is {now:+.2%}, {RATIO:.1%} accepted"
        found = context.fem[-1].values[worst]
        return Pair(context.analytic[worst], found, 2 * abs(now - before) * found, words)

    return pair


def force_ratio_bent(key: str) -> Function:
    """Function that returns a pair: `key` at 1.8 N_0 by formula with bending, and by reference."""
    name = f"{key}_most"

    def pair(context: Context) -> Pair:
        q = context.inputs
        bent = bounds(q.part, q.stroke["1.8 N_0"].case.N).bending.whole
        before, now = (r.values[name] / context.analytic[name] - 1 for r in context.fem[-2:])
        words = (
            f"the difference is {now:+.2%}, of which bending causes {bent:+.2%}; {RATIO:.1%} "
            "accepted for the rest"
        )
        found = context.fem[-1].values[name]
        formula = context.analytic[name] * (1 + bent)
        return Pair(formula, found, 2 * abs(now - before) * found, words)

    return pair


def keeps_its_angle(context: Context) -> tuple[float, float, str]:
    """Positive margin if T_i/N_i changes by less than 1 % over the stroke.

    The uncertainty and the text of the row are also returned.
    """
    spread = [
        max(s) / min(s) - 1
        for s in ([r.values[f"mu_i_{k}"] for k in KEYS.values()] for r in context.fem[-2:])
    ]
    words = f"T_i/N_i changes by {spread[1]:.2%} from N_0/4 to 1.8 N_0, 1 % accepted"
    return 0.01 - spread[1], 2 * abs(spread[1] - spread[0]), words


def inner_above_outer(context: Context) -> tuple[float, float]:
    """Smallest value of p_i/p_o - 1 over the stroke, and its uncertainty."""
    ratios = [
        min(r.values[f"p_i_{k}"] / r.values[f"p_e_{k}"] for k in KEYS.values())
        for r in context.fem[-2:]
    ]
    return ratios[1] - 1, 2 * abs(ratios[1] - ratios[0])


def onset(context: Context) -> Pair:
    """Pair: tan(nu) by the formula, and the friction coefficient midway between hold and slip."""
    v = context.fem[0].values
    tan = float(np.tan(wedged(context.inputs.clutch, v["N_at_onset"]).nu))
    between, half = (v["holds"] + v["slides"]) / 2, abs(v["holds"] - v["slides"]) / 2
    words = (
        f"the sprag holds at μ = {v['holds'] / tan:.4f} tan ν and slips at μ = "
        f"{v['slides'] / tan:.4f} tan ν"
    )
    return Pair(tan, between, half, words)
