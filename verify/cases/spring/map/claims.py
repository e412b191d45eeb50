"""Claims of case spring-map on its maps, on a free head and on the path of the roller."""

from typing import Any

import numpy as np

from analytic.spring import energy
from verify.cases.spring.claims import stored
from verify.cases.spring.map.inputs import Cell, MapInputs, points
from verify.core.case import Context
from verify.judging.tolerance_checks import Pair

CLAIMED, FROM = 0.10, 240.0  # the paper's error at larger L_0/b
THIRD = 1 / 3
NOISE = 1e-4  # relative error of the finite elements of the maps


def errors(q: MapInputs, cells: list[list[Cell]], k: Any) -> Any:
    """Relative errors of the stiffness by Eqs. 1-9; nan where `k` is not positive.

    `k` (rows, columns, 3) are the stiffnesses by finite elements: initial, and secant at the two
    displacements `SHARES`.
    """
    k1 = np.array([[float(energy.stiffness(**c.eqs, h=q.h, E=q.E)) if c.b < c.r else np.nan
                    for c in row] for row in cells])  # fmt: skip
    with np.errstate(divide="ignore"):
        return np.where(k > 0, k1[..., None] / k - 1, np.nan)


def within_claim(context: Context) -> tuple[float, float, str]:
    """Positive margin if the largest error for L_0/b of at least 240 is below 10 %.

    The uncertainty and the text of the row are also returned.
    """
    q = context.inputs
    cells = points(q, deep=False)["slender"]
    m = errors(q, cells, stored(context, "slender"))[..., 0]
    z = np.array([[c.length / c.b for c in row] for row in cells])
    worst = float(np.nanmax(np.abs(m[z > FROM * 0.999])))
    return CLAIMED - worst, NOISE, f"largest error {worst:.1%}"


def falls(context: Context) -> tuple[float, float, str]:
    """Smallest decrease of the error from a spring to the next thinner one, equal centre lines."""
    q = context.inputs
    b, z, k = stored(context, "on_line").T
    k1 = np.array([
        float(energy.stiffness(**Cell(q.n, t, q.R - t / 2, q.L1, q.alpha).eqs, h=q.h, E=q.E))
        for t in b
    ])  # fmt: skip
    m = np.abs(k1 / k - 1)
    words = f"error {m[-1]:.1%} at L_0/b = {z[-1]:.0f}, {m[0]:.1%} at L_0/b = {z[0]:.0f}"
    return float(np.diff(m).min()), NOISE, words


def free_head(context: Context) -> tuple[float, float, str]:
    """Positive margin if the force with a free head is below a third of that by Eq. 9.

    The forces are those at a displacement of 0.3 of the length. The uncertainty and the text of the
    row are also returned.
    """
    F = [r.values["F_free"] for r in context.fem]
    promised = context.analytic["linear_0_3"]
    words = f"{F[-1]:.3g} N with a free head, {promised:.3g} N by Eq. 9"
    return THIRD - F[-1] / promised, 3 * abs(F[-1] - F[-2]) / promised, words


def travel(context: Context) -> Pair:
    """Pair of axial forces [N] at the end of the straight and of the slanted path of the roller."""
    v = context.fem[-1].values
    m = v["F_x_straight"] / v["F_x"] - 1
    words = f"difference {m:+.2%}; transverse over axial force {v['F_y'] / v['F_x']:+.1%}"
    return Pair(v["F_x_straight"], v["F_x"], NOISE * v["F_x"], words)
