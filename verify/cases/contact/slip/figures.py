"""What the report shows of partial slip: sketch, formulas with numbers, tractions, the loop."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import hertz_line, partial_slip, tangential_cycle
from verify.cases.contact.slip.fem import GROWTH, SHARES, STAGES
from verify.cases.contact.slip.read import ACROSS, AROUND
from verify.core.case import Context, Values
from verify.core.figures import Dots, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, um, nm, uJ = 1e6, 1e-6, 1e-9, 1e-6
FINE = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))  # x/a of curves, dense at the edges


def sketch(q: Any) -> Sketch:
    """Both half discs, their contact not to scale."""
    t = np.linspace(0.0, np.pi, 61)
    lower = np.column_stack([np.cos(t), np.sin(t) - 1])
    upper = lower * (1, -1)
    wall = 0.1
    a, c = q.a / um, float(partial_slip.stick_half_width(Q=q.share * q.mu * q.P, a=q.a, **q.loads))
    shapes = (
        Shape(style="modelled", points=upper),
        Shape(style="modelled", points=lower),
        Shape(style="axis", points=np.array([[0.0, -1.3], [0.0, 1.3]])),
        Shape(style="clamp", points=np.array([[1 + wall, -1.0], [-1 - wall, -1.0]])),
        Shape(style="load", points=np.array([[0.0, 1.55], [0.0, 1.05]]), label="P"),
        Shape(style="load", points=np.array([[-1.6, 1.0], [-1.08, 1.0]]), label="Q"),
        Shape(style="leader", points=np.array([[1.5, 0.42], [0.05, 0.0]]),
              label=f"contact, a = {a:.4g} µm"),
        Shape(style="leader", points=np.array([[1.5, -0.42], [0.02, -0.01]]),
              label=f"sticks to c = {c / um:.4g} µm"),
        Shape(style="leader", points=np.array([[-1.5, -0.3], [-0.86, -0.5]]),
              label=f"R = {q.R * 1e3:.4g} mm"),
        Shape(style="text", points=np.array([[2.6, 0.0]])),
        Shape(style="text", points=np.array([[-2.4, 0.0]])),
    )  # fmt: skip
    return Sketch(
        title="two equal half discs; the lower cut is fixed, the upper one driven along x and y",
        shapes=shapes,
    )


def equations(q: Any, v: Values) -> Sequence[Equation]:
    k, limit = q.share, v["limit"]
    P, E, kN = tex(q.P / 1e3), tex(q.E_star / MPa), tex(limit / 1e3)
    rest = 1 - k
    bracket = k * (2 - k) + 2 * rest * math.log(rest)
    return (
        Equation(
            tex=r"a = \sqrt{\frac{4 P (R/2)}{\pi E^*}}, \quad E^* = \frac{E}{2(1-\nu^2)}",
            numbers=rf"= \sqrt{{\frac{{2\cdot {P}\cdot {tex(q.R * 1e3)}}}{{\pi\cdot {E}}}}} "
            rf"= {tex(q.a / um)}\ \mathrm{{\mu m}}",
            place="Hertz",
        ),
        Equation(
            tex=r"\frac{c}{a} = \sqrt{1 - \frac{Q}{\mu P}}",
            numbers=rf"= \sqrt{{1 - {tex(k)}}} = {tex(math.sqrt(rest))}",
            place="Cattaneo, at Q_max",
        ),
        Equation(
            tex=r"q_1(x, Q) = \mu p_0\left[\sqrt{1-\frac{x^2}{a^2}}"
            r" - \frac{c}{a}\sqrt{1-\frac{x^2}{c^2}}\right]",
            numbers=rf"\Rightarrow\ q_1(0, Q_{{max}}) = {tex(q.mu)}"
            rf"\cdot {tex(v['peak pressure'] / MPa)}\,(1 - {tex(math.sqrt(rest))}) = "
            rf"{tex(q.mu * v['peak pressure'] / MPa * (1 - math.sqrt(rest)))}\ \mathrm{{MPa}}",
            place="Cattaneo, first loading",
        ),
        Equation(
            tex=r"\delta = \frac{\mu P}{\pi E^*}\left[k + (1-k)\ln(1-k)\right],"
            r"\quad k = \frac{Q}{\mu P}",
            numbers=rf"= \frac{{{kN}}}{{\pi\cdot {E}}}\cdot {tex(k + rest * math.log(rest))} "
            rf"= {tex(v['beyond stick'] / nm)}\ \mathrm{{nm}}",
            place="beyond a contact that sticks whole; with Q_max",
        ),
        Equation(
            tex=r"q(x) = q_1(x, Q_{max}) - 2\,q_1\left(x, \frac{Q_{max}-Q}{2}\right)",
            place="Mindlin, on the way down",
        ),
        Equation(
            tex=r"W = \frac{2(\mu P)^2}{\pi E^*}\left[k(2-k) + 2(1-k)\ln(1-k)\right]",
            numbers=rf"= \frac{{2\cdot {kN}^2}}{{\pi\cdot {E}}}\cdot {tex(bracket)} "
            rf"= {tex(v['energy'] / uJ)}\ \mathrm{{\mu J/m}}",
            place="energy of a cycle, per length; k of Q_max",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    return (
        _first_loading(context), _growth(context), _cycle(context), _loop(context),
        _energies(context),
    )  # fmt: skip


def _first_loading(context: Context) -> Profile:
    """Tractions for all shares in one line, to and fro: all of them end at zero."""
    q = context.inputs

    def curve(x: Any, k: float) -> Any:
        return partial_slip.traction(x * q.a, Q=k * q.mu * q.P, a=q.a, **q.loads)

    limit = q.mu * hertz_line.pressure(FINE * q.a, a=q.a, p_0=context.analytic["peak pressure"])
    edges = ", ".join(f"±{math.sqrt(1 - k):.3f} a" for k in SHARES)
    lines = [curve(FINE, k) for k in SHARES] + [limit]
    return _chained(
        context, lines, [curve(ACROSS, k) for k in SHARES], [f"k = {k:g}" for k in SHARES],
        title="Traction under Q/(μP) = 0.2, 0.4, 0.6, 0.8",
        note=f"The outermost line is μp, where all slips; a traction leaves it at the edge of its "
        f"stick zone, {edges}.",
    )  # fmt: skip


def _cycle(context: Context) -> Profile:
    q = context.inputs
    Q_max = q.share * q.mu * q.P

    def curve(x: Any, stage: float) -> Any:
        return tangential_cycle.traction(
            x * q.a, Q=stage * Q_max, Q_max=Q_max, a=q.a, branch="unloading", **q.loads
        )

    stages = (1.0, *STAGES)
    return _chained(
        context, [curve(FINE, s) for s in stages], [curve(ACROSS, s) for s in stages],
        [f"Q/Q_max = {s:g}" for s in stages],
        title="Traction on the way down: Q/Q_max = 1, 0.5, 0, −0.5, −1",
        note="From the top line down. Slip the other way starts at the edges; at Q = 0 the "
        "traction is not zero.",
    )  # fmt: skip


def _chained(
    context: Context, curves: list[Any], references: list[Any], names: list[str], *, title: str,
    note: str,
) -> Profile:  # fmt: skip
    """Several curves over x/a that all end at zero, drawn as one line."""
    scale = context.inputs.mu * context.analytic["peak pressure"]
    found = [along(context, f"profile, {name}", formal=1.0, scale=scale) for name in names]

    def chain(parts: Sequence[Any]) -> Any:
        return np.concatenate([part[:: (-1) ** i] for i, part in enumerate(parts)])

    x = np.tile(ACROSS, len(names))
    order = np.argsort(x, kind="stable")
    y_fem = np.concatenate([values for values, _ in found])[order] / scale
    return Profile(
        title=title, x_label="x/a", y_label="q/(μp_0)", x=chain([FINE] * len(curves)),
        y=chain(curves) / scale, x_fem=x[order], y_fem=y_fem,
        y_ref=np.concatenate(references)[order] / scale,
        u=np.full(x.size, max(u.max() for _, u in found)) / scale, scale=1.0,
        note=note + " Below: what is left at fixed places, in the band of all meshes.",
    )  # fmt: skip


def _growth(context: Context) -> Profile:
    values, u = along(context, "profile, growth", formal=1.0, scale=1.0)
    k = np.linspace(0.0, 1.0, 201)
    return Profile(
        title="Stick zone shrinks as Q grows", x_label="Q/(μP)", y_label="c/a", x=k,
        y=np.sqrt(1 - k), x_fem=GROWTH, y_fem=values, y_ref=np.sqrt(1 - GROWTH), u=u, scale=1.0,
        note="Stick half-width from the moments of the traction.",
    )  # fmt: skip


def _loop(context: Context) -> Profile:
    q = context.inputs
    Q_max = q.share * q.mu * q.P

    def beyond(s: Any) -> Any:
        """Displacement beyond the line between the reversals, down and up again."""
        of: dict[str, Any] = {"Q_max": Q_max, "E_star": q.E_star, **q.loads}
        rigid = tangential_cycle.rigid_displacement_beyond_stick
        top = rigid(Q=Q_max, branch="unloading", **of)
        down = rigid(Q=s[::-1] * Q_max, branch="unloading", **of) - s[::-1] * top
        up = rigid(Q=s * Q_max, branch="reloading", **of) - s * top
        return np.concatenate([down, up])

    fine = np.linspace(-1.0, 1.0, 101)
    scale = context.analytic["left at Q = 0"]
    values, u = along(context, "profile, loop", formal=1.0, scale=scale)
    x = np.concatenate([AROUND[::-1], AROUND])
    order = np.argsort(x, kind="stable")
    return Profile(
        title="Loop of displacement over force", x_label="Q/Q_max", y_label="δ − δ_c [nm]",
        x=np.concatenate([fine[::-1], fine]), y=beyond(fine) / nm, x_fem=x[order],
        y_fem=values[order] / nm, y_ref=beyond(AROUND)[order] / nm, u=u / nm, scale=scale / nm,
        scale_name="δ(0)",
        note="Displacement beyond the straight line δ_c between both reversals; above on the way "
        "down. What the loop encloses is lost.",
    )  # fmt: skip


def _energies(context: Context) -> Dots:
    finest = context.fem[-1].values
    return Dots(
        title="Energy lost in a cycle", label="W [µJ/m]",
        items=(
            ("Mindlin", context.analytic["energy"] / uJ, None, "formula"),
            ("FE, work of friction", finest["friction's work"] / uJ, None, "fe"),
            ("FE, area of the loop", finest["loop's area"] / uJ, None, "fe"),
        ),
        note="Friction's work is summed over nodes and steps, the area is taken from forces and "
        "displacements of the cut.",
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    relative = float(hertz_line.relative_radius(R_1=q.R, R_2=q.R))
    p_0 = float(hertz_line.peak_pressure(P=q.P, R=relative, E_star=q.E_star))
    w = 2.0 * q.a
    return (
        Picture(field="pushed", data="shear_at_nodes", symbol="τ_max/p_0", unit="1", factor=p_0,
                caption="Largest shear stress about the contact at Q_max, over p_0, from means "
                "of cells at nodes", displacement="",
                window=(-w, -w, w, w)),
    )  # fmt: skip
