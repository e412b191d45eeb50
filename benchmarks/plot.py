"""Cost over size, both axes logarithmic, with the fitted exponents."""

from pathlib import Path
from statistics import median
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

mpl.rcParams["svg.hashsalt"] = "plane"
CURVES = (  # name, seconds of a row, colour, marker
    ("calculix, end to end", lambda r: median(r["calculix"]), "#b5482a", "s"),
    ("this project, end to end", lambda r: median(r["seconds"]), "#1f4e79", "o"),
    ("factorisation", lambda r: r["stages"]["factorisation"], "#5b9bd5", "^"),
    ("assembly", lambda r: r["stages"]["assembly"], "#70ad47", "v"),
)


def draw(rows: list[dict[str, Any]], *files: Path) -> None:
    """Draw one panel for each kind of cell into each of `files`."""
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    figure = Figure(figsize=(4.2 * len(kinds), 3.8), layout="constrained")
    for i, kind in enumerate(kinds):
        axes = figure.add_subplot(1, len(kinds), i + 1)
        chosen = [row for row in rows if row["kind"] == kind]
        n = np.array([row["unknowns"] for row in chosen])
        for name, seconds, colour, marker in CURVES:
            if name.startswith("calculix") and "calculix" not in chosen[0]:
                continue
            t = np.array([seconds(row) for row in chosen])
            exponent = np.polyfit(np.log(n), np.log(t), 1)[0]
            label = f"{name}, $n^{{{exponent:.2f}}}$"
            axes.loglog(n, t, color=colour, marker=marker, lw=1.6, ms=5, label=label)
        axes.set(title=f"quadratic {kind}", xlabel="unknowns", ylabel="seconds" if not i else "")
        axes.grid(visible=True, which="major", color="#dddddd", lw=0.6)
        axes.legend(frameon=False, fontsize=8, loc="upper left")
        axes.spines[["top", "right"]].set_visible(False)
        axes.set_ylim(top=axes.get_ylim()[1] * 6)
    for file in files:
        figure.savefig(file, dpi=110)
