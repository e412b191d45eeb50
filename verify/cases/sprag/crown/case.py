"""Effect of the three crown parameters on the pressures of a sprag clutch (Secs. 4.1, 4.2)."""

import math
from collections.abc import Iterator
from functools import partial
from typing import ClassVar

import numpy as np

from analytic.contact import crown_mean
from analytic.contact.crown import straight_length
from analytic.contact.sliced import SlicedContact
from analytic.sprag.crowned import mid
from analytic.sprag.work_balance import at_rest, sprags_inertia
from verify.case import Case, Level, Quantity, Scan, drawn_by, shared
from verify.cases.sprag.clutch.advice import refusal as refusal_at_rest
from verify.cases.sprag.clutch.model import normal_force, under
from verify.cases.sprag.crown import advice as advised
from verify.cases.sprag.crown import comparisons as compared
from verify.cases.sprag.crown import figures as drawn
from verify.cases.sprag.crown import formulas
from verify.cases.sprag.crown.table2 import table_2
from verify.cases.sprag.engagement.formulas import swing
from verify.cases.sprag.engagement.model import crowned_for, gap, motion, wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import Crown
from verify.core.case import Context
from verify.core.figures import Table
from verify.core.references import BY_STRIPS
from verify.form.adapter import adapted


def _is_crowned(q: "SpragCrown") -> bool:
    return q.z_m > 0


Drop = partial(Quantity, when=_is_crowned)
ARTANH = r"\ln\left(\frac{1 + \sqrt{c}}{1 - \sqrt{c}}\right)"  # 2 artanh(√c)


class SpragCrown(EngagementInputs, Case):
    """Design load of a crown, and the effect of the crown on the largest pressure of an engagement.

    The figures of the paper state which of its crowns have low or high pressures. The case
    verifies these statements under the contact forces of computed engagements. If a statement is
    true only under another force, the row states this force.
    """

    id = "sprag-crown"
    title = "Effect of the crown's parameters on contact pressure"
    source = "huang2018"
    place = "Eq. 1, Secs. 4.1 and 4.2, Figs. 11-14, Table 2"
    method = BY_STRIPS
    levels: ClassVar = (41, 81, 161)  # strips along a sprag
    scans: ClassVar = (Scan(vary=("T=20N m,25N m,30N m",), star=True),)
    readings: ClassVar = (
        "Eq. 1 is symmetric about mid-length, and its drop is zero in the straight middle part; "
        "A is the factor before the logarithm (ledger: eq-1-a-undefined, eq-1-clipping)",
        "z_m is in millimetres; the paper prints no unit",
        "Q of Eq. 1 is the same load for all torques, 3407 N: the static load of rigid parts at "
        "25 N m (3388 N with deflections). If Q depended on the torque, the optimal K_1 would not "
        "increase with the torque",
        "Fig. 12 applies under a force of 2 to 4 kN, such as the static load, not at the first "
        "peak at 25 N m (ledger: fig-12-load). The paper does not print which crowns Fig. 12 "
        "contains: all eight printed crowns are compared",
    )
    assumptions: ClassVar = (
        "length, width and wedge angle of the sprags, the stiffness of the support and Q are "
        "identified, not printed: results that depend on them are calibrated",
        "N_max of the crowns of Eq. 19 is a quadratic function fitted to 27 computed engagements. "
        "N_max differs by 2 % over all crowns; the residual of the fit changes p_max by less than "
        "0.1 %",
        "for a user's clutch, the bounds of z_m in Eq. 19 are multiplied by 2Q/(π l E') of that "
        "clutch divided by 2Q/(π l E') of the clutch of the paper",
        "pressures are computed by slices (Palmgren's law): at loaded ends, they are lower than on "
        "a half-space",
    )

    @Drop("A", "µm", "factor of the logarithm", equation="1", form="corrected",
          tex=r"\frac{2 K_1 Q (1 - \nu^2)}{\pi l E}")  # fmt: skip
    def A(self) -> float:
        return self.K_1 * formulas.unit(self)

    @Drop("l_0", "mm", "length of the straight middle part", equation="1", tex="(1 - K_2) l")
    def straight(self) -> float:
        return float(straight_length(K_2=self.K_2, length=self.l))

    @Drop("c", "1", "coefficient of t² in the logarithm", role="step", equation="1",
          tex=r"1 - \exp\left(-\frac{z_m}{A}\right)")  # fmt: skip
    def c(self) -> float:
        return float(-np.expm1(-self.z_m / self.A))

    @Drop("z_mean", "µm", "mean drop over the length", source="Eq. 1, mean over the length",
          tex=rf"K_2 (z_m + 2 A - A \frac{{{ARTANH}}}{{\sqrt{{c}}}})")  # fmt: skip
    def mean(self) -> float:
        return crown_mean.mean_drop(self.A, self.K_2, self.z_m)

    @Drop("e_z", "1", "increase of the mean drop in % for 1 % more z_m",
          source="Eq. 1, mean over the length",
          tex=rf"\frac{{z_m K_2}}{{z_{{mean}}}} (1 - \frac{{1}}{{c}} + "
          rf"\frac{{(1 - c) {ARTANH}}}{{2 c \sqrt{{c}}}})")  # fmt: skip
    def share(self) -> float:
        return crown_mean.z_m_share(self.A, self.z_m)

    @Drop("t", "1", "coordinate of the middle of the end slices", role="step", equation="1")
    def end_place(self) -> float:
        return max(0.0, 1 - 1 / (self.slices * self.K_2))

    @Drop("z_end", "µm", "drop at the middle of the end slices", equation="1", form="corrected",
          tex=r"-A \ln\left(1 - c t^2\right)")  # fmt: skip
    def end_slice(self) -> float:
        return float(gap(self)[0])

    @Drop("Q_even", "N", "load under which this crown is uniformly loaded", source="Lundberg",
          tex="K_1 Q")  # fmt: skip
    def suits(self) -> float:
        return self.K_1 * crowned_for(self)

    @Quantity(
        "N",
        "N",
        "normal force at rest, with deflections of all parts, without springs",
        safe="too high",
    )
    def N(self) -> float:
        return normal_force(under(self))

    @Quantity(
        "N_max",
        "N",
        "first peak of the normal force, by the model of two races on a spring",
        safe="too high",
    )
    def N_max(self) -> float:
        if under(self) is None or (swung := swing(self)).over:
            return math.nan
        return float(swung.peak[1])

    @Quantity("N_max/Q", "1", "K_1 for a uniform load at the first force peak", source="Lundberg",
              tex=r"\frac{N_{max}}{Q}")  # fmt: skip
    def K_1_suits(self) -> float:
        return self.N_max / crowned_for(self)

    @shared
    def _rest(self) -> SlicedContact | None:
        """Inner contact under the normal force at rest; None without equilibrium."""
        return formulas.pressed(self, self.N) if math.isfinite(self.N) else None

    @shared
    def _peak(self) -> SlicedContact | None:
        """Inner contact at the first force peak; None if the sprags roll over."""
        return formulas.pressed(self, self.N_max) if math.isfinite(self.N_max) else None

    @Quantity("p", "MPa", "largest pressure at rest, inner race, by slices", safe="too high")
    def p_rest(self) -> float:
        return _largest(self._rest)

    @Quantity("p_max", "MPa", "largest pressure at the first force peak, by slices",
              safe="too high")  # fmt: skip
    def p_peak(self) -> float:
        return _largest(self._peak)

    @Quantity("p_mid", "MPa", "pressure at mid-length at the first force peak", safe="too high")
    def p_mid_peak(self) -> float:
        return mid(self._peak) if self._peak else math.nan

    @Quantity("p_end", "MPa", "pressure of the end slices at the first force peak", safe="too high")
    def p_end_peak(self) -> float:
        return float(self._peak.peak_pressure[0]) if self._peak else math.nan

    @Quantity("R", "mm", "relative radius of curvature of the inner contact at rest", role="step")
    def R_rest(self) -> float:
        return formulas.radius(self, self.N) if math.isfinite(self.N) else math.nan

    @Quantity(
        "R_max",
        "mm",
        "relative radius of curvature of the inner contact at the first force peak",
        role="step",
    )
    def R_peak(self) -> float:
        return formulas.radius(self, self.N_max) if math.isfinite(self.N_max) else math.nan

    @Quantity("p_e", "MPa", "pressure of a uniform load at rest", source="Hertz",
              tex=r"\sqrt{\frac{N E}{2 (1 - \nu^2) \pi l R}}")  # fmt: skip
    def p_even_rest(self) -> float:
        return formulas.even(self, self.N) if math.isfinite(self.N) else math.nan

    @Quantity("p_even", "MPa", "pressure of a uniform load at the first force peak", source="Hertz",
              tex=r"\sqrt{\frac{N_{max} E}{2 (1 - \nu^2) \pi l R_{max}}}")  # fmt: skip
    def p_even_peak(self) -> float:
        return formulas.even(self, self.N_max) if math.isfinite(self.N_max) else math.nan

    def peak_of(self, crown: Crown) -> float:
        """Largest pressure [Pa] with the crown `crown` under the force `N_max` of the inputs."""
        return _largest(formulas.pressed(self, self.N_max, crown))

    @property
    def unequal(self) -> float:
        """Ratio of outer to inner normal force at the first force peak, minus 1."""
        states = wedge(self).states
        return float(np.interp(self.N_max, states.N[1:], states.N_e[1:] / states.N[1:])) - 1

    @property
    def inertia(self) -> float:
        """Ratio of the inertia of the sprags to that of the inner race."""
        w = wedge(self)
        return float(sprags_inertia(w, at_rest(w, self.T), motion(self)) / self.I_bi)

    comparisons = compared.stated
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary

    def reference(self, level: int) -> Level:
        """Results of numerical profiles, and of strips under the forces of computed engagements."""
        from verify.cases.sprag.crown.reference import solve

        return solve(self, level)

    def tables(self, context: Context) -> Iterator[Table]:
        """Table 2 of the paper with recomputed errors."""
        if context.is_paper:
            yield table_2()

    def refusal(self) -> str:
        """Reason why no reference exists; empty if it exists.

        The reference requires a crown, a peak, and a solution at rest.
        """
        if self.z_m == 0:
            return "without a crown there is nothing to compare; check it without --fem"
        if not math.isfinite(self.N_max):
            return "the sprags roll over: no peak exists to compare; check it without --fem"
        return refusal_at_rest(self)


def _largest(contact: SlicedContact | None) -> float:
    return math.nan if contact is None else float(contact.peak_pressure.max())


CROWN = adapted(SpragCrown)
