"""What the report shows of a stepped turning shaft: the error's maps, stress at the step."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.rotor.step.fem import MODES, RATIOS, SHARES
from verify.core.case import Context, Values
from verify.core.figures import Curve, Curves, Equation, Figure, Map, Picture, Shape, Sketch, Table
from verify.core.tex import tex

RPM = np.pi / 30
HZ = 2 * np.pi
mm = 1e-3
DRAWN = (2, 4, 5)  # rows of the map that are drawn as curves
LIMITS = (0.01, 0.02, 0.05)


def sketch(q: Any) -> Sketch:
    first, last = q.start / q.L, (q.start + q.L_2) / q.L
    thin, thick, b = q.d_1 / q.L / 2, q.d_2 / q.L / 2, q.b / q.L
    half = np.array([[0, thin], [first, thin], [first, thick], [last, thick], [last, thin],
                     [1, thin]])  # fmt: skip
    whole = np.vstack([half, half[::-1] * [1, -1]])
    reach = min((thick - thin), (last - first) / 2)
    cone = np.array([[first, thin], [first + reach, thin + reach], [last - reach, thin + reach],
                     [last, thin]])  # fmt: skip
    shapes = [
        Shape(style="body", points=whole),
        Shape(style="modelled", points=np.vstack([half, [[1, 0], [0, 0]]])),
        Shape(style="axis", points=np.array([[-0.06, 0.0], [1.06, 0.0]])),
        Shape(style="faint", points=cone),
        Shape(style="leader", points=np.array([[first + 0.1, thick + 0.1], cone[1] - reach / 2]),
              label="45° rule: stiff within"),
        Shape(style="dimension", points=np.array([[first, -thick - 0.08], [last, -thick - 0.08]]),
              label=f"L_2 = {q.L_2 / mm:.5g} mm"),
        Shape(style="dimension", points=np.array([[0, -thick - 0.18], [1, -thick - 0.18]]),
              label=f"L = {q.L / mm:.5g} mm"),
        Shape(style="leader", points=np.array([[0.12, thick], [0.15, thin]]),
              label=f"d_1 = {q.d_1 / mm:.5g} mm"),
        Shape(style="leader", points=np.array([[last + 0.12, thick + 0.04], [last - 0.02, thick]]),
              label=f"d_2 = {q.d_2 / mm:.5g} mm"),
    ]  # fmt: skip
    shapes += [
        Shape(style="clamp", points=np.array([[x, -thin], [x + b, -thin]])) for x in (0, 1 - b)
    ]
    return Sketch(title=f"stepped shaft at {q.n / RPM:.5g} r/min", shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    reach = min((q.d_2 - q.d_1) / 2, q.L_2 / 2)
    return (
        Equation(
            tex=r"d_{stiff}(s) = \min(d_2,\ d_1 + 2s),\quad s\ \mathrm{from\ the\ step}",
            numbers=rf"d_2\ \mathrm{{at}}\ s = {tex(reach / mm, 4)}\ \mathrm{{mm}}",
            place="45° rule",
        ),
        Equation(
            tex=r"\frac{\omega_{drawn}}{\omega_{45}}",
            numbers=rf"= \frac{{{tex(v['drawn 1 forward'])}}}{{{tex(v['45° 1 forward'])}}} = "
            rf"{tex(v['drawn 1 forward'] / v['45° 1 forward'], 5)}",
            place="mode 1 forward",
        ),
    )


def tables(context: Context) -> Sequence[Table]:
    if not context.fem:
        return ()
    v, body = context.analytic, context.fem[-1].values
    rows = []
    for j in MODES:
        for whirl in ("backward", "forward"):
            exact = body[f"solid {j} {whirl}"]
            drawn, cone = (v[f"{name} {j} {whirl}"] for name in ("drawn", "45°"))
            rows.append(
                (f"mode {j} {whirl}", exact / HZ, drawn / HZ, f"{drawn / exact - 1:+.2%}",
                 cone / HZ, f"{cone / exact - 1:+.2%}")
            )  # fmt: skip
    return (
        Table(
            title=f"Frequencies at {context.inputs.n / RPM:.5g} r/min [Hz]",
            header=("", "elastic body", "beam as drawn", "error", "beam, 45° rule", "error"),
            rows=tuple(rows),
        ),
    )


def errors(context: Context) -> Any:
    """Errors (shares, ratios, 2) of mode 1 at rest: as drawn, by the 45° rule."""
    return next(r.arrays["map"] for r in context.fem if "map" in r.arrays)


def figures(context: Context) -> Sequence[Figure]:
    if not context.fem:
        return ()
    m = errors(context)
    titles = ("beam as drawn", "beam by the 45° rule")
    return (
        *(_map(context.inputs, title, m[..., k]) for k, title in enumerate(titles)),
        over_ratio(context),
    )


def _map(q: Any, title: str, m: Any) -> Map:
    return Map(
        title=f"Error of mode 1, {title}", x_label="d_2/d_1", y_label="L_2/L",
        columns=tuple(f"{r:g}" for r in RATIOS), rows=tuple(f"{s:g}" for s in SHARES),
        error=m, limits=LIMITS,
        note=f"Beam over elastic body less one, at rest, thick part in the middle; d_1/L = "
        f"{q.d_1 / q.L:.3g}, bearings as given. Weak form of the beam, coarse mesh of the body "
        "(0.1 % of the frequency).",
    )  # fmt: skip


def over_ratio(context: Context) -> Curves:
    m = errors(context) * 100
    curves = [
        Curve(name=f"{words}, L_2/L = {SHARES[k]:g}", x=np.array(RATIOS), y=m[k, :, which],
              style=style, colour=colour)
        for colour, k in enumerate(DRAWN)
        for which, words, style in ((0, "as drawn", "line"), (1, "45° rule", "dashes"))
    ]  # fmt: skip
    return Curves(
        title="Error of mode 1 over the step", x_label="d_2/d_1", y_label="error [%]",
        curves=tuple(curves),
        note="These errors are the beam theory's own: finer beam elements do not remove them.",
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="mode 1", data="stress along z", symbol="σ_z", unit="cut",
                factor=1.0, share=0.1,
                caption="Mode 1: axial stress in the plane of bending, colours cut at the "
                "magnitude that 98 % of the volume stays below"),
    )  # fmt: skip
