"""Plot of errors on increasingly fine meshes, with lines of the theoretical order."""

import math

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import HEIGHT, WIDTH, Axes
from verify.core.figures import Refinement

APART = 16.0  # between two names


def refinement(r: Refinement) -> Markup:
    """SVG of errors as dots on logarithmic axes, with names at the finest mesh."""
    every = np.concatenate([np.abs(e) for _, e in r.errors])
    every = every[every > 0]
    if not every.size:
        return Markup("")
    low, high = math.floor(math.log10(every.min())), math.ceil(math.log10(every.max()) + 1e-9)
    cells = float(r.cells[0]), float(r.cells[-1])
    axes = Axes(
        (52, 28, 330, 262), (cells[0] / 1.08, cells[1] * 1.08), (10.0**low, 10.0**high), log=True
    )
    axes.grid([10.0**e for e in range(low, high + 1)], lambda v: svg.decade(round(math.log10(v))))
    axes.base(r.cells.tolist(), svg.plain)
    axes.titles(r.x_label, r.y_label)
    names = []
    for i, (name, errors) in enumerate(r.errors):
        seen = np.abs(errors) > 0  # an error of zero has no place on a logarithmic axis
        x, y = r.cells[seen], np.abs(errors[seen])
        if x.size:
            axes.curve(x, y[-1] * (x[-1] / x) ** r.order, f"fit s{i}")
            axes.dots(x, y, f"s{i}")
            names.append((axes.Y(y[-1]) + 4, name, i))
    last = -math.inf
    for at, name, i in sorted(names):
        last = max(at, last + APART)
        axes.body.append(svg.text(340, last, name, f"direct s{i}"))
    return svg.drawing(WIDTH, HEIGHT, axes.body, r.title, "chart")
