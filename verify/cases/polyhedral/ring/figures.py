"""What the report shows of the polyhedral ring under pressure."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.polyhedral import bore_pressure
from analytic.polyhedral.sector import Sector
from verify.cases.polyhedral.fem import stations
from verify.core.case import Context, Values
from verify.core.figures import Array, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import factor, tex
from verify.form.sketches import circle
from verify.judging.profiles import along

MPa, mm, um = 1e6, 1e-3, 1e-6
ARC = 13  # points of a fillet


def outline(q: Any) -> Array:
    """The bore as points (m, 2), in units of the outer radius."""
    points = []
    for k in range(q.z):
        middle = 2 * np.pi * (k + 0.5) / q.z
        turn = middle + np.linspace(-1, 1, ARC) * q.half_angle
        centre = (q.d_i / 2 - q.rho) * np.array([np.cos(middle), np.sin(middle)])
        points.append(centre + q.rho * np.column_stack([np.cos(turn), np.sin(turn)]))
    return np.asarray(np.vstack(points) / (q.d_e / 2))


def half(q: Any) -> Array:
    """Half a sector as a closed outline (m, 2)."""
    r = q.d_e / 2
    turn = np.linspace(0, q.half_angle, ARC)
    centre = (q.d_i / 2 - q.rho) * np.array([np.cos(q.half_angle), np.sin(q.half_angle)])
    fillet = centre + q.rho * np.column_stack([np.cos(turn), np.sin(turn)])
    rim = r * np.column_stack([np.cos(turn[::-1]), np.sin(turn[::-1])])
    return np.asarray(np.vstack([[[q.apothem, 0.0]], fillet, rim]) / r)


def body(q: Any, gap: float = 0.05, roller: float = 0.12) -> list[Shape]:
    """Ring, rollers and race, the clearance drawn large; the modelled half sector shaded."""
    shapes = [
        circle(1.0, "body"),
        Shape(style="hole", points=outline(q)),
        Shape(style="modelled", points=half(q)),
        circle(1 + gap + 2 * roller),
    ]
    size = min(roller, 0.9 * (1 + gap + roller) * np.sin(q.half_angle))
    for k in range(q.z):
        angle = 2 * np.pi * k / q.z
        at = (1 + gap + size) * np.array([np.cos(angle), np.sin(angle)])
        shapes.append(circle(size, centre=(at[0], at[1])))
    return shapes


def sketch(q: Any) -> Sketch:
    shapes = body(q)
    for k in range(0, q.z, max(1, q.z // 6)):
        angle = 2 * np.pi * k / q.z
        flat = q.apothem / (q.d_e / 2)
        way = np.outer([flat - 0.24, flat], [np.cos(angle), np.sin(angle)])
        shapes.append(Shape(style="load", points=way, label="p" if k == 0 else ""))
    corner = q.half_angle + np.pi * (1 - 2 / q.z if q.z > 3 else 0.0)
    thin = (q.d_i + q.d_e) / 2 / q.d_e * np.array([np.cos(corner), np.sin(corner)])
    shapes.append(
        Shape(style="leader", points=np.array([[-1.3, 1.02], thin]),
              label=f"δ_1 = {q.delta_1 / mm:.4g} mm")
    )  # fmt: skip
    inside = half(q)[ARC // 2 + 1 : ARC + 4].mean(axis=0)
    shapes.append(
        Shape(style="leader", points=np.array([[1.32, 1.05], inside]), label="FE: half a sector")
    )  # fmt: skip
    title = (
        f"a ring with {q.z} flats in its bore, d_e = {q.d_e / mm:.4g} mm, fillets of "
        f"{q.rho / mm:.3g} mm; rollers and race drawn faint, the clearance much too large"
    )
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    return (
        Equation(
            tex=r"p_{1r} = K p_1 = K\,\frac{2\delta_1 E j_D}{d_i d_m}",
            numbers=rf"= {tex(v['K mid'])}\cdot {factor(v['p_1'] / MPa)} "
            rf"= {tex(v['p_1r'] / MPa)}\ \mathrm{{MPa}}",
            place="Eq. 11, K in the middle of the flats",
        ),
        Equation(
            tex=r"\sigma_{tr} = \frac{p_{1r} d_i}{2\delta_1} = K\sigma_t",
            numbers=rf"= {tex(v['K mid'])}\cdot {factor(v['sigma_t'] / MPa)} "
            rf"= {tex(v['sigma_tr'] / MPa)}\ \mathrm{{MPa}}",
            place="Eq. 12, read as p_1r/p_1 = K: the mean over the wall in a corner",
        ),
        Equation(
            tex=r"K \to \frac{d_m^2}{d_i d_e}\quad (z \to \infty)",
            numbers=rf"= \frac{{{tex(q.d_m / mm)}^2}}{{{tex(q.d_i / mm)}\cdot {tex(q.d_e / mm)}}} "
            rf"= {tex(v['K many'])}",
            place="Lamé",
        ),
        Equation(
            tex=r"u_r + i u_\theta = \frac{4}{E}\,e^{-i\theta}\,\varphi(r_e e^{i\theta})",
            place="outside, by the complex potential",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    """The outside where its flats have reached the rollers: series and finite elements."""
    q, v = context.inputs, context.analytic
    if not context.converging:
        return ()
    ring = Sector(z=q.z, d_e=q.d_e, d_i=q.d_i, rho=q.rho)
    fine, at = np.linspace(0, q.half_angle, 121), stations(q)
    load = {"p": v["p_1r"], "E": q.E, "nu": q.nu, "assumption": "plane stress"}
    y, y_ref = (bore_pressure.rim_displacement(t, sector=ring, **load).real for t in (fine, at))
    values, u = along(context, "outside", formal=3, scale=q.j_D / 2)
    return (
        Profile(
            title="Growth of the outside where it reaches the rollers",
            x_label="angle from the middle of a flat [°]", y_label="u_r [µm]",
            x=np.degrees(fine), y=y / um, x_fem=np.degrees(at), y_fem=values / um,
            y_ref=y_ref / um, u=u / um, scale=q.j_D / 2 / um, scale_name="half the clearance",
            note="The rollers sit at 0°; the corner is at the right. Line: complex potentials.",
        ),
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    return tuple(
        Picture(field=f"z = {z}", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                share=0.02,
                caption=f"{z} flats, where they have taken up the clearance: von Mises stress")
        for z in dict.fromkeys((3, 6, 12, q.z))
    )  # fmt: skip
