"""Judge formulas with an error band at user inputs; rows are SHOWN if meshes are too coarse."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from verify.core.case import Context, Values
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.checks import Approximation, Identity

LOOSE = 0.05  # half of a band from which on a formula is SHOWN, not judged
FINER = 0.5  # of half a band: coarser meshes cannot decide
TWICE = 2.2  # half bands: largest change of a formula inside its band, with a margin


def undecided(rows: list[Row], band: tuple[float, float]) -> list[Row]:
    """Rows for user inputs; a row is SHOWN instead of FAIL if the meshes do not resolve the `band`.

    A row is also SHOWN instead of FAIL if the values do not converge.
    """
    row, half = rows[0], (band[1] - band[0]) / 2
    if row.grid is None or not row.fem or row.analytic is None:
        return rows
    steady = row.grid.behaviour not in ("diverging", "short")
    m, U = row.analytic / row.fem - 1, judge.expanded(row.u_num or 0.0) / abs(row.fem)
    outside = max(band[0] - m, m - band[1]) > U
    if steady and (outside or (FINER * half > U and row.status is not Status.FAIL)):
        return rows
    why = f"its uncertainty is {U:.2g}" if steady else "the meshes do not converge"
    reason = (
        f"measured model error: {100 * m:+.2f} %; {why}; "
        f"the half-width of the expected interval is {half:.2g}"
    )
    return [
        replace(r, status=Status.SHOWN, reason=reason) if r.status is Status.FAIL else r
        for r in rows
    ]


def too_wide(rows: list[Row], reason: str) -> list[Row]:
    """Rows of a comparison whose band is too wide; all but passed convergence rows become SHOWN."""
    first, *others = rows
    undecided_rows = [first, *(row for row in others if row.status is Status.FAIL)]
    others = [row for row in others if row.status is not Status.FAIL]
    return [
        replace(r, status=Status.SHOWN, reason=f"{r.reason}; {reason}") for r in undecided_rows
    ] + others


@dataclass(frozen=True, kw_only=True)
class OwnFormula(Approximation):
    """Comparison of a formula that is judged by a band of expected errors, also at user inputs.

    At user inputs, the required sensitivity is at least the width of the band, and `bent` [1] is
    the widening of the band by bending. `wide` is the reason that is displayed if the band is too
    wide.
    """

    wide: str
    bent: Callable[[Any, Values], float] | None = None

    def band(self, q: Any, v: Values) -> tuple[float, float] | None:
        """Band of expected errors at user inputs; None if it is too wide for judging."""
        band = self.interval and self.interval(q, v)
        if not band:
            return None
        more = self.bent(q, v) if self.bent else 0.0
        low, high = band[0] - more, band[1] + more
        return (low, high) if high - low < 2 * LOOSE else None

    def rows(self, context: Context) -> list[Row]:
        if context.is_paper:
            return super().rows(context)
        band = self.band(context.inputs, context.analytic)
        widened = replace(self, interval=lambda _q, _v: band, bent=None)
        rows = Approximation.rows(widened, context)
        if band:
            return undecided(rows, band)
        return too_wide(rows, self.wide)

    def demanded(self, context: Context) -> float:
        usual = super().demanded(context)
        band = None if context.is_paper else self.band(context.inputs, context.analytic)
        return max(usual, TWICE * (band[1] - band[0]) / 2) if band else usual


@dataclass(frozen=True, kw_only=True)
class OwnFillet(Identity):
    """Comparison of a largest stress; at user inputs, an error of the contact force is allowed for.

    Hertz's simplifications cause the error of the contact force N. `blur` is the analytic key of
    the resulting standard uncertainty, relative to the stress. `wide` is the reason that is
    displayed if the uncertainty is too large.
    """

    blur: str
    wide: str

    def rows(self, context: Context) -> list[Row]:
        if context.is_paper:
            return super().rows(context)
        blur = 2 * context.analytic[self.blur]
        rows = Identity.rows(replace(self, residual=self.blur), context)
        if blur < LOOSE:
            return undecided(rows, (-blur, blur))
        return too_wide(rows, self.wide)

    def demanded(self, context: Context) -> float:
        usual = super().demanded(context)
        return usual if context.is_paper else max(usual, 2 * TWICE * context.analytic[self.blur])
