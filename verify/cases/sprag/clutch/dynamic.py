"""Engagement of a clutch in time: its first peak, and whether the clutch locks."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.sprag import pressure
from analytic.sprag.balance import balance
from analytic.sprag.closure import wedged
from analytic.sprag.history import Phase
from analytic.sprag.readings import slid
from analytic.sprag.steps import missing
from verify.cases.sprag.clutch.dynamic_messages import findings, overall
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.run_fem import Run, run_fem
from verify.cases.sprag.engagement import pressures
from verify.core.case import Dynamic, Output, Values
from verify.core.figures import Curves, Density, Figure
from verify.form.plots import dashes, line, plot

DEGREE = math.degrees(1.0)
DRAWN, ACROSS = 4000, 240  # points of a curve, moments of p(y, t)
ATOM = 1e-10  # m, below which a sliding distance is round-off


def run(q: ClutchFormulas, _values: Values) -> Values:
    found = run_fem(q)
    e = found.engagement
    slips, energies = slid(e), balance(e)
    M = e.table.n_s * e.T_i * e.table.at(e.alpha)["OA"]
    values = {
        "N_max": e.N_max, "slid_i": slips[0] if slips[0] > ATOM else 0.0,
        "slid_o": slips[1] if slips[1] > ATOM else 0.0,
        "friction": float(energies.friction[-1]), "damping": float(energies.damping[-1]),
        "work": float(energies.torque[-1]), "missing": missing(e),
        "theta_max": float((e.theta_i - e.theta_e).max()), "M_max": float(np.nanmax(M)),
        "D_V": e.D_V, "t_slip": float(e.dt * (e.phases == Phase.SLIP).any(axis=1).sum()),
    }  # fmt: skip
    if e.followed:
        values["p_i_max"], values["p_o_max"] = found.peaks
        values["t_max"] = e.peak[0]
    if e.verdict == "locks":
        values["peak_factor"] = e.peak_factor
    return {key: value for key, value in values.items() if math.isfinite(value)}


def output(key: str, symbol: str, unit: str, what: str) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=False)


OUTPUTS = (
    output("N_max", "N_max", "N", "largest normal force of a sprag"),
    output("peak_factor", "N_max/N", "1", "peak factor: ratio of N_max to N at rest (no springs)"),
    output("t_max", "t_max", "ms", "time of the largest normal force"),
    output("M_max", "M_max", "N m", "largest torque that the sprags carry"),
    output("theta_max", "θ_max", "deg", "largest wind-up of the races"),
    output("p_i_max", "p_i,max", "MPa", "largest pressure at the inner race, by slices"),
    output("p_o_max", "p_o,max", "MPa", "largest pressure at the outer race, by slices"),
    output("t_slip", "t_s", "ms", "time during which a contact slides"),
    output("slid_i", "s_i", "mm", "sliding distance of the inner contacts"),
    output("slid_o", "s_o", "mm", "sliding distance of the outer contacts"),
    output("work", "W", "J", "work of the torque"),
    output("friction", "W_μ", "J", "part of W dissipated by friction"),
    output("damping", "W_c", "J", "part of W dissipated by damping"),
    output("missing", "ΔW/W", "1", "error of the balance of energies"),
    output("D_V", "D_V", "m/s", "band of sliding speeds in which contacts may stick"),
)


def summary(q: ClutchFormulas, v: Values) -> dict[str, Any]:
    """Results for JSON: verdict of the engagement; `peak_factor`, None without locking."""
    return {"verdict": run_fem(q).engagement.verdict, "peak_factor": v.get("peak_factor")}


def figures(q: ClutchFormulas, v: Values) -> Sequence[Figure]:
    found = run_fem(q)
    e = found.engagement
    thin = slice(None, None, max(1, len(e.t) // DRAWN))
    t = e.t[thin] * 1e3
    static = (
        []
        if not math.isfinite(e.N_static)
        else [dashes("at rest under T (Eq. 14, no springs)", t[[0, -1]], e.N_static / 1e3, 4)]
    )
    force = plot(
        "Normal force of a sprag", "t [ms]", "N [kN]", line("engagement", t, e.N[thin] / 1e3),
        static, y_bottom=0.0,
        note=f"Largest {v['N_max'] / 1e3:.4g} kN at {e.peak[0] * 1e3:.4g} ms.",
    )  # fmt: skip
    loaded = e.N[thin] > 0.05 * e.N_max
    asked = np.abs(e.T_i[thin][loaded]) / e.N[thin][loaded]
    friction = plot(
        "Friction used by the inner contacts", "t [ms]", "T_i/N",
        line("T_i/N while N exceeds 5 % of N_max", t[loaded], asked),
        dashes("μ_s", t[[0, -1]], q.mu_s, 2), y_bottom=0.0,
        note="If T_i/N reaches μ_s, the contact slides.",
    )  # fmt: skip
    return force, along(q, found), *over_time(q, found), friction


def over_time(q: ClutchFormulas, found: Run) -> tuple[Density, ...]:
    """Figures of p(y, t) on both races, computed with the contact radii under the largest force."""
    e, one = found.engagement, found.one
    every = slice(None, None, max(1, len(e.t) // ACROSS))
    planes = [
        pressure.along(e.N[every], one.gap, length=q.l, R=R, E_star=float(one.parts.E_star))
        for R in one.radii(wedged(one.clutch, e.N_max))
    ]
    top = max(float(p.max()) for p in planes)
    return tuple(
        pressures.over_time(
            e.t[every], p, q, top, title=f"Pressure on the {race} race",
            note="The figures of both races have one colour scale.",
        ) for p, race in zip(planes, ("inner", "outer"), strict=True)
    )  # fmt: skip


def along(q: ClutchFormulas, found: Run) -> Curves:
    """Figure of the pressure along the sprags: inner race at four forces, outer race at N_max."""
    y = pressures.centres(q) * 1e3
    curves = []
    for k, share in enumerate((0.05, 0.25, 0.5, 1.0)):
        N = share * found.engagement.N_max
        inner, outer = found.one.pressed(N)
        curves.append(line(f"inner, {share:g} N_max", y, inner.peak_pressure / 1e6, k))
    curves.append(dashes("outer, N_max", y, outer.peak_pressure / 1e6, 3))
    return plot("Pressure along the sprags up to the peak force", "y [mm]", "p [MPa]", curves,
                y_bottom=0.0)  # fmt: skip


DYNAMIC = Dynamic(
    run=run, outputs=OUTPUTS, what="the engagement", findings=findings, summary=summary,
    figures=figures, overall=overall,
)  # fmt: skip
