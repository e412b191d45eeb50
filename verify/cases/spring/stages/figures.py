"""What the report shows of the spring beyond its free stage: sketch, formulas, F over U."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.spring import frame
from analytic.spring.stages import stages
from verify.cases.spring.stages.fem import SHARES
from verify.cases.spring.stages.inputs import StagesInputs
from verify.cases.spring.stages.readings import EQ10_END, eq10, meeting
from verify.core.case import Context, Values
from verify.core.figures import Curve, Curves, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along
from verify.papers.ledger import published

MPa, mm = 1e6, 1e-3


def own(q: StagesInputs, **other: Any) -> Any:
    """The stages of the spring as the inputs hold it."""
    ends: dict[str, Any] = {"head": q.head, "tail": q.tail, "width_factor": q.factor}
    return stages(**q.path, **q.strip, **(ends | other))


def sketch(q: StagesInputs) -> Sketch:
    """The whole centre line to scale, with the gaps that the tips close."""
    line = frame.sections(frame.pieces(**q.path, tail="mid-leaf")).at.T / mm
    end = np.array(frame.end_point(**q.path, tail="mid-leaf")) / mm
    a, toward = q.L1 / 2 / mm, -1.0 if q.n % 2 == 0 else 1.0  # the tail's leaf runs this way
    tip = end + np.array([0.0, toward * a])
    line = np.vstack([[[0.0, -a]], [[0.0, 0.0]], line, [end], [tip]])
    low, high = line.min(axis=0), line.max(axis=0)
    tall, right = float(high[1] - low[1]), float(high[0])
    wall, edge = 0.08 * tall, 0.03 * tall
    facing = (q.L1 + q.R * math.cos(q.alpha)) / math.tan(q.alpha) + q.R * (1 + math.sin(q.alpha))
    facing /= mm
    arc_end = end - np.array([0.0, toward * a])
    held = sorted([arc_end[1], tip[1]] if q.tail == "arc" else [end[1] - wall, end[1] + wall])
    below, tail_side = -a - 0.6 * tall, toward * (a + 0.5 * tall)
    shapes = (
        Shape(style="text", points=np.array([[-1.1 * tall, 0.0]])),
        Shape(style="text", points=np.array([[right + 1.1 * tall, 0.0]])),
        Shape(style="axis", points=np.array([[-0.1 * tall, 0.0], [right + 0.2 * tall, 0.0]])),
        Shape(style="line", points=line),
        Shape(style="load", points=np.array([[-0.35 * tall, 0.0], [0.0, 0.0]]), label="F"),
        Shape(style="clamp", points=np.array([[right + edge, held[1]], [right + edge, held[0]]])),
        Shape(style="faint", points=np.array([[0.0, -a], [0.0, below]])),
        Shape(style="faint", points=np.array([[facing, -a], [facing, below]])),
        Shape(style="dimension", label=f"g_0 = {own(q).gap / mm:.3g} mm",
              points=np.array([[0.0, below], [facing, below]])),
        Shape(style="leader", label="free tip",
              points=np.array([[-0.3 * tall, -a - 0.15 * tall], [0.0, -a]])),
        Shape(style="leader", label="free tip" if q.tail == "mid-leaf" else "clamped leaf",
              points=np.array([[tip[0] + 0.25 * tall, tail_side], tip])),
        Shape(style="dimension", label=f"L_1 = {2 * a:.4g} mm",
              points=np.array([[-0.5 * tall, -a], [-0.5 * tall, a]])),
    )  # fmt: skip
    return Sketch(
        title=f"centre line with whole end leaves, head {q.head}, tail held at {q.tail}, to scale",
        shapes=shapes,
    )


def equations(q: StagesInputs, v: Values) -> Sequence[Equation]:
    EI = q.factor * q.E * q.h * q.b**3 / 12
    J, f_FC = EI / v["k1"], v["gap"] * EI / v["F_A"]
    alpha = rf"{tex(math.degrees(q.alpha), 4)}^\circ"
    R, facing = tex(q.R / mm, 4), tex((q.L1 + q.R * math.cos(q.alpha)) / mm, 5)
    lever = tex(q.b / 2 / mm, 3)
    return (
        Equation(
            tex=r"g_0 = R(1 + \sin\alpha) + \frac{L_1 + R\cos\alpha}{\tan\alpha} "
            r"- \frac{b}{2}\left(1 + \frac{1}{\sin\alpha}\right)",
            numbers=rf"= {R}\,(1 + \sin {alpha}) + \frac{{{facing}}}{{\tan {alpha}}} - {lever}\,"
            rf"\left(1 + \frac{{1}}{{\sin {alpha}}}\right) = {tex(v['gap'] / mm, 4)}\ "
            r"\mathrm{mm}",
        ),
        Equation(
            tex=r"k_1 = \frac{E I}{J}, \quad J = \int M^2 ds",
            numbers=rf"= \frac{{{tex(EI / mm**2, 5)}}}{{{tex(J / mm**3, 5)}}} "
            rf"= {tex(v['k1'] / 1e3, 4)}\ \mathrm{{N/mm}}",
        ),
        Equation(
            tex=r"F_A = \frac{g_0 E I}{f_{FC}}, \quad f_{FC} = \int M\,m\,ds",
            numbers=rf"= \frac{{{tex(v['gap'] / mm, 4)}\cdot {tex(EI / mm**2, 5)}}}"
            rf"{{{tex(f_FC / mm**3, 5)}}} = {tex(v['F_A'], 4)}\ \mathrm{{N}}",
        ),
        Equation(
            tex=r"U_A = \frac{F_A}{k_1}",
            numbers=rf"= \frac{{{tex(v['F_A'], 4)}}}{{{tex(v['k1'] / 1e3, 4)}}} "
            rf"= {tex(v['U_A'] / mm, 4)}\ \mathrm{{mm}}",
        ),
        Equation(
            tex=r"k_2 = \frac{E I}{J - p\,f_{FC}^2/f_{CC}}, \quad f_{CC} = \int m^2 ds",
            numbers=rf"= \frac{{{tex(EI / mm**2, 5)}}}{{{tex(J / mm**3, 5)} - "
            rf"{tex((J - EI / v['k2']) / mm**3, 5)}}} = {tex(v['k2'] / 1e3, 4)}\ \mathrm{{N/mm}}",
        ),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    found: list[Figure] = [_judged(context)] if context.converging else []
    return (*found, *(_beside_eq_10(context) if context.is_paper else _bounds(context.inputs)))


def _judged(context: Context) -> Profile:
    """Force over displacement as the inputs hold the spring, with the frame on it."""
    q = context.inputs
    line = own(q, theory="thin")
    length = frame.end_point(**q.path, tail=q.tail)[0]
    at = SHARES * length
    scale = float(line.force(at[-1]))
    values, u = along(context, "force", formal=2.0, scale=scale)
    U = np.linspace(0, at[-1], 200)
    return Profile(
        title=f"Force over displacement, head {q.head}, tail held at {q.tail}, linear theory",
        x_label="U [mm]", y_label="F [N]", x=U / mm, y=line.force(U), x_fem=at / mm, y_fem=values,
        y_ref=line.force(at), u=u, scale=scale, scale_name="the largest force shown",
        note="Line: closed form; dots: straight elements with rigid links between tips and leaves.",
    )  # fmt: skip


def _beside_eq_10(context: Context) -> tuple[Curves, ...]:
    """Readings that meet the printed k_1, and the inputs' own, over the lines of Eq. 10."""
    q, lines = context.inputs, eq10()
    tests = [published(f"wang2023:{name}-test").value * 1e3 for name in ("k1", "k2")]
    U = np.linspace(0.0, EQ10_END, 60)
    printed = np.where(U > lines.U, lines.c2 + lines.k2 * U, lines.c1 + lines.k1 * U)
    tested = np.where(U > lines.U, (tests[0] - tests[1]) * lines.U + tests[1] * U, tests[0] * U)
    found = [("Eq. 10, the paper's shell model", printed, "line", 0),
             ("slopes of the tests, from the origin", tested, "dots", 5)]  # fmt: skip
    found += [
        (f"meets k_1: {x}", x.stages.force(U), "dashes", i)
        for i, x in enumerate(meeting(q)[:3], start=1)
    ]
    strip = "E I" if q.width_factor is None else f"{q.width_factor:.4g} E I"
    name = f"tail at {q.tail}, head {q.head}, r + b/2, {strip}"
    found.append((name, own(q).force(U), "dashes", 4))
    note = (
        "To 11 N, where the tests end. The constants of the tests' lines are not printed: their "
        "slopes are drawn from the origin, with Eq. 10's point A."
    )
    return (
        Curves(
            title="Closed form beside Eq. 10: what a reading chosen by k_1 says of A and k_2",
            x_label="U [mm]", y_label="F [N]", note=note,
            curves=tuple(_curve(name, U / mm, F, style, c) for name, F, style, c in found),
        ),
        Curves(
            title="The same less Eq. 10's first slope, which shows where the tips touch",
            x_label="U [mm]", y_label="F − 0.613 N/mm U [N]", note=note,
            y_bottom=float(min((F - lines.k1 * U).min() for _, F, _, _ in found)),
            curves=tuple(
                _curve(name, U / mm, F - lines.k1 * U, style, c) for name, F, style, c in found
            ),
        ),
    )  # fmt: skip


def _bounds(q: StagesInputs) -> tuple[Curves, ...]:
    """The inputs' own spring, narrow and wide, and with its other ends."""
    top = 1.5 * float(own(q).U_A)
    curves = []
    for i, head in enumerate(("guided", "free")):
        for style, tail in (("line", "mid-leaf"), ("dashes", "arc")):
            s = own(q, head=head, tail=tail)
            U = np.unique(np.clip([0.0, float(s.U_A), float(s.U_B), top], 0.0, top))
            curves.append(_curve(f"head {head}, tail at {tail}", U / mm, s.force(U), style, i))
    return (Curves(
        title="Force over displacement for every way of holding the ends", x_label="U [mm]",
        y_label="F [N]", curves=tuple(curves), note="Closed form, linear theory.",
    ),)  # fmt: skip


def _curve(name: str, U: Any, F: Any, style: str, colour: int) -> Curve:
    return Curve(name=name, x=np.asarray(U), y=np.asarray(F), style=style, colour=colour)


def pictures(q: StagesInputs) -> Sequence[Picture]:
    s = own(q)
    body = max(frame.end_point(**q.path, tail="mid-leaf")[0], q.L1 + 2 * q.R)
    return (
        Picture(field="point A", data="bending_stress", symbol="σ_b", unit="MPa", factor=MPa,
                width=q.h, share=float(s.U_A) / body,
                caption="Bending stress 6 M/(h b²) where the tips touch, displacements to scale"),
    )  # fmt: skip
