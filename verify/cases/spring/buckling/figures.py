"""Figures and tables of lateral buckling."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.spring import column
from verify.cases.spring.buckling.inputs import KEYS, MAP_L1, MAP_N, RATIO, SAME_RATIO, TAILS
from verify.cases.spring.claims import stored
from verify.core.case import Context
from verify.core.figures import Array, Curves, Figure, Map, Panel, Shapes, Table
from verify.form.plots import dashes, dots, line, plot

mm = 1e-3


def tables(q: Any, context: Context) -> Sequence[Table]:
    by_b, ratio = (stored(context, name) for name in ("by_b", "same_ratio"))
    if by_b is None or ratio is None:
        return ()
    z = q.length / by_b[:, 0]
    same_line = [
        (q.n, round(b / mm, 4), round(float(s), 1), round(U / q.length * 100, 3), round(F, 4))
        for (b, U, F), s in zip(by_b, z, strict=True)
    ]
    same_ratio = [
        (n, round(q.length_of(n, q.L1) / RATIO / mm, 4), RATIO,
         None if math.isnan(xi) else round(float(xi) * 100, 3), None)
        for n, xi in zip(SAME_RATIO, ratio, strict=True)
    ]  # fmt: skip
    return (
        Table(
            title="Lateral buckling and L_0/b",
            header=("n", "b [mm]", "L_0/b", "U_cr/L_0 [%]", "F_cr [N]"),
            rows=(*same_line, *same_ratio),
            note="Upper rows: springs with the same centre line and different thicknesses. L_0/b "
            "changes with the thickness, U_cr does not. Lower rows: springs with the largest L_0/b "
            "that Eq. 13 allows. All values by finite elements, tail clamped at its arc.",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    if not context.fem:
        return (_slender(context, None),)
    found = stored(context, "map")
    return (
        _slender(context, found), _error(context, found), _drift(context), _guide(context),
        _shapes(context),
    )  # fmt: skip


def _slender(context: Context, found: Array | None) -> Curves:
    """Figure of U_cr/L_0 over L_0/L_1 by Haringx's column and by finite elements."""
    q = context.inputs
    n = np.arange(4, 61)
    x = np.array([q.length_of(int(k), q.L1) for k in n]) / q.L1
    curves = []
    heads: tuple[tuple[column.Head, str], ...] = (
        ("free", "head free"), ("hinged", "head hinged"), ("guided", "head guided"),
    )  # fmt: skip
    for k, (head, name) in enumerate(heads):
        shape = q.path | {"n": n}
        xi = column.critical_shortening(head, **shape, b=q.b, nu=q.nu)
        on = np.isfinite(xi) & (x < 12)
        curves.append(line(f"Haringx, {name}", x[on], 100 * xi[on], k))
    if found is not None:
        at = np.array([
            [q.length_of(m, ratio * q.L1) / (ratio * q.L1) for m in MAP_N] for ratio in MAP_L1
        ])  # fmt: skip
        on = np.isfinite(found) & (at < 12)
        curves.append(
            dots("FE, head free, leaves of 0.5 to 2 L_1", at[on], 100 * found[on])
        )  # fmt: skip
    return plot(
        "Relative compression at which springs buckle", "L_0/L_1", "U_cr/L_0 [%]", curves,
        y_bottom=0.0, y_top=60.0,
        note="Springs with a smaller L_0/L_1 than the left end of a line do not buckle with this "
        "support of the head. The lines apply to all thicknesses.",
    )  # fmt: skip


def _error(context: Context, found: Array) -> Map:
    q = context.inputs
    n = np.array(MAP_N)
    xi = np.array([
        column.critical_shortening("free", **q.path | {"n": n, "L1": k * q.L1}, b=q.b, nu=q.nu)
        for k in MAP_L1
    ])  # fmt: skip
    return Map(
        title="Error of Haringx's column", x_label="number of segments n",
        y_label="leaf L_1 [mm]", columns=tuple(map(str, MAP_N)),
        rows=tuple(f"{k * q.L1 / mm:.3g}" for k in MAP_L1), error=xi / found - 1,
        checked=np.isfinite(found), without="never buckles",
        note="Error of U_cr in per cent, with a free head and the tail clamped at its arc. The "
        "error arises because head and tail are not units (arc, leaf, arc) of the column.",
    )  # fmt: skip


def _drift(context: Context) -> Curves:
    """Figure of the sideways movement of a free head over the force, with buckling loads."""
    curves = []
    for k, tail in enumerate(TAILS):
        F, _, y, _ = stored(context, f"free{KEYS[tail]}").T
        curves.append(line(f"tail clamped at {tail}", np.abs(y) / mm, F, k))
        limit = context.analytic[f"F_cr{KEYS[tail]}"]
        curves.append(dashes(f"F_cr, tail clamped at {tail}", [0, np.abs(y).max() / mm], limit, k))
    return plot(
        "Sideways movement of a free head", "sideways movement [mm]", "F [N]", curves,
        y_bottom=0.0,
        note="F is a dead load at O along x. There is no limit point and no bifurcation: the "
        "movement increases steadily, even at F_cr (dashed), the force at which a guided spring "
        "buckles if its guide is removed.",
    )  # fmt: skip


def _guide(context: Context) -> Curves:
    """Figure of the lateral stiffness of the guided head over the displacement."""
    curves = []
    for k, tail in enumerate(TAILS):
        U, _, k_y, _ = stored(context, f"guided{KEYS[tail]}").T
        curves.append(line(f"tail clamped at {tail}", U / mm, k_y * mm, k))
    return plot(
        "Lateral stiffness of the guided head", "U [mm]", "k_y [N/mm]", curves,
        y_bottom=min(float(c.y.min()) for c in curves),
        note="If the stiffness is negative, the spring pushes its roller sideways, and the head "
        "needs a guide.",
    )  # fmt: skip


def _shapes(context: Context) -> Shapes:
    """Figure of the spring at its critical point with a guided head, and with a free head."""
    q = context.inputs
    panels = []
    for tail in TAILS:
        let_go, free = (stored(context, f"{name}{KEYS[tail]}") / mm
                        for name in ("let_go", "free_shape"))  # fmt: skip
        straight = tuple(let_go)
        panels += [
            Panel(name=f"buckled, clamp at {tail}", lines=straight),
            Panel(name=f"free head, clamp at {tail}", lines=tuple(free),
                  faint=straight),
        ]  # fmt: skip
    return Shapes(
        title="Guided head and free head", unit="mm", panels=tuple(panels),
        thickness=q.b / mm, note="To scale. The springs with a free head are "
            "compressed by 10 % of the length. Faint lines: guided springs at the critical point.",
    )  # fmt: skip
