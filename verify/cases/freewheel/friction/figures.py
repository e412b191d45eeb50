"""Figures of a freewheel's friction: cone, onset of slip, slip beyond the limit."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.freewheel import criterion
from analytic.freewheel.state import loaded
from fem.wedge.slip_limit import HELD
from verify.core.case import Context
from verify.core.figures import Curves, Figure, Sketch, Table
from verify.form import sketches
from verify.form.plots import dashes, dots, line, plot
from verify.form.sketches import arrow, leader, shape, text

mm, µm = 1e-3, 1e-6
QUARTER = np.linspace(0.0, np.pi / 2, 91)
STARTED = 0.999  # torque over T below which the ring slides
GRID = np.linspace(0.0, 1.6, 81)[1:]  # torques over T for the curve of the limit
WIDE, CIRCLE = 2.2, 1.7  # over r: half-length of the drawn walls, radius of the cone's circle
ABOVE = 2.2  # upper end of the axial load, over F_ax,lim or F_ax


def sketch(q: Any) -> Sketch:
    """Sketch: roller between flat and ring; friction force in the circle of radius mu F_n."""
    state = loaded(q.clutch, q.T)
    psi, tan = float(state.psi), math.tan(float(state.alpha))
    ray, along = np.array([math.sin(psi), math.cos(psi)]), np.array([math.cos(psi), -math.sin(psi)])
    up, right = np.array([0.0, 1.0]), np.array([1.0, 0.0])
    turn = np.linspace(0.0, 2 * np.pi, 121)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    cone = np.array([WIDE + CIRCLE + 1.2, 0.0])
    used = min(tan * math.hypot(1.0, q.lever) / q.mu, 1.4)
    tip = cone + CIRCLE * used * np.array([1.0, q.lever]) / math.hypot(1.0, q.lever)
    return sketches.sketch(
        "left: forces of star and ring on a roller under torque, with the ring drawn as a straight "
        "line. Right: at each contact, the resultant of the tangential force F_t and the axial "
        "force F_a must lie within the friction circle of radius μ F_n",
        shape("body", circle),
        arrow((WIDE, -1.0), (-WIDE, -1.0), style="clamp"),
        shape("clamp", ray + WIDE * np.array([-along, along])),
        arrow(-2.2 * up, -up, "F_n"),
        arrow(2.2 * ray, ray, "F_n"),
        arrow(-0.7 * up - 1.7 * right, -0.7 * up, "F_t"),
        arrow(0.7 * ray - 1.7 * along, 0.7 * ray, "F_t"),
        text((0.0, 0.0), "F_a"),
        shape("faint", cone + CIRCLE * circle),
        (shape("axis", cone + 1.2 * CIRCLE * np.array([-axis, axis])) for axis in (right, up)),
        arrow(cone, tip),
        leader(cone + 1.45 * CIRCLE * (right + up) / 1.4142, tip, "μ_req F_n"),
        leader(cone + 1.4 * CIRCLE * (right - up) / 1.4142, cone + CIRCLE * (right - up) / 1.4142,
               "μ F_n"),
        text(cone + 1.4 * CIRCLE * right, "F_t"),
        text(cone + 1.4 * CIRCLE * up, "F_a"),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    last, q = context.fem[-1].arrays, context.inputs
    found = [_cone(q, last), _limit(context), _path(q, last), _let_out(q, last), _shares(last)]
    if len(last["angles"]):
        found.append(_angles(last))
    return tuple(found)


def _cone(q: Any, last: Any) -> Curves:
    angles, creep = last["angles"], last["creep"] / q.mu
    slid = angles[angles[:, 3] > 0] if len(angles) else np.zeros((0, 7))
    N, F_t, F_z = last["loaded"]
    return plot(
        "Friction forces of a contact, and friction cone", "F_t/(μ F_n)", "F_a/(μ F_n)",
        line("friction cone, Eq. 8", np.cos(QUARTER), np.sin(QUARTER)),
        dashes("FE, ring driven along the axis", creep[:, 2:4].mean(axis=1),
               np.abs(creep[:, 4:6]).mean(axis=1), 1),
        dots(f"FE, F_ax = {q.F_ax:g} N", (F_t / N / q.mu)[1:], np.abs(F_z / N / q.mu)[1:], 1),
        dots("FE, slipping, clutches that differ in X",
             slid[:, 3::2].ravel(), slid[:, 4::2].ravel(),
             2),
        note="F_t/F_n is tan α at any F_a: as the axial load increases, the point moves vertically "
             "to the cone.",
    )  # fmt: skip


def _limit(context: Context) -> Curves:
    q, v = context.inputs, context.analytic
    T = GRID * q.T
    alpha = loaded(q.clutch, T).alpha
    limits = {k: criterion.largest_axial_load(alpha=alpha, T=T, R=q.R, mu=q.mu / k)
              for k in (criterion.GREEN, criterion.RED)}  # fmt: skip
    fe = context.fem[-1].values
    return plot(
        "Limit of the axial load of a locked clutch", "T [N m]", "F_ax [N]",
        line("μ_req = μ: green below", T, limits[criterion.GREEN]),
        dashes("μ/μ_req = 0.8: red above", T, limits[criterion.RED], 2),
        dots("FE, slips", q.T, fe["F_lim"]),
        dots("given loads", q.T, q.F_ax, 1),
        y_top=ABOVE * max(v.get("F_lim", 0.0), q.F_ax),
        note="The class limits 0.8 and 1.0 of μ/μ_req follow from the paper's tests; 1.0 is also "
             "the limit of Coulomb's law.",
    )  # fmt: skip


def _path(q: Any, last: Any) -> Curves:
    creep, out = last["creep"], last["let_out"]
    tan = creep[0, 2:4].mean()
    full = math.sqrt(q.mu**2 - tan**2)
    turned = creep[-1, 1] + (out[-1, 0] - creep[-1, 0]) * tan / full
    return plot(
        "Slip beyond the limit, ring driven along the axis", "u_z [µm]",
        "(F_a/F_n)/limit; T/(T before slip)",
        line("F_a/F_n, ring held", out[:, 0] / µm, np.abs(out[:, 4:6]).mean(axis=1) / full),
        line("T, ring held", out[:, 0] / µm, out[:, 7], 1),
        dots("F_a/F_n, constant torque", creep[::2, 0] / µm,
             np.abs(creep[::2, 4:6]).mean(axis=1) / full),
        dots("T, constant torque", creep[1::2, 0] / µm, creep[1::2, 7], 1),
        note=f"A constant torque rotates the ring: its bore moves by {turned / µm:.3g} µm in the "
             f"circumferential direction during an axial slip of {out[-1, 0] / µm:.3g} µm. If the "
             "ring is held against rotation, the rollers are released. Under constant torque, both "
             "plotted ratios remain at 1; their marks are drawn alternately.",
    )  # fmt: skip


def _let_out(q: Any, last: Any) -> Curves:
    u, T = q.slipped()
    out = last["let_out"]
    start = np.interp(-STARTED, -out[:, 7], out[:, 0])  # before that the parts only deform
    return plot(
        "Remaining torque over axial slip, ring held against rotation",
        "axial slip [µm]",
        "T/(T before slip)",
        line("Coulomb's law and equilibrium", u[::-1] / µm, T[::-1]),
        dots("FE", (out[:, 0] - start).clip(0) / µm, out[:, 7]),
        note="During slip, the clamping angle is constant in the finite elements and decreases in "
             "the formula.",
    )  # fmt: skip


def _shares(last: Any) -> Curves:
    k, star, ring = last["shares"]
    share = last["onset"][0] if math.isfinite(last["onset"][0]) else 1.0
    return plot(
        "Share of the normal force on slipping nodes, torque alone", "tan α/μ",
        "share of F_n on slipping nodes",
        dots("FE, star", 1 / k, star),
        dots("FE, ring", 1 / k, ring, 1),
        dashes("both contacts slip: the roller is released",
               np.array([1.0, 1.0]) / share, [0.0, 1.0], 2),
        note="As tan α/μ increases, more nodes slip, from the edge of the contact inwards. In the "
             "finite elements, the roller is placed between the races in one step. A torque that "
             "increases gradually from zero causes less slip.",
    )  # fmt: skip


def _angles(last: Any) -> Curves:
    k, left, ratio = last["angles"].T[:3]
    stays, unit = left > HELD, np.array([0.0, 1.0])
    return plot(
        "Used friction under torque alone, clutches that differ in X", "tan α/μ",
        "F_t/(μ F_n)",
        line("F_t = F_n tan α", unit, unit),
        dots("FE, held", k[stays], ratio[stays]),
        dots("FE, released: F_n is zero", k[~stays], ratio[~stays], 2),
        note="All clutches have the same approaches of the contacts.",
    )  # fmt: skip


def tables(q: Any, context: Context) -> Sequence[Table]:
    """Table that describes the states of the clutch by finite elements."""
    if not context.converging:
        return ()
    last, v = context.fem[-1].arrays, context.fem[-1].values
    k, star, ring = last["shares"]
    rows = [
        (f"torque alone, μ = {k[i]:g} tan α",
         f"at rest; slipping nodes carry {star[i]:.0%} of F_n on the star and {ring[i]:.0%} of "
         "F_n on the ring")
        for i in (k.size - 1, 0)
    ]  # fmt: skip
    if math.isfinite(last["onset"][0]):
        rows.append((
            f"torque alone, μ below {last['onset'][0]:.5f} tan α",
            "slips; both contacts slip completely, and the roller is released from the wedge",
        ))  # fmt: skip
    holds = "at rest" if v["F_lim"] >= q.F_ax else "slips along the axis"
    rows.append(
        (f"T, F_ax = {q.F_ax:g} N, μ = {q.mu:g}", f"{holds}; F_ax at slip is {v['F_lim']:.5g} N")
    )
    creep, out = last["creep"], last["let_out"]
    rows.append((
        "ring driven along the axis at constant torque",
        f"slips; F_t, F_n and F_a are constant, and the circumferential creep of the ring is "
        f"{v['creep']:.3f} times its axial slip",
    ))  # fmt: skip
    rows.append((
        "ring driven along the axis and held against rotation",
        f"slips; the rollers are gradually released: {1 - out[-1, 7]:.0%} of the torque is lost "
        f"after an axial slip of {out[-1, 0] / µm:.3g} µm" if len(out) > 1
        else f"slips; {len(creep)} steps were computed",
    ))  # fmt: skip
    return (Table(title="States by finite elements", header=("load", "state"), rows=tuple(rows)),)
