"""Figures of crowns: profile, pressures over force and torque, number of slices."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from analytic.contact.crown_mean import z_m_share
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.clutch.drawn_fem import places
from verify.cases.sprag.crown.formulas import even, label, pressed, unit
from verify.cases.sprag.crown.measured_figures import AT, number, window
from verify.cases.sprag.crown.paper_fem import EQ_21, FIG_12, FIG_14
from verify.cases.sprag.crown.slices import by_number
from verify.cases.sprag.engagement.model import crowned_for, gap
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Context
from verify.core.figures import Array, Curves, Dots, Figure, Sketch
from verify.form import sketches
from verify.form.plots import curve, dashes, dots, line, plot
from verify.form.sketches import shape

MPa, mm, um, kN = 1e6, 1e-3, 1e-6, 1e3
EQ_22 = (2.80, 0.7, 11.8e-6)
DEEPER = 0.3  # drop of the sketched crown over the length


def sketch(q: EngagementInputs) -> Sketch | None:
    """Sketch of the sprag profile along its axis, with an enlarged drop; None without crown."""
    if q.z_m == 0:
        return None
    y, z = places(q, 401), gap(q.model_copy(update={"slices": 401}))
    drop = z * DEEPER * q.l / q.z_m
    low = -1.6 * DEEPER * q.l
    top = np.column_stack([y, -drop])
    body = np.concatenate([top, [[q.l / 2, low], [-q.l / 2, low]]])
    start, above = (1 - q.K_2) * q.l / 2, 0.08 * q.l
    shapes = (
        shape("body", body / mm), shape("faint", np.array([[-q.l / 2, 0.0], [q.l / 2, 0.0]]) / mm),
        shape("dimension", np.array([[-start, above], [start, above]]) / mm, "(1 − K_2) l"),
        shape(
            "dimension", np.array([[q.l / 2, 0.0], [q.l / 2, -z[-1] / q.z_m * DEEPER * q.l]]) / mm,
            "z_m",
        ),
        shape("dimension", np.array([[-q.l / 2, low * 1.1], [q.l / 2, low * 1.1]]) / mm, "l"),
    )  # fmt: skip
    return sketches.sketch("profile of the sprag along its axis; the drop is enlarged", shapes)


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    found: list[Figure] = [shares(q)] if q.z_m else []
    if math.isfinite(q.N):
        found.append(along(context))
    if not context.fem:
        return found
    last = context.fem[-1].arrays
    if "torques" in last:
        found += [
            by_force(context), by_torque(last), above(last), suits(context),
            by_number(context), ratios(last),
        ]  # fmt: skip
    return found


def shares(q: EngagementInputs) -> Curves:
    """Figure of the increase of the mean drop in % for 1 % more z_m, over z_m/A."""
    m = np.geomspace(0.05, 30.0, 121)
    printed = np.array([(c[2] / (c[0] * unit(q)), z_m_share(c[0] * unit(q), c[2]))
                        for c in DESIGNS])  # fmt: skip
    own = q.z_m / (q.K_1 * unit(q))
    return plot(
        "Effects of z_m and K_1 on the mean drop", "z_m/A",
        "increase of mean drop for 1 % more z_m [%]",
        line("Eq. 1", m, [z_m_share(1.0, x) for x in m]),
        dots("crowns that the paper prints", printed[:, 0], printed[:, 1], 2),
        dots("this crown", own, z_m_share(1.0, own), 4), y_bottom=0.0,
        note="A is the factor of the logarithm in Eq. 1 and proportional to K_1. A value of 0.25 "
        "means: 1 % more z_m increases the mean drop by 0.25 %, 1 % more K_1 by 0.75 %. If z_m is "
        "many times A, the profile reaches z_m only at the ends, and K_1 determines the mean drop.",
    )  # fmt: skip


def along(context: Context) -> Curves:
    """Figure of the pressure p(y) at rest and at the first force peak."""
    q = context.inputs
    both = (q.N, q.p_even_rest, "at rest"), (q.N_max, q.p_even_peak, "at the first force peak")
    states = [state for state in both if math.isfinite(state[0])]
    y = places(q, q.slices) / mm
    curves = [
        line(words, y, pressed(q, N).peak_pressure / MPa, 2 * k)
        for k, (N, _, words) in enumerate(states)
    ]  # fmt: skip
    if context.fem:
        p = context.fem[-1].arrays["strips"]
        curves.append(dashes("at the first force peak, strips", places(q, p.size) / mm, p / MPa, 2))
    curves += [
        dashes(f"uniform load, {words}", y[[0, -1]], p / MPa, 2 * k + 1)
        for k, (_, p, words) in enumerate(states)
    ]  # fmt: skip
    return plot(
        "Pressure along the sprag, inner race", "y [mm]", "p [MPa]", curves, y_bottom=0.0,
        y_top=1.5 * states[-1][1] / MPa,
        note=f"(K_1, K_2, z_m) = {label((q.K_1, q.K_2, q.z_m))}. At loaded ends the "
        "largest pressure is unbounded: it grows with the number of slices or strips.",
    )  # fmt: skip


def by_force(context: Context) -> Curves:
    """Figure of the ratio of the largest to the uniform pressure over the force, for two crowns."""
    q, found = context.inputs, context.fem[-1].arrays
    N = found["swept"]
    base = np.array([even(q, float(x)) for x in N])
    curves = [
        curve(f"{label(crown)}, {by}", N / kN, found[f"swept, {by}"][number(crown)] / base, style,
              2 * k)
        for k, crown in enumerate(FIG_12)
        for by, style in (("slices", "line"), ("strips", "dashes"))
    ]  # fmt: skip
    highest = max(float(np.max(curve.y)) for curve in curves)
    marks = (("vertical: static load, 25 N m", q.N),
             ("vertical: first force peak, 25 N m", q.N_max))  # fmt: skip
    curves += [dashes(name, at / kN, [1.0, highest], 4 + k) for k, (name, at) in enumerate(marks)]
    return plot(
        "Best and worst crown of Fig. 12 over the force", "N [kN]",
        "p_max / pressure of uniform load", curves, y_bottom=1.0,
        note="Of all printed crowns, these two have the lowest and the highest pressure "
        f"{window(found, 'slices')}; the static load lies in this range. At the first force "
        "peak of an engagement with 25 N m, the order is reversed. Strips model a half-space, on "
        "which pressures at loaded ends are higher.",
    )  # fmt: skip


def by_torque(found: Mapping[str, Array]) -> Curves:
    """Figure of p_max over torque: its range for crowns of Eq. 19, and both crowns of Fig. 14."""
    T = found["band T"]
    curves = [
        line("lowest of 125 crowns of Eq. 19", T, found["band low"] / MPa, 1),
        dashes("highest of 125 crowns", T, found["band high"] / MPa, 1),
    ]  # fmt: skip
    for k, crown in enumerate(FIG_14):
        n = number(crown)
        curves.append(line(label(crown), T, found["band p"][n] / MPa, 2 * k + 2))
        curves.append(dots("", found["torques"], found["named p"][n] / MPa, 2 * k + 2))
    return plot(
        "Largest pressure over the torque (Fig. 14)", "T [N m]", "p_max [MPa]", curves,
        y_bottom=0.0, note="Dots: computed engagements. Lines: the forces are interpolated between "
        "engagements.",
    )  # fmt: skip


def above(found: Mapping[str, Array]) -> Curves:
    """Figure of the ratio of p_max of printed crowns to the lowest p_max, minus 1, in per cent."""
    T, low = found["band T"], found["band low"]
    names = (*FIG_14, EQ_21, EQ_22)
    return plot(
        "Excess of p_max of printed crowns over the lowest p_max", "T [N m]",
        "p_max above the lowest of 125 crowns [%]",
        (
            line(label(c), T, 100 * (found["band p"][number(c)] / low - 1), k)
            for k, c in enumerate(names)
        ),
        y_bottom=-1.0,
        note="K_1 = 1 suits low torques. K_1 = 5 suits torques above the range of the figure: at "
        "30 N m, p_max with K_1 = 5 is still "
        f"{found['named p'][number(FIG_14[1]), AT[30]] / found['many p'][:, AT[30]].min() - 1:.1%} "
        "above the lowest.",
    )  # fmt: skip


def suits(context: Context) -> Curves:
    """Figure of K_1 of the crown with the lowest pressure over torque, with printed values."""
    found, Q = context.fem[-1].arrays, crowned_for(context.inputs)
    T = found["band T"]
    return plot(
        "K_1 of the crown with the lowest pressure", "T [N m]", "K_1",
        line("lowest with K_2 = 0.7, z_m = 10 µm", T, found["band K_1"]),
        dashes("N_max/Q", T, found["band N"] / Q, 4),
        dots("printed, Eqs. 21 and 22", [25.0, 40.0], [EQ_21[0], EQ_22[0]], 2),
        dots("printed, Fig. 14", [10.0, 30.0], [c[0] for c in FIG_14], 1), y_bottom=0.0,
        note="Lundberg's crown gives a uniform load under its design load K_1 Q. The printed value "
        "5 at 30 N m does not fit the printed values 2.15 at 25 N m and 2.80 at 40 N m.",
    )  # fmt: skip


def ratios(found: Mapping[str, Array]) -> Dots:
    """Figure of the ratio of p_max at 40 N m to p_max at 25 N m, printed and computed."""
    N_25, N_40 = found["counted N"]
    flat = found["counted, 40"][0] / found["counted, slices"][0]
    best = found["named p"][number(EQ_22), AT[40]] / found["named p"][number(EQ_21), AT[25]]
    kept = found["named p"][number(EQ_21)]
    items = [
        ("printed, no crown: 4700/3500", 4700 / 3500, None, "paper"),
        *((f"no crown, {n:.0f} slices", float(r), None, "formula")
          for n, r in zip(found["counts"], flat, strict=True) if n in (11, 41, 161)),
        ("uniform load: √(N_40/N_25)", float(np.sqrt(N_40 / N_25)), None, "formula"),
        ("crown of Eq. 22 at 40, of Eq. 21 at 25 N m", float(best), None, "formula"),
        ("crown of Eq. 21 at both torques", float(kept[AT[40]] / kept[AT[25]]), None, "formula"),
        ("printed, optimal crowns: 3400/2980", 3400 / 2980, None, "paper"),
    ]  # fmt: skip
    return Dots(
        title="Increase of p_max from 25 to 40 N m", label="p_max(40 N m) / p_max(25 N m)",
        items=tuple(items),
        note=f"The ratio of the forces is {N_40 / N_25:.3f}. The ratio of p_max can be below that "
        "of a uniform load only if the load at 25 N m is not uniform. According to the paper, the "
        "loads of its optimal crowns are uniform.",
    )  # fmt: skip
