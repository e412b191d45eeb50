"""Figures of a clutch between two rotors: sketch, stiffness curves."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch_state import under_torque
from verify.cases.freewheel.star_sketch import arc, label, ray
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.cases.rotor.clutch.reference import OFFSETS, TORQUES
from verify.core.case import Context
from verify.core.figures import Curves, Figure, Sketch
from verify.form import sketches
from verify.form.plots import curve, dashes, dots, line, plot
from verify.form.sketches import arrow, leader, shape, text

um = 1e-6
THIN = 201  # slices, enough for a smooth curve when slices leave contact


def sketch(q: SpragLink) -> Sketch:
    """Sketch of both races, to scale; each sprag is a line that is inclined by nu."""
    h = q.R_i * math.sin(q.nu)
    turn = q.nu - math.asin(h / q.R_e)
    # seen against +z: angles count from x on, counter-clockwise
    ends = [
        np.vstack([q.R_i * ray(math.pi / 2 - psi), q.R_e * ray(math.pi / 2 - psi - turn)])
        for psi in q.angles()
    ]
    first, R = ends[1], 1.35 * q.R_e
    beyond = first[0] + (first[1] - first[0]) * (R - q.R_i) / (q.R_e - q.R_i)
    out = first[0] / np.hypot(*first[0])
    # names above and below: a narrow page has no space for them next to the races
    named = (
        ((-0.85, 1.5), q.R_e * ray(-0.6), label("R_e", q.R_e)),
        ((0.1, 1.5), ends[q.Z // 4].mean(axis=0), f"ν = {math.degrees(q.nu):.4g}°"),
        ((-0.7, -1.5), q.R_i * ray(-2.5), label("R_i", q.R_i)),
        ((0.5, -1.5), 0.6 * q.R_i * ray(2.4), f"T = {q.T:.4g} N m"),
    )
    shapes = (
        shape("body", arc(1.25 * q.R_e, 0, 2 * math.pi)), shape("hole", arc(q.R_e, 0, 2 * math.pi)),
        shape("body", arc(q.R_i, 0, 2 * math.pi)), *(shape("line", end) for end in ends),
        arrow((-1.1 * q.R_e, 0.0), (1.45 * q.R_e, 0.0), style="axis"),
        arrow(np.zeros(2), R * out, style="axis"), arrow(first[0], beyond, style="axis"),
        text((1.55 * q.R_e, 0.0), "x"), text(1.55 * q.R_e * out, "ψ_j"),
        shape("load", arc(0.6 * q.R_i, 2.4, 0.6)),
        *(leader(q.R_e * np.array(start), tip, name) for start, tip, name in named),
    )  # fmt: skip
    return sketches.sketch(
        f"{q.Z} sprags between the races, to scale. Each line connects both contacts of a sprag; "
        f"its angle to the radius at the inner race is {math.degrees(q.nu):.4g}°.",
        shapes,
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    return _over_torque(context), _over_offset(context), _over_crown(context), _over_gap(context)


def _over_torque(context: Context) -> Curves:
    q = context.inputs
    T = np.geomspace(0.01, 2.0, 81) * q.T
    k = uniform.contact_stiffness(N=uniform.normal_force(T=T, Z=q.Z, d_t=q.d_t), k_n=q.k_n)
    curves = [
        line("K_xx, K_yy, K_zz and K_tilt: tenth root of torque", T, k / q.k),
        dots("the given torque", q.T, 1.0),
    ]  # fmt: skip
    if context.fem:
        solved = np.array(TORQUES) * q.T
        for number, key in enumerate(("K_xx", "K_zz"), start=1):
            y = context.fem[-1].arrays[f"{key} over T"] / getattr(q, key)
            curves.append(dots(f"{key}, struts", solved, y, number))
    return plot(
        "Stiffness over torque", "T [N m]", "K(T)/K", curves,
        note="Without torque the clutch has no stiffness; the stiffness increases fast at first, "
             "then slowly.",
    )  # fmt: skip


def _over_offset(context: Context) -> Curves:
    q = context.inputs
    clutch = q.clutch()
    dx = np.linspace(0, 2 * max(q.e, 0.75 * q.delta_0), 61)
    K = np.array([
        clutch.stiffness(under_torque(clutch, T=q.T, offset=(one, 0, 0, 0)))[0, 4] for one in dx
    ])  # fmt: skip
    curves = [
        line("Eq. 8, not linearised", dx / um, K),
        dashes("first order in the offset", dx / um, q.K_xz_first * dx / q.e, 1),
    ]  # fmt: skip
    if context.fem:
        y = context.fem[-1].arrays["K_xz over offset"]
        x = np.array(OFFSETS) * q.e / um
        curves.append(dots("struts", x, y, 2))
    return plot(
        "Coupling of bending and torsion over a static offset", "Δx [µm]", "K_xz [N]", curves,
        note="The coupling is zero without offset. If the offset exceeds the deflection of a "
             f"sprag, {q.delta_0 / um:.4g} µm, sprags lose contact one after the other, and K_xz "
             "increases in steps.",
    )  # fmt: skip


def _relative(K: Any, whole: Any) -> dict[str, Any]:
    """Entries of K over those of `whole`; the coupling over √(K_xx K_zz) of `whole`."""
    across = math.sqrt(whole[0, 0] * whole[4, 4])
    return {
        "K_xx": K[0, 0] / whole[0, 0], "K_yy": K[1, 1] / whole[1, 1],
        "K_tilt": K[3, 3] / whole[3, 3], "K_zz": K[4, 4] / whole[4, 4],
        "|K_xz|/√(K_xx K_zz)": abs(K[0, 4]) / across,
    }  # fmt: skip


def _entries(
    q: SpragLink, changed: Sequence[SpragLink], *, n_s: int | None = None, **parts: bool
) -> dict[str, Any]:
    plain = q.clutch(n_s=n_s)
    whole = plain.stiffness(under_torque(plain, T=q.T))
    rows = []
    for one in changed:
        clutch = one.clutch(n_s=n_s, **parts)
        rows.append(_relative(clutch.stiffness(under_torque(clutch, T=q.T)), whole))
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def _over_crown(context: Context) -> Curves:
    q = context.inputs
    drop = np.linspace(0, max(2 * q.drop, q.delta_0), 31)
    changed = [q.model_copy(update={"drop": float(d)}) for d in drop]
    found = _entries(q, changed, n_s=THIN, crowned=True)
    return plot(
        "Stiffness over the drop of the crown", "drop at the ends [µm]", "K/K(no crown)",
        line("K_xx", drop / um, found["K_xx"]), line("K_tilt", drop / um, found["K_tilt"], 1),
        # dots, as the curve lies on that of K_xx
        dots("K_zz", drop[::3] / um, found["K_zz"][::3], 2),
        note="The torque is the same for all crowns. A crown mainly reduces the tilting stiffness, "
             "because the crown unloads the ends of the sprags.",
    )  # fmt: skip


def _over_gap(context: Context) -> Curves:
    q = context.inputs
    most = min(q.Z - 3, max(q.Z // 2, q.missing))
    counts = np.arange(1, most + 1)
    found = _entries(q, [q.model_copy(update={"missing": int(m)}) for m in counts], gap=True)
    return plot(
        "Stiffness over the number of missing sprags", "missing sprags", "K/K(all sprags)",
        # dots, as the curve lies on that of K_xx
        (curve(name, counts.astype(float), y, "dots" if name == "K_tilt" else "line", number)
         for number, (name, y) in enumerate(found.items())),
        note="The missing sprags are adjacent and symmetric to the x-axis. Bearings hold the "
             "inner race concentric.",
    )  # fmt: skip
