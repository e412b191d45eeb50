"""Case of a roller without crown: converging results, and singular peak at the ends."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from verify.case import Comparison, Drawn, Level, Scan
from verify.cases.contact.roller import comparisons, half_space, texts
from verify.cases.contact.roller.formulas import MIDDLE, by_strips
from verify.cases.contact.roller.inputs import FEWEST, MOST
from verify.cases.contact.roller.shown import OnHalfSpace
from verify.core.case import Check, Context
from verify.core.figures import Figure, Refinement
from verify.core.references import BY_HALF_SPACE
from verify.form.adapter import adapted
from verify.form.plots import dashes, line, plot
from verify.judging.checks import Order

SLOPE = 0.5  # order of 1/peak in the cell: pressure grows as 1/sqrt(distance) at the end
ALONG = 128  # cells along the roller, a level: no more than b/12 long
COUNTS = (41, 57, 81, 115, 161, 229, 321)
FLAT = 5e-3  # acceptance of pressures and approach without a crown
WITHIN = f"strips of width b and half-space agree within {FLAT:.1%}"


class FlatRoller(OnHalfSpace):
    """A cylindrical roller without a crown presses on a race.

    On a half-space, the pressure at the ends of the roller is infinite. The peak that a model gives
    there has no physical meaning: it depends only on the size of the cells or slices of the model.
    The rows judge values that converge, and the exponent with which the peak grows as the cells
    become smaller.
    """

    id = "contact-roller-flat"
    title = "Roller without crown on a race"
    source = "huang2018"
    place = "Eqs. 2-5, without profile modification"
    method = BY_HALF_SPACE
    levels: ClassVar = (8, 11, 16, 22, 32)
    scans: ClassVar = (
        Scan(vary=("F=1000N,3407N,10000N", "L=4mm,9mm,18mm", "R_1=2mm,4.02mm,8mm"), star=True),
    )
    readings: ClassVar = (texts.COUPLED,)
    assumptions: ClassVar = texts.ASSUMPTIONS

    @property
    def n(self) -> int:
        """Number of strips, which are about as wide as the half-width of the contact.

        Narrower strips overestimate the load of loaded ends.
        """
        return min(max(round(self.L / self.b), FEWEST), MOST)

    def reference(self, level: int) -> Level:
        """Results of the half-space, with more cells along the roller than by default."""
        found = half_space.pressed(self, level, along=ALONG * level)
        return half_space.result(found, level, {})

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: converging results at mid-length and ends, and exponent of the unbounded peak."""
        q = FlatRoller
        yield comparisons.agreeing(f"{MIDDLE}: {WITHIN}", q.p_mid, FLAT, lambda: self.p_0)
        yield comparisons.agreeing(f"approach: {WITHIN}", q.delta, FLAT, lambda: self.delta_P)
        yield comparisons.loaded_ends(self)
        yield comparisons.end_pressure(self)
        yield Order(name="exponent of the cell size in the power law for 1/(peak pressure)",
                    symbol="p", unit="1", errors=self._inverse_peaks, order=SLOPE)  # fmt: skip
        yield from comparisons.sliced_rows(self, (q.p_mid_slices,), (q.p_mid_lamina,))
        yield comparisons.balanced(self)

    def _inverse_peaks(self, context: Context) -> tuple[list[float], list[float]]:
        """Cell sizes, and ratios of Hertz's to the largest pressure; the ratio tends to zero."""
        h, peaks = context.series("p_largest")
        return h, [self.p_0 / p for p in peaks]

    def figures(self) -> Iterator[Drawn]:
        """Figures: pressure along the roller, end load over n, peak pressure over cell number."""
        yield Drawn(self._drawn)

    def _drawn(self, context: Context) -> Iterator[Figure]:
        yield from self.along_roller(context)
        yield self._over_strips(context)
        if context.converging:
            yield self._peaks(context)

    def _peaks(self, context: Context) -> Figure:
        """Figure of the peak pressure over the number of cells: the pressure has no limit."""
        cells = np.array([len(r.arrays["y"]) for r in context.fem]) * self.b / self.L
        peak, mid = (np.array(context.series(k)[1]) / self.p_0 for k in ("p_largest", "p_mid"))
        return Refinement(
            title="Unbounded peak pressure at the end", x_label="cells on Hertz's half-width",
            y_label="p/p_0", cells=np.round(cells, 1), errors=(("peak", peak),), order=-0.5,
            note="Dots: largest pressure of a cell over p_0, Hertz's pressure of the uniform line "
            f"load; line: slope 1/2. At mid-length, p/p_0 is {mid[-1]:.4f}.",
        )  # fmt: skip

    def _over_strips(self, context: Context) -> Figure:
        """Figure: end load over the number of strips; narrow strips overestimate this load."""
        found = [sum(by_strips(self, n)[1].ends) / self.F for n in COUNTS]
        curves = [line("strips", np.array(COUNTS, float), np.array(found))]
        if context.fem:
            x, share = np.array([COUNTS[0], COUNTS[-1]], float), context.series("F_d")[1][-1]
            curves.append(dashes("half-space", x, share / self.F, 4))  # fmt: skip
        return plot(
            "Share of the load in both end zones d over the number of strips", "n", "F_d/F",
            curves,
            y_bottom=0.9 * min(found),
            note="With strips narrower than b, the load near a loaded end does not converge: use "
            f"about l/b = {self.L / self.b:.0f} strips.",
        )  # fmt: skip


UNCROWNED = adapted(FlatRoller)
