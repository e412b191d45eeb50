"""Figures of a wedged sprag."""

import math
from collections.abc import Sequence

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import Wedged, wedged
from verify.cases.freewheel.star_sketch import arc
from verify.cases.sprag.wedge.formulas import WedgeFormulas
from verify.cases.sprag.wedge.reference import GRID
from verify.cases.sprag.wedge.sketch import outline
from verify.core.case import Context
from verify.core.figures import Array, Bars, Curve, Curves, Figure, Panel, Profile, Shapes
from verify.form.plots import curve, dots, line, plot
from verify.judging.profiles import along

FINE = np.linspace(0.005, 1.88, 94)  # forces of the curves over N_0
DEGREE = math.degrees(1.0)
DRAWN = (0.0, 0.5, 1.0, 1.8)  # of N_0


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    states = wedged(q.clutch, FINE * q.N_0)
    shown: list[Figure] = [_stroke(q), _yields(context, states), _shares(q)]
    if context.converging:
        shown += [
            _angle(context, states, "nu", "ν", "inner"),
            _angle(context, states, "omega", "ω", "outer"),
            _rotation(context), _force(context, states),
        ]  # fmt: skip
    return shown


def _stroke(q: WedgeFormulas) -> Shapes:
    half = math.pi / q.z
    panels = []
    for share in DRAWN:
        at = wedged(q.clutch, share * q.N_0)
        OC_e, beta, alpha = float(at.OC_e), float(at.beta), float(at.alpha_b)
        if not math.isfinite(alpha):
            continue
        A = float(at.OA) * np.array([math.sin(beta), math.cos(beta)])
        B = np.array([0.0, float(at.OB)])
        body = outline(q, turned=float(at.turned), alpha_b=alpha, OC_e=OC_e)
        lines = (arc(float(at.OA), -half, half), arc(float(at.OB), -half, half), np.vstack([A, B]))
        name = f"{share:g} N_0, α = {alpha * DEGREE:.3g}°" if share else "without load"
        panels.append(Panel(
            name=name, dots=1e3 * np.vstack([A, B]),
            lines=tuple(1e3 * x for x in (*lines, body) if x.size),
        ))  # fmt: skip
    return Shapes(
        title="The sprag under increasing load",
        unit="mm",
        panels=tuple(panels),
        dots_name="contacts",
        note="To scale, with the line through both contacts. Deflections of about 10 µm rotate "
        "the sprag by several degrees. The contacts move along the flanks of the sprag; the angle "
        "of the line to the radius is constant. In a panel without a sprag, the sprag has rolled "
        "over.",
    )


def _angle(context: Context, states: Wedged, key: str, symbol: str, race: str) -> Profile:
    values, u = along(context, f"profile_{key}", formal=2, scale=1.0)
    q = context.inputs
    N = GRID * q.N_0
    curve, marks = getattr(states, key), getattr(wedged(q.clutch, N), key)
    return Profile(
        title=f"Angle of the force on the {race} race", x_label="N [N]", y_label=f"{symbol} [°]",
        x=states.N, y=curve * DEGREE, x_fem=N, y_fem=values * DEGREE, y_ref=marks * DEGREE,
        u=u * DEGREE, scale=float(curve[0]) * DEGREE, scale_name=f"{symbol}_0", neglects=True,
        note="Without load, the force of the elastic sector acts along the line through both "
        "contacts. Under load, the difference between the angles of force and line increases with "
        "N², because the contacts lie beside the centre line of the sprag, so that their forces "
        "bend it.",
    )  # fmt: skip


def _rotation(context: Context) -> Curves:
    q, loads = context.inputs, context.fem[-1].arrays["loads"]
    N, palmgren = FINE * q.N_0, context.inputs.bodies.composite
    most = 1.05 * loads[1].max()

    def over_torque(name: str, at: Wedged, colour: int, style: str = "line") -> Curve:
        within = most >= at.T
        return curve(name, at.T[within], at.alpha_b[within] * DEGREE, style, colour)

    return plot(
        "Rotation of the sprags over torque", "T [N m]", "α [°]",
        over_torque("elastic", wedged(q.clutch, N), 0),
        over_torque("elastic, printed Eqs. 9, 10", printed.wedged(q.clutch, N), 0, "dashes"),
        over_torque("Palmgren", wedged(palmgren, N), 1),
        over_torque("Palmgren, printed Eqs. 9, 10", printed.wedged(palmgren, N), 1, "dashes"),
        over_torque("Palmgren, rigid races (Liu)", wedged(palmgren.rigid_races(), N), 2),
        dots("FE", loads[1], loads[4] * DEGREE),
        note="For the same deflections, Eqs. 9 and 10 as printed give too small a rotation. The "
        "deflections by Palmgren's law with Eqs. 6 and 7 are too large. Both errors nearly cancel, "
        "by chance.",
    )  # fmt: skip


def _force(context: Context, states: Wedged) -> Curves:
    q, loads = context.inputs, context.fem[-1].arrays["loads"]
    rigid = q.N_0 / q.T

    def excess(N: Array, T: Array) -> Array:
        return np.asarray(100 * (N / (rigid * T) - 1))

    return plot(
        "Excess of the normal force over that of a rigid clutch", "T [N m]", "N/N_0(T) − 1 [%]",
        line("Eqs. 9, 10, corrected", states.T, excess(states.N, states.T)),
        dots("FE", loads[1], excess(loads[0], loads[1])), y_bottom=None,
        note="N_0(T) = T/(n_s R_i tan ν_0). N is proportional to T within 1 %, because the wedge "
        "angle is nearly constant. Bending of the sprag increases N.",
    )  # fmt: skip


def parts_of(q: WedgeFormulas, N: Array) -> tuple[tuple[str, Array], ...]:
    """Name and deflection [m] of each component under N [N], from inner to outer race."""
    (inner, outer), yields = q.bodies.races, q.clutch.compliance.yields(N)
    unit = N / (q.l * q.bodies.E_plane)
    local = [
        unit * (race.at(a) - race.mean)
        for race, a in zip((inner, outer), q.bodies.half_widths(N), strict=True)
    ]
    return (
        ("inner mean", yields.race_i),
        ("inner indentation", local[0]),
        ("sprag", yields.contact_i + yields.contact_e - local[0] - local[1]),
        ("outer indentation", local[1]),
        ("outer mean", yields.race_e),
    )


def _yields(context: Context, states: Wedged) -> Curves:
    q, total = context.inputs, np.zeros_like(states.N)
    curves = []
    for k, (name, part) in enumerate(parts_of(q, states.N)):
        total = total + part
        curves.append(line(f"+ {name}" if k else name, states.N, total * 1e6, k))
    if context.fem:
        loads = context.fem[-1].arrays["loads"]
        curves.append(dots("FE, total", loads[0], loads[5] * 1e6))
    return plot(
        "Deflection by component, stacked", "N [N]", "H [µm]", curves,
        note="The races are rings under concentrated forces, one at each sprag. The deflection of "
        "a race is the mean deflection of the ring plus the local indentation under a sprag. The "
        "sprag is a column between two forces.",
    )  # fmt: skip


def _shares(q: WedgeFormulas) -> Bars:
    found = parts_of(q, np.array([q.N_0]))
    whole = float(sum(part[0] for _, part in found))
    return Bars(
        title="Deflections under N_0", label="[µm]",
        items=tuple(
            (name, float(part[0]) * 1e6, f"{float(part[0]) / whole:.0%}") for name, part in found
        ),
        note="Eq. 6 for plane strain contains the mean deflections of both races. The contact law "
        "and Eq. 7 contain the local indentations and the deflection of the sprag.",
    )  # fmt: skip
