"""What the report shows of a roller freewheel under torque."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.freewheel.state import State, loaded
from verify.cases.freewheel import over_torque
from verify.cases.freewheel.over_torque import DEGREE, FINE
from verify.cases.freewheel.star_sketch import sketch
from verify.cases.freewheel.torque.fem import ACROSS, GRID
from verify.cases.freewheel.torque.model import clutch
from verify.core.case import Context, Values
from verify.core.figures import Curve, Curves, Equation, Figure, Picture, Profile
from verify.core.tex import tex
from verify.judging.profiles import along

__all__ = ["equations", "figures", "pictures", "sketch"]


ROLLED = (
    "Finite elements know nothing of rolling here: the angle is what the energy of all "
    "states asks for. The printed form takes the flat for a circle of radius X."
)


def equations(q: Any, v: Values) -> Sequence[Equation]:
    R, r, X, T = tex(q.R * 1e3), tex(q.r * 1e3), tex(q.X * 1e3, 7), tex(q.T)
    d_i, d_o = tex(v["d_i"] * 1e6, 4), tex(v["d_o"] * 1e6, 4)
    a0, a = tex(v["alpha_0"] * DEGREE, 5), tex(v["alpha"] * DEGREE, 5)
    return (
        Equation(
            tex=r"\cos\alpha_0 = \sqrt{\frac{R + X}{2(R - r)}}, \quad "
            r"\cos 2\alpha_0 = \frac{X + r}{R - r}",
            numbers=rf"\frac{{{X} + {r}}}{{{R} - {r}}} \Rightarrow \alpha_0 = {a0}°",
            place="Eq. 4, corrected: R for r_RO in the numerator",
        ),
        Equation(
            tex=r"\alpha = \frac{1}{2}\arccos\frac{X + r - d_i}{R - r + d_o}",
            numbers=rf"d_i = {d_i}, d_o = {d_o}\ \mathrm{{µm}} \Rightarrow \alpha = {a}°",
            place="Eq. 5, corrected",
        ),
        Equation(
            tex=r"T = z R F_t = z\,(F_n x - F_t X), \quad F_t = F_n\tan\alpha",
            numbers=rf"{T} = {q.z}\cdot {tex(q.R)}\cdot {tex(v['F_t'], 5)}\ \mathrm{{N\,m}}",
            place="Eqs. 2 and 3, corrected; x = (R − r + d_o) sin 2α",
        ),
        Equation(
            tex=r"s = (R - r + d_o)\,2(\alpha - \alpha_0)",
            numbers=rf"= {tex(v['s'] * 1e6, 5)}\ \mathrm{{µm}}", place="Eq. 6",
        ),
        Equation(
            tex=r"\varphi = \frac{1}{R}\int\frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
            numbers=rf"= {tex(v['phi'] * DEGREE, 5)}°, \quad "
            rf"\frac{{s}}{{R}} + \frac{{s}}{{X}} = {tex(v['phi printed'] * DEGREE, 5)}°",
            place="Eq. 7, corrected, and as printed",
        ),
        Equation(
            tex=r"d_i = \frac{P}{\pi E'}\left(2\ln\frac{4r}{a_i} - 1 + "
            r"2\ln\frac{l}{a_i} + k\right), \quad P = \frac{F_n}{L}",
            place="approach of roller and star, which is clamped in its bore; the ring alike",
        ),
    )  # fmt: skip


def _states(q: Any) -> State:
    return loaded(clutch(q), FINE * q.T)


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    q = context.inputs
    states, marks = _states(q), loaded(clutch(q), GRID * q.T)
    return (
        over_torque.angle(context, states, marks, ends="."),
        over_torque.torsion(context, states, printed="s/R + s/X", note=ROLLED),
        over_torque.way(context, states, marks),
        _approaches(context), _pressures(context), _contacts(context),
    )  # fmt: skip


def _approaches(context: Context) -> Curves:
    v = context.fem[-1].arrays["loads"]
    star, ring = context.fem[-1].arrays["shares"]
    tan = np.tan(v[2] / 2)
    return Curves(
        title="How far the line of the forces leaves the bisector", x_label="T [N m]",
        y_label="(F_t/F_n)/tan(ψ/2) − 1 [10⁻³]", y_bottom=None,
        curves=(
            Curve(name="FE, on the star", x=v[0], y=1e3 * (star / tan - 1), style="dots"),
            Curve(name="FE, on the ring", x=v[0], y=1e3 * (ring / tan - 1), style="dots",
                  colour=2),
            Curve(name="rigid surfaces", x=np.array([0.0, v[0][-1]]), y=np.zeros(2)),
        ),
        note="It grows with the normal force: surfaces tilt, and in small displacements forces act "
        "where the mesh has them. To either side by as much: the mean is tan(ψ/2).",
    )  # fmt: skip


def _pressures(context: Context) -> Profile:
    return _pressure(context, "star")


def _contacts(context: Context) -> Profile:
    return _pressure(context, "ring")


def _pressure(context: Context, where: str) -> Profile:
    values, u = along(context, f"profile, p on the {where}", formal=1, scale=1.0)
    x = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))
    return Profile(
        title=f"Pressure on the {where}, in the heaviest state", x_label="x/a", y_label="p/p_0",
        x=x, y=np.sqrt(1 - x**2), x_fem=ACROSS, y_fem=values, y_ref=np.sqrt(1 - ACROSS**2), u=u,
        scale=1.0, neglects=True,
        note="a from the moments of the pressure, p_0 = 2P/(πa): the shape is compared.",
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    x, y = (float(v) for v in q.cam.centre(d_i=0.0, d_o=0.0))
    w = 1.35 * q.r
    return (
        Picture(field="sector", data="log_mises", symbol="σ_v", unit="MPa", factor=1.0,
                decades=True,
                caption="One pitch in the heaviest state of the sweep, von Mises' stress",
                displacement=""),
        Picture(field="sector", data="log_mises", symbol="σ_v", unit="MPa", factor=1.0,
                decades=True,
                caption="The roller between both races: the forces run from contact to contact; "
                "below 10 MPa in one colour",
                displacement="", window=(x - w, y - w, x + w, y + w)),
    )  # fmt: skip
