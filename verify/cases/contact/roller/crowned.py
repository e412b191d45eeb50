"""Crowned rollers: crown of Eq. 1, and optimal crown for the load."""

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from analytic.contact import strips
from analytic.contact.crown import slice_centres
from verify.case import Comparison, Computed, Quantity, shared
from verify.cases.contact.roller import comparisons, figures, texts
from verify.cases.contact.roller.inputs import Crown, Design, Divided
from verify.cases.contact.roller.shown import OnHalfSpace
from verify.core.case import Context
from verify.core.figures import Array, Figure
from verify.form.plots import dashes, plot

if TYPE_CHECKING:
    from analytic.contact.best_crown import BestCrown


@lru_cache(maxsize=64)
def _best_crown(
    load: float, length: float, R: float, E_star: float, tilts: tuple[float, float]
) -> "BestCrown":
    """The optimal crown; cached, because formulas and all levels use equal loads and tilts."""
    from analytic.contact.best_crown import best_crown  # common to formulas and reference

    return best_crown(load=load, length=length, R=R, E_star=E_star, tilt=tilts)


class CrownedRoller(Crown, Divided, OnHalfSpace):
    """A crowned roller, modelled by strips and slices."""

    @Quantity("A", "µm", "scale of the crown", equation="1", role="step",
              tex=r"\frac{2 K_1 Q}{\pi l E'} = \frac{K_1 Q}{\pi l E*}")  # fmt: skip
    def A(self) -> float:
        return float(self.K_1 * self.Q / (np.pi * self.L * self.E_star))

    @Quantity("t", "1", "coordinate t at y = l/2 - d; t is 0 at the start of the crown and 1 "
              "at the end of the roller",
              equation="1", form="corrected", role="step",
              tex=r"\max\left(0, \frac{|y| - l/2}{K_2 l/2} + 1\right) "
              r"= 1 - \frac{2 d}{K_2 l}")  # fmt: skip
    def t(self) -> float:
        return max(1 - 2 * self.d / (self.K_2 * self.L), 0.0)

    @Quantity(
        "z",
        "µm",
        "drop of the crown at y = l/2 - d",
        equation="1",
        form="corrected",
        role="step",
        tex=r"-A \ln\left(1 - \left(1 - \exp\left(-\frac{z_m}{A}\right)\right) t^2\right)",
    )
    def drop(self) -> float:
        return float(Crown.gap(self, np.array(self.L / 2 - self.d)))

    best_K_1 = Quantity("K_1*", "1",
                        "K_1 of the optimal crown for Q = F with unloaded ends; the pressure "
                        "changes little near the optimum",
                        source="search", role="step").reads(lambda q: q._best.K_1)  # fmt: skip
    best_K_2 = Quantity("K_2*", "1", "K_2 of the optimal crown", source="search",
                        role="step").reads(lambda q: q._best.K_2)  # fmt: skip
    best_z_m = Quantity("z_m*", "mm", "z_m of the optimal crown", source="search",
                        role="step").reads(lambda q: q._best.z_m)  # fmt: skip
    p_best = Quantity("p_max*", "MPa", "largest pressure with the optimal crown, ends "
                      "included, strips",
                      source="strips",
                      safe="too high").reads(lambda q: q.with_best_crown.strips.p_top)  # fmt: skip

    @shared
    def _best(self) -> "BestCrown":
        return self.best()

    @shared
    def with_best_crown(self) -> Self:
        """The roller with the crown that is optimal for F."""
        best = self._best
        sizes = {"K_1": best.K_1, "K_2": best.K_2, "z_m": best.z_m}
        return self.model_copy(update=sizes | {"Q": self.F})

    def best(self, load: float = 1.0, tilt: float | None = None) -> "BestCrown":
        """The crown that is optimal for `load` times F at the tilts 0 and ±`tilt` [rad]."""
        tilts = (0.0, self.lean if tilt is None else tilt)
        return _best_crown(load * self.F, self.L, self.R, self.E_star, tilts)

    @property
    def best_design(self) -> Design:
        """Parameters of the optimal crown, as input of the reference."""
        best = self.best()
        return Design(best.K_1, best.K_2, best.z_m)

    @property
    def lean(self) -> float:
        """Tilt of the axis [rad]."""
        return 0.0

    def even_pressure(self, share: float = 1.0) -> float:
        """Hertz's pressure [Pa] under `share` times F, if the load is uniformly distributed."""
        return float(np.sqrt(share * self.F / self.L * self.E_star / (np.pi * self.R)))

    def best_row(self) -> Comparison:
        """Row: largest pressure of the roller with optimal crown, strips against half-space."""

        def interval() -> tuple[float, float] | None:
            return comparisons.of_strips(self.with_best_crown, "p_top", own=not self.is_default)

        return comparisons.estimated(
            CrownedRoller.p_best, expected=Computed(interval, comparisons.ESTIMATE),
            symbol="p_max", order=1, by=comparisons.HALF_SPACE, sensitivity=(1e-2, ""),
            shares=f"{comparisons.SHARED}; the optimal crown, found with strips",
        )  # fmt: skip

    def warnings(self) -> Iterator[str]:
        """Warnings if the pressures are not valid for these inputs."""
        yield from texts.of_contact(self)
        if not self._best.free:
            yield "no crown leaves both ends unloaded: the reported crown has the least loaded ends"
        yield from texts.of_materials(self)

    def along_crowned(self, context: Context) -> Iterator[Figure]:
        """Figures: gap, pressure and line load along the roller."""
        yield figures.profile(self)
        yield from self.along_roller(context)

    def peaks_over(
        self, context: Context, over: str, x_label: str, *, gaps: Array, loads: Array, x: Array,
        best: tuple[str, Array], y_top: float, note: str,
    ) -> Figure:  # fmt: skip
        """Figure: ratio of the peak pressure to Hertz's pressure for each pair of gap and load.

        The loads are `loads` times F. The ratios are drawn over the abscissae `x`. A dashed curve
        shows the peak pressures with optimal crowns by the reference; best[0] is the name of this
        curve, best[1] are its abscissae.
        """
        roller: dict[str, Any] = {"length": self.L, "R": self.R, "E_star": self.E_star}
        pairs = zip(gaps, loads, strict=True)
        solved = [strips.press_strips(z, load=k * self.F, **roller) for z, k in pairs]
        curves = figures.over(solved, x, [self.even_pressure(k) for k in loads])
        least = context.fem[-1].arrays.get(f"best_over_{over}") if context.fem else None
        if least is not None:
            curves.append(dashes(best[0], best[1], least, 2))
        return plot(
            f"Largest pressure as a function of the {over}", x_label, "p_max/p_0", curves,
            y_top=y_top, y_bottom=0.95,
            note=f"p_0: Hertz's pressure of the uniform line load. Computed with {self.n} "
            f"strips, ends included. {note}",
        )  # fmt: skip

    @property
    def centres(self) -> Array:
        """Coordinates y [m] of the middles of the strips, shape (n,)."""
        return slice_centres(length=self.L, slices=self.n)
