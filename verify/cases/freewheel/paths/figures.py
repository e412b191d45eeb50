"""Figures of a freewheel on the rig's load paths."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.freewheel.course import Course
from analytic.freewheel.criterion import RED
from verify.cases.freewheel.paths.reference import LOUD, OTHERS, QUIET
from verify.core.case import Context
from verify.core.figures import Curve, Curves, Figure, Table, Zone, Zones
from verify.form.plots import curve, dashes, dots, line, plot

Array = NDArray[np.float64]

NAMES = {
    1: "load case 1 (steady torque, growing axial load)",
    2: "load case 2 (steady torque, alternating axial load)",
    3: "load case 3 (torque and axial load alternate in phase)",
}
HIGH = 1.15  # upper end of the axis over the largest value
NEAR = 0.9  # friction cone drawn from this multiple of tan(alpha_0)
CUT = 4.0  # required friction is drawn up to this multiple of mu
DRAWN = 8  # steps of a path's times that a curve is drawn over: 30 points a cycle


def tables(q: Any, context: Context) -> Sequence[Table]:  # noqa: ARG001
    """Table of the three load cases."""
    rows = []
    for case, course in q.courses.items():
        slip = course.slips_at
        peak = short(course.peak) if np.isfinite(course.peak) else None
        rows.append((
            NAMES[case], peak, short(course.when), short(course.mu / course.peak), course.light,
            short(slip) if np.isfinite(slip) else "holds",
        ))  # fmt: skip
    return (
        Table(
            title="The three load cases",
            header=("path", "largest μ_req", "at t [s]", "μ/μ_req", "class", "slips at t [s]"),
            rows=tuple(rows),
            note="The class limits of Sec. 7 are used as printed and not derived. By Coulomb's law "
                 "the clutch slips as soon as μ/μ_req is below 1.",
        ),
    )  # fmt: skip


def short(value: float) -> float:
    """The number rounded to six significant digits."""
    return float(f"{value:.6g}")


def figures(context: Context) -> Sequence[Figure]:
    found: list[Figure] = [loads(context, case) for case in NAMES]
    found += [classes(context, case) for case in NAMES]
    if context.converging:
        found += [plane(context), creeping(context), walked(context)]
    return found


def loads(context: Context, case: int) -> Curves:
    course, q = context.inputs.courses[case], context.inputs
    return plot(
        f"Loads, {NAMES[case]}", "t [s]", "T and F_ax, relative to the values in the legend",
        line(f"T/({q.T_peak if case == 3 else q.T:.4g} N m)", course.t[::DRAWN],
             course.T[::DRAWN] / (q.T_peak if case == 3 else q.T)),
        line(f"F_ax/({q.F_ax:.4g} N)", course.t[::DRAWN], course.F_ax[::DRAWN] / q.F_ax, 2),
        y_bottom=None,
    )  # fmt: skip


def classes(context: Context, case: int) -> Zones:
    """Figure of mu_req over time, with the zones of the classes."""
    course, q = context.inputs.courses[case], context.inputs
    finite = course.mu_req[np.isfinite(course.mu_req)]
    top = HIGH * max(min(float(finite.max()), CUT * q.mu), q.mu / RED)
    across = np.linspace(0, q.duration, 101)
    flat = np.ones(across.size)
    curves = [
        line("μ_req" if first else "", t, np.minimum(y, 0.999 * top))
        for first, t, y in _pieces(course)
    ]
    slip = course.slips_at
    point = (slip, q.mu, f"slips at {slip:.3f} s") if np.isfinite(slip) else None
    return Zones(
        title=f"Required friction, {NAMES[case]}", x_label="t [s]", y_label="μ_req", y_top=top,
        x=across,
        zones=(
            Zone(name="green: holds, μ ≥ μ_req", top=q.mu * flat, tone="good"),
            Zone(name="yellow", top=q.mu / RED * flat, tone="fair"),
            Zone(name="red", top=top * flat, tone="bad"),
        ),
        curves=tuple(curves), point=point,
        note=f"μ = {q.mu:g}. After slip, the curve continues as if the clutch still held. "
        + ("In the gaps of the curve, the torque is negative and the clutch "
           "overruns." if np.isnan(course.mu_req).any() else ""),
    )  # fmt: skip


def _pieces(course: Course) -> list[tuple[bool, Array, Array]]:
    """Times and mu_req of each interval without overrunning, with True for the first one."""
    known = ~np.isnan(course.mu_req)
    starts = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(int)))
    return [
        (k == 0, course.t[a:b:DRAWN], course.mu_req[a:b:DRAWN])
        for k, (a, b) in enumerate(starts.reshape(-1, 2))
        if b - a > DRAWN
    ]


def plane(context: Context) -> Curves:
    """Figure of the three paths in the plane of F_t/N and F_a/N."""
    q, last = context.inputs, context.fem[-1].arrays
    widest = np.arccos(NEAR * np.tan(float(q.cam.alpha0)) / q.mu)
    turn = np.linspace(-widest, widest, 181)
    curves = [
        dashes(f"friction cone, μ = {q.mu:g}", q.mu * np.cos(turn), q.mu * np.sin(turn), 3),
    ]  # fmt: skip
    for case, colour, drawn in ((2, 2, "line"), (1, 0, "dashes"), (3, 1, "line")):
        curves += _path(q.courses[case], q.R, f"load case {case}", colour, drawn)
    for name, colour, of in (
        ("growing", 2, "axial load peaks, load case 2"),
        ("ramp", 0, "load case 1"),
    ):
        table = last[name]
        curves.append(dots(f"FE, {of}", table[:, 1:3].mean(axis=1), table[:, 3], colour))
    return plot(
        "F_a/F_n over F_t/F_n along the load paths, up to slip", "F_t/F_n", "F_a/F_n",
        curves,
        y_bottom=-q.mu,
        note="Under a steady torque, F_t/F_n = tan α is constant, and the path is a vertical line "
             "that ends on the friction cone. Load case 1 covers the upper half of the line of "
             "load case 2. In load case 3, F_t/F_n varies between tan α_0 and tan α(T).",
    )  # fmt: skip


def _path(course: Course, R: float, name: str, colour: int, drawn: str) -> list[Curve]:
    """Curves of a path up to slip, one for each interval in which the clutch is locked."""
    found: list[Curve] = []
    for _, t, mu_req in _pieces(course):
        held = t <= course.slips_at
        at = np.searchsorted(course.t, t[held])
        if at.size < 2 or not np.all(np.isfinite(mu_req[held])):
            continue
        tan, loaded = np.tan(course.alpha[at]), course.T[at] > 0
        found.append(curve("" if found else name, tan[loaded],
                           tan[loaded] * course.F_ax[at][loaded] * R / course.T[at][loaded], drawn,
                           colour))  # fmt: skip
    return found


def creeping(context: Context) -> Curves:
    """Figure of the creep of the ring (rotation times R) in each cycle of constant amplitude."""
    own, others = context.fem[-1].arrays["cycles"], context.fem[-1].arrays["walks"]
    found = [(QUIET, own[0]), (LOUD, own[1]), *zip(OTHERS, others, strict=True)]
    colours = (1, 0, 2, 3)
    curves = [
        curve(f"{share:g} of the limit" if style == "dots" else "", np.arange(1.0, 1 + walk.size),
              walk * 1e9, style, colours[k])
        for k, (share, walk) in enumerate(sorted(found, key=lambda w: w[0]))
        for style in ("dots", "line")
    ]  # fmt: skip
    return plot(
        "Ratcheting of the ring under an alternating axial load, finite elements", "cycle",
        "R Δφ in one cycle [nm]", curves,
        x_names=tuple((k, f"{k:g}") for k in range(1, own.shape[1] + 1)),
        note="The limit is the axial load at slip; torque and normal force are constant. At "
             "amplitudes up to 0.6 of the limit, the creep decreases from cycle to cycle. At 0.8 "
             "of the limit, no part of the contacts sticks throughout a cycle, and the ring "
             "rotates further in every cycle, although μ always exceeds μ_req. Each half cycle is "
             "one load step; with four load steps per half cycle, the rotation is a fifth smaller.",
    )  # fmt: skip


def walked(context: Context) -> Curves:
    """Figure of the fraction of F_n that slipping nodes carry, at peaks of the axial load."""
    last = context.fem[-1].arrays
    return plot(
        "Share of the normal force on slipping nodes, up to slip, finite elements", "|F_ax|/F_lim",
        "share of F_n on slipping nodes",
        line("load case 1", last["ramp"][:, 0], last["ramp"][:, 7]),
        dots("axial load peaks, load case 2", np.abs(last["growing"][:, 0]), last["growing"][:, 7],
             2),
        note="The torque alone requires most of the available friction, so that only a small part "
             "of the contacts sticks even without axial load.",
    )  # fmt: skip
