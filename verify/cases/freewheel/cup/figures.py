"""What the report shows of a drawn-cup roller clutch under torque."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.freewheel.state import State, at_normal_force, loaded
from verify.cases.freewheel import over_torque
from verify.cases.freewheel.cup.model import clutch
from verify.cases.freewheel.over_torque import DEGREE, FINE
from verify.cases.freewheel.torque.fem import ACROSS, GRID
from verify.cases.freewheel.torque.figures import pictures
from verify.core.case import Context, Values
from verify.core.figures import Array, Curve, Curves, Equation, Figure, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along

__all__ = ["equations", "figures", "pictures", "sketch"]

FORCES = np.linspace(1e-4, 1.0, 160)  # of the largest normal force of the states

ROLLED = "The angle grows faster than the torque: the largest torque has no stiffness left."


def sketch(q: Any) -> Sketch:
    """One pitch to scale: shaft, roller, cup, the angle psi between flat and roller."""
    cam, half = q.cam, math.pi / q.z
    x, y = (float(v) for v in cam.centre(d_i=0.0, d_o=0.0))
    psi, unit = 2 * float(cam.alpha0), 1 / q.X_o
    turn = np.linspace(-half, half, 61)

    def arc(r: float, at: float = 0.0) -> Array:
        return np.asarray(r * unit * np.column_stack([np.sin(turn + at), np.cos(turn + at)]))

    right = q.corner * unit * np.array([math.sin(half), math.cos(half)])
    cup = np.vstack([arc(q.R_a), right, right * [-1, 1]])
    shaft = np.vstack([arc(q.R_s, psi), arc(q.r_b, psi)[::-1]])
    around = np.linspace(0, 2 * np.pi, 91)
    centre, out = unit * np.array([x, y]), np.array([math.sin(psi), math.cos(psi)])
    roller = centre + q.r * unit * np.column_stack([np.cos(around), np.sin(around)])
    at_cup, at_shaft = centre + np.array([0, q.r * unit]), centre - q.r * unit * out
    top, low, force = q.R_a * unit, q.r_b * unit, 0.55 * min(q.R_s - q.r_b, q.R_a - q.X_o) * unit
    side = 1.12 * q.corner * unit * math.sin(half)
    shapes = (
        Shape(style="modelled", points=cup), Shape(style="modelled", points=shaft),
        Shape(style="body", points=roller),
        Shape(style="axis", points=np.array([[0.0, 0.9 * low], [0.0, 1.05 * top]])),
        Shape(style="axis", points=np.vstack([0.9 * low * out, 1.03 * top * out])),
        Shape(style="load", points=np.vstack([at_cup + np.array([0, force]), at_cup]), label="F_n"),
        Shape(style="load", points=np.vstack([at_shaft - force * out, at_shaft])),
        Shape(style="leader", points=np.vstack([[side, q.R_s * unit * 0.8], arc(q.R_s, psi)[42]]),
              label=f"R_s = {q.R_s * 1e3:.4g} mm"),
        Shape(style="leader", points=np.vstack([[side, y * unit * 0.97], centre]),
              label=f"r = {q.r * 1e3:.4g} mm"),
        Shape(style="leader", points=np.array([[side, 1.12], [0.7 * right[0], 1.0]]),
              label=f"X_o = {q.X_o * 1e3:.8g} mm"),
        Shape(style="text", points=np.array([[0.25, 1.09 * top]]),
              label=f"ψ = 2α_0 = {psi * DEGREE:.4g}°"),
    )  # fmt: skip
    return Sketch(
        title=f"one of {q.z} pitches, to scale: the shaft turned anticlockwise draws the roller "
        "to the left, where the gap narrows down to the flat's middle; both cuts of shaft and cup "
        "move alike",
        shapes=shapes,
    )


def equations(q: Any, v: Values) -> Sequence[Equation]:
    R, r, X, T = tex(q.R_s * 1e3), tex(q.r * 1e3), tex(q.X_o * 1e3, 8), tex(q.T)
    d_i, d_o = tex(v["d_i"] * 1e6, 4), tex(v["d_o"] * 1e6, 4)
    a0, a = tex(v["alpha_0"] * DEGREE, 5), tex(v["alpha"] * DEGREE, 5)
    return (
        Equation(
            tex=r"\cos 2\alpha_0 = \frac{X_o - r}{R_s + r}",
            numbers=rf"\frac{{{X} - {r}}}{{{R} + {r}}} \Rightarrow \alpha_0 = {a0}°",
            place="Eq. 4 for a cup",
        ),
        Equation(
            tex=r"\alpha = \frac{1}{2}\arccos\frac{X_o - r + d_o}{R_s + r - d_i}",
            numbers=rf"d_i = {d_i}, d_o = {d_o}\ \mathrm{{µm}} \Rightarrow \alpha = {a}°",
            place="Eq. 5 for a cup: load lowers the angle",
        ),
        Equation(
            tex=r"T = z R_s F_t = z\,(F_n x - F_t X_o), \quad F_t = F_n\tan\alpha",
            numbers=rf"{T} = {q.z}\cdot {tex(q.R_s)}\cdot {tex(v['F_t'], 5)}\ \mathrm{{N\,m}}",
            place="Eqs. 2 and 3 for a cup; x = (R_s + r - d_i) sin 2α",
        ),
        Equation(
            tex=r"s = (R_s + r - d_i)\,2(\alpha_0 - \alpha)",
            numbers=rf"= {tex(v['s'] * 1e6, 5)}\ \mathrm{{µm}}", place="Eq. 6 for a cup",
        ),
        Equation(
            tex=r"\varphi = \frac{1}{R_s}\int\frac{\mathrm{d}d_i + \mathrm{d}d_o}{\tan\alpha}",
            numbers=rf"= {tex(v['phi'] * DEGREE, 5)}°, \quad \frac{{s}}{{R_s}} + \frac{{s}}{{X_o}}"
            rf" = {tex(v['phi printed'] * DEGREE, 5)}°",
            place="Eq. 7, corrected, and as printed",
        ),
        Equation(
            tex=r"T_{max} = \max_{F_n}\, z R_s F_n\tan\alpha(F_n), \qquad "
            r"\alpha = 0 \text{ at } d_i + d_o = R_s + 2r - X_o",
            numbers=rf"= {tex(v['T summit'], 5)}\ \mathrm{{N\,m}} \text{{ at }} "
            rf"{tex(v['share'], 3)}\cdot {tex(v['through'] * 1e6, 4)}\ \mathrm{{µm}}",
            place="largest torque, before the rollers go through",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    q = context.inputs
    states, marks = loaded(clutch(q), FINE * q.T), loaded(clutch(q), GRID * q.T)
    return (
        _over_the_summit(context), _angles(context),
        over_torque.angle(context, states, marks, ends=" and falls."),
        over_torque.torsion(context, states, printed="s/R_s + s/X_o", note=ROLLED),
        over_torque.way(context, states, marks), _bisector(context),
        _pressure(context, "cup"), _pressure(context, "shaft"),
    )  # fmt: skip


def _course(context: Context) -> State:
    return at_normal_force(clutch(context.inputs), FORCES * context.fem[-1].arrays["loads"][1][-1])


def _over_the_summit(context: Context) -> Curves:
    T, N, *_ = context.fem[-1].arrays["loads"]
    states, q = _course(context), context.inputs
    kept = states.N[q.z * q.R_s * states.N * math.tan(float(q.cam.alpha0)) < 1.25 * states.T.max()]
    return Curves(
        title="Torque over normal force: the summit", x_label="F_n [kN]", y_label="T [N m]",
        curves=(
            Curve(name="z R_s F_n tan α", x=states.N / 1e3, y=states.T),
            Curve(name="angle kept at α_0", x=kept / 1e3, style="dashes", colour=1,
                  y=q.z * q.R_s * kept * math.tan(float(q.cam.alpha0))),
            Curve(name="FE", x=N / 1e3, y=T, style="dots"),
        ),
        note="Overlaps are given to finite elements, so that they pass the summit: beyond it more "
        "normal force bears less torque, and a clutch under a dead weight lets its rollers "
        "through.",
    )  # fmt: skip


def _angles(context: Context) -> Curves:
    _, N, psi, *_ = context.fem[-1].arrays["loads"]
    states = _course(context)
    return Curves(
        title="The clamping angle falls", x_label="F_n [kN]", y_label="α [°]", y_bottom=0.0,
        curves=(
            Curve(name="Eq. 5 for a cup", x=states.N / 1e3, y=states.alpha * DEGREE),
            Curve(name="FE", x=N / 1e3, y=psi / 2 * DEGREE, style="dots"),
        ),
        note="At α = 0 the roller stands between the flat's middle and the shaft and goes through.",
    )  # fmt: skip


def _bisector(context: Context) -> Curves:
    _, N, psi, *_ = context.fem[-1].arrays["loads"]
    cup, shaft = context.fem[-1].arrays["shares"]
    tan = np.tan(psi / 2)
    return Curves(
        title="How far the line of the forces leaves the bisector", x_label="F_n [kN]",
        y_label="(F_t/F_n)/tan(ψ/2) − 1 [10⁻³]", y_bottom=None,
        curves=(
            Curve(name="FE, on the cup", x=N / 1e3, y=1e3 * (cup / tan - 1), style="dots"),
            Curve(name="FE, on the shaft", x=N / 1e3, y=1e3 * (shaft / tan - 1), style="dots",
                  colour=2),
            Curve(name="rigid surfaces", x=np.array([0.0, N[-1] / 1e3]), y=np.zeros(2)),
        ),
        note="Flat and shaft tilt under the normal force, while the angle itself falls.",
    )  # fmt: skip


def _pressure(context: Context, where: str) -> Profile:
    values, u = along(context, f"profile, p on the {where}", formal=1, scale=1.0)
    x = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))
    return Profile(
        title=f"Pressure on the {where}, in the heaviest state", x_label="x/a", y_label="p/p_0",
        x=x, y=np.sqrt(1 - x**2), x_fem=ACROSS, y_fem=values, y_ref=np.sqrt(1 - ACROSS**2), u=u,
        scale=1.0, neglects=True,
        note="a from the moments of the pressure, p_0 = 2P/(πa): the shape is compared.",
    )  # fmt: skip
