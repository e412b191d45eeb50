"""Cost of one pitch of a freewheel over the number of unknowns, and its error over the cost."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from benchmarks import sector

mpl.rcParams["svg.hashsalt"] = "freewheel"
THEIRS, OURS = "#b5482a", "#1f4e79"
SIZES = (5_000, 10_000, 20_000, 50_000)
CURVES = (  # name, key of a row, colour, marker
    ("calculix, end to end", "calculix", THEIRS, "s"),
    ("this project, end to end", "cpu", OURS, "o"),
    ("with meshing and the place at rest", "rest", "#7f6000", "D"),
    ("set-up", "set-up", "#5b9bd5", "^"),
    ("solve", "first", "#70ad47", "v"),
)


def draw(result: dict[str, Any], *files: Path) -> None:
    """Draw seconds over unknowns, and errors over seconds, into each of `files`."""
    figure = Figure(figsize=(9.2, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    rows = result["rows"]
    for name, key, colour, marker in CURVES:
        points = np.array([(row["unknowns"], row[key]) for row in rows if key in row])
        if len(points):
            look = {"color": colour, "marker": marker, "lw": 1.6, "ms": 5}
            left.loglog(*points.T, label=name, **look)
    left.set(title="star, roller and ring with friction", xlabel="unknowns")
    left.set(ylabel="processor seconds")
    left.legend(frameon=False, fontsize=8, loc="upper left")
    left.set_ylim(top=left.get_ylim()[1] * 12)
    tried = [(t["cpu"], sector.worst(t["errors"])) for t in result.get("tried", ())]
    if tried:
        right.loglog(*np.transpose(tried), "x", color=THEIRS, label="calculix, other settings")
    for name, time, error, colour, marker in (
        ("calculix, as compared", "calculix", "calculix errors", THEIRS, "s"),
        ("this project", "cpu", "errors", OURS, "o"),
    ):
        points = np.array([(r[time], sector.worst(r[error])) for r in rows if error in r])
        if len(points):
            right.loglog(*points.T, color=colour, marker=marker, lw=1.6, ms=5, label=name)
    right.set(title="what the seconds buy", xlabel="processor seconds")
    right.set(ylabel="largest relative error")
    right.legend(frameon=False, fontsize=8, loc="lower right")
    left.set_xticks(SIZES, [f"{n:,}" for n in SIZES])
    left.xaxis.set_minor_formatter(NullFormatter())
    for axes in (left, right):
        axes.grid(visible=True, which="major", color="#dddddd", lw=0.6)
        axes.spines[["top", "right"]].set_visible(False)
    for file in files:
        figure.savefig(file, dpi=110)
