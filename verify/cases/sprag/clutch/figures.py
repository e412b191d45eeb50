"""What the report shows of a sprag clutch: its course under torque, its pressures, its limits."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import at_torque, wedged
from analytic.sprag.course import rolled
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.model import built, first_contact, under
from verify.cases.sprag.clutch.sketch import sketch
from verify.cases.sprag.inputs import SpragInputs
from verify.core.case import Context, Values
from verify.core.figures import Array, Bars, Curve, Curves, Equation, Figure
from verify.core.tex import tex

__all__ = ["equations", "figures", "sketch"]
DEGREE = math.degrees(1.0)
POINTS = 121
LEAST = 1e-3  # of the largest force of a figure


def equations(q: SpragInputs, v: Values) -> Sequence[Equation]:
    found = [
        Equation(
            tex=r"OC_e^2 = R_i^2 + \rho_0^2 + \frac{2 R_i\,\rho_0}{\sqrt{1+m^2}}, \quad "
            r"\rho_0 = \frac{r_i}{\sqrt{1+m^2}}",
            numbers=rf"m = {tex(v['m'], 5)} \Rightarrow OC_e = {tex(v['OC_e'] * 1e3, 6)}, \quad "
            rf"r_e = {tex(v['r_e'] * 1e3, 5)}\ \mathrm{{mm}}", place="Eq. 10, at first contact",
        ),
        Equation(
            tex=r"\beta = \arctan m - \eta, \quad "
            r"\tan\nu = \frac{OB\sin\beta}{OB\cos\beta - OA}, \quad \omega = \nu - \beta",
            numbers=rf"\nu_0 = {tex(v['nu_0'] * DEGREE, 5)}°, \quad "
            rf"\omega_0 = {tex(v['omega_0'] * DEGREE, 5)}°", place="Eq. 10",
        ),
    ]  # fmt: skip
    if "N" not in v:
        return found
    return (
        *found,
        Equation(
            tex=r"H = \delta_{BI} + \delta_{HI} + \delta_g + \delta_{BE} + \delta_{HE}",
            numbers=" + ".join(tex(v[k] * 1e6, 4) for k in ("d_BI", "d_HI", "d_g", "d_BE", "d_HE"))
            + rf" = {tex(v['H'] * 1e6, 4)}\ \mathrm{{µm}}", place="Eqs. 2 to 7",
        ),
        Equation(
            tex=r"\alpha = \frac{1}{m}\ln\frac{\rho}{\rho_0} - (\eta - \eta_0)",
            numbers=rf"= {tex(v['alpha'] * DEGREE, 5)}°",
            place="Eq. 10, corrected, with the deflections of the whole inner side",
        ),
        Equation(
            tex=r"T = n_s N \tan\nu\;OA",
            numbers=rf"{tex(q.T)} = {q.z}\cdot {tex(v['N'], 6)}\cdot {tex(v['mu_req'], 5)}"
            rf"\cdot {tex(v['OA'], 5)}, \quad \frac{{\mu_s}}{{\tan\nu}} = {tex(v['safety'], 4)}",
            place="statics of Eqs. 14 and 16",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    if under(q) is None:
        return ()
    found: list[Figure] = [force(q), pressures(q, context), turned(q), yields(context), off(q)]
    measured = context.fem[-1].arrays if context.fem else {}
    if "fitted" in measured and np.isfinite(measured["fitted"]).all():
        found += [counted(context), pairs(context)]
    return found


def reach(q: SpragInputs) -> float:
    """The largest torque [N m] of figures: a little past the first limit ahead."""
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
        Curve(name="sprags of this clutch", x=now.T, y=N / 1e3),
        Curve(name="rigid races (Liu)", x=rigid.T, y=N / 1e3, style="dashes", colour=4),
        Curve(name="T", x=np.array([q.T]), y=np.interp([q.T], now.T, N) / 1e3, style="dots",
              colour=5),
    ]  # fmt: skip
    curves += [
        Curve(name=limit.words, x=np.full(2, limit.at), y=np.array([0.0, top]), style="dashes",
              colour=1 + k)
        for k, limit in enumerate(x for x in as_torque_grows(q) if x.at <= now.T[-1])
    ]  # fmt: skip
    return Curves(title="Normal force of a sprag and what ends it", x_label="T [N m]",
                  y_label="N [kN]", curves=tuple(curves), y_bottom=0.0)  # fmt: skip


def pressures(q: SpragInputs, context: Context) -> Curves:
    now = under(q)
    assert now is not None
    y = ((np.arange(q.slices) + 0.5) / q.slices - 0.5) * q.l * 1e3
    curves = []
    for k, (contact, race) in enumerate(zip(built(q).pressed(float(now.N)), ("inner", "outer"),
                                            strict=True)):  # fmt: skip
        curves.append(Curve(name=f"slices, {race} race", x=y, y=contact.peak_pressure / 1e6,
                            colour=2 * k))  # fmt: skip
        if context.fem:
            found = context.fem[0].arrays
            curves.append(Curve(name=f"strips, {race} race", x=found["strips, y"] * 1e3,
                                y=found[f"strips, {'io'[k]}"] / 1e6, style="dots",
                                colour=2 * k))  # fmt: skip
    return Curves(
        title="Pressure along the sprags under T", x_label="y [mm]", y_label="p [MPa]",
        curves=tuple(curves), y_bottom=0.0,
        note="The pressure at a loaded end is unbounded: it grows with the number of parts.",
    )  # fmt: skip


def turned(q: SpragInputs) -> Curves:
    N, now = course(q)
    one = built(q)
    rigid = one.clutch.rigid_races()
    return Curves(
        title="Turn of the sprags and of the races", x_label="T [N m]", y_label="[°]",
        curves=(
            Curve(name="sprags, α", x=now.T, y=now.alpha_b * DEGREE),
            Curve(name="sprags, Eqs. 9 and 10 as printed", x=now.T, style="dashes", colour=2,
                  y=printed.wedged(one.clutch, N).alpha_b * DEGREE),
            Curve(name="sprags, rigid races (Liu)", x=wedged(rigid, N).T, style="dashes", colour=4,
                  y=wedged(rigid, N).alpha_b * DEGREE),
            Curve(name="races, θ", x=now.T, y=rolled(one.clutch, N) * DEGREE, colour=1),
        ), y_bottom=0.0,
    )  # fmt: skip


def yields(context: Context) -> Bars:
    v = context.analytic
    names = (("d_BI", "inner race"), ("d_HI", "inner contact"), ("d_g", "sprag"),
             ("d_HE", "outer contact"), ("d_BE", "outer race"))  # fmt: skip
    return Bars(
        title="Deflections of the parts", label="deflection [µm]",
        items=tuple((name, v[key] * 1e6, f"{v[key] * 1e6:.3g} µm, {v[key] / v['H']:.0%}")
                    for key, name in names),
        note=f"Together {v['H'] * 1e6:.4g} µm, which turn the sprags by "
        f"{v['alpha'] * DEGREE:.3g}°.",
    )  # fmt: skip


def off(q: SpragInputs) -> Curves:
    far = np.linspace(-20e-6, 20e-6, 41)
    found = {name: np.array([first_contact(q, **{f"d{name}": float(x)}) for x in far])
             for name in ("R_i", "R_e")}  # fmt: skip
    return Curves(
        title="Sensitivity to the radii of the races", x_label="radius off by [µm]",
        y_label="turn of the unloaded sprags [°]", y_bottom=None,
        curves=tuple(
            Curve(name=name, x=far * 1e6, y=found[name][:, 1] * DEGREE, colour=2 * k)
            for k, name in enumerate(found)
        ),
        note="The wedge angle itself stays between "
        f"{min(f[:, 0].min() for f in found.values()) * DEGREE:.4g}° and "
        f"{max(f[:, 0].max() for f in found.values()) * DEGREE:.4g}°.",
    )  # fmt: skip


def counted(context: Context) -> Curves:
    found = context.fem[-1].arrays
    n, p = found["flat, counts"], found["flat, peaks"] / 1e6
    return Curves(
        title="Peak of an engagement without a crown, 25 N m", x_label="slices",
        y_label="p_max [MPa]",
        curves=(
            Curve(name="inner race", x=n, y=p),
            Curve(name="computed", x=n, y=p, style="dots"),
            Curve(name="printed, about 3500", x=n[[0, -1]], y=np.full(2, 3500.0), style="dashes",
                  colour=2),
        ), y_bottom=0.95 * float(p.min()),
        note="It has no limit; the paper does not print its number of slices.",
    )  # fmt: skip


def pairs(context: Context) -> Curves:
    """Computed and printed pressures of both pairs, over the torque."""
    found = context.fem[-1].arrays
    T = np.array([25.0, 40.0])
    flat, best = np.array([found["pair 25"], found["pair 40"]]).T / 1e6
    return Curves(
        title="Calibrated at 25 N m, predicted at 40 N m", x_label="T [N m]",
        y_label="p_max [MPa]", y_bottom=2500.0,
        curves=(
            Curve(name="no crown", x=T, y=flat), Curve(name="best crowns", x=T, y=best, colour=2),
            Curve(name="printed, no crown", x=T, y=np.array([3500.0, 4700.0]), style="dots"),
            Curve(name="printed, best crowns", x=T, y=np.array([2980.0, 3400.0]), style="dots",
                  colour=2),
        ),
        note="The printed pairs ask for force ratios of 1.8 and 1.3; the clutch's is "
        f"{float(found['N_max'][1] / found['N_max'][0]):.3g}.",
    )  # fmt: skip
