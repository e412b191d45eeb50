"""Figures of a stepped rotating shaft: sketch, maps of the error, stress at the step."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.rotor.step.inputs import MODES, RATIOS, SHARES
from verify.core.case import Context, Values
from verify.core.figures import Curves, Figure, Map, Picture, Shape, Sketch, Table
from verify.form import sketches
from verify.form.plots import curve, plot
from verify.form.sketches import Point, arrow, leader, shape

RPM = np.pi / 30
HZ = 2 * np.pi
mm = 1e-3
DRAWN = (2, 4, 5)  # rows of the map that are drawn as curves
LIMITS = (0.01, 0.02, 0.05)


MODE = Picture(
    field="mode 1", data="stress along z", symbol="σ_z/σ_{98}", unit="1", factor=1.0, share=0.1,
    caption="Axial stress σ_z of mode 1 in the plane of bending, divided by the magnitude σ_{98} "
            "that is not exceeded in 98 % of the volume; larger magnitudes are drawn as ±1",
)  # fmt: skip


def sketch(q: Any) -> Sketch:
    first, last = q.start / q.L, (q.start + q.L_2) / q.L
    thin, thick, b = q.d_1 / q.L / 2, q.d_2 / q.L / 2, q.b / q.L
    half = np.array([[0, thin], [first, thin], [first, thick], [last, thick], [last, thin],
                     [1, thin]])  # fmt: skip
    reach = min((thick - thin), (last - first) / 2)
    cone = np.array([[first, thin], [first + reach, thin + reach], [last - reach, thin + reach],
                     [last, thin]])  # fmt: skip
    x, y = cone[1] - reach / 2

    def size(left: float, right: float, below: float, name: str) -> Shape:
        ends: tuple[Point, Point] = (left, -thick - below), (right, -thick - below)
        return arrow(*ends, f"{name} = {getattr(q, name) / mm:.5g} mm", "dimension")

    return sketches.sketch(
        f"stepped shaft at {q.n / RPM:.5g} r/min",
        shape("body", np.vstack([half, half[::-1] * [1, -1]])),
        shape("modelled", np.vstack([half, [[1, 0], [0, 0]]])),
        arrow((-0.06, 0.0), (1.06, 0.0), style="axis"), shape("faint", cone),
        leader((first + 0.1, thick + 0.1), (x, y), "45° rule: stiff part"),
        size(first, last, 0.08, "L_2"), size(0, 1, 0.18, "L"),
        leader((0.12, thick), (0.15, thin), f"d_1 = {q.d_1 / mm:.5g} mm"),
        leader((last + 0.12, thick + 0.04), (last - 0.02, thick), f"d_2 = {q.d_2 / mm:.5g} mm"),
        [arrow((x, -thin), (x + b, -thin), style="clamp") for x in (0, 1 - b)],
    )  # fmt: skip


def frequencies(q: Any, body: Values) -> Table:
    """Table of frequencies of both beams and of the elastic body."""
    rows = []
    for j in MODES:
        for sense in ("backward", "forward"):
            exact = body[f"solid_whirl_{j}_{sense}"]
            nominal, cone = (beam.whirl(j, sense) for beam in (q, q.by_rule))
            rows.append(
                (f"mode {j} {sense}", exact / HZ, nominal / HZ, f"{nominal / exact - 1:+.2%}",
                 cone / HZ, f"{cone / exact - 1:+.2%}")
            )  # fmt: skip
    return Table(
        title=f"Frequencies at {q.n / RPM:.5g} r/min [Hz]",
        header=("", "elastic body", "beam, nominal diameters", "error", "beam, 45° rule", "error"),
        rows=tuple(rows),
    )


def errors(context: Context) -> Any:
    """Errors of mode 1 at rest, shape (values of L_2/L, values of d_2/d_1, 2).

    The last axis distinguishes nominal diameters and the 45° rule.
    """
    return next(r.arrays["map"] for r in context.fem if "map" in r.arrays)


def figures(context: Context) -> Sequence[Figure]:
    if not context.fem:
        return ()
    m = errors(context)
    titles = ("beam with nominal diameters", "beam by the 45° rule")
    return (
        *(_map(context.inputs, title, m[..., k]) for k, title in enumerate(titles)),
        over_ratio(context),
    )


def _map(q: Any, title: str, m: Any) -> Map:
    return Map(
        title=f"Error of the frequency of mode 1, {title}", x_label="d_2/d_1", y_label="L_2/L",
        columns=tuple(f"{r:g}" for r in RATIOS), rows=tuple(f"{s:g}" for s in SHARES),
        error=m, limits=LIMITS,
        note="The error is the frequency of the beam at rest divided by that of the elastic "
             "body, minus one. The thick part is in the middle, "
             f"d_1/L = {q.d_1 / q.L:.3g}, and the bearings are those of the inputs. The beam is "
             "solved by its weak form; the mesh of the body is coarse and causes an error of 0.1 % "
             "of the frequency.",
    )  # fmt: skip


def over_ratio(context: Context) -> Curves:
    m = errors(context) * 100
    curves = [
        curve(f"{words}, L_2/L = {SHARES[k]:g}", np.array(RATIOS), m[k, :, which], style, colour)
        for colour, k in enumerate(DRAWN)
        for which, words, style in ((0, "nominal diameters", "line"), (1, "45° rule", "dashes"))
    ]  # fmt: skip
    return plot(
        "Error of the frequency of mode 1 over d_2/d_1", "d_2/d_1", "error [%]", curves,
        note="The errors are errors of beam theory: finer beam elements do not reduce the errors.",
    )  # fmt: skip
