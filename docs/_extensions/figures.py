"""Figures of the pages on verification, drawn with the code that the pages explain."""

import json
from collections import Counter
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

mpl.use("agg")
import matplotlib.pyplot as plt

from analytic.ring.lame import stresses
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.ring.quarter import quarter_ring
from verify.core.results import Status
from verify.judging import judge
from verify.judging.convergence import grid_convergence

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "docs" / "verification" / "_generated"
RING = {"r_i": 30.0, "r_o": 45.0}
PRESSURE = 100.0
REFINE = (1, 2, 4, 8)
ORDER = 2.0  # order of convergence of stresses of quadratic elements on a boundary
BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#808080"


def setup(app: Any) -> dict[str, bool]:
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}


def write(_app: Any) -> None:
    """Draw all figures."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for draw in (kinds, tolerances, detection, verdicts):
        figure = draw()
        figure.savefig(FOLDER / f"{draw.__name__}.svg", metadata={"Date": None})
        plt.close(figure)


def hoop_stresses() -> list[float]:
    """Mean hoop stress at the bore of a thick ring on each mesh, coarse to fine."""
    found = []
    for refine in REFINE:
        ring = solve_plane(
            quarter_ring(**RING, refine=refine), materials=Elastic(E=210e3, nu=0.3),
            assumption="plane stress", supports={"x=0": "x", "y=0": "y"},
            pressures={"bore": PRESSURE},
        )  # fmt: skip
        bore = ring.on_boundary("bore")
        found.append(float(bore.mean(bore.polar()[2])))
    return found


def kinds() -> plt.Figure:
    """Figure: intervals for the difference between formula and reference, for three checks."""
    figure, axes = plt.subplots(3, 1, figsize=(7, 3.6), layout="constrained")
    rows = (
        ("identity: within the expanded uncertainty", (-0.4, 0.4), 0.15, 0.0),
        ("approximation: inside the interval stated beforehand", (2.0, 4.0), 3.1, 0.4),
        ("statement: the margin exceeds its uncertainty", (0.0, 6.5), 4.5, 0.8),
    )
    for axis, (title, allowed, value, U) in zip(axes, rows, strict=True):
        axis.axvspan(*allowed, color=GREEN, alpha=0.25)
        axis.errorbar(value, 0, xerr=U or None, fmt="o", color=BLUE, capsize=4)
        axis.axvline(0, color=GREY, lw=1)
        axis.set(xlim=(-1.5, 6.5), yticks=[], title=title)
        axis.title.set_size(10)
    axes[-1].set_xlabel("difference of formula and reference [%]; green: the row passes")
    return figure


def tolerances() -> plt.Figure:
    """Figure: a value over the mesh size, with its numerical uncertainty."""
    values, sizes = hoop_stresses(), [1 / refine for refine in REFINE]
    exact = float(stresses(RING["r_i"], **RING, p_i=PRESSURE)[1])
    figure, axis = plt.subplots(figsize=(7, 3.4), layout="constrained")
    for last in (3, 4):
        found = grid_convergence(sizes[:last], values[:last], formal=ORDER, scale=exact)
        U = judge.expanded(judge.numerical_uncertainty(found))
        label = "expanded uncertainty U" if last == len(REFINE) else None
        axis.errorbar(
            sizes[last - 1], values[last - 1], yerr=U, color=ORANGE, capsize=5, label=label
        )
    axis.plot(sizes, values, "o-", color=BLUE, label="finite elements")
    axis.axhline(exact, color=GREY, ls="--", label="formula (Lamé)")
    axis.set(xlabel="relative mesh size h", ylabel="hoop stress at the bore [MPa]")
    axis.legend()
    return figure


def detection() -> plt.Figure:
    """Figure: status of a row over the error of its formula, and the detection limit."""
    values = hoop_stresses()
    exact = float(stresses(RING["r_i"], **RING, p_i=PRESSURE)[1])
    found = grid_convergence([1 / r for r in REFINE], values, formal=ORDER, scale=exact)
    U = judge.expanded(judge.numerical_uncertainty(found))
    limit = judge.difference(values[-1], exact, U=U, scale=exact).detects or 0.0
    errors = np.linspace(-2.5, 2.5, 501) * limit
    rows = [judge.difference(values[-1], exact * (1 + e), U=U, scale=exact) for e in errors]
    passed = np.array([row.status is Status.PASS for row in rows])
    size = [abs(row.difference or 0.0) / exact for row in rows]
    figure, axis = plt.subplots(figsize=(7, 3.2), layout="constrained")
    axis.plot(100 * errors, 100 * np.array(size), color=BLUE, label="difference |d|")
    axis.axhline(100 * U / exact, color=ORANGE, label="expanded uncertainty U")
    axis.fill_between(
        100 * errors, 0, 400 * limit, where=passed, color=GREEN, alpha=0.2, label="the row passes"
    )
    for side in (-1, 1):
        label = "detection limit (U + |d|)/scale" if side > 0 else None
        axis.axvline(side * 100 * limit, color=GREY, ls="--", label=label)
    axis.set(
        xlabel="error put into the formula [%]", ylabel="share of the value [%]",
        ylim=(0, 400 * limit),
    )  # fmt: skip
    axis.legend(loc="upper center")
    return figure


def verdicts() -> plt.Figure:
    """Figure: number of formulas with each verdict of record."""
    record = json.loads((ROOT / "verify" / "measured" / "verdicts.json").read_text("utf-8"))
    counts = Counter(entry["verdict"] for entry in record).most_common()[::-1]
    figure, axis = plt.subplots(figsize=(7, 3.2), layout="constrained")
    bars = axis.barh([name for name, _ in counts], [n for _, n in counts], color=BLUE)
    axis.bar_label(bars, padding=3)
    axis.set_xlabel("formulas with this verdict, as printed and as corrected")
    return figure
