"""What the report draws of the locked ring."""

from collections.abc import Iterator, Sequence

import numpy as np

from verify.cases.polyhedral.locking.formulas import LockedFormulas
from verify.cases.polyhedral.locking.reference import PRESSURES, diameters
from verify.core.case import Context, FemResult
from verify.core.figures import Array, Curve, Curves

MPa, mm, N_mm = 1e6, 1e-3, 1e3
FINE = 25


def curves(levels: Sequence[FemResult]) -> dict[str, Array]:
    """The finite elements' curves, which one level has; none without it."""
    return next((dict(level.arrays) for level in levels if level.arrays), {})


def figures(q: LockedFormulas, context: Context) -> Iterator[Curves]:
    """Force of a roller over the pressure; efficiency over the width of the support."""
    fem, p = curves(context.fem), np.linspace(0, 1.2 * q.p_t, FINE)
    side = q.d_i * np.sin(q.half_angle)
    rigid, soft = (np.array([one.under(x, q.d).N for x in p]) for one in (q.alone, q.soft))
    drawn = [
        Curve(name="Eq. 16 without hub", x=p / MPa, y=np.maximum(p - q.p_1r, 0) * side / N_mm,
              style="dashes", colour=0),
        Curve(name="series", x=p / MPa, y=rigid / N_mm, colour=1),
        Curve(name="series, elastic rollers", x=p / MPa, y=soft / N_mm, colour=4),
    ]  # fmt: skip
    if "over pressure" in fem:
        at, (alone, pushed, elastic) = PRESSURES * q.p_t / MPa, fem["over pressure"] / N_mm
        drawn += [
            Curve(name=name, x=at, y=y, style="dots", colour=colour)
            for name, y, colour in (("FE", alone, 2), ("FE, elastic rollers", elastic, 4),
                                    ("FE, with the hub's force", pushed, 3))
        ]  # fmt: skip
    yield Curves(
        title="Force of a roller over the pressure", x_label="p [MPa]", y_label="N/b [N/mm]",
        curves=tuple(drawn),
        note=f"Of a further pressure {q.alone.efficiency:.0%} reach rigid rollers; the rest is "
        "the ring's own hoop force. Eq. 16 hands on all of it.",
    )  # fmt: skip
    if "rollers" in fem:
        yield _supports(q, *fem["rollers"], *fem["bonded"])


def _supports(q: LockedFormulas, a: Array, eta: Array, w: Array, bonded: Array) -> Curves:
    """Efficiency over half the width that is held."""
    states = [q.alone.under(q.p_t, d) for d in diameters(q)]
    sizes = ", ".join(f"{d / mm:.3g}" for d in diameters(q))
    return Curves(
        title="Efficiency over the width of the support", x_label="half-width [mm]", y_label="η",
        curves=(
            Curve(name="rollers, series", x=np.array([s.a for s in states]) / mm,
                  y=np.array([s.efficiency for s in states]), colour=1),
            Curve(name="rollers, FE", x=a / mm, y=eta, style="dots", colour=2),
            Curve(name="held stretch, FE", x=w / mm, y=bonded, style="dots", colour=4),
        ),
        y_bottom=float(0.9 * min(eta.min(), bonded.min())),
        note=f"Rollers of {sizes} mm under p_t, and stretches that are held all along.",
    )  # fmt: skip
