"""Figures of the locked ring: roller force over pressure, load transfer over support width."""

from collections.abc import Iterator, Sequence

import numpy as np

from verify.cases.polyhedral.locking.formulas import LockedFormulas
from verify.cases.polyhedral.locking.reference import PRESSURES, diameters
from verify.core.case import Context, FemResult
from verify.core.figures import Array, Curves
from verify.form.plots import dashes, dots, line, plot

MPa, mm, N_mm = 1e6, 1e-3, 1e3
FINE = 25


def curves(levels: Sequence[FemResult]) -> dict[str, Array]:
    """Curves by finite elements, from the first level that has them; empty if none has."""
    return next((dict(level.arrays) for level in levels if level.arrays), {})


def figures(q: LockedFormulas, context: Context) -> Iterator[Curves]:
    """Figures: force of a roller over pressure; load-transfer ratio over support width."""
    fem, p = curves(context.fem), np.linspace(0, 1.2 * q.p_t, FINE)
    side = q.d_i * np.sin(q.half_angle)
    rigid, soft = (np.array([one.under(x, q.d).N for x in p]) for one in (q.alone, q.soft))
    drawn = [
        dashes("Eq. 16 without hub force", p / MPa, np.maximum(p - q.p_1r, 0) * side / N_mm),
        line("series", p / MPa, rigid / N_mm, 1),
        line("series, elastic rollers", p / MPa, soft / N_mm, 4),
    ]  # fmt: skip
    if "over pressure" in fem:
        at, (alone, pushed, elastic) = PRESSURES * q.p_t / MPa, fem["over pressure"] / N_mm
        drawn += [
            dots(name, at, y, colour)
            for name, y, colour in (("FE", alone, 2), ("FE, elastic rollers", elastic, 4),
                                    ("FE, with hub force", pushed, 3))
        ]  # fmt: skip
    yield plot(
        "Force of a roller over the pressure", "p [MPa]", "N/b [N/mm]", drawn,
        note=f"Rigid rollers carry {q.alone.efficiency:.0%} of an increase of the pressure; the "
        "hoop force of the ring balances the rest. Eq. 16 assigns the whole increase to the "
        "rollers.",
    )  # fmt: skip
    if "rollers" in fem:
        yield _supports(q, *fem["rollers"], *fem["bonded"])


def _supports(q: LockedFormulas, a: Array, eta: Array, w: Array, bonded: Array) -> Curves:
    """Figure: load-transfer ratio over the half-width of the support."""
    states = [q.alone.under(q.p_t, d) for d in diameters(q)]
    sizes = ", ".join(f"{d / mm:.3g}" for d in diameters(q))
    return plot(
        "Incremental load-transfer ratio over the half-width of the support", "half-width [mm]",
        "η",
        line("rollers, series", np.array([s.a for s in states]) / mm,
             np.array([s.efficiency for s in states]), 1),
        dots("rollers, FE", a / mm, eta, 2),
        dots("supported part, FE", w / mm, bonded, 4),
        y_bottom=float(0.9 * min(eta.min(), bonded.min())),
        note=f"Each support is a rigid roller of {sizes} mm diameter under p_t, or, in place of a "
        "roller, a part of the outer surface that is fixed in radial direction.",
    )  # fmt: skip
