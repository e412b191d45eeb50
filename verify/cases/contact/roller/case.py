"""Case of a crowned roller on its race: strips and slices against the half-space."""

from collections.abc import Iterator
from functools import partial
from typing import Any, ClassVar

import numpy as np

from verify.case import Comparison, Computed, Drawn, Level, Scan, approximation
from verify.cases.contact.roller import comparisons
from verify.cases.contact.roller.crowned import CrownedRoller
from verify.cases.contact.roller.half_space import LEVELS, solve_crowns
from verify.cases.contact.roller.texts import ASSUMPTIONS, READINGS
from verify.core.case import Context
from verify.core.figures import Array, Figure
from verify.core.references import Method
from verify.form.adapter import adapted

PLANE_NU = 0.3  # Poisson's ratio of the disc; only E/(1 − ν²) matters
BEST_AT = np.geomspace(0.2, 2.5, 6)  # loads over F
FINE_AT = np.geomspace(0.2, 2.5, 40)
SERIES = "derived series of the disc, ± (a/R)⁴ as an estimate of the next term, at least 3e-4"
PLANE = "plane finite elements under the line load computed by strips"


class RollerOnRace(CrownedRoller):
    """A roller of finite length represents the sprag; it has the crown of the paper for 25 N m.

    Two models are compared with boundary elements on a half-space: strips, each with Hertz's
    elliptical pressure across the contact, and the slicing technique of the paper. Plane finite
    elements verify the middle of the roller. The error of strips is derived; the difference between
    strips and half-space must agree with this error.
    """

    id = "contact-roller"
    title = "Crowned roller on a race"
    source = "huang2018"
    place = "Eqs. 1-5"
    method = Method("half-space; finite elements at mid-length", "half-space")
    levels: ClassVar = LEVELS
    scans: ClassVar = (Scan(vary=("F=1500N,3407N,6000N", "L=6mm,9mm"), star=True),)
    readings: ClassVar = READINGS
    assumptions: ClassVar = (
        *ASSUMPTIONS,
        "plane finite elements: a disc of the relative radius on a rigid flat, under the line load "
        "of the strips at mid-length",
    )

    def reference(self, level: int) -> Level:
        """Results of the half-space with the given and the optimal crown, and of a plane disc."""
        best = {"best_over_load": self._best_over_load()} if level == LEVELS[-1] else {}
        more = self.plane_at_middle(level)
        return solve_crowns(self, level, self.best_design, more=more, arrays=best)

    def plane_at_middle(self, level: int) -> dict[str, float]:
        """Plane-strain values of a disc on a rigid flat under the line load of the middle strip."""
        from analytic.contact.strips import press_strips
        from verify.cases.contact.line.inputs import FlatInputs
        from verify.cases.contact.line.reference import disc_fem

        gap = self.gap(self.centres)
        solved = press_strips(gap, length=self.L, R=self.R, E_star=self.E_star, load=self.F)
        P = float(solved.mid**2 * np.pi * self.R / self.E_star)
        disc = FlatInputs(R=self.R, E=self.E_star * (1 - PLANE_NU**2), nu=PLANE_NU, F=P * self.L,
                          L=self.L)  # fmt: skip
        found = disc_fem(disc, P, disc.guess, level // 4)
        return {"p_plane": found.peak, "b_plane": found.half_width}

    def _best_over_load(self) -> Array:
        """Peak pressure with the optimal crown for each load, divided by Hertz's pressure."""
        return np.array([self.best(k).peak / self.even_pressure(k) for k in BEST_AT])

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: strips and slices against the half-space; the middle against plane elements."""
        q = RollerOnRace
        yield from comparisons.strips_rows(self, q.p_max, q.p_mid, q.delta)
        yield from comparisons.sliced_rows(
            self, (q.p_max_slices, q.p_mid_slices, q.delta_slices),
            (q.p_max_lamina, q.p_mid_lamina, q.delta_lamina),
        )  # fmt: skip
        yield comparisons.loaded_ends(self)
        yield comparisons.end_pressure(self)
        plane: dict[str, Any] = {
            "order": 2, "sensitivity": (5e-3, comparisons.ACCEPTED),
            "shares": "line load of the strips at mid-length",
        }  # fmt: skip
        for one, what, symbol, key in ((q.p_mid, "pressure", "p", "pressure"),
                                       (q.b_mid, "half-width", "b", "width")):  # fmt: skip
            interval = partial(comparisons.of_disc, self, key)
            yield approximation(one, f"{symbol}_plane", name=f"{what} at mid-length, {PLANE}",
                                symbol=symbol, expected=Computed(interval, SERIES),
                                **plane)  # fmt: skip
        yield self.best_row()
        yield comparisons.balanced(self)

    def figures(self) -> Iterator[Drawn]:
        """Figures: pressure along the roller, and peak pressure over the load."""
        yield Drawn(self.along_crowned)
        yield Drawn(self._over_load)

    def _over_load(self, context: Context) -> Iterator[Figure]:
        yield self.peaks_over(
            context, "load", "load/F", gaps=np.tile(self.gap(self.centres), (len(FINE_AT), 1)),
            loads=FINE_AT, x=FINE_AT, best=("optimal crown for each load", BEST_AT), y_top=1.6,
            note="The optimal crown for a load leaves the ends unloaded. Dots: loads at which the "
            "ends of the given crown are loaded; on a half-space, the pressure there is unbounded.",
        )  # fmt: skip


ROLLER = adapted(RollerOnRace)
