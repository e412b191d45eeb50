"""Accordion spring before its leaves touch: Eqs. 1-9 of Wang et al. 2023 and the true centre line.

The cases of the free stage share these formulas, warnings and sketch.
"""

from collections.abc import Iterator
from typing import Any

from analytic.spring import energy, frame
from verify.case import Case, Quantity
from verify.cases.spring.claims import loaded
from verify.cases.spring.inputs import AccordionInputs, strip_of
from verify.cases.spring.sketch import sketch as to_scale

L0_OVER_B = 240  # Eq. 13
FREE_STAGE = 11.95 / 25.6  # intersection of Eq. 10's branches over L_0 of the true centre line
FRAME = "force method on the true centre line"


class FreeStage(AccordionInputs, Case):
    """Stiffness, deflection and stress of the spring in the free stage."""

    @Quantity("L_2", "mm", "straight length of a middle leaf", equation="3", role="step",
              tex=r"\frac{L_1}{\sin\alpha} + \frac{2 (r + b/2)}{\tan\alpha}")  # fmt: skip
    def L2(self) -> float:
        return float(energy.leaf_length(L1=self.L1, r=self.r, b=self.b, alpha=self.alpha))

    @Quantity("T_1/F", "mm", "bending moment at the first apex, divided by the force", equation="1",
              role="step",
              tex=r"\frac{L_1}{2} + r")  # fmt: skip
    def T1(self) -> float:
        return float(energy.apex_moments(**self._printed)[0])

    @Quantity("T_2/F", "mm", "bending moment at the second apex, divided by the force",
              equation="3", role="step",
              tex=r"T_1/F - (2 r (1 - \cos\alpha) + L_2 \sin\alpha)")  # fmt: skip
    def T2(self) -> float:
        return float(energy.apex_moments(**self._printed)[1])

    @Quantity("J", "mm^3", "integral of the squared lever arm of the force", equation="7",
              role="step", tex=r"\int (M/F)^2 ds")  # fmt: skip
    def J(self) -> float:
        return float(energy.flexibility(**self._printed))

    @Quantity("k_1", "N/mm", "stiffness with arcs of the inner radius", equation="9",
              tex=r"\frac{E h b^3}{12 J}")  # fmt: skip
    def k1(self) -> float:
        return float(energy.stiffness(**self._printed, h=self.h, E=self.E))

    @Quantity("k", "N/mm", "stiffness of the true centre line with E I", source=FRAME)
    def k(self) -> float:
        return frame.stiffness(**self.path, **strip_of(self))

    @Quantity("k_w", "N/mm", "stiffness of the true centre line with E I/(1 − ν²)", source=FRAME)
    def k_wide(self) -> float:
        return frame.stiffness(**self.path, **strip_of(self), plane_strain=True)

    @Quantity("L_0", "mm", "overall free length", source="geometry of the true centre line")
    def L0(self) -> float:
        return frame.free_length(n=self.n, b=self.b, r=self.r, L1=self.L1, alpha=self.alpha)

    @Quantity("Δ", "mm", "deflection at F", equation="8", tex=r"\frac{F}{k_1}", when=loaded)
    def deflection(self) -> float:
        assert self.F is not None
        return self.F / self.k1

    @Quantity("κ", "1",
              "ratio of the stress at the inside of a curved bar to the stress of a straight bar",
              role="step", source="Golovin")  # fmt: skip
    def kappa(self) -> float:
        return float(energy.curvature_factor(b=self.b, r=self.r))

    @Quantity("σ", "MPa", "bending stress at F, inside of the apex of a loop", safe="too high",
              source="Golovin", when=loaded,
              tex=r"\kappa \frac{6 F (L_1/2 + r)}{h b^2}")  # fmt: skip
    def stress(self) -> float:
        assert self.F is not None
        return self.bending_stress(self.F)

    def bending_stress(self, F: float) -> float:
        """Largest bending stress [Pa] under the force F [N]."""
        return float(energy.bending_stress(F=F, b=self.b, h=self.h, r=self.r, L1=self.L1))

    @property
    def _printed(self) -> dict[str, Any]:
        """Geometry as arguments of the functions for Eqs. 1-9."""
        return {"n": self.n, "L1": self.L1, "r": self.r, "b": self.b, "alpha": self.alpha}

    sketch = to_scale

    def warnings(self) -> Iterator[str]:
        """Warnings if geometry or force is outside the range of Eqs. 1-9."""
        if self.L0 / self.b > L0_OVER_B:
            yield (
                f"L_0/b = {self.L0 / self.b:.4g} exceeds {L0_OVER_B}, the limit of Eq. 13: as the "
                "paper states, the head then moves sideways, and the formula loses accuracy"
            )
        if abs(self.k1 / self.k - 1) > 0.01:
            yield (
                f"Eqs. 1-9 use the inner radius as radius of the centre line: the error of k_1 is "
                f"{self.k1 / self.k - 1:+.1%} (with the true centre line, k_1 is "
                f"{self.k / 1e3:.4g} N/mm)"
            )
        if self.h > 10 * self.b:
            yield (
                f"the bending stiffness of a strip {self.h / self.b:.0f} times as wide as thick is "
                f"between E I and E I/(1 - ν²): k_1 may be up to "
                f"{1 / (1 - self.nu**2) - 1:.1%} larger than with E I"
            )
        if self.b > 0.3 * self.R:
            yield (
                f"b/(r + b/2) = {self.b / self.R:.2f}: the strip is not thin; run with --fem, "
                "which includes a frame of curved beams"
            )
        if self.F is not None:
            yield from self._overloaded(self.F)

    def _overloaded(self, F: float) -> Iterator[str]:
        share = self.deflection / self.L0
        if share > FREE_STAGE:
            yield (
                f"F = {F:g} N compresses the spring by {share:.1%} of the free length; the leaves "
                f"of the paper's spring touch at {FREE_STAGE:.0%}, beyond which Eqs. 1-9 do not "
                "apply" + ("; Eq. 12 allows 60 %" if share > 0.6 else "")
            )
        if self.R_p is not None and self.stress > self.R_p:
            yield (
                f"bending stress {self.stress / 1e6:.4g} MPa at F = {F:g} N exceeds R_p = "
                f"{self.R_p / 1e6:.4g} MPa: the loops yield"
            )
