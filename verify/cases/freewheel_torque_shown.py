"""What the report shows of a roller freewheel under torque."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.freewheel.state import State, loaded
from verify.case import Context, Values
from verify.cases.freewheel_torque_fem import ACROSS, GRID
from verify.cases.freewheel_torque_model import clutch
from verify.profiles import along
from verify.shown import (
    Array,
    Curve,
    Curves,
    Equation,
    Figure,
    Picture,
    Profile,
    Shape,
    Sketch,
)
from verify.tex import tex

FINE = np.linspace(0.002, 1.0, 160)  # of T, where curves are drawn
DEGREE = math.degrees(1.0)


def sketch(q: Any) -> Sketch:
    """One pitch to scale: star, roller, ring, the angle psi between flat and roller."""
    cam, half = q.cam, math.pi / q.z
    x, y = (float(v) for v in cam.centre(d_i=0.0, d_o=0.0))
    psi = 2 * float(cam.alpha0)
    unit = 1 / q.R
    turn = np.linspace(-half, half, 61)

    def arc(r: float, at: float = 0.0) -> Array:
        return np.asarray(r * unit * np.column_stack([np.sin(turn + at), np.cos(turn + at)]))

    corner = min(q.X / math.cos(half), q.R)
    right = corner * unit * np.array([math.sin(half), math.cos(half)])
    star = np.vstack([arc(q.r_b), right, right * [-1, 1]])
    ring = np.vstack([arc(q.R, psi), arc(q.R_a, psi)[::-1]])
    around = np.linspace(0, 2 * np.pi, 91)
    centre = unit * np.array([x, y])
    roller = centre + q.r * unit * np.column_stack([np.cos(around), np.sin(around)])
    out = np.array([math.sin(psi), math.cos(psi)])
    at_star, at_ring = centre - [0, q.r * unit], centre + q.r * unit * out
    top = q.R_a * unit
    shapes = (
        Shape(style="modelled", points=star), Shape(style="modelled", points=ring),
        Shape(style="body", points=roller),
        Shape(style="axis", points=np.array([[0.0, q.r_b * unit * 0.9], [0.0, 1.08 * top]])),
        Shape(style="axis", points=np.vstack([0.6 * q.X * unit * out, 1.06 * top * out])),
        Shape(style="clamp", points=arc(q.r_b)),
        Shape(style="load", points=np.vstack([at_star - [0, 0.12], at_star]), label="F_n"),
        Shape(style="load", points=np.vstack([at_ring + 0.12 * out, at_ring])),
        Shape(style="dimension", points=np.array([[-0.03, q.r_b * unit], [-0.03, q.X * unit]]),
              label="X − r_b"),
        Shape(style="leader", points=np.vstack([[0.62, 1.08], at_ring + 0.03 * out]),
              label=f"R = {q.R * 1e3:.4g} mm"),
        Shape(style="leader", points=np.vstack([[0.66, 0.86], centre]),
              label=f"r = {q.r * 1e3:.4g} mm"),
        Shape(style="leader", points=np.array([[-0.3, 0.88], [-0.2, q.X * unit]]),
              label=f"X = {q.X * 1e3:.7g} mm"),
        Shape(style="text", points=np.array([[0.3, 1.15 * top]]),
              label=f"ψ = 2α_0 = {psi * DEGREE:.4g}°"),
    )  # fmt: skip
    return Sketch(
        title=f"one of {q.z} pitches, to scale: the ring turned clockwise draws the roller into "
        "the gap that narrows to the right; both cuts of star and ring move alike",
        shapes=shapes,
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
        _angle(context, states, marks), _torsion(context, states), _way(context, states, marks),
        _approaches(context), _pressures(context), _contacts(context),
    )  # fmt: skip


def _angle(context: Context, states: State, marks: State) -> Profile:
    values, u = along(context, "profile, alpha", formal=2, scale=1.0)
    q = context.inputs
    return Profile(
        title="Clamping angle over torque", x_label="T [N m]", y_label="α [°]",
        x=FINE * q.T, y=states.alpha * DEGREE, x_fem=GRID * q.T, y_fem=values * DEGREE,
        y_ref=marks.alpha * DEGREE, u=u * DEGREE, scale=context.analytic["alpha"] * DEGREE,
        scale_name="α(T)", neglects=True,
        note=f"It begins at α_0 = {context.analytic['alpha_0'] * DEGREE:.4g}°.",
    )  # fmt: skip


def _way(context: Context, states: State, marks: State) -> Profile:
    values, u = along(context, "profile, s", formal=2, scale=1.0)
    q = context.inputs
    return Profile(
        title="Way of the roller's centre (Eq. 6)", x_label="T [N m]", y_label="s [µm]",
        x=FINE * q.T, y=states.s * 1e6, x_fem=GRID * q.T, y_fem=values * 1e6, y_ref=marks.s * 1e6,
        u=u * 1e6, scale=context.analytic["s"] * 1e6, scale_name="s(T)", neglects=True,
    )  # fmt: skip


def _torsion(context: Context, states: State) -> Curves:
    q = context.inputs
    return Curves(
        title="Torsion over torque: Eq. 7 as printed and exact rolling", x_label="T [N m]",
        y_label="φ [°]",
        curves=(
            Curve(name="exact rolling", x=FINE * q.T, y=states.phi * DEGREE),
            Curve(name="Eq. 7 as printed, s/R + s/X", x=FINE * q.T,
                  y=states.phi_printed * DEGREE, style="dashes", colour=1),
            Curve(name="FE, ∫dU/T", x=GRID * q.T,
                  y=context.fem[-1].arrays["profile, phi"] * DEGREE, style="dots"),
        ),
        note="Finite elements know nothing of rolling here: the angle is what the energy of all "
        "states asks for. The printed form takes the flat for a circle of radius X.",
    )  # fmt: skip


def _approaches(context: Context) -> Curves:
    q, v = context.inputs, context.fem[-1].arrays["loads"]
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
        note=f"Flat and bore tilt in proportion to the normal force; with z = {q.z} rollers on "
        "thin walls more than on thick ones. They tilt to either side: their mean is tan(ψ/2).",
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
        Picture(field="sector", data="von_mises", symbol="σ_v", unit="MPa", factor=1e6,
                caption="One pitch in the heaviest state of the sweep, von Mises' stress",
                displacement=""),
        Picture(field="sector", data="log_mises", symbol="lg(σ_v/MPa)", unit="1", factor=1.0,
                caption="The roller between both races: the forces run from contact to contact; "
                "below 10 MPa in one colour",
                displacement="", window=(x - w, y - w, x + w, y + w)),
    )  # fmt: skip
