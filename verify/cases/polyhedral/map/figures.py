"""Figures of K: maps over flats, wall and fillet, and curves over flats."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.polyhedral.map.inputs import FLATS, SHARES, WALLS
from verify.core.case import Context
from verify.core.figures import Array, Curves, Figure, Map
from verify.form.plots import dashes, dots, line, plot

TICKS = (3, 4, 6, 8, 12, 24, 48)
NAMES = tuple((float(np.log2(z)), str(z)) for z in TICKS)
LARGEST, LEAST = 4.0, -2.0  # limits of K in the figure: K at the corners of four flats is unbounded


def on_map(context: Context, name: str) -> Array | None:
    """Array (m,) of 1/K by finite elements, row by row of the map `name`; None if not solved."""
    return next((level.arrays[name] for level in context.fem if name in level.arrays), None)


def figures(q: Any, context: Context) -> Sequence[Figure]:
    """Figures: two maps of the error of K = 1 (over walls, over fillets), and curves."""
    wall, fillet = (
        q.flexibility(rings)[:, 0] if (found := on_map(context, name)) is None else found
        for name, rings in (("wall", q.by_wall), ("fillet", q.by_fillet))
    )
    solved = bool(context.fem)
    return (
        _map("Error of K = 1 over number of flats and wall thickness", "wall δ_1/d_e", WALLS, wall,
             solved,
             "Error [%] of p_1r = K p_1 with K = 1, for a fillet radius of "
             f"{q.rho * 1e3:.3g} mm."),
        _map("Error of K = 1 over number of flats and fillet radius", "fillet ρ/δ_1", SHARES,
             fillet, solved,
             "Error [%] of p_1r = K p_1 with K = 1, for a wall thickness of "
             f"{q.delta_1 * 1e3:.3g} mm."),
        _factors(q, context),
        _efficiency(q, context),
    )  # fmt: skip


def _map(
    title: str, label: str, rows: Sequence[float], flexible: Array, solved: bool, note: str
) -> Map:
    error = (flexible - 1).reshape(len(rows), len(FLATS))  # 1/K is formula over reference
    return Map(
        title=title, x_label="flats z", y_label=label, columns=tuple(map(str, FLATS)),
        rows=tuple(f"{row:g}" for row in rows), error=error,
        checked=np.full(error.shape, solved), note=note,
    )  # fmt: skip


def _factors(q: Any, context: Context) -> Curves:
    """Figure of K by three definitions; values beyond the range of the axis are omitted."""
    x = np.log2(np.array(FLATS, dtype=float))
    curves = []
    names = ("K for the middle of the flats", "K for the mean displacement", "K for the corners")
    for k, name in enumerate(names):
        K = 1 / q.flexible_middle[:, k]
        seen = (K > LEAST) & (K < LARGEST)
        curves.append(line(name, x[seen], K[seen], k))
        if context.fem:
            found = 1 / context.fem[-1].arrays["reference"][:, k]
            curves.append(dots("", x[seen], found[seen], k))
    limit = np.full(2, q.K_many)
    curves.append(dashes("Lamé", x[[0, -1]], limit, 3))
    return plot(
        "K by three definitions over the number of flats", "flats z", "K", curves,
        y_bottom=0.8, y_top=LARGEST, x_names=NAMES,
        note="Lines: series; dots: finite elements. For 3 to 5 flats, K for the corners is outside "
        "the range of the diagram; for 3 flats, it is negative.",
    )  # fmt: skip


def _efficiency(q: Any, context: Context) -> Curves:
    """Figure of the load-transfer ratio over the number of flats."""
    x: Any = np.log2(np.array(FLATS, dtype=float))
    curves = [
        line("η, series", x, q.efficiency, 1),
        dashes("Eq. 16", x[[0, -1]], np.ones(2)),
    ]
    if context.fem:
        fem = context.fem[-1].arrays
        curves.insert(1, dots("η, FE", x, fem["efficiency"], 1))
    return plot(
        "Incremental load-transfer ratio, pressure to rollers", "flats z", "η", curves,
        x_names=NAMES, note="The rollers are rigid. The pressure is 1.5 times the pressure that "
        "closes the clearance of a thin round ring.",
    )  # fmt: skip
