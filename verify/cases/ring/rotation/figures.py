"""What the report shows of a rotating race: sketch, Eq. 8 with numbers, profiles, its size."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.ring import rotating
from verify.core.case import Context, Values
from verify.core.figures import Curve, Curves, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, mm, um = 1e6, 1e-3, 1e-6
RPM = np.pi / 30
ACROSS = 13  # stations over the wall
ASKEW = np.radians(30.0)  # their direction: on no line of the mesh's symmetry


def stations(q: Any) -> Any:
    """Radii (m,) of the profiles [m], both walls included."""
    return np.linspace(q.r_i, q.r_o, ACROSS)


def arc(r: float, start: float = 0.0, end: float = 360.0) -> Any:
    t = np.radians(np.linspace(start, end, 73))
    return r * np.column_stack([np.cos(t), np.sin(t)])


def sketch(q: Any) -> Sketch:
    inner = q.r_i / q.r_o
    turn = arc(inner - 0.15, 200, 340)
    shapes = [
        Shape(style="body", points=arc(1.0)),
        Shape(style="hole", points=arc(inner)),
        Shape(style="modelled", points=np.vstack([arc(1.0, 0, 90), arc(inner, 90, 0)])),
        Shape(style="axis", points=np.array([[-1.12, 0.0], [1.12, 0.0]])),
        Shape(style="axis", points=np.array([[0.0, -1.12], [0.0, 1.12]])),
        Shape(style="faint", points=turn),
        Shape(style="load", points=turn[-2:]),
        Shape(style="text", points=np.array([[0.0, -inner / 2]]), label=f"n = {q.omega / RPM:.5g}"),
        Shape(style="leader", points=np.array([[1.18, 0.98], [0.75, 0.52]]), label="FE: a quarter"),
    ]
    for name, r, degrees, at in (("R_ed", q.r_o, 140, 1.0), ("R_e", q.r_i, 160, inner)):
        ray = np.outer([1.32, at], [np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
        shapes.append(Shape(style="leader", points=ray, label=f"{name} = {r / mm:.4g} mm"))
    title = f"race at {q.omega / RPM:.5g} r/min, density {q.rho:.5g} kg/m³"
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    R_e, R_ed, nu = tex(q.r_i / mm), tex(q.r_o / mm), tex(q.nu)
    speed = tex(q.omega / RPM)
    return (
        Equation(
            tex=r"\delta_{ce} = \frac{R_e}{E}\frac{(3+\nu)\rho}{4}\left(\frac{\pi n}{30}\right)^2"
            r"\left[R_{ed}^2 + R_e^2\,\frac{1-\nu}{3+\nu}\right]",
            numbers=rf"= \frac{{{R_e}}}{{{tex(q.E / MPa)}}}\cdot\frac{{(3 + {nu})\cdot {tex(q.rho)}"
            rf"}}{{4}}\left(\frac{{\pi\cdot {speed}}}{{30}}\right)^2\left[{R_ed}^2 + {R_e}^2\cdot"
            rf"\frac{{1 - {nu}}}{{3 + {nu}}}\right] "
            rf"= {tex(v['bore growth, plane stress'] / um)}\ \mathrm{{\mu m}}",
            place="Eq. 8",
        ),
        Equation(
            tex=r"\frac{\delta_{ce}}{\delta_{BE}}",
            numbers=rf"= \frac{{{tex(v['bore growth, plane stress'] / um)}}}"
            rf"{{{tex(v['under the sprags'] / um)}}} = {tex(v['ratio'], 4)}",
            place="Eq. 8 over Eq. 6",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    """The profiles over the wall, and the growth over speed beside the sprags' deflection."""
    return (*(_profiles(context) if context.converging else ()), _over_speed(context))


def _profiles(context: Context) -> Sequence[Figure]:
    q = context.inputs
    ring = {"r_i": q.r_i, "r_o": q.r_o, "rho": q.rho, "omega": q.omega, "nu": q.nu,
            "assumption": "plane stress"}  # fmt: skip
    fine, at = np.linspace(q.r_i, q.r_o, 81), stations(q)
    (radial, hoop), (radial_at, hoop_at) = (rotating.stresses(r, **ring) for r in (fine, at))
    u, u_at = (rotating.radial_displacement(r, E=q.E, **ring) for r in (fine, at))
    scale = context.analytic["bore hoop stress, plane stress"]
    shown = (
        ("hoop stress", "σ_θ [MPa]", hoop, hoop_at, MPa, scale, 2.0),
        ("radial stress", "σ_r [MPa]", radial, radial_at, MPa, scale, 2.0),
        ("radial displacement", "u_r [µm]", u, u_at, um, float(u[0]), 3.0),
    )
    found = []
    for name, label, curve, reference, factor, size, formal in shown:
        values, sigma = along(context, f"profile, {name}", formal=formal, scale=size)
        found.append(
            Profile(
                title=f"{name.capitalize()} across the wall, plane stress", x_label="r [mm]",
                y_label=label, x=fine / mm, y=curve / factor, x_fem=at / mm,
                y_fem=values / factor, y_ref=reference / factor, u=sigma / factor,
                scale=size / factor,
                note="Points on a radius at 30°; below, what is left when the formula is taken "
                "away, in the band of the profile's own tolerance.",
            )
        )  # fmt: skip
    return found


def _over_speed(context: Context) -> Curves:
    q, v = context.inputs, context.analytic
    top = 1.1 * max(v["10 %"], q.omega)
    speed = np.linspace(0, top, 81)
    growth = v["bore growth, plane stress"] * (speed / q.omega) ** 2
    share = v["under the sprags"]
    return Curves(
        title="Growth of the bore over speed", x_label="n [r/min]", y_label="u_r(R_e) [µm]",
        curves=(
            Curve(name="growth, Eq. 8", x=speed / RPM, y=growth / um),
            *(
                Curve(name=f"{part:.0%} of the deflection under the sprags, Eq. 6",
                      x=np.array([0.0, top]) / RPM, y=np.full(2, part * share / um),
                      style="dashes", colour=k + 1)
                for k, part in enumerate((0.01, 0.1))
            ),
            Curve(name="the speed taken here", x=np.array([q.omega / RPM]),
                  y=np.array([v["bore growth, plane stress"] / um]), style="dots"),
        ),
        note="No speed is printed, so that nothing says where on this curve the paper's "
        "engagement lies.",
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="plane stress", data="hoop_stress", symbol="σ_θ", unit="MPa", factor=MPa,
                caption="Hoop stress, plane stress, cell means", mirror=("x", "y")),
    )  # fmt: skip
