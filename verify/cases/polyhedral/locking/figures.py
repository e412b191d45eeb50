"""What the report shows of the locked ring."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.polyhedral.locking import Roller, locked
from analytic.polyhedral.sector import Sector
from verify.cases.polyhedral.ring.sketch import body
from verify.core.case import Context, FemResult, Values
from verify.core.figures import Array, Curve, Curves, Equation, Figure, Picture, Shape, Sketch
from verify.core.tex import factor, tex

MPa, mm, N_mm = 1e6, 1e-3, 1e3
SIZES = (0.25, 0.5, 1.0, 2.0, 4.0)  # of the roller's diameter
STRETCHES = (0.005, 0.01, 0.02, 0.05, 0.1)  # of the wall above the flat
PRESSURES = np.linspace(0, 1.2, 9)  # of p_t, where finite elements are shown
FINE = 25


def diameters(q: Any) -> list[float]:
    """Diameters [m] of rollers that fit beside each other."""
    sine = np.sin(q.half_angle)
    room = 0.98 * (q.d_e + q.j_D) * sine / (1 - sine)
    return [float(d) for d in q.d * np.array(SIZES) if d < room]


def widths(q: Any) -> list[float]:
    """Half-widths [m] of bonded supports."""
    wall = min(q.d_e / 2 - q.apothem, q.half_angle * q.d_e / 2)
    return [float(w) for w in wall * np.array(STRETCHES)]


def sketch(q: Any) -> Sketch:
    return locked_sketch(q, d=q.d, e=q.e, p_t=q.p_t)


def locked_sketch(q: Any, *, d: float, e: float, p_t: float) -> Sketch:
    """The ring `q` with rollers of diameter d [m], the hub's contacts at e [m], pressure [Pa]."""
    shapes = body(q, gap=0.0)
    flat, at = q.apothem / (q.d_e / 2), e / (q.d_e / 2)
    for k in range(0, q.z, max(1, q.z // 6)):
        c, s = np.cos(2 * np.pi * k / q.z), np.sin(2 * np.pi * k / q.z)
        turn = np.array([[c, s], [-s, c]])
        hub = np.array([[flat - 0.28, at - 0.014], [flat, at]]) @ turn
        shapes.append(Shape(style="load", points=hub, label="R" if k == 0 else ""))
        push = np.array([[flat - 0.16, -0.1], [flat, -0.1]]) @ turn
        shapes.append(Shape(style="load", points=push, label="p" if k == 0 else ""))
    title = (
        f"the ring with {q.z} flats pressed against rollers of {d / mm:.4g} mm by p_t = "
        f"{p_t / MPa:.4g} MPa; the hub pushes on each flat with R at e = {e / mm:.4g} mm"
    )
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    return (
        Equation(
            tex=r"F = p_2 b d_i \sin\frac{\pi}{z}",
            numbers=rf"= {factor(v['p_2'] / MPa)}\cdot b\cdot {tex(q.d_i / mm)}\cdot "
            rf"\sin\frac{{\pi}}{{{q.z}}} = {tex(v['F'] / N_mm)}\ \mathrm{{N/mm}}\cdot b",
            place="Eq. 13, corrected",
        ),
        Equation(
            tex=r"N = F + R\cos\varphi_1",
            numbers=rf"= {factor(v['F'] / N_mm)} b + {tex(q.R_b / N_mm)} b\cdot "
            rf"{tex(np.cos(np.arctan(q.tan_phi)))} = {tex(v['N Eq. 16'] / N_mm)}"
            r"\ \mathrm{N/mm}\cdot b",
            place="Eq. 16 with γ = 0; the ring's hoop force is left out",
        ),
        Equation(
            tex=r"u_p\,p + u_h - u_N(a)\,N = \frac{j_D}{2}",
            numbers=rf"\Rightarrow N = {tex(v['N with hub'] / N_mm)}\ \mathrm{{N/mm}}\cdot b",
            place="series, with the half-width a of Hertz under N",
        ),
        Equation(
            tex=r"\eta = \frac{1}{b\,d_i\sin(\pi/z)}\,\frac{dN}{dp}",
            numbers=rf"= {tex(v['efficiency'])}",
            place="1 would be Eq. 16",
        ),
    )


def curves(levels: Sequence[FemResult]) -> dict[str, Array]:
    """The finite elements' curves, which one level has; none without it."""
    return next((dict(level.arrays) for level in levels if level.arrays), {})


def figures(context: Context) -> Sequence[Figure]:
    """Force of a roller over the pressure; efficiency over the width of the support."""
    q, v = context.inputs, context.analytic
    ring = Sector(z=q.z, d_e=q.d_e, d_i=q.d_i, rho=q.rho)

    def series(p: float, d: float, **own: float) -> Any:
        return locked(sector=ring, roller=Roller(d=d, j_D=q.j_D, **own), p=p, E=q.E, nu=q.nu,
                      assumption="plane stress")  # fmt: skip

    p = np.linspace(0, 1.2 * q.p_t, FINE)
    side = q.d_i * np.sin(q.half_angle)
    drawn = [
        Curve(name="Eq. 16 without hub", x=p / MPa, y=np.maximum(p - v["p_1r"], 0) * side / N_mm,
              style="dashes", colour=0),
        Curve(name="series", x=p / MPa, y=np.array([series(x, q.d).N for x in p]) / N_mm,
              colour=1),
        Curve(name="series, elastic rollers", x=p / MPa,
              y=np.array([series(x, q.d, E=q.E, nu=q.nu).N for x in p]) / N_mm, colour=4),
    ]  # fmt: skip
    fem = curves(context.fem)
    if "over pressure" in fem:
        alone, pushed, soft = fem["over pressure"] / N_mm
        at = PRESSURES * q.p_t / MPa
        drawn.append(Curve(name="FE", x=at, y=alone, style="dots", colour=2))
        drawn.append(Curve(name="FE, elastic rollers", x=at, y=soft, style="dots", colour=4))
        drawn.append(Curve(name="FE, with the hub's force", x=at, y=pushed, style="dots",
                            colour=3))  # fmt: skip
    found: list[Figure] = [
        Curves(title="Force of a roller over the pressure", x_label="p [MPa]",
               y_label="N/b [N/mm]", curves=tuple(drawn),
               note=f"Of a further pressure {v['efficiency']:.0%} reach rigid rollers; the rest is "
               "the ring's own hoop force. Eq. 16 hands on all of it.")
    ]  # fmt: skip
    if "rollers" in fem:
        found.append(_supports(q, fem, [series(q.p_t, d) for d in diameters(q)]))
    return tuple(found)


def _supports(q: Any, fem: Any, states: Sequence[Any]) -> Curves:
    """Efficiency over half the width that is held."""
    (a, eta), (w, bonded) = fem["rollers"], fem["bonded"]
    x: Array = np.array([s.a for s in states])
    sizes = ", ".join(f"{d / mm:.3g}" for d in diameters(q))
    return Curves(
        title="Efficiency over the width of the support", x_label="half-width [mm]",
        y_label="η",
        curves=(
            Curve(name="rollers, series", x=x / mm, y=np.array([s.efficiency for s in states]),
                  colour=1),
            Curve(name="rollers, FE", x=a / mm, y=eta, style="dots", colour=2),
            Curve(name="held stretch, FE", x=w / mm, y=bonded, style="dots", colour=4),
        ),
        y_bottom=float(0.9 * min(eta.min(), bonded.min())),
        note=f"Rollers of {sizes} mm under p_t, and stretches that are held all along.",
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="locked", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa, share=0.02,
                caption="Locked ring under pressure, hub and rollers: von Mises stress, coarse "
                "mesh"),
    )  # fmt: skip
