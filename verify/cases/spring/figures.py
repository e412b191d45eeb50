"""What the report shows of an accordion spring: sketch, formulas with numbers, figures."""

import math
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np

from analytic.spring import energy, frame
from analytic.spring.moments import moment_diagram
from verify.cases.spring.inputs import strip_of
from verify.core.case import Context, Values
from verify.core.figures import Dots, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published

MPa, mm = 1e6, 1e-3
PRINTED = ("k1-theory", "k1-fea", "k1-test")


def sketch(q: Any) -> Sketch:
    """The centre line to scale, with force, clamp and the lengths that the formulas name."""
    line = frame.sections(frame.pieces(**q.path, tail="arc")).at.T / mm
    end = np.array(frame.end_point(**q.path, tail="arc")) / mm
    line = np.vstack([[[0.0, 0.0]], line, [end]])
    low, high = line.min(axis=0), line.max(axis=0)
    L1, tall = q.L1 / mm, float(high[1] - low[1])
    left, right = float(low[0]), float(high[0])
    wall = 0.06 * tall
    top, foot = high[1] + 0.16 * tall, low[1]
    leaf = line[int(0.5 * len(line)) + np.argmin(abs(line[int(0.5 * len(line)) :, 1]))]
    L0 = frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha) / mm
    shapes = (
        # room on both sides for the labels
        Shape(style="text", points=np.array([[left - 0.6 * tall, 0.0]])),
        Shape(style="text", points=np.array([[right + 0.5 * tall, 0.0]])),
        Shape(style="axis", points=np.array([[left - 0.1 * tall, 0.0], [right + 0.2 * tall, 0.0]])),
        Shape(style="line", points=line),
        Shape(style="load", points=np.array([[-0.3 * tall, 0.0], [0.0, 0.0]]), label="F"),
        Shape(style="clamp", points=np.array([[end[0] + wall, end[1]], [end[0] - wall, end[1]]])),
        Shape(style="leader", label="tail clamped",
              points=np.array([[end[0] + 0.2 * tall, end[1] + 0.45 * tall], end])),
        Shape(style="dimension", label=f"L_1/2 = {L1 / 2:.4g} mm",
              points=np.array([[-0.12 * tall, 0.0], [-0.12 * tall, L1 / 2]])),
        Shape(style="dimension", label=f"L_0 = {L0:.4g} mm, n = {q.n}",
              points=np.array([[left, top], [right, top]])),
        Shape(style="leader", label=f"r = {q.r / mm:.4g} mm inside",
              points=np.array([[0.2 * (left + right), foot - 0.25 * tall], _bottom(line)])),
        Shape(style="leader", label=f"leaves at α = {math.degrees(q.alpha):.4g}°",
              points=np.array([[leaf[0] + 0.35 * tall, foot - 0.25 * tall], leaf])),
    )  # fmt: skip
    strip = f"strip {q.b / mm:.4g} mm × {q.h / mm:.4g} mm"
    return Sketch(title=f"centre line of the spring, to scale; {strip}", shapes=shapes)


def _bottom(line: Any) -> Any:
    return line[int(np.argmin(line[:, 1]))]


def equations(q: Any, v: Values) -> Sequence[Equation]:
    eqs: dict[str, Any] = {"n": q.n, "L1": q.L1, "r": q.r, "b": q.b, "alpha": q.alpha}
    L2 = float(energy.leaf_length(L1=q.L1, r=q.r, b=q.b, alpha=q.alpha))
    f, T = float(energy.flexibility(**eqs)), [float(t) / mm for t in energy.apex_moments(**eqs)]
    EI = q.E * q.h * q.b**3 / 12
    alpha = rf"{tex(math.degrees(q.alpha))}^\circ"
    half, r, R = tex(q.L1 / 2 / mm), tex(q.r / mm), tex(q.R / mm)
    return (
        Equation(
            tex=r"L_2 = \frac{L_1}{\sin\alpha} + \frac{2(r + b/2)}{\tan\alpha}",
            numbers=rf"= \frac{{{tex(q.L1 / mm)}}}{{\sin {alpha}}} + \frac{{2\cdot {R}}}"
            rf"{{\tan {alpha}}} = {tex(L2 / mm)}\ \mathrm{{mm}}",
            place="Eq. 3",
        ),
        Equation(
            tex=r"\frac{T_1}{F} = \frac{L_1}{2} + r",
            numbers=rf"= {half} + {r} = {tex(T[0])}\ \mathrm{{mm}}", place="Eq. 1",
        ),
        Equation(
            tex=r"T_i = T_{i-1} \pm (2 r(1-\cos\alpha) + L_2\sin\alpha)\,F",
            numbers=rf"\Rightarrow\ \frac{{T_2}}{{F}} = {tex(T[1])}\ \mathrm{{mm}}", place="Eq. 3",
        ),
        Equation(
            tex=r"\int \left(\frac{M}{F}\right)^2 ds",
            numbers=rf"= {tex(f / mm**3)}\ \mathrm{{mm^3}}", place="Eqs. 2, 4, 6, 7",
        ),
        Equation(
            tex=r"k_1 = \frac{E h b^3/12}{\int (M/F)^2 ds}",
            numbers=rf"= \frac{{{tex(EI / mm**2)}}}{{{tex(f / mm**3)}}} "
            rf"= {tex(v['k1'] / 1e3)}\ \mathrm{{N/mm}}", place="Eqs. 8 and 9",
        ),
    )  # fmt: skip


def combinations(q: Any) -> list[tuple[str, str, str, bool, float]]:
    """Tail, head, arc radius, wide strip or not, and k [N/m]: what the paper leaves open."""
    return [
        (tail, head, radius, wide,
         frame.stiffness(**path, **strip_of(q), head=head, tail=tail, plane_strain=wide))
        for tail, head, (radius, path), wide in product(
            ("arc", "mid-leaf"), ("free", "guided"),
            (("r", q.paper_path), ("r + b/2", q.path)), (False, True),
        )
    ]  # fmt: skip


def accordion_figures(context: Context) -> Sequence[Figure]:
    found: list[Figure] = [_moments(context)] if context.converging else []
    return (*found, _open_questions(context))


def _moments(context: Context) -> Profile:
    """Eqs. 1-5 as a moment diagram, with the straight frame at the ends of all pieces."""
    q = context.inputs
    spring = {"n": q.n, "L1": q.L1, "r": q.r, "b": q.b, "alpha": q.alpha}
    s, m = moment_diagram(**spring, per_piece=17)
    _, ends = moment_diagram(**spring, per_piece=2)
    at, reference = s.reshape(-1, 17)[:, -1], ends.reshape(-1, 2)[:, -1]
    scale = float(abs(m).max())
    values, u = along(context, "moments", formal=2.0, scale=scale)
    return Profile(
        title="Bending moment over force along the spring", x_label="arc length from the head [mm]",
        y_label="M/F [mm]", x=s / mm, y=m / mm, x_fem=at / mm, y_fem=values / mm,
        y_ref=reference / mm, u=u / mm, scale=scale / mm,
        note="Line: Eqs. 1, 3 and 5; dots: the straight frame where pieces meet, exact there by "
        "statics, so that only round-off is left below.",
    )  # fmt: skip


def _open_questions(context: Context) -> Dots:
    """Every reading that the paper leaves open beside what it prints."""
    q = context.inputs
    items: list[tuple[str, float, float | None, str]] = []
    if context.is_paper:
        for name in PRINTED:
            entry = published(f"wang2023:{name}")
            half = half_last_digit(entry.printed) if entry.kind == "theory" else None
            items.append((f"printed, {entry.kind}", entry.value, half, "paper"))
    items.append(("Eqs. 1-9", context.analytic["k1"] / 1e3, None, "formula"))
    if context.fem:
        curved = context.series("paper's lengths, curved")[1][-1]
        items.append(("FE, the same lengths", curved / 1e3, None, "fe"))
    for tail, head, radius, wide, k in combinations(q):
        if tail == "arc":
            strip = "wide strip" if wide else "narrow"
            items.append((f"head {head}, {radius}, {strip}", k / 1e3, None, "formula"))
    return Dots(
        title="What the paper leaves open moves k_1", label="k_1 [N/mm]", items=tuple(items),
        note="Force method with the tail clamped at its arc, under the readings of head, radius "
        "and strip that the text allows; the table below has all sixteen.",
    )  # fmt: skip


def continuum_figures(context: Context) -> Sequence[Figure]:
    """How far each frame theory is from the plane body."""
    if not context.converging:
        return ()
    found = []
    for assumption in ("plane stress", "plane strain"):
        fe = context.series(f"k, {assumption}")[1][-1]
        items = tuple(
            (words, (context.analytic[f"{theory}, {assumption}"] / fe - 1) * 1e4, None, "formula")
            for theory, words in (
                ("bending", "thin: bending alone"),
                ("shear", "with axial force and shear"),
                ("thick", "thick curved frame"),
            )
        )
        found.append(Dots(
            title=f"Frames against the plane body, {assumption}",
            label="k of the frame / k of the body − 1 [1/10 000]",
            items=(*items, ("plane body", 0.0, None, "fe")),
            note="What each theory neglects; the bars of the rows above are narrower than a dot.",
        ))  # fmt: skip
    return tuple(found)


def frame_pictures(q: Any) -> Sequence[Picture]:
    return (
        Picture(field="paper's lengths", data="bending_stress", symbol="σ_b", unit="MPa",
                factor=MPa, width=q.h,
                caption="Bending stress 6 M/(h b²) under 1 N; positive: tension in the left face, "
                "seen from head to tail"),
    )  # fmt: skip


def body_pictures(q: Any) -> Sequence[Picture]:
    loop = (-0.8 * q.R, q.L1 / 2 - 0.8 * q.R, 2.8 * q.R, q.L1 / 2 + 1.9 * q.R)
    return (
        Picture(field="plane stress", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="Von Mises stress under 1 N, plane stress, cell means"),
        Picture(field="plane stress", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="The same in the head's loop", window=loop),
    )  # fmt: skip
