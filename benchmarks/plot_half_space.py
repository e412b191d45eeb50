"""Processor seconds over cells, both axes logarithmic, with the fitted exponents."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

mpl.rcParams["svg.hashsalt"] = "half-space"
CURVES = (  # name, key of a row, colour, marker
    ("tamaas", "tamaas cpu", "#b5482a", "s"),
    ("this project", "ours cpu", "#1f4e79", "o"),
)
LINES = ("-", "--", ":")


def draw(rows: list[dict[str, Any]], *files: Path) -> None:
    """Draw the curves of both solvers for each kind of contact into each of `files`."""
    figure = Figure(figsize=(6.4, 4.4), layout="constrained")
    axes = figure.add_subplot()
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    for name, key, colour, marker in CURVES:
        for kind, line in zip(kinds, LINES, strict=False):
            chosen = [row for row in rows if row["kind"] == kind and key in row]
            if not chosen:
                continue
            n = np.array([row["nx"] * row["ny"] for row in chosen])
            t = np.array([row[key] for row in chosen])
            label = f"{name}, {kind}"
            if len(n) > 1:
                label += f", $n^{{{np.polyfit(np.log(n), np.log(t), 1)[0]:.2f}}}$"
            axes.loglog(n, t, line, color=colour, marker=marker, lw=1.6, ms=5, label=label)
    axes.set(title="half-spaces in contact", xlabel="cells")
    axes.set(ylabel="processor seconds")
    axes.grid(visible=True, which="major", color="#dddddd", lw=0.6)
    figure.legend(frameon=False, fontsize=8, loc="outside right upper")
    axes.spines[["top", "right"]].set_visible(False)
    for file in files:
        figure.savefig(file, dpi=110)
