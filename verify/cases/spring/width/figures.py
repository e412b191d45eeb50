"""Figures and tables on the width of the strip: factor over width, shapes, end conditions."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.spring.stages.inputs import StagesInputs
from verify.cases.spring.stages.sketch import sketch as stages_sketch
from verify.cases.spring.width.claims import (
    N_PER_MM,
    leaf_factor,
    limits,
    readings,
    sweep,
    sweep_uncertainty,
)
from verify.cases.spring.width.inputs import WidthInputs
from verify.cases.spring.width.reference import RATIOS, widths_of_both
from verify.core.case import Context
from verify.core.figures import Curves, Figure, Picture, Profile, Sketch, Table
from verify.form.plots import dashes, dots, line, plot
from verify.papers.ledger import published

mm, MPa = 1e-3, 1e6


def sketch(q: WidthInputs) -> Sketch:
    """Sketch of the spring with whole end leaves and the supports of the inputs."""
    return stages_sketch(StagesInputs(**q.model_dump(), width_factor=None))


def tables(_: WidthInputs, context: Context) -> Sequence[Table]:
    if not context.fem:
        return ()
    return (_readings(context), _widths(context))


def _readings(context: Context) -> Table:
    """Table of the stiffness by the shell for all end conditions, with the printed values."""
    header: tuple[str, ...] = ("tail clamped at", "head", "k_1 of E I [N/mm]", "f, shell",
                               "k_1, shell [N/mm]")  # fmt: skip
    if context.is_paper:
        header += ("against the paper's shell model, 0.613", "against the paper's test, 0.610")
    rows = []
    for (tail, head), (f, k) in readings(context).items():
        row: tuple[Any, ...] = (tail, head, round(k / f / N_PER_MM, 4), round(f, 4),
                                round(k / N_PER_MM, 4))  # fmt: skip
        if context.is_paper:
            row += tuple(
                f"{100 * (k / N_PER_MM / published(f'wang2023:k1-{what}').value - 1):+.1f} %"
                for what in ("fea", "test")
            )
        rows.append(row)
    note = (
        "The arcs have the radius r + b/2. The paper does not state how the tail is clamped or how "
        "the head is guided. The end conditions are therefore chosen so that the stiffness of the "
        "paper's shell model results (calibrated)."
    )
    return Table(
        title="Stiffness of the shell by end conditions", header=header, rows=tuple(rows),
        note=note if context.is_paper else "The arcs have the radius r + b/2.",
    )  # fmt: skip


def _widths(context: Context) -> Table:
    q = context.inputs
    h, f = sweep(context).T
    leaf = leaf_factor(q, h)
    return Table(
        title="Width factor over the width h: shell of the spring, and plate model of a leaf",
        header=("h [mm]", "h/b", "h/l", "spring, shell", "leaf, plate", "leaf against spring"),
        rows=tuple(
            (float(f"{w / mm:.4g}"), float(f"{w / q.b:.4g}"), float(f"{w / q.leaf:.3g}"),
             round(float(a), 5), round(float(b), 5), f"{100 * (b / a - 1):+.3f} %")
            for w, a, b in zip(h, f, leaf, strict=True)
        ),
        note="A strip that is narrower than thick is not a plate. If the width is smaller than the "
        "length of a leaf, the arcs stiffen the spring more than the leaves do, because the arcs "
        "cannot bend across the width.",
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    return _over_width(context), _elements(context), _lifted(context)


def _over_width(context: Context) -> Profile:
    q = context.inputs
    h, f = sweep(context).T
    at = np.geomspace(h[0], h[-1], 40)
    return Profile(
        title="Width factor of the whole spring and of one leaf",
        x_label="log10 of h/b", y_label="f", x=np.log10(at / q.b), y=leaf_factor(q, at),
        x_fem=np.log10(h / q.b), y_fem=f, y_ref=leaf_factor(q, h),
        u=np.full(len(h), sweep_uncertainty(context)), scale=1.0, scale_name="a narrow strip",
        neglects=True,
        note="Line: plate model of a leaf with straight ends. Dots: shell of the spring.",
    )  # fmt: skip


def _elements(context: Context) -> Curves:
    """Figure of the factors of spring and loop by shells and solids, with both limits."""
    q = context.inputs
    h, f = sweep(context).T
    low, high = limits(context)
    ends = np.log10(h[[0, -1]] / q.b)
    both = dict.fromkeys(widths_of_both(q), context.fem[-1].values)
    x = np.log10([w / q.b for w in widths_of_both(q).values()])
    loops = [
        dots(f"loop, {what}", x, np.array([high * v[f"{kind}_{name}"] for name, v in both.items()]),
             colour)
        for kind, what, colour in (("shell", "shell", 2), ("solid", "27-node solids", 3))
    ]  # fmt: skip
    return plot(
        "Width factors of spring and loop by shells, and of the loop by solids", "h/b",
        "f",
        dashes("plane stress", ends, low, 4),
        dashes("plane strain", ends, high, 5),
        line("spring, shell", np.log10(h / q.b), f, 1),
        line("leaf, plate", np.log10(h / q.b), leaf_factor(q, h)),
        loops,
        y_bottom=low - 0.05 * (high - low), x_names=tuple(
        (float(k), f"{10.0**k:g}") for k in range(int(np.ceil(ends[0])), int(ends[1]) + 1)
        ), note="The loop consists of two half leaves and two quarter arcs. The width factor "
        "of the loop is its stiffness over its stiffness in plane strain, times the width factor "
        "in plane strain.",
    )  # fmt: skip


def _lifted(context: Context) -> Curves:
    curves = []
    for colour, ratio in enumerate(RATIOS):
        y, lifted = context.fem[-1].arrays[f"lifted_{ratio}"].T
        curves.append(line(f"h/l = {ratio:g}", y, 100 * lifted, colour))
    return plot(
        "Transverse curvature of a thin leaf: deflection of the edge relative to the middle",
        "position along the leaf / l", "deflection / displacement of head [%]", curves,
        y_bottom=float(min(c.y.min() for c in curves)) * 1.05,
        note="The ends of the leaf remain straight lines, at the distance l from each other. Wide "
        "leaves curve across the width only near their edges, over a distance of about l.",
    )  # fmt: skip


ACROSS = Picture(
    field="loop", data="across", symbol="σ_z", unit="MPa", factor=MPa,
    caption="Transverse bending stress in a loop under 2 N on the whole width. Half of the width "
    "is drawn, with the free edge in front. Except at the free edge, the stress is ν times the "
    "longitudinal bending stress",
)  # fmt: skip
