"""Case of a crowned roller with a tilted axis: load of the more loaded end."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from verify.case import Comparison, Drawn, Level, Quantity, Scan
from verify.cases.contact.roller import comparisons
from verify.cases.contact.roller.crowned import CrownedRoller
from verify.cases.contact.roller.half_space import LEVELS, solve_crowns
from verify.cases.contact.roller.inputs import Crown, Tilt
from verify.cases.contact.roller.texts import ASSUMPTIONS, COUPLED, READINGS
from verify.core.case import Context
from verify.core.figures import Array, Figure
from verify.core.references import BY_HALF_SPACE
from verify.form.adapter import adapted
from verify.judging.tolerance_checks import suites

TILTS = np.linspace(0.0, 2.0, 33)  # over the one given
BEST_TILTS = np.linspace(0.0, 2.0, 5)
LEAN = 5e-4  # rad, if no tilt is given
MOMENT = 0.01  # relative to the tilting moment


class TiltedRoller(Tilt, CrownedRoller):
    """Races deflect and sprags tilt: the axis of the crowned roller is not parallel to the race.

    Strips and slices are computed with the gap of the tilted roller. Strips must predict the load
    in the more loaded end zone.
    """

    id = "contact-roller-tilted"
    title = "Tilted crowned roller on a race"
    source = "huang2018"
    place = "Eqs. 1-5, with a tilted axis of the roller"
    method = BY_HALF_SPACE
    levels: ClassVar = LEVELS
    scans: ClassVar = (Scan(vary=("theta=0.01deg,0.03deg,0.06deg",), star=True),)
    readings: ClassVar = (
        *READINGS, COUPLED, "θ rotates the roller about mid-length and adds −θ y to the gap",
    )  # fmt: skip
    assumptions: ClassVar = ASSUMPTIONS

    @property
    def lean(self) -> float:
        """Tilt of the axis [rad]."""
        return self.theta

    @Quantity("M", "N m", "tilting moment about mid-length, strips", source="strips",
              tex=r"\int_{-l/2}^{l/2} q y\,dy")  # fmt: skip
    def M(self) -> float:
        return float(self.strips.line @ self.strips.y * self.strips.width)

    F_high = Quantity(
        "F_h", "N", "load in the more loaded end zone d, strips", source="strips",
        safe="too high",
        tex=r"\int_{l/2 - d}^{l/2} q\,dy",
    ).reads(lambda q: q.strips.ends[1])  # fmt: skip

    def reference(self, level: int) -> Level:
        """Results of the tilted roller on the half-space, with its crown and the optimal crown."""
        best = {"best_over_tilt": self._best_over_tilt()} if level == LEVELS[-1] else {}
        return solve_crowns(self, level, self.best_design, more={}, arrays=best)

    def _best_over_tilt(self) -> Array:
        """Peak pressure with the optimal crown for each tilt, divided by Hertz's pressure."""
        angles = BEST_TILTS * (self.theta or LEAN)
        return np.array([self.best(tilt=a).peak / self.even_pressure() for a in angles])

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: pressures, tilting moment and load of the more loaded end against half-space."""
        q = TiltedRoller
        yield from comparisons.strips_rows(self, q.p_max, q.delta)
        yield from comparisons.sliced_rows(self, (q.p_max_slices,), (q.p_max_lamina,))
        yield comparisons.agreeing(
            f"tilting moment: strips and half-space agree within {MOMENT:.0%}", q.M, MOMENT,
            self.F * self.L, suites("equal to the default required sensitivity of a row"),
        )  # fmt: skip
        yield comparisons.agreeing(
            "load in the more loaded end zone d: strips and half-space agree within "
            f"{comparisons.ENDS:.0%}",
            q.F_high, comparisons.ENDS, self.F,
            suites("with tilt, the accepted error is the same as without tilt"), symbol="F_d",
        )  # fmt: skip
        yield comparisons.end_pressure(self)
        yield self.best_row()
        yield comparisons.balanced(self)

    def figures(self) -> Iterator[Drawn]:
        """Figures: pressure along the roller, and peak pressure over the tilt."""
        yield Drawn(self.along_crowned)
        yield Drawn(self._over_tilt)

    def _over_tilt(self, context: Context) -> Iterator[Figure]:
        y, unit = self.centres, self.theta or LEAN
        yield self.peaks_over(
            context, "tilt", "θ [°]", gaps=Crown.gap(self, y) - (TILTS * unit)[:, None] * y,
            loads=np.ones(len(TILTS)), x=np.degrees(TILTS * unit),
            best=("optimal crown for ±θ", np.degrees(BEST_TILTS * unit)), y_top=2.2,
            note="The optimal crown of a tilted roller is deeper than that of a roller without "
            "tilt.",
        )  # fmt: skip


TILTED = adapted(TiltedRoller)
