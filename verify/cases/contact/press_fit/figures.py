"""What the report shows of a press fit: sketch, formulas with numbers, profiles, pictures."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact.press_fit import Wall
from verify.core.case import Context, Values
from verify.core.figures import Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, mm, um = 1e6, 1e-3, 1e-6
WORDS = {"rings": "rings", "drawn": "rings drawn with overlap", "shaft": "solid shaft"}
TURNS = np.linspace(0.02, np.pi / 2 - 0.02, 41)  # where the pressure is plotted [rad]
ASKEW = np.radians(30.0)  # direction of the profile across: on no line of the mesh's symmetry
ACROSS = 7  # stations in each wall


def stations(q: Any) -> tuple[Any, Any]:
    """Radii (m,) of the profile in the inner and in the outer wall [m], off the fit itself."""
    off = 1e-3
    return tuple(
        np.linspace(a + off * (b - a), b - off * (b - a), ACROSS)
        for a, b in ((q.r_i, q.r_f), (q.r_f, q.r_o))
    )  # type: ignore[return-value]


def across(q: Any, plane: Any) -> dict[str, Any]:
    """Hoop and radial stress at the stations of both walls, of a solved plane problem."""
    r = np.concatenate(stations(q))
    _, radial, hoop, _ = plane.at(np.outer([np.cos(ASKEW), np.sin(ASKEW)], r)).polar()
    return {"hoop stress": hoop, "radial stress": radial}


def sketch(q: Any) -> Sketch:
    inner, fit = q.r_i / q.r_o, q.r_f / q.r_o

    def arc(r: float, start: float = 0.0, end: float = 2 * np.pi) -> Any:
        t = np.linspace(start, end, 73)
        return r * np.column_stack([np.cos(t), np.sin(t)])

    def ray(degrees: float, r0: float, r1: float) -> Any:
        t = np.radians(degrees)
        return np.outer([r0, r1], [np.cos(t), np.sin(t)])

    quarter = np.vstack([arc(1.0, 0, np.pi / 2), arc(inner, np.pi / 2, 0)])
    shapes = [
        Shape(style="body", points=arc(1.0)),
        Shape(style="hole", points=arc(inner)),
        Shape(style="modelled", points=quarter),
        Shape(style="line", points=arc(fit)),
        Shape(style="axis", points=np.array([[-1.12, 0.0], [1.12, 0.0]])),
        Shape(style="axis", points=np.array([[0.0, -1.12], [0.0, 1.12]])),
    ]
    for degrees in (22.5, 67.5, 112.5, 157.5, 202.5, 247.5, 292.5, 337.5):
        first = degrees == 22.5
        if q.p_i:
            points = ray(degrees, max(inner - 0.2, 0.0), inner)
            shapes.append(Shape(style="load", points=points, label="p_i" if first else ""))
        if q.p_o:
            points = ray(degrees, 1.2, 1.0)
            shapes.append(Shape(style="load", points=points, label="p_o" if first else ""))
    labels = (("r_o", q.r_o, 130, 1.0), ("r_f", q.r_f, 158, fit), ("r_i", q.r_i, 220, inner))
    for name, r, degrees, at in labels:
        shapes.append(
            Shape(style="leader", points=ray(degrees, 1.35, at), label=f"{name} = {r / mm:.4g} mm")
        )
    shapes += [
        Shape(style="leader", points=np.array([[1.2, 0.98], [0.75, 0.52]]), label="FE: a quarter"),
        Shape(style="leader", label=f"δ = {q.delta / um:.4g} µm",
              points=np.array([[1.2, -0.98], [fit * 0.77, -fit * 0.638]])),
    ]  # fmt: skip
    title = (
        f"inner ring (E = {q.E_i / 1e9:.4g} GPa) pressed into the outer one "
        f"({q.E_o / 1e9:.4g} GPa), {q.p_i / MPa:.4g} MPa in the bore, {q.p_o / MPa:.4g} MPa outside"
    )
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    inner, outer = _pair(q)
    soft = {
        "i": -float(inner.displacement(q.r_f, p_i=0, p_o=1, assumption="plane stress")),
        "o": float(outer.displacement(q.r_f, p_i=1, p_o=0, assumption="plane stress")),
    }
    lost = float(outer.displacement(q.r_f, p_i=0, p_o=q.p_o, assumption="plane stress"))
    lost -= float(inner.displacement(q.r_f, p_i=q.p_i, p_o=0, assumption="plane stress"))
    r_i, r_f, r_o = (tex(r / mm) for r in (q.r_i, q.r_f, q.r_o))
    micro = {k: tex(s / um * MPa) for k, s in soft.items()}
    unit = r"\frac{\mathrm{\mu m}}{\mathrm{MPa}}"
    p = v["rings, plane stress: p"] / MPa
    return (
        Equation(
            tex=r"c_i = \frac{r_f}{E_i}\left[\frac{r_f^2 + r_i^2}{r_f^2 - r_i^2} - \nu_i\right]",
            numbers=rf"= \frac{{{r_f}}}{{{tex(q.E_i / MPa)}}}\left[\frac{{{r_f}^2 + {r_i}^2}}"
            rf"{{{r_f}^2 - {r_i}^2}} - {tex(q.nu_i)}\right] = {micro['i']}\ {unit}",
            place="Lamé; behind Eq. 6",
        ),
        Equation(
            tex=r"c_o = \frac{r_f}{E_o}\left[\frac{r_o^2 + r_f^2}{r_o^2 - r_f^2} + \nu_o\right]",
            numbers=rf"= \frac{{{r_f}}}{{{tex(q.E_o / MPa)}}}\left[\frac{{{r_o}^2 + {r_f}^2}}"
            rf"{{{r_o}^2 - {r_f}^2}} + {tex(q.nu_o)}\right] = {micro['o']}\ {unit}",
        ),
        Equation(
            tex=r"\delta_0 = \frac{2 p_i r_f r_i^2}{E_i (r_f^2 - r_i^2)}"
            r" + \frac{2 p_o r_f r_o^2}{E_o (r_o^2 - r_f^2)}",
            numbers=rf"= {tex(-lost / um)}\ \mathrm{{\mu m}}", place="what p_i and p_o add to δ",
        ),
        Equation(
            tex=r"p = \frac{\delta + \delta_0}{c_i + c_o}",
            numbers=rf"= \frac{{{tex(q.delta / um)} + {tex(-lost / um)}}}"
            rf"{{{micro['i']} + {micro['o']}}} = {tex(p)}\ \mathrm{{MPa}}", place="plane stress",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    """Stresses through both walls, and the contact pressure along the fit."""
    if not context.converging:
        return ()
    q, v = context.inputs, context.analytic
    p = v["rings, plane stress: p"]
    scale = v["rings, plane stress: hoop scale"]
    loads = ({"p_i": q.p_i, "p_o": p}, {"p_i": p, "p_o": q.p_o})
    fine = (np.linspace(q.r_i, q.r_f, 41), np.linspace(q.r_f, q.r_o, 41))
    found: list[Figure] = []
    for i, (name, label) in enumerate(
        (("radial stress", "σ_r [MPa]"), ("hoop stress", "σ_θ [MPa]"))
    ):
        curve, at = (
            np.concatenate([
                wall.stresses(r, **load)[i]
                for wall, load, r in zip(_pair(q), loads, radii, strict=True)
            ])
            for radii in (fine, stations(q))
        )  # fmt: skip
        values, u = along(context, f"profile {name}", formal=2.0, scale=scale)
        found.append(Profile(
            title=f"{name.capitalize()} through both rings, plane stress", x_label="r [mm]",
            y_label=label, x=np.concatenate(fine) / mm, y=curve / MPa,
            x_fem=np.concatenate(stations(q)) / mm, y_fem=values / MPa, y_ref=at / MPa, u=u / MPa,
            scale=scale / MPa,
            note="Points on a radius at 30°; below, what is left when the formula is taken away, "
            "in the band of the profile's own tolerance.",
        ))  # fmt: skip
    values, u = along(context, "p along", formal=2.0, scale=p)
    even = np.full(TURNS.size, p)
    found.append(Profile(
        title="Contact pressure along the fit, rings, plane stress", x_label="angle [deg]",
        y_label="p [MPa]", x=np.degrees(TURNS), y=even / MPa, x_fem=np.degrees(TURNS),
        y_fem=values / MPa, y_ref=even / MPa, u=u / MPa, scale=p / MPa, scale_name="p",
        note="The meshes do not match: three cells on the inner ring lie on two of the outer one.",
    ))  # fmt: skip
    return tuple(found)


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="rings, plane stress", data="hoop_stress", symbol="σ_θ", unit="MPa",
                factor=MPa, mirror=("x", "y"), displacement="",
                caption="Hoop stress of both rings, plane stress, cell means"),
        Picture(field="shaft, plane stress", data="von_mises", symbol="σ_v", unit="MPa",
                factor=MPa, mirror=("x", "y"), displacement="",
                caption="Von Mises stress with a solid shaft, plane stress, cell means"),
    )  # fmt: skip


def _pair(q: Any) -> tuple[Wall, Wall]:
    return (
        Wall(r_i=q.r_i, r_o=q.r_f, E=q.E_i, nu=q.nu_i),
        Wall(r_i=q.r_f, r_o=q.r_o, E=q.E_o, nu=q.nu_o),
    )
