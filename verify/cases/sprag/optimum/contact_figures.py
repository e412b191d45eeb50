"""Figures of the contact pressure: along the sprag, over the number of slices, over time."""

from collections.abc import Sequence

import numpy as np

from analytic.contact import crown
from analytic.sprag.pressure import along
from verify.cases.sprag.clutch.drawn_fem import places
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.engagement.model import crowned_for, gap
from verify.cases.sprag.engagement.pressures import over_time
from verify.cases.sprag.optimum.crown_claims import CELLS, STRIPPED, series
from verify.cases.sprag.optimum.ends_fem import SLICED
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.cases.sprag.peaks import with_crown
from verify.cases.sprag.statements import measured
from verify.core.case import Context
from verify.core.figures import Array, Curves, Figure
from verify.form.plots import curve, dashes, dots, line, plot

MPa, mm, um = 1e6, 1e-3, 1e-6
BELOW, ABOVE = 0.6, 1.4  # range of the pressure axis over the largest pressure by slices


def names(context: Context) -> dict[str, str]:
    """Displayed names, by key, of the crowns whose contacts were solved."""
    hand = "printed crown" if context.is_paper else "given crown"
    found = {
        "best": "optimal crown by slices",
        "at hand": hand,
        "free": "optimal crown with unloaded ends",
    }
    return {key: name for key, name in found.items() if f"{key}: R" in measured(context)}


def contact(context: Context) -> Sequence[Figure]:
    """Figures of the pressure along the sprag by slices, strips and cells, one for each crown."""
    found, q = measured(context), context.inputs
    figures = []
    for key, name in names(context).items():
        p = found[f"{key}: pressures"][0] / MPa
        K_1, K_2, z_m = found[f"{key}: crown"]
        n, cells = STRIPPED[-1], CELLS[-1]
        figures.append(plot(
            f"Pressure along the sprag, {name}", "y from mid-length [mm]", "p [MPa]",
            line(f"{cells} cells of a half-space", outer(q, cells) / mm,
                 half(found[f"{key}: cells {cells}"]) / MPa, 2),
            dashes(f"{n} strips", outer(q, n) / mm, half(found[f"{key}: strips {n}"]) / MPa, 4),
            dots(f"{q.slices} slices", outer(q, q.slices) / mm, half(p)),
            y_bottom=BELOW * float(p.max()), y_top=ABOVE * float(p.max()),
            note=f"(K_1, K_2, z_m) = ({K_1:.3g}, {K_2:.3g}, {z_m / um:.3g} µm), N_max = "
            f"{found[f'{key}: N_max'][0]:.0f} N."
            + cut(ABOVE * float(p.max()), *(float(found[f"{key}: {part}"].max()) / MPa
                                            for part in (f"cells {cells}", f"strips {n}"))),
        ))  # fmt: skip
    return figures


def cut(top: float, *highest: float) -> str:
    """Remark that pressures exceed the end `top` [MPa] of the axis; empty if none exceeds it."""
    above = max(highest)
    return f" The largest pressure, {above:.0f} MPa, is beyond the axis." if above > top else ""


def half(values: Array) -> Array:
    """The part of `values` from mid-length to one end."""
    return np.asarray(values[len(values) // 2 :])


def outer(q: OptimumInputs, n: int) -> Array:
    """Centres [m] of slices, strips or cells (n on the full length), from mid-length to an end."""
    return half(places(q, n))


def at_counts(context: Context) -> Curves:
    """Figure of the largest pressure over the number of slices, strips and cells."""
    curves = []
    for k, (key, name) in enumerate(names(context).items()):
        for by, style, counts, p in (
            ("slices", "line", SLICED, measured(context)[f"{key}: sliced"]),
            ("strips", "dashes", STRIPPED, np.array(series(context, key, "strips", "peak"))),
            ("cells", "dots", CELLS, np.array(series(context, key, "cells", "peak"))),
        ):
            curves.append(curve(f"{name}, {by}", np.log2(counts), p / MPa, style, 2 * k))
    low = min(float(c.y.min()) for c in curves)
    return plot(
        "Largest pressure over the number of slices, strips and cells", "number along the sprag",
        "p_max [MPa]", curves,
        y_bottom=0.97 * low, y_top=ABOVE * low,
        x_names=tuple((float(np.log2(n)), str(n)) for n in (*SLICED, *CELLS)),
        note="The largest pressure converges only for crowns with unloaded ends."
        + cut(ABOVE * low, *(float(c.y.max()) for c in curves)),
    )  # fmt: skip


def apart(context: Context) -> Curves:
    """Figure of the drops of several crowns, from mid-length to the end of the sprag."""
    q = context.inputs
    y = np.linspace(0, q.l / 2, 121)
    curves = []
    for k, (key, name) in enumerate(names(context).items()):
        K_1, K_2, z_m = measured(context)[f"{key}: crown"]
        drop = crown.logarithmic(
            y, K_1=K_1, K_2=K_2, z_m=z_m, load=crowned_for(q), length=q.l,
            E_star=float(built(q).parts.E_star),
        )  # fmt: skip
        curves.append(line(name, y / mm, drop / um, 2 * k))
    return plot(
        "Drop of the crowns", "y from mid-length [mm]", "drop [µm]", curves, y_bottom=0.0,
        note="The drop is zero in the straight middle, which has the length (1 − K_2) l, and "
        "increases to z_m at the end.",
    )  # fmt: skip


def before_and_after(context: Context) -> Sequence[Figure]:
    """Figures of p(y, t) without a crown and with the optimal crown (Figs. 16, 18)."""
    found, q = measured(context), context.inputs
    printed = f" (Fig. {18 if q.T_less else 16}{{}})" if context.is_paper else ""
    designs = {"before": None, "after": found["best"]}
    planes: dict[str, Array] = {}
    for name, design in designs.items():
        mine = with_crown(q, design)
        planes[name] = along(
            found[f"{name} N"], gap(mine), length=q.l, R=float(found["best: R"]),
            E_star=float(built(q).parts.E_star),
        )  # fmt: skip
    top = max(float(p.max()) for p in planes.values())
    peaks = {"before": found["none: pressures"][0], "after": found["best: pressures"][0]}
    return tuple(
        over_time(
            found[f"{name} t"], p, q, top,
            title=("Without a crown" if name == "before" else "With the optimal crown by slices")
            + printed.format(part),
            note=f"{q.slices} slices; the largest pressure is {peaks[name].max() / MPa:.0f} MPa. "
            "Both figures have the same colour scale.",
        )
        for part, (name, p) in zip("ab", planes.items(), strict=True)
    )  # fmt: skip
