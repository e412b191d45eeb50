"""What the report shows of a wedged sprag."""

import math
from collections.abc import Sequence

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import Wedged, wedged
from verify.cases.freewheel.star_sketch import arc
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.fem import GRID
from verify.cases.sprag.wedge.model import (
    composite,
    elastic,
    half_widths,
    plane_modulus,
    races,
    rigid_force,
)
from verify.cases.sprag.wedge.sketch import outline, sketch
from verify.core.case import Context, Values
from verify.core.figures import (
    Array,
    Bars,
    Curve,
    Curves,
    Equation,
    Figure,
    Panel,
    Picture,
    Profile,
    Shapes,
)
from verify.core.tex import tex
from verify.judging.profiles import along

__all__ = ["equations", "figures", "pictures", "sketch"]

FINE = np.linspace(0.005, 1.88, 94)  # of N_0, where curves are drawn
DEGREE = math.degrees(1.0)
DRAWN = (0.0, 0.5, 1.0, 1.8)  # of N_0


def equations(q: WedgeInputs, v: Values) -> Sequence[Equation]:
    return *_closure(q, v), *_statics(q, v), *_yielding(v)


def _closure(q: WedgeInputs, v: Values) -> tuple[Equation, ...]:
    return (
        Equation(
            tex=r"OA_s = R_i - \delta_{BI} - \delta_{HI} - \frac{\delta_g}{2}",
            numbers=rf"R_i = {tex(q.R_i * 1e3, 5)}\ \mathrm{{mm}}",
            place="Eq. 9, corrected: all that yields on the inner side",
        ),
        Equation(
            tex=r"OC_e = R_e - r_e + \delta_{BE} + \delta_{HE} + \frac{\delta_g}{2}",
            numbers=rf"r_e = {tex(v['r_e'] * 1e3, 5)}\ \mathrm{{mm}}",
            place="Eq. 9",
        ),
        Equation(
            tex=r"OC_e^2 = OA_s^2 + \rho^2 + \frac{2\,OA_s\,\rho}{\sqrt{1 + m^2}}",
            numbers=rf"m = {tex(v['m'], 5)}",
            place="Eq. 10, with the free spiral's OA_s for OA",
        ),
        Equation(
            tex=r"\sin\eta = \frac{m\,OA_s}{OC_e\sqrt{1 + m^2}}, \quad \beta = \arctan m - \eta",
            numbers=rf"\beta = {tex((v['nu'] - v['omega']) * DEGREE, 5)}°",
            place="Eq. 10, with OA_s",
        ),
        Equation(
            tex=r"\alpha = \frac{1}{m}\ln\frac{\rho}{\rho_0} - (\eta - \eta_0)",
            numbers=rf"\alpha = {tex(v['alpha'] * DEGREE, 4)}°",
            place="Eq. 10; the logarithm of ρ/ρ_0 over m",
        ),
    )


def _statics(q: WedgeInputs, v: Values) -> tuple[Equation, ...]:
    nu, omega = (tex(v[name] * DEGREE, 5) for name in ("nu", "omega"))
    N = tex(v["N"], 5)
    return (
        Equation(
            tex=r"\nu = \arctan\frac{OB\sin\beta}{OB\cos\beta - OA}, \quad \omega = \nu - \beta",
            numbers=rf"\nu = {nu}°, \quad \omega = {omega}°",
            place="Eq. 10",
        ),
        Equation(
            tex=r"T = n_s N \tan\nu\;OA",
            numbers=rf"{tex(q.T)}\ \mathrm{{N\,m}} = {q.z}\cdot {N}\ \mathrm{{N}}\cdot\tan {nu}°"
            r"\cdot OA",
            place="Eq. 10; two forces hold a sprag",
        ),
        Equation(
            tex=r"N_e = N\,\frac{\cos\omega}{\cos\nu}",
            numbers=rf"N_e = {tex(v['N'] * math.cos(v['omega']) / math.cos(v['nu']), 5)}"
            r"\ \mathrm{N}",
            place="the paper has both normal forces equal",
        ),
    )


def _yielding(v: Values) -> tuple[Equation, ...]:
    return (
        Equation(
            tex=r"H = \delta_{BI} + \delta_{HI} + \delta_g + \delta_{HE} + \delta_{BE}",
            numbers=rf"H = {tex(v['H'] * 1e6, 4)}\ \mathrm{{µm}}",
            place="all that yields under a sprag",
        ),
        Equation(
            tex=r"n_s N\,\mathrm{d}H = T\,\mathrm{d}\theta",
            numbers=rf"\theta = {tex(v['theta'] * DEGREE, 4)}°",
            place="work: it holds with OA_s, not with the printed OA in Eq. 10",
        ),
        Equation(
            tex=r"\bar\delta_B = \frac{n_s N}{2\pi l E'}\left[\frac{r_o^2 + r_i^2}{r_o^2 - r_i^2} "
            r"\pm \nu'\right]",
            numbers=rf"\bar\delta_{{BI}} = {tex(v['mean i, N_0'] * 1e6, 4)}, \quad "
            rf"\bar\delta_{{BE}} = {tex(v['mean e, N_0'] * 1e6, 4)}\ \mathrm{{µm}}",
            place="Eq. 6 for long races, under N_0: their mean",
        ),
        Equation(
            tex=r"E' = \frac{E}{1 - \nu^2}, \quad \nu' = \frac{\nu}{1 - \nu}",
            place="Eq. 6 as printed, for thin races, has E and ν",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    states = wedged(elastic(q), FINE * rigid_force(q))
    shown: list[Figure] = [_stroke(q), _yields(context, states), _shares(q)]
    if context.converging:
        shown += [
            _angle(context, states, "nu", "ν", "inner"),
            _angle(context, states, "omega", "ω", "outer"),
            _rotation(context), _force(context, states),
        ]  # fmt: skip
    return shown


def _stroke(q: WedgeInputs) -> Shapes:
    half = math.pi / q.z
    panels = []
    for share in DRAWN:
        at = wedged(elastic(q), share * rigid_force(q))
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
        title="The sprag through its stroke",
        unit="mm",
        panels=tuple(panels),
        dots_name="contacts",
        note="To scale, with the strut between both contacts: yields of some 10 µm turn the sprag "
        "by degrees, its contacts move along its flanks and the strut keeps its angle. A sprag "
        "without an outline has rolled over.",
    )


def _angle(context: Context, states: Wedged, key: str, symbol: str, race: str) -> Profile:
    values, u = along(context, f"profile, {key}", formal=2, scale=1.0)
    q = context.inputs
    N = GRID * rigid_force(q)
    curve, marks = getattr(states, key), getattr(wedged(elastic(q), N), key)
    return Profile(
        title=f"Angle of the force on the {race} race", x_label="N [N]", y_label=f"{symbol} [°]",
        x=states.N, y=curve * DEGREE, x_fem=N, y_fem=values * DEGREE, y_ref=marks * DEGREE,
        u=u * DEGREE, scale=float(curve[0]) * DEGREE, scale_name=f"{symbol}_0", neglects=True,
        note="Without load the elastic sector has the strut's angle. It falls behind with N², as "
        "contacts beside the middle bend the column.",
    )  # fmt: skip


def _rotation(context: Context) -> Curves:
    q, loads = context.inputs, context.fem[-1].arrays["loads"]
    N = FINE * rigid_force(q)
    most = 1.05 * loads[1].max()

    def curve(name: str, at: Wedged, colour: int, style: str = "line") -> Curve:
        shown = most >= at.T
        return Curve(name=name, x=at.T[shown], y=at.alpha_b[shown] * DEGREE, style=style,
                     colour=colour)  # fmt: skip

    return Curves(
        title="Rotation of the sprags over torque", x_label="T [N m]", y_label="α [°]",
        curves=(
            curve("elastic", wedged(elastic(q), N), 0),
            curve("elastic, printed Eqs. 9, 10", printed.wedged(elastic(q), N), 0, "dashes"),
            curve("Palmgren", wedged(composite(q), N), 1),
            curve("Palmgren, printed Eqs. 9, 10", printed.wedged(composite(q), N), 1, "dashes"),
            curve("Palmgren, rigid races (Liu)", wedged(composite(q).rigid_races(), N), 2),
            Curve(name="FE", x=loads[1], y=loads[4] * DEGREE, style="dots"),
        ),
        note="The printed closure turns the sprag too little for the same yields; Palmgren's law "
        "with Eqs. 6 and 7 yields too much. Together they come near to the elastic sector, by "
        "chance.",
    )  # fmt: skip


def _force(context: Context, states: Wedged) -> Curves:
    q, loads = context.inputs, context.fem[-1].arrays["loads"]
    rigid = rigid_force(q) / q.T

    def excess(N: Array, T: Array) -> Array:
        return np.asarray(100 * (N / (rigid * T) - 1))

    return Curves(
        title="Normal force over a rigid clutch's", x_label="T [N m]", y_label="N/N_0(T) − 1 [%]",
        curves=(
            Curve(name="closure", x=states.T, y=excess(states.N, states.T)),
            Curve(name="FE", x=loads[1], y=excess(loads[0], loads[1]), style="dots"),
        ),
        y_bottom=None,
        note="N_0(T) = T/(n_s R_i tan ν_0). The wedge angle hardly changes: N goes with T "
        "within 1 %; the column's bending adds to it.",
    )  # fmt: skip


def parts_of(q: WedgeInputs, N: Array) -> tuple[tuple[str, Array], ...]:
    """Who yields how much [m] under N [N], from the inner race's mean to the outer's."""
    (inner, outer), yields = races(q), elastic(q).compliance.yields(N)
    unit = N / (q.l * plane_modulus(q))
    dents = [
        unit * (race.at(a) - race.mean)
        for race, a in zip((inner, outer), half_widths(q, N), strict=True)
    ]
    return (
        ("inner mean", yields.race_i),
        ("inner dent", dents[0]),
        ("sprag", yields.contact_i + yields.contact_e - dents[0] - dents[1]),
        ("outer dent", dents[1]),
        ("outer mean", yields.race_e),
    )


def _yields(context: Context, states: Wedged) -> Curves:
    q, total = context.inputs, np.zeros_like(states.N)
    curves = []
    for k, (name, part) in enumerate(parts_of(q, states.N)):
        total = total + part
        curves.append(Curve(name=f"+ {name}" if k else name, x=states.N, y=total * 1e6, colour=k))
    if context.fem:
        loads = context.fem[-1].arrays["loads"]
        curves.append(Curve(name="FE, all", x=loads[0], y=loads[5] * 1e6, style="dots"))
    return Curves(
        title="Who yields how much, one on top of the other",
        x_label="N [N]",
        y_label="H [µm]",
        curves=tuple(curves),
        note="Races as rings under single loads, their mean and what they yield more under a "
        "sprag; the sprag as a column between two forces.",
    )


def _shares(q: WedgeInputs) -> Bars:
    found = parts_of(q, np.array([rigid_force(q)]))
    whole = float(sum(part[0] for _, part in found))
    return Bars(
        title="Yields under N_0", label="[µm]",
        items=tuple(
            (name, float(part[0]) * 1e6, f"{float(part[0]) / whole:.0%}") for name, part in found
        ),
        note="Eq. 6, for long races, has both means; the dents at the contacts and the sprag are "
        "left to the contacts' law and to Eq. 7.",
    )  # fmt: skip


def pictures(_q: WedgeInputs) -> Sequence[Picture]:
    return (
        Picture(field="sector", data="log_mises", symbol="σ_v", unit="MPa", factor=1.0,
                decades=True, displacement="",
                caption="One pitch in the heaviest state of the stroke, von Mises' stress: forces "
                "run along the strut, beside the middle of the column; below 10 MPa in one colour"),
    )  # fmt: skip
