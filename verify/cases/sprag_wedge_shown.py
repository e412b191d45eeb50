"""What the report shows of a wedged sprag."""

import math
from collections.abc import Sequence

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import Wedged, wedged
from verify.case import Context, Values
from verify.cases.freewheel_star_sketch import arc
from verify.cases.sprag_inputs import WedgeInputs
from verify.cases.sprag_wedge_fem import GRID
from verify.cases.sprag_wedge_model import (
    composite,
    elastic,
    half_widths,
    plane_modulus,
    races,
    rigid_force,
)
from verify.cases.sprag_wedge_sketch import outline, sketch
from verify.profiles import along
from verify.shown import (
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
from verify.tex import tex

__all__ = ["equations", "figures", "pictures", "sketch"]

FINE = np.linspace(0.005, 1.8, 90)  # of N_0, where curves are drawn
DEGREE = math.degrees(1.0)
DRAWN = (0.0, 0.5, 1.0, 1.8)  # of N_0


def equations(q: WedgeInputs, v: Values) -> Sequence[Equation]:
    mm = {name: tex(getattr(q, name) * 1e3, 5) for name in ("R_i", "R_e", "R_id", "R_ed")}
    nu, omega = tex(v["nu"] * DEGREE, 5), tex(v["omega"] * DEGREE, 5)
    H, alpha, theta = tex(v["H"] * 1e6, 4), tex(v["alpha"] * DEGREE, 4), tex(v["theta"] * DEGREE, 4)
    return (
        Equation(
            tex=r"OC_e^2 = OA_s^2 + \rho^2 + \frac{2\,OA_s\,\rho}{\sqrt{1 + m^2}}, \quad "
            r"\beta = \arctan m - \eta",
            numbers=rf"m = {tex(v['m'], 5)}, \quad r_e = {tex(v['r_e'] * 1e3, 5)}\ \mathrm{{mm}}",
            place="Eq. 10, with OA_s for OA",
        ),
        Equation(
            tex=r"\sin\eta = \frac{m\,OA_s}{OC_e\sqrt{1 + m^2}}, \quad "
            r"\alpha = \frac{1}{m}\ln\frac{\rho}{\rho_0} - (\eta - \eta_0)",
            numbers=rf"\alpha = {alpha}°",
            place="Eq. 10, with OA_s for OA; the logarithm of ρ/ρ_0 over m",
        ),
        Equation(
            tex=r"OA_s = R_i - \delta_{BI} - \delta_{HI} - \frac{\delta_g}{2}, \quad "
            r"OC_e = R_e - r_e + \delta_{BE} + \delta_{HE} + \frac{\delta_g}{2}",
            numbers=rf"R_i = {mm['R_i']}, \quad R_e = {mm['R_e']}\ \mathrm{{mm}}, \quad "
            rf"H = {H}\ \mathrm{{µm}}",
            place="Eq. 9, corrected: all that yields on the inner side",
        ),
        Equation(
            tex=r"T = n_s N \tan\nu\;OA",
            numbers=rf"{tex(q.T)}\ \mathrm{{N\,m}} = {q.z}\cdot "
            rf"{tex(v['N'], 5)}\ \mathrm{{N}}\cdot\tan {nu}°\cdot OA",
            place="Eq. 10; two forces hold a sprag",
        ),
        Equation(
            tex=r"\nu = \arctan\frac{OB\sin\beta}{OB\cos\beta - OA}, \quad \omega = \nu - \beta, "
            r"\quad N_e = N\,\frac{\cos\omega}{\cos\nu}",
            numbers=rf"\nu = {nu}°, \quad \omega = {omega}°",
            place="Eq. 10; the paper has both normal forces equal",
        ),
        Equation(
            tex=r"n_s N\,\mathrm{d}H = T\,\mathrm{d}\theta, \quad "
            r"H = \delta_{BI} + \delta_{HI} + \delta_g + \delta_{HE} + \delta_{BE}",
            numbers=rf"\theta = {theta}°",
            place="work: it holds with OA_s, and not with the printed OA in Eq. 10",
        ),
        Equation(
            tex=r"\bar\delta_B = \frac{n_s N}{2\pi l E'}\left[\frac{r_o^2 + r_i^2}{r_o^2 - r_i^2} "
            r"\pm \nu'\right], \quad E' = \frac{E}{1 - \nu^2}, \quad \nu' = \frac{\nu}{1 - \nu}",
            numbers=rf"\bar\delta_{{BI}} = {tex(v['mean i, N_0'] * 1e6, 4)}, \quad "
            rf"\bar\delta_{{BE}} = {tex(v['mean e, N_0'] * 1e6, 4)}\ \mathrm{{µm}}",
            place="Eq. 6 for long races, under N_0: their mean",
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
        panels.append(Panel(
            name=f"{share:g} N_0, α = {alpha * DEGREE:.3g}°", dots=1e3 * np.vstack([A, B]),
            lines=tuple(1e3 * x for x in (*lines, body) if x.size),
        ))  # fmt: skip
    return Shapes(
        title="The sprag through its stroke",
        unit="mm",
        panels=tuple(panels),
        dots_name="contacts, and the strut between them",
        note="To scale: yields of some 10 µm turn the sprag by degrees, and the contacts move "
        "along its flanks while the strut keeps its angle. A sprag without an outline has rolled "
        "over its flanks.",
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
            curve("elastic yields", wedged(elastic(q), N), 0),
            curve("the same, Eqs. 9, 10 as printed", printed.wedged(elastic(q), N), 0, "dashes"),
            curve("Palmgren, Eqs. 6, 7", wedged(composite(q), N), 1),
            curve("the same, Eqs. 9, 10 as printed", printed.wedged(composite(q), N), 1, "dashes"),
            curve("the same with rigid races (Liu)", wedged(composite(q).rigid_races(), N), 2),
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
        "within 1 %.",
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
        ("inner race, mean", yields.race_i),
        ("inner race, dent", dents[0]),
        ("sprag", yields.contact_i + yields.contact_e - dents[0] - dents[1]),
        ("outer race, dent", dents[1]),
        ("outer race, mean", yields.race_e),
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
        note="Races as rings under single loads, the sprag as a column between two forces.",
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


def pictures(q: WedgeInputs) -> Sequence[Picture]:
    middle, w = (q.R_i + q.R_e) / 2, 0.75 * (q.R_e - q.R_i)
    return (
        Picture(field="sector", data="log_mises", symbol="σ_v", unit="MPa", factor=1.0,
                decades=True,
                caption="One pitch in the heaviest state of the stroke, von Mises' stress",
                displacement=""),
        Picture(field="sector", data="log_mises", symbol="σ_v", unit="MPa", factor=1.0,
                decades=True,
                caption="The sprag between both races: the forces run along the strut, beside the "
                "middle of the column; below 10 MPa in one colour",
                displacement="", window=(-w, middle - w, w, middle + w)),
    )  # fmt: skip
