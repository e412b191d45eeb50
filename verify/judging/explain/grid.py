"""Levels, behaviour, observed order and grid convergence index of a row, recomputed."""

import math

from verify.core.results import Grid
from verify.judging.convergence import (
    FAR_FROM_FORMAL,
    FLOOR,
    NEAR_FORMAL,
    RESOLVED,
    GridConvergence,
    grid_convergence,
    unresolved_multiple,
)
from verify.judging.explain.lines import Step, amount, long, short
from verify.judging.judge import numerical_uncertainty

MEANING = {
    "monotone": "the last differences have equal signs and decrease with a constant order",
    "oscillating": "the last differences change sign",
    "slow": "the observed order is below 0.5",
    "noisy": "the iteration error exceeds 1 % of the last difference",
    "round-off": f"the last difference is below {RESOLVED:g} of the scale",
    "diverging": "the differences grow, or a value is not finite",
    "short": "fewer than three levels",
}


def regrid(g: Grid) -> tuple[GridConvergence, float]:
    """Grid convergence of the recorded levels, computed again, and u_num of the finest value."""
    h, v = zip(*g.levels, strict=True)
    if not all(map(math.isfinite, v)):
        return GridConvergence("diverging", math.inf), math.inf
    again = grid_convergence(h, v, formal=g.formal, scale=g.scale, u_it=g.u_it)
    return again, numerical_uncertainty(again, g.u_it)


def levels(g: Grid) -> list[Step]:
    """One line per level: relative mesh size, value, change from the coarser level."""
    found: list[Step] = []
    before: float | None = None
    for h, v in g.levels:
        change = "" if before is None else f", changes by {v - before:+.3e}"
        found.append((f"h = {h:.4g}", amount(v, g.unit, long) + change))
        before = v
    return found


def grid_steps(g: Grid) -> list[Step]:
    """Lines of the explanation: levels, their convergence behaviour, and the observed order."""
    again, _ = regrid(g)
    found = [*levels(g), ("behaviour", f"{again.behaviour}: {MEANING[again.behaviour]}")]
    if again.order is not None:
        (h3, _), (h2, _), (h1, _) = g.levels[-3:]
        theory = "none in theory" if g.formal is None else f"{g.formal:g} in theory"
        ratios = f"refined by {h3 / h2:.4g} and {h2 / h1:.4g}"
        found.append(("order", f"observed {again.order:.4f} ({ratios}), {theory}"))
    return found


def uncertainty_steps(g: Grid) -> list[Step]:
    """Lines of the explanation: grid convergence index with numbers, and u_num (finest mesh)."""
    again, u_num = regrid(g)
    if not again.converges:
        return []
    return [
        *_index(g, again),
        (
            "u_it",
            f"{amount(g.u_it, g.unit)}, error of iteration and round-off stated by the solver",
        ),
        (
            "u_num",
            f"√((GCI/2)² + u_it²) = √(({short(again.gci)}/2)² + {short(g.u_it)}²) = "
            f"{amount(u_num, g.unit)}",
        ),
    ]


def _index(g: Grid, again: GridConvergence) -> list[Step]:
    gci = amount(again.gci, g.unit)
    v3, v2, v1 = (v for _, v in g.levels[-3:])
    spread = max(v1, v2, v3) - min(v1, v2, v3)
    if again.used is None or again.factor is None or again.order is None or g.formal is None:
        last = short(spread)
        if again.behaviour == "round-off":
            times = unresolved_multiple(v1 - v2, v2 - v3, g.scale)
            how = (
                f"{'' if times == 1 else f'{times:.3g} × '}spread of the last three values, {last}"
            )
        else:
            why = "theory gives no order" if g.formal is None else "no order can be determined"
            how = f"3 × spread of the last three values, 3 × {last}: {why}"
        return [("GCI", f"{_floored(g, again.gci, how)} = {gci}")]
    off = abs(again.order - g.formal)
    ratio = g.levels[-2][0] / g.levels[-1][0]
    word = (
        f"within {NEAR_FORMAL}" if off <= NEAR_FORMAL
        else f"beyond {NEAR_FORMAL}" if off >= FAR_FROM_FORMAL
        else f"between {NEAR_FORMAL} and {FAR_FROM_FORMAL}"
    )  # fmt: skip
    return [
        ("p", f"min(observed, theory) = {again.used:.4f}"),
        (
            "F",
            f"{again.factor:g}: observed and theory differ by {off:.2g}, {word}",
        ),
        (
            "GCI",
            "F |v1 − v2|/(r^p − 1) = "
            + _floored(
                g,
                again.gci,
                f"{again.factor:g} × {short(abs(v1 - v2))}/({ratio:.4g}^{again.used:.4f} − 1)",
            )
            + f" = {gci}",
        ),
    ]


def _floored(g: Grid, gci: float, how: str) -> str:
    """Derivation of the index, with the lower bound if this bound applies."""
    if gci > FLOOR * g.scale:
        return how
    return f"max({how}, {FLOOR:g} of the scale {short(g.scale)})"
