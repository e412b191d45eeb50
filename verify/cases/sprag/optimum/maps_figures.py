"""Figures of the largest pressure over the parameters of the crown (Figs. 15, 17)."""

from collections.abc import Sequence

import numpy as np

from analytic.sprag.crown_surrogate import held
from verify.cases.sprag.optimum.comparisons import FLAT
from verify.cases.sprag.statements import measured
from verify.core.case import Context
from verify.core.figures import Curves, Density, Figure
from verify.form.plots import dashes, dots, line, plot

MPa, um, PERCENT = 1e6, 1e-6, 100
ABOVE = 4.0  # % above the lowest pressure, upper end of the axis of the figure over K_1


def figure(context: Context) -> str:
    """Format string for the number of the paper's figure; empty if inputs are not the paper's."""
    if not context.is_paper:
        return ""
    return " (Fig. 17{})" if context.inputs.T_less else " (Fig. 15{})"


def maps(context: Context) -> Sequence[Figure]:
    """Maps of the largest pressure over K_1 and K_2, and over K_1 and z_m, by the surrogate."""
    found, q = measured(context), context.inputs
    both = {"K_2": found["map K_1, K_2"], "z_m": found["map K_1, z_m"]}
    top = (min(float(z.min()) for z in both.values()) / MPa,
           max(float(z.max()) for z in both.values()) / MPa)  # fmt: skip
    notes = {"K_2": f"z_m = {held(q.box, 2) / um:g} µm.", "z_m": f"K_2 = {held(q.box, 1):g}."}
    return tuple(
        Density(
            title="Largest pressure of the engagement" + figure(context).format(part),
            x_label="K_1", y_label="K_2" if key == "K_2" else "z_m [µm]", z_label="Pre_max [MPa]",
            x=found["K_1"], y=found[key] / (um if key == "z_m" else 1.0), z=z.T / MPa, range=top,
            note=f"{notes[key]} Values of the surrogate. Both maps have the same colour scale.",
        )
        for part, (key, z) in zip("ab", both.items(), strict=True)
    )  # fmt: skip


def lines(context: Context) -> Curves:
    """Figure of p_max over K_1 for several z_m, by surrogate and by computed engagements."""
    found, q = measured(context), context.inputs
    true, K_1 = found["true K_1, z_m"][0], np.linspace(q.K_1_low, q.K_1_high, q.levels)
    z_m = np.linspace(q.z_m_low, q.z_m_high, q.levels)
    curves = []
    for k, drop in enumerate(z_m[:6]):
        near = int(np.argmin(np.abs(found["z_m"] - drop)))
        curves += [
            line(f"z_m = {drop / um:g} µm", found["K_1"], found["map K_1, z_m"][:, near] / MPa, k),
            dots("", K_1, true[:, k] / MPa, k),
        ]  # fmt: skip
    return plot(
        f"Largest pressure over K_1 at K_2 = {held(q.box, 1):g}", "K_1", "Pre_max [MPa]", curves,
        y_bottom=0.98 * float(true.min()) / MPa,
        note="Lines: surrogate, fitted without designs at this K_2. Dots: computed "
        "engagements.",
    )  # fmt: skip


def valley(context: Context) -> Curves:
    """Figure of the lowest pressure over K_1, with optimal K_2 and z_m, near the optimum."""
    found, q = measured(context), context.inputs
    over = found["whole"].min(axis=(1, 2))
    curves = [line(f"{q.T:g} N m", found["K_1"], PERCENT * (over / over.min() - 1))]
    if "less over K_1" in found:
        less = found["less over K_1"]
        curves.append(line(f"{q.T_less:g} N m", found["K_1"], PERCENT * (less / less.min() - 1), 2))
    p = float(found["at hand: pressures"][0].max())
    best = float(found["best true"][0])
    wide = np.array([found["K_1"][0], found["K_1"][-1]])
    curves += [
        dots("N_max/Q", found["Lundberg"][:1], [PERCENT * (found["Lundberg"][3] / best - 1)], 3),
        dots("printed" if context.is_paper else "given", q.K_1, PERCENT * (p / best - 1), 5),
        dashes(f"{FLAT:.1%}", wide, PERCENT * FLAT, 4),
    ]  # fmt: skip
    return plot(
        "Flatness of the optimum", "K_1", "p_max above the lowest [%]", curves, y_bottom=-0.2,
        y_top=ABOVE, note="Values of the surrogate; K_2 and z_m are optimal for each K_1.",
    )  # fmt: skip
