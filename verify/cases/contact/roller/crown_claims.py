"""Comparisons of crowns for uniform pressure, and of the designs of the paper."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from verify.cases.contact.roller.formulas import by_strips
from verify.cases.contact.roller.inputs import DESIGNS, Design
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.judging.checks import Accepted, Fact, Margin
from verify.judging.tolerance_checks import Deviation, suites

FLAT = 0.01  # acceptance of a uniform pressure
FITTED = (
    "the paper prints neither length nor load: both are fitted; the best design depends on the load"
)
FIRST, NEXT = 1e-5, 0.05
RESOLVED = 2e-3  # relative to the half-length: 9 µm of the paper's roller
MID, AT_ENDS = 3e-3, 0.02  # acceptance of strips against the half-space
BEST = ("huang2018:fig12-best-k1", "huang2018:fig12-best-k2", "huang2018:fig12-best-zm")


def uneven(key: str, crown: str, far: float) -> Accepted:
    """Row: the half-space pressure is uniform except within `far` half-widths of the ends."""

    def margin(context: Context) -> tuple[float, float, str]:
        v = context.series(key)[1]
        return (
            FLAT - v[-1],
            3 * abs(v[-1] - v[-2]),
            f"the largest deviation from p_0 is {v[-1]:.2%}",
        )

    return Accepted(
        name=f"pressure with {crown} is uniform within {FLAT:.0%} at more than {far:g} b from "
        "the ends",
        symbol="p", unit="1", margin=margin,
    )  # fmt: skip


def printed_designs() -> Iterator[Check]:
    """Rows: the designs of Fig. 12 with the most and the least uniform pressure."""
    shared: dict[str, Any] = {"symbol": "q", "unit": "1", "fitted": FITTED}
    yield Accepted(name="Fig. 12: of the printed crowns, (K_1, K_2, z_m) = (1, 0.7, 0.01 mm) has "
                   "the most uniform pressure",
                   margin=extreme(0, most=False), printed=BEST, **shared)  # fmt: skip
    yield Accepted(name="Fig. 12: of the printed crowns, (K_1, K_2, z_m) = (5, 0.7, 0.015 mm) has "
                   "the least uniform pressure",
                   margin=extreme(1, most=True), **shared)  # fmt: skip


def deviations() -> Iterator[Check]:
    """Rows: length of the straight middle, and length of contact under a light load."""
    yield Deviation(
        name="the length of the straight middle depends on K_2, not on z_m", symbol="Δl_s/l",
        unit="1", size=straight, accepted=RESOLVED,
        source=suites("0.2 % of l/2, about the length of a cell of the half-space"),
        whole="l/2", by="crown", fem_needed=False, everywhere=True,
    )  # fmt: skip
    yield Fact(name="under a light load, only the straight middle is loaded", symbol="l_c/l",
               unit="1", margin=first_contact, fem_needed=False)  # fmt: skip


def extreme(design: int, *, most: bool) -> Margin:
    """Function that returns a positive margin if `design` has the largest or smallest share.

    The share is the fraction of the load that must move along the roller for a uniform line load.
    If `most`, the share of `design` must be the largest of all designs. The margin is then the
    ratio of this share to the next largest one, minus 1. Otherwise, the share must be the smallest,
    and the ratio is inverted.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        found = _designs(context, "uneven")
        this, others = float(found[-1, design]), np.delete(found[-1], design)
        next_ = float(others.max() if most else others.min())
        extent = "largest" if most else "smallest"
        words = (
            f"{this:.1%} of the load would have to move along the roller to make the line load "
            f"uniform, the {extent} share of all designs (next design: {next_:.1%})"
        )
        more = this / next_ if most else next_ / this
        return more - 1, _spread(found), f"{words}; {_peaks(context, design)}"

    return margin


def _peaks(context: Context, design: int) -> str:
    """Text: largest pressure of `design` and its rank, for two lengths of excluded end zones."""
    peaks = []
    for key, where in (
        ("p_max", "outside the end zones d"), ("near", "outside the last 0.1 mm at each end"),
    ):  # fmt: skip
        found = _designs(context, key)[-1]
        place = int(np.argsort(np.argsort(found))[design]) + 1
        peaks.append(
            f"largest pressure {found[design] / 1e6:.0f} MPa {where}, number {place} of the "
            f"{len(found)} designs in ascending order"
        )
    return "; ".join(peaks)


def _designs(context: Context, key: str) -> Array:
    names = [f"{key}_of_{design!s}" for design in DESIGNS]
    return np.array([[r.values[name] for name in names] for r in context.fem])


def _spread(found: Array) -> float:
    return float(3 * np.abs(found[-1] / found[-2] - 1).max())


def straight(context: Context) -> tuple[float, float, str]:
    """Error of the position where the crown starts, its uncertainty, and a text.

    The error is the shift due to z_m plus the distance from (1 - K_2) l/2, relative to l/2.
    """
    q = context.inputs
    y = np.linspace(0, q.L / 2, 20001)

    def start(K_2: float, z_m: float) -> float:
        z = q.designed(Design(1.0, K_2, z_m)).gap(y)
        return float(y[np.argmax(z > 0)])

    by_z = abs(start(0.7, 25e-6) - start(0.7, 5e-6))
    off = abs(start(0.4, 10e-6) - 0.6 * q.L / 2) + abs(start(0.7, 10e-6) - 0.3 * q.L / 2)
    moved = (by_z + off) / (q.L / 2)
    return (
        moved,
        2 * float(y[1]) / (q.L / 2),
        f"the start of the crown differs by {moved:.1e} of l/2",
    )


def first_contact(context: Context) -> tuple[float, float]:
    """Margin, positive if the contact under a light load ends within a limit; its uncertainty.

    The limit is the end of the straight middle plus NEXT l/2. The contact is computed by strips,
    for the crown of Fig. 13a and FIRST times the load F.
    """
    q = context.inputs
    light = q.designed(Design(1, 0.4, 10e-6)).model_copy(update={"F": FIRST * q.F})
    solved, parts = by_strips(light, q.n)
    outmost = float(np.abs(parts.y[solved.carries]).max())
    return float(1 - light.K_2 + NEXT - outmost / (q.L / 2)), 1 / q.n
