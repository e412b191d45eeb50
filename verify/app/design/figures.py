"""Figures of a spring design: causes of rejection, feasible region, Pareto front, F(U)."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from reports.design import Picture
from reports.design_plots import Bars, Parallel, Region
from verify.core import units
from verify.core.figures import Curve, Curves
from verify.studies.design.compressed import PARTS
from verify.studies.design.front import scaled
from verify.studies.design.outcome import Outcome
from verify.studies.design.records import violations
from verify.studies.design.search import Search

MOST_DOTS = 600
MOST_CELLS = {"L1": 60, "r": 30}
NAMES = {
    "e_max": "|U_w − Δ|/Δ", "ratio_min": "U_w/L_0 too small", "ratio_max": "U_w/L_0 too large",
    "wedge": "wedge", "margin": "point A", "sigma": "stress", "z_max": "L_0/b",
    "room": "height", "k_band": "tolerance", "sway": "buckling", "shape": "no spring",
}  # fmt: skip


def figures(outcome: Outcome) -> list[Picture]:
    """All figures that can be drawn; without a feasible spring, there is no front and no curve."""
    s = outcome.search
    if outcome.chosen is None:
        at = s.nearest[0].candidate if s.nearest else 0
        return [reasons(s), region(s, at, "nearest")]
    return [
        curve(outcome), scatter(outcome), front(outcome), region(s, outcome.candidate, "chosen"),
        reasons(s),
    ]  # fmt: skip


def reasons(s: Search) -> Bars:
    """Bars with the number of candidates that violate each limit."""
    counts = {key: count for key, count in violations(s).items() if count or key != "shape"}
    return Bars(
        title="Why candidates are rejected", names=tuple(NAMES[key] for key in counts),
        counts=tuple(counts.values()), total=len(s.springs),
        note=f"Number of the {len(s.springs):,} candidates that violate each limit; most violate "
        "several limits.",
    )  # fmt: skip


def region(s: Search, i: int, name: str) -> Region:
    """Map of the number of violated limits over L1 and r, for n, b and alpha of candidate `i`."""
    g = s.springs
    same = (g.n == g.n[i]) & (g.b == g.b[i]) & (g.alpha == g.alpha[i])
    r, L1 = _thinned(g.r, i, MOST_CELLS["r"]), _thinned(g.L1, i, MOST_CELLS["L1"])
    count = np.where(s.judged.possible, s.judged.violations.sum(axis=0), -1)
    shown: Mapping[Any, int] = {
        (r_i, l_i): int(c) for r_i, l_i, c in zip(g.r[same], g.L1[same], count[same], strict=True)
    }
    return Region(
        title="Where springs are feasible", x_label="L_1 [mm]", y_label="r [mm]",
        columns=tuple(float(x) * 1e3 for x in L1), rows=tuple(float(x) * 1e3 for x in r),
        violated=np.array([[shown[r_i, l_i] for l_i in L1] for r_i in r]),
        mark=(int(np.flatnonzero(r == g.r[i])[0]), int(np.flatnonzero(g.L1[i] == L1)[0])),
        mark_name=name,
        note=f"All candidates with n = {g.n[i]}, b = {g.b[i] * 1e3:.4g} mm and "
        f"α = {g.alpha[i] / units.factor('deg'):.4g}°: number of limits that each violates.",
    )  # fmt: skip


def _thinned(parameter: Any, i: int, most: int) -> Any:
    """At most `most` evenly distributed values of a parameter, including that of candidate `i`."""
    values, keep = np.unique(parameter), parameter[i]
    if len(values) <= most:
        return values
    chosen = set(np.round(np.linspace(0, len(values) - 1, most - 1)).astype(int).tolist())
    return values[sorted(chosen | {int(np.flatnonzero(values == keep)[0])})]


def scatter(outcome: Outcome) -> Curves:
    """Plot of the stress over the free length, for all feasible springs and for the front."""
    s = outcome.search
    feasible = np.flatnonzero(s.judged.feasible)
    if len(feasible) > MOST_DOTS:
        feasible = feasible[np.linspace(0, len(feasible) - 1, MOST_DOTS).astype(int)]
    x, y = s.formulas.L0 * 1e3, s.formulas.stress / 1e6
    groups = (
        ("feasible", feasible, 4),
        ("front", s.members, 0),
        ("chosen", [outcome.candidate], 2),
    )
    low, high = y[feasible].min(), y[feasible].max()
    return Curves(
        title="Stress over free length", x_label="L_0 [mm]", y_label="σ [MPa]",
        curves=tuple(Curve(name=name, x=x[which], y=y[which], style="dots", colour=colour)
                     for name, which, colour in groups),
        y_bottom=float(low - 0.08 * ((high - low) or 0.1 * high)),
        note="Members of the front that are not best in these two objectives are better in their "
        "margin to point A or in their stiffness.",
    )  # fmt: skip


def front(outcome: Outcome) -> Parallel:
    """Plot of the members of the Pareto front over all objectives."""
    s = outcome.search
    goals = s.objectives[s.members]
    shown = np.stack(
        [goals[:, 0] / 1e6, goals[:, 1] * 1e3, 100 * (-goals[:, 2] - 1), 100 * goals[:, 3]], axis=1
    )
    best, worst = goals.argmin(axis=0), goals.argmax(axis=0)
    forms = ("{:.0f} MPa", "{:.2f} mm", "{:.0f} %", "{:.2g} %")
    kept = [v.agrees and v.fits for v in outcome.verified] or [True] * len(goals)
    return Parallel(
        title="Pareto front", axes=("σ", "L_0", "U_A/U_w − 1", "|k_1/k_w − 1|"),
        ends=tuple((form.format(shown[b, j]), form.format(shown[w, j]))
                   for j, (form, b, w) in enumerate(zip(forms, best, worst, strict=True))),
        lines=scaled(goals), kept=tuple(kept), chosen=outcome.chosen or 0,
        note="One line per spring; the best value of each axis is at the top. No line is higher "
        "than another on all axes.",
    )  # fmt: skip


def curve(outcome: Outcome) -> Curves:
    """Plot of F(U) of the selected spring: formula, finite elements, working point."""
    s, i = outcome.search, outcome.candidate
    q, f = s.task.demands, s.formulas
    U_A, F_A, k1, k2, U_w = (float(v[i]) for v in (f.U_A, f.F_A, f.k1, f.k2, f.U_w))
    end = 1.15 * max(U_A, U_w)
    U = np.array([0.0, U_A, end])
    F = np.array([0.0, F_A, F_A + k2 * (end - U_A)])
    drawn = [Curve(name="closed form", x=U * 1e3, y=F, colour=0)]
    if q.b_tolerance:
        for sign in (1, -1):
            share = (1 + sign * q.b_tolerance / float(s.springs.b[i])) ** 3
            name = "with the strip's tolerance" if sign == 1 else ""
            drawn.append(Curve(name=name, x=U * 1e3, y=F * share, style="dashes", colour=0))
    touching = ""
    if (large := outcome.curve) is not None:
        if np.isfinite(large.touches):
            before = large.touches - U_w / PARTS
            touching = (
                f" By finite elements, the leaves touch between {before * 1e3:.4g} and "
                f"{large.touches * 1e3:.4g} mm."
            )
        if not large.whole:
            touching += " The curve of the finite elements ends where no equilibrium was found."
        name = "finite elements, large displacements"
        drawn.append(Curve(name=name, x=large.U * 1e3, y=large.F, style="dots", colour=1))
    drawn.append(
        Curve(
            name="working point of the task",
            x=np.array([U_w * 1e3]),
            y=np.array([q.F_w]),
            style="dots",
            colour=2,
        )
    )
    return Curves(
        title="Force over displacement of the chosen spring", x_label="U [mm]", y_label="F [N]",
        curves=tuple(drawn),
        note=f"By the closed form, the leaves touch at U_A = {U_A * 1e3:.4g} mm, F_A = "
             f"{F_A:.4g} N; the stiffness is "
        f"k_1 = {k1 / 1e3:.4g} N/mm below U_A and k_2 = {k2 / 1e3:.4g} N/mm above." + touching,
    )  # fmt: skip
