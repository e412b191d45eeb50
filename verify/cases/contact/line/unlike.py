"""The pair once more with unlike materials under a high load, where what Hertz neglects shows.

At the paper's load and with like materials the terms of `pair_series` drown in the meshes.
"""

import math
from typing import Any

from analytic.contact import hertz_line, pair_series
from verify.cases.contact.line.checks import about
from verify.cases.contact.line.inputs import PairInputs
from verify.core.case import Values
from verify.judging.checks import Approximation

RATIO = 0.1  # Hertz's a over the smaller radius
SOFT, NU = 1 / 3, 0.1  # the lower roller's modulus over the upper one's, and its Poisson's ratio
WHERE = f"unlike, a/R = {RATIO:g}"


def unlike(q: PairInputs) -> PairInputs:
    """The same rollers, the lower one softer, under the load that makes a/R `RATIO`."""
    soft = q.model_copy(update={"E_2": SOFT * q.E_1, "nu_2": NU})
    P = math.pi / 4 * (RATIO * q.smallest) ** 2 * q.curvature / soft.softness
    return soft.model_copy(update={"F": P * q.L})


def unlike_values(q: PairInputs) -> Values:
    """Hertz's half-width and peak pressure, and what the series says of them."""
    soft = unlike(q)
    R = float(hertz_line.relative_radius(R_1=q.R_1, R_2=q.R_2))
    E_star = float(hertz_line.contact_modulus(**soft.materials, assumption="plane strain"))
    a = float(hertz_line.half_width(P=soft.P, R=R, E_star=E_star))
    p_0 = float(hertz_line.peak_pressure(P=soft.P, R=R, E_star=E_star))
    sizes = {"a": a, "R_1": q.R_1, "R_2": q.R_2}
    p, w = pair_series.excess(**sizes, **soft.materials, assumption="plane strain")
    left_out = pair_series.left_out(**sizes, **soft.materials, assumption="plane strain")
    found = {
        "Hertz a": a, "Hertz p0": p_0, "excess p0": p.total, "excess a": w.total,
        "left out": left_out,
    }  # fmt: skip
    return {f"{key}, {WHERE}": value for key, value in found.items()}


def series(key: str) -> Any:
    """Interval of Hertz/FE - 1: the series and what it leaves out."""

    def interval(_: PairInputs, v: Values) -> tuple[float, float] | None:
        m = 1 / (1 + v[f"excess {key}, {WHERE}"]) - 1
        return about(m, v[f"left out, {WHERE}"])

    return interval


UNLIKE = tuple(
    Approximation(name=f"{name}, {WHERE}, Hertz", symbol=symbol, unit=unit, fem=f"{key}, {WHERE}",
                  analytic=f"Hertz {key}, {WHERE}", formal=2, interval=series(key),
                  demand=1e-3, demand_reason="well below the second order, 2.6e-3, which must show",
                  source="derived series of two discs; its next terms are bounded, 3e-4 at least")
    for key, name, symbol, unit in (("p0", "peak pressure", "p_0", "MPa"),
                                    ("a", "half-width", "a", "µm"))
)  # fmt: skip
