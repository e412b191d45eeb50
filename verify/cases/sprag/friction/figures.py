"""Figures of friction: locking, check of the time step, friction law of Eq. 13."""

import math
from collections.abc import Sequence

import numpy as np

from analytic.sprag.friction import coefficient
from analytic.sprag.sliding import sliding
from verify.cases.sprag.friction.reference import BANDS, NARROW, STEPS
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Context
from verify.core.figures import Array, Curve, Figure, Map, Sketch, Zone, Zones
from verify.form import sketches
from verify.form.plots import dashes, dots, line, plot
from verify.form.sketches import arrow, shape, text

ms, kN = 1e-3, 1e3
FASTEST = 5.0  # sliding speeds of the law's curve over gamma_b
EARLY = 40  # displayed steps after the start, in which a contact comes to rest or not
FINE = 141  # torques in the map
HIGH = 0.3  # largest friction of the map


def sketch(q: EngagementInputs) -> Sketch:
    """Sketch of a sprag between its races, drawn straight, with forces and driving direction."""
    turn = np.linspace(0, 2 * math.pi, 91)
    lean = 0.35
    body = np.column_stack([0.42 * np.cos(turn), 1.0 * np.sin(turn)]) @ np.array(
        [[math.cos(lean), math.sin(lean)], [-math.sin(lean), math.cos(lean)]]
    )
    top, low = float(body[:, 1].max()), float(body[:, 1].min())
    above, below = body[np.argmax(body[:, 1])], body[np.argmin(body[:, 1])]
    up, right = np.array([0.0, 1.0]), np.array([1.0, 0.0])

    def race(y: float, way: float) -> Array:
        return np.array([[-2, y], [2, y], [2, y + 0.5 * way], [-2, y + 0.5 * way]])

    shapes = (
        shape("body", race(top, 1)), shape("body", race(low, -1)), shape("modelled", body),
        arrow(above, below, style="axis"), arrow(above + 0.9 * up, above, "N"),
        arrow(below - 0.9 * up, below, "N"),
        arrow(above + 0.12 * up - 1.1 * right, above + 0.12 * up - 0.1 * right, "T_e"),
        arrow(below - 0.12 * up + 1.1 * right, below - 0.12 * up + 0.1 * right, "T_i"),
        text((-1.3, low - 0.8), "inner race, driven ←"), text((1.3, top + 0.8), "outer race, held"),
    )  # fmt: skip
    return sketches.sketch(
        "forces on a sprag; the races are drawn straight. N acts along the radius, the friction "
        "forces T_i and T_e are at most μN. The resultant acts along the dash-dotted line AB, "
        f"whose angle to the radius is ν = {math.degrees(q.nu_0):.3g}° (drawn larger)",
        shapes,
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    found: list[Figure] = [law(context.inputs), slides(context)]
    if not context.converging:
        return found
    found += [zones(context), wrong(context), speeds(context)]
    guard = context.fem[-1].arrays["guard"]
    return [*found, *(guarded(context, factor) for factor in np.unique(guard[:, 0]))]


def law(q: EngagementInputs) -> Figure:
    """Figure of the friction coefficient of Eq. 13, and of the required friction coefficient."""
    v = np.linspace(0, FASTEST / q.gamma_b, 201)
    tan = math.tan(q.nu_0)
    return plot(
        "Friction over the sliding speed (Eq. 13)", "v [m/s]", "μ",
        line("μ_d", v, coefficient(v, mu_c=q.mu_c, mu_s=q.mu_s, gamma_b=q.gamma_b)),
        dashes("tan ν_0, required friction coefficient", v, tan, 1),
        note="If μ_d exceeds the required coefficient, sliding sprags stick again; otherwise they "
        "continue to slide.",
    )  # fmt: skip


def slides(context: Context) -> Figure:
    """Figure of the normal force of sliding sprags, driven and overrunning, over μ."""
    q, w = context.inputs, context.inputs.wedge
    curves: list[Curve] = []
    for words, share in (
        ("driven", np.linspace(0.02, 0.97, 96)), ("overrunning", np.linspace(-3, -0.02, 96)),
    ):  # fmt: skip
        N = np.array([sliding(w, float(s * q.tan_0)).N for s in share])
        held = np.isfinite(N)
        curves.append(line(f"closed form, {words}", share[held], N[held], len(curves)))
    if context.fem:
        last = context.fem[-1].values
        curves.append(dots("Runge-Kutta steps", [0.9, -q.mu_s / q.tan_0],
                           [last["N_slides"], last["N_overruns"]], 2))  # fmt: skip
    return plot(
        "Normal force of sprags that slide",
        "μ/tan ν_0, negative where the race overruns", "N [N]", curves, y_top=float(2 * q.N_slides),
        note="The springs cause the normal force, and friction multiplies it by 1/(1 − μ/tan ν): "
        "the force increases if the clutch is driven, where μ is positive, and decreases if it "
        "overruns, where μ is negative. Between the curves no steady sliding exists.",
    )  # fmt: skip


def zones(context: Context) -> Figure:
    """Figure of the regions of stick and slip over torque and μ, for weak springs."""
    coarse = context.fem[-1].arrays["map"].T
    T = np.linspace(coarse[0, 0], coarse[0, -1], FINE)
    firm, _, weak, most = (np.interp(T, coarse[0], column) for column in coarse[1:])
    tan = context.inputs.tan
    return Zones(
        title="Stick and slip with weak springs", x_label="T [N m]", y_label="μ/tan ν", x=T,
        y_top=HIGH / tan,
        zones=(
            Zone(name="slips permanently", top=weak / tan, tone="bad"),
            Zone(name="slips first, then locks", top=np.minimum(most, HIGH) / tan, tone="fair"),
            Zone(name="locks without slip", top=np.full_like(T, HIGH / tan), tone="good"),
        ),
        curves=(dashes("lower limit of locking, springs of the inputs", T, firm / tan),),
        note="The springs have the stiffness K_r/25, μ_s = μ_c = μ, the torque is a step, and ν is "
        "the wedge angle under T. The sprags slip first because the step accelerates the race "
        "before the springs have built up N. With the springs of the inputs, the zone \"slips "
        "first, then locks\" is very small.",
    )  # fmt: skip


def wrong(context: Context) -> Figure:
    """Figure of N(t) with the automatic speed band, and with a band that is too narrow."""
    last = context.fem[-1].arrays
    return plot(
        "Force with a band too narrow for the time step, without check", "t [ms]", "N [kN]",
        line("automatic band, equal to LSODA", last["t"] / ms, last["right N"] / kN),
        line(f"D_V = {NARROW:g} m/s, without check", last["wrong t"] / ms, last["wrong N"] / kN, 1),
        note="The torque is 1.6 T, the springs are weak. Nothing in the curve without check of the "
        "time step indicates the error. With other round-off errors, the curve may be quite "
        "different.",
    )  # fmt: skip


def speeds(context: Context) -> Figure:
    """Figure of the sliding speed at the start, with the automatic and the narrow speed band."""
    last = context.fem[-1].arrays
    t = last["fine t"][:EARLY] / ms
    return plot(
        "Sliding speed at the start, and the speed band in which contacts stick", "t [ms]",
        "v_i [m/s]",
        line("automatic band", t, last["right v"][:EARLY]),
        dots(f"D_V = {NARROW:g} m/s", t, last["wrong v"][:EARLY], 1),
        dashes("the narrow band", t, NARROW, 2), dashes("", t, -NARROW, 2),
        y_bottom=float(min(last["wrong v"][:EARLY].min(), 0.0)),
        note="A time step changes v_i by several times the width of the narrow band. The speed "
        "therefore skips the band repeatedly, and the sign of friction alternates.",
    )  # fmt: skip


def guarded(context: Context, factor: float) -> Figure:
    """Map of the error of N_max over speed bands and time steps; rejected pairs are marked."""
    guard, q = context.fem[-1].arrays["guard"], context.inputs
    chosen = guard[guard[:, 0] == factor].reshape(len(STEPS), len(BANDS), -1)
    return Map(
        title="Error of N_max without the check of the time step, "
        f"{factor * q.T:.3g} N m, weak springs",
        x_label="D_V [m/s]", y_label="time step [µs]",
        columns=tuple(f"{D_V:g}" for D_V in BANDS),
        rows=tuple(f"{step * q.dt * 1e6:g}" for step in STEPS),
        error=chosen[:, :, 4], limits=(0.01, 0.1, 0.5), checked=chosen[:, :, 3] == 1,
        checked_name="rejected by the check",
        note="Errors in per cent, relative to a run with one fifth of the time step and an "
        "automatic band. The check rejects time steps that are too long for the band.",
    )  # fmt: skip
