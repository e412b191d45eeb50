"""Figures of the pressures of an engagement, over time and along the sprag."""

from collections.abc import Sequence

import numpy as np

from analytic.sprag.pressure import along
from verify.cases.sprag.engagement.model import gap, in_slices, parts
from verify.cases.sprag.engagement.reference import drawn
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Context
from verify.core.figures import Array, Density, Figure
from verify.form.plots import curve, plot

ms, MPa, mm = 1e-3, 1e6, 1e-3


def pressures(context: Context) -> Sequence[Figure]:
    """Figures for each crown to be drawn: pressures at three instants, p(y, t) on both races."""
    found: list[Figure] = []
    last = context.fem[-1].arrays
    planes = {
        (name, race): along(last[f"{name}drawn N"], gap(q), length=q.l, R=float(R),
                            E_star=float(parts(q).E_star))
        for name, q in drawn(context.inputs).items() for race, R in radii(q)
    }  # fmt: skip
    top = max(float(p.max()) for p in planes.values())
    for name, q in drawn(context.inputs).items():
        found.append(moments(last["N"], name, q))
        found += [
            over_time(
                last["drawn t"], planes[name, race], q, top,
                title=f"Pressure on the {race} race{_part(name)}",
                note=f"(K_1, K_2, z_m) = {_crown(q)}. All these figures have one colour scale.",
            ) for race, _ in radii(q)
        ]  # fmt: skip
    return found


def over_time(
    t: Array, p: Array, q: EngagementInputs, top: float, *, title: str, note: str
) -> Density:
    """Figure of the pressures p [Pa], (times, slices), over t [s], coloured from 0 to `top`."""
    return Density(
        title=title, x_label="t [ms]", y_label="y [mm]", z_label="p [MPa]", x=t / ms,
        y=centres(q) / mm, z=p.T / MPa, range=(0.0, top / MPa), note=note,
    )  # fmt: skip


def centres(q: EngagementInputs) -> Array:
    """Positions of the slices along the sprag [m]."""
    return (np.arange(q.slices) + 0.5) / q.slices * q.l - q.l / 2


def radii(q: EngagementInputs) -> tuple[tuple[str, Array], ...]:
    """Names of both races and relative radii [m] of their contacts."""
    whole = parts(q)
    return ("inner", whole.R_contact_i), ("outer", whole.R_contact_e)


def moments(N: Array, name: str, q: EngagementInputs) -> Figure:
    """Figure of the pressure along the sprag at the start, first peak and next minimum of N(t)."""
    top = int(np.argmax(N[: len(N) // 2]))
    trough = top + int(np.argmin(N[top : top + max(len(N) // 4, 2)]))
    loads = np.array([0.02 * N[top], N[top], max(N[trough], 1e-3 * N[top])])
    curves = []
    for (race, R), style in zip(radii(q), ("line", "dashes"), strict=True):
        p = in_slices(q, gap(q), float(R), loads).peak_pressure
        for colour, (words, one) in enumerate(
            zip(("2 % of the peak force", "first force peak", "next force minimum"), p, strict=True)
        ):
            curves.append(curve(f"{words}, {race}", centres(q) / mm, one / MPa, style, colour))
    return plot(
        f"Pressure at three instants{_part(name)}", "y [mm]", "p [MPa]", curves,
        note=f"{q.slices} slices, (K_1, K_2, z_m) = {_crown(q)}. Under a small force the "
        "straight middle is loaded; according to the paper, the ends are loaded first.",
    )  # fmt: skip


def _part(name: str) -> str:
    return f" (Fig. 13, part {name.strip()})" if name else ""


def _crown(q: EngagementInputs) -> str:
    return f"({q.K_1:g}, {q.K_2:g}, {q.z_m / mm:g} mm)"
