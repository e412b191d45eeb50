"""Cost of contact over size, both axes logarithmic, with the fitted exponents."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

mpl.rcParams["svg.hashsalt"] = "contact"
LARGE = 1e4  # least number of unknowns for the fit of exponents: below, overhead dominates
CURVES = (  # name, key of a row, colour, marker
    ("calculix, end to end", "calculix", "#b5482a", "s"),
    ("this project, end to end", "cpu", "#1f4e79", "o"),
    ("set-up", "set-up", "#5b9bd5", "^"),
    ("first solve", "first", "#70ad47", "v"),
    ("further step", "step cpu", "#7f6000", "D"),
)


def draw(rows: list[dict[str, Any]], *files: Path) -> None:
    """Draw all curves in one panel into each of `files`."""
    figure = Figure(figsize=(6.4, 4.4), layout="constrained")
    axes = figure.add_subplot()
    for name, key, colour, marker in CURVES:
        points = np.array([(row["unknowns"], row[key]) for row in rows if key in row])
        if not len(points):
            continue
        n, t = points.T
        large = n > LARGE
        label = name
        if np.count_nonzero(large) > 1:
            label += f", $n^{{{np.polyfit(np.log(n[large]), np.log(t[large]), 1)[0]:.2f}}}$"
        axes.loglog(n, t, color=colour, marker=marker, lw=1.6, ms=5, label=label)
    axes.set(title="two discs in contact, quadratic quadrilaterals", xlabel="unknowns")
    axes.set(ylabel="processor seconds")
    axes.grid(visible=True, which="major", color="#dddddd", lw=0.6)
    figure.legend(frameon=False, fontsize=8, loc="outside right upper")
    axes.spines[["top", "right"]].set_visible(False)
    for file in files:
        figure.savefig(file, dpi=110)
