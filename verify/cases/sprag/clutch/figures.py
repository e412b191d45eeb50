"""Figures of a sprag clutch: results over the torque, pressures, limits."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import at_torque, wedged
from analytic.sprag.course import rolled
from analytic.sprag.tolerance import first_contact
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.model import built, under
from verify.cases.sprag.inputs import SpragInputs
from verify.core.case import Context
from verify.core.figures import Array, Bars, Curves, Figure
from verify.form.plots import dashes, dots, line, plot

DEGREE = math.degrees(1.0)
POINTS = 121
LEAST = 1e-3  # over the largest force of a figure


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    if under(q) is None:
        return ()
    found: list[Figure] = [force(q), pressures(q, context), turned(q), yields(q), off(q)]
    measured = context.fem[-1].arrays if context.fem else {}
    if "fitted" in measured and np.isfinite(measured["fitted"]).all():
        found += [counted(context), pairs(context)]
    return found


def reach(q: SpragInputs) -> float:
    """Upper end [N m] of the torque axis: above the first limit beyond T, but at most 6 T."""
    found = as_torque_grows(q)
    ahead = [x.at for x in found if x.at > q.T and x.key != "wide"]
    wide = min((x.at for x in found if x.key == "wide"), default=math.inf)
    return min(max(1.6 * q.T, 1.1 * ahead[0] if ahead else 0.0), 0.999 * wide, 6 * q.T)


def course(q: SpragInputs) -> tuple[Array, Any]:
    one = built(q)
    last = at_torque(one.clutch, reach(q))
    top = float(last.N) if np.isfinite(last.N) else one.N_top
    N = top * np.linspace(LEAST, 1.0, POINTS)
    return N, wedged(one.clutch, N)


def force(q: SpragInputs) -> Curves:
    N, now = course(q)
    top = float(N[-1]) / 1e3
    rigid = wedged(built(q).clutch.rigid_races(), N)
    curves = [
        line("sprags of this clutch", now.T, N / 1e3),
        dashes("rigid races (Liu)", rigid.T, N / 1e3, 4),
        dots("T", [q.T], np.interp([q.T], now.T, N) / 1e3, 5),
    ]  # fmt: skip
    curves += [
        dashes(limit.words, limit.at, [0.0, top], 1 + k)
        for k, limit in enumerate(x for x in as_torque_grows(q) if x.at <= now.T[-1])
    ]  # fmt: skip
    return plot("Normal force of a sprag and its limits", "T [N m]", "N [kN]", curves,
                y_bottom=0.0)  # fmt: skip


def pressures(q: SpragInputs, context: Context) -> Curves:
    now = under(q)
    assert now is not None
    y = ((np.arange(q.slices) + 0.5) / q.slices - 0.5) * q.l * 1e3
    curves = []
    for k, (contact, race) in enumerate(zip(built(q).pressed(float(now.N)), ("inner", "outer"),
                                            strict=True)):  # fmt: skip
        curves.append(line(f"slices, {race} race", y, contact.peak_pressure / 1e6, 2 * k))
        if context.fem:
            found = context.fem[0].arrays
            curves.append(dots(f"strips, {race} race", found["strips, y"] * 1e3,
                               found[f"strips, {'io'[k]}"] / 1e6, 2 * k))  # fmt: skip
    return plot(
        "Pressure along the sprags under T", "y [mm]", "p [MPa]", curves, y_bottom=0.0,
        note="The pressure at a loaded end is unbounded: it grows with the number of slices.",
    )  # fmt: skip


def turned(q: SpragInputs) -> Curves:
    N, now = course(q)
    one = built(q)
    rigid = one.clutch.rigid_races()
    return plot(
        "Sprag rotation and wind-up of the races", "T [N m]", "[°]",
        line("sprags, α", now.T, now.alpha_b * DEGREE),
        dashes("sprags, Eqs. 9 and 10 as printed", now.T,
               printed.wedged(one.clutch, N).alpha_b * DEGREE, 2),
        dashes("sprags, rigid races (Liu)", wedged(rigid, N).T, wedged(rigid, N).alpha_b * DEGREE,
               4),
        line("races, θ", now.T, rolled(one.clutch, N) * DEGREE, 1), y_bottom=0.0,
    )  # fmt: skip


def yields(q: ClutchFormulas) -> Bars:
    parts = ((q.d_BI, "inner race"), (q.d_HI, "inner contact"), (q.d_g, "sprag"),
             (q.d_HE, "outer contact"), (q.d_BE, "outer race"))  # fmt: skip
    return Bars(
        title="Deflections of the parts", label="deflection [µm]",
        items=tuple((name, d * 1e6, f"{d * 1e6:.3g} µm, {d / q.H:.0%}") for d, name in parts),
        note=f"The sum of {q.H * 1e6:.4g} µm rotates the sprags by {q.alpha * DEGREE:.3g}°.",
    )  # fmt: skip


def off(q: SpragInputs) -> Curves:
    far = np.linspace(-20e-6, 20e-6, 41)
    found = {name: np.array([first_contact(q.sprag, **{f"d{name}": float(x)}) for x in far])
             for name in ("R_i", "R_e")}  # fmt: skip
    return plot(
        "Sensitivity to the radii of the races", "deviation of the radius [µm]",
        "rotation of the unloaded sprags [°]",
        (line(name, far * 1e6, found[name][:, 1] * DEGREE, 2 * k) for k, name in enumerate(found)),
        y_bottom=None,
        note="The wedge angle remains between "
        f"{min(f[:, 0].min() for f in found.values()) * DEGREE:.4g}° and "
        f"{max(f[:, 0].max() for f in found.values()) * DEGREE:.4g}°.",
    )  # fmt: skip


def counted(context: Context) -> Curves:
    found = context.fem[-1].arrays
    n, p = found["flat, counts"], found["flat, peaks"] / 1e6
    return plot(
        "Peak pressure of an engagement without a crown, 25 N m", "slices", "p_max [MPa]",
        line("inner race", n, p), dots("computed", n, p),
        dashes("printed, about 3500", n[[0, -1]], 3500.0, 2), y_bottom=0.95 * float(p.min()),
        note="The peak pressure grows without limit as the number of slices increases; the paper "
        "does not print how many slices it uses.",
    )  # fmt: skip


def pairs(context: Context) -> Curves:
    """Figure of peak pressures over torque: computed and printed, with and without a crown."""
    found = context.fem[-1].arrays
    T = np.array([25.0, 40.0])
    flat, best = np.array([found["pair 25"], found["pair 40"]]).T / 1e6
    return plot(
        "Peak pressure, calibrated at 25 N m, predicted at 40 N m", "T [N m]", "p_max [MPa]",
        line("no crown", T, flat), line("optimal crowns", T, best, 2),
        dots("printed, no crown", T, [3500.0, 4700.0]),
        dots("printed, optimal crowns", T, [2980.0, 3400.0], 2), y_bottom=2500.0,
        note="The force at 40 N m divided by the force at 25 N m must be 1.8 according to the "
        "pressures printed without a crown and 1.3 according to those printed with the optimal "
        "crowns. The computed ratio is "
        f"{float(found['N_max'][1] / found['N_max'][0]):.3g}.",
    )  # fmt: skip
