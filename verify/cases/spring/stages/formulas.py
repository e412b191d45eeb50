"""Stages of the accordion spring: closed forms before and after the free tips touch."""

import math
from collections.abc import Iterator
from typing import Any, ClassVar

from analytic.spring import energy, frame
from analytic.spring.loops import Normal
from analytic.spring.redundant import Theory
from analytic.spring.stages import Stages, stages
from verify.case import Case, Quantity, shared
from verify.cases.spring.claims import loaded, other_width
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.stages.inputs import StagesInputs

LINEAR = 0.1  # largest U_A over L_0 for unchanged lengths
PARALLEL = math.radians(5)
TIPS = "closed form for the contact of the tips"


def narrow(q: Any) -> bool:
    """Whether the inputs contain no width factor."""
    return q.width_factor is None


class StageFormulas(StagesInputs, Case):
    """Force and displacement at first contact of a tip (point A), stiffness before and after it."""

    theory: ClassVar[Theory] = "thin"  # theory of the stages below
    normal: ClassVar[Normal] = "force"
    inner: ClassVar[bool] = False  # whether arcs have the inner radius

    @Quantity("R", "mm", "radius of the centre line of the arcs", role="geometry",
              tex=r"r + \frac{b}{2}")  # fmt: skip
    def radius(self) -> float:
        return self.R

    @Quantity("EI", "N mm^2", "bending stiffness of the strip", role="step",
              tex=r"\frac{f E h b^3}{12}")  # fmt: skip
    def EI(self) -> float:
        return self.factor * self.E * self.h * self.b**3 / 12

    gap = Quantity(
        "g_0", "mm", "initial gap between tip and leaf", role="step", source=TIPS,
        tex=r"R (1 + \sin\alpha) + \frac{L_1 + R \cos\alpha}{\tan\alpha} "
        r"- \frac{b}{2} (1 + \frac{1}{\sin\alpha})",
    ).reads(lambda q: q._bent.gap)  # fmt: skip

    @Quantity("J", "mm^3", "compliance integral of the force", role="step", source=TIPS,
              tex=r"\int M^2 ds")  # fmt: skip
    def J(self) -> float:
        return self.EI / self.k1

    k1 = Quantity("k_1", "N/mm", "stiffness before the tips touch", source=TIPS,
                  tex=r"\frac{EI}{J}").reads(lambda q: q._stages.k1)  # fmt: skip

    @Quantity("f_FC", "mm^3", "mutual compliance integral of F and the contact force",
              role="step", source=TIPS, tex=r"\int M\,m\,ds")  # fmt: skip
    def f_FC(self) -> float:
        return self.gap * self.EI / self.F_A

    F_A = Quantity("F_A", "N", "force at point A, at which the first tip touches", source=TIPS,
                   tex=r"\frac{g_0 EI}{f_{FC}}").reads(lambda q: q._stages.F_A)  # fmt: skip
    U_A = Quantity("U_A", "mm", "displacement at point A, at which the first tip touches",
                   source=TIPS, tex=r"\frac{F_A}{k_1}").reads(lambda q: q._stages.U_A)  # fmt: skip

    @Quantity("J_C", "mm^3", "reduction of J by the contact of the tips", role="step", source=TIPS,
              tex=r"\frac{p f_{FC}^2}{\int m^2 ds}")  # fmt: skip
    def J_C(self) -> float:
        return self.J - self.EI / self.k2

    k2 = Quantity("k_2", "N/mm", "stiffness after the first and before the second tip touches",
                  source=TIPS,
                  tex=r"\frac{EI}{J - J_C}").reads(lambda q: q._stages.k2)  # fmt: skip

    @Quantity("c_2", "N", "force at U = 0 on the line of slope k_2", source=TIPS)
    def intercept(self) -> float:
        return self.F_A - self.k2 * self.U_A

    U_B = Quantity("U_B", "mm", "displacement at which the second tip touches",
                   source=TIPS).reads(lambda q: q._stages.U_B)  # fmt: skip
    F_B = Quantity("F_B", "N", "force at which the second tip touches",
                   source=TIPS).reads(lambda q: q._stages.F_B)  # fmt: skip
    k3 = Quantity("k_3", "N/mm", "stiffness with both tips in contact",
                  source=TIPS).reads(lambda q: q._stages.k3)  # fmt: skip

    @Quantity("L_0", "mm", "overall free length", role="step")
    def L0(self) -> float:
        return frame.free_length(n=self.n, b=self.b, r=self.r, L1=self.L1, alpha=self.alpha)

    @Quantity("U_A/L_0", "1", "displacement at point A over the free length", role="step")
    def share(self) -> float:
        return self.U_A / self.L0

    @Quantity("σ_A", "MPa", "bending stress at point A, inside of the apex of a loop",
              safe="too high", source="Golovin")  # fmt: skip
    def stress_at_A(self) -> float:
        bend = 6 * float(energy.curvature_factor(b=self.b, r=self.r)) / (self.h * self.b**2)
        return bend * float(self._bent.top_couple)

    @Quantity("k_1w", "N/mm", "stiffness before the tips touch, wide strip", source=TIPS,
              tex=r"\frac{k_1}{1 - \nu^2}", when=narrow)  # fmt: skip
    def k1_wide(self) -> float:
        return self.widest * self.k1

    @Quantity("F_Aw", "N", "force at point A, at which the first tip touches, wide strip",
              source=TIPS, tex=r"\frac{F_A}{1 - \nu^2}", when=narrow)  # fmt: skip
    def F_A_wide(self) -> float:
        return self.widest * self.F_A

    @Quantity("k_2w", "N/mm", "stiffness after the first contact, wide strip", source=TIPS,
              tex=r"\frac{k_2}{1 - \nu^2}", when=narrow)  # fmt: skip
    def k2_wide(self) -> float:
        return self.widest * self.k2

    U_w = Quantity("U_w", "mm", "displacement at F", source=TIPS,
                   when=loaded).reads(lambda q: q._stages.displacement(q.F or 0.0))  # fmt: skip

    @Quantity("ΔU", "mm", "remaining displacement until a tip touches", role="step", when=loaded)
    def margin(self) -> float:
        return self.U_A - self.U_w

    @property
    def tilt(self) -> float:
        """Angle [rad] that remains at point A between the touching tip and its leaf."""
        return float(self._bent.tilt)

    @shared
    def _stages(self) -> Stages:
        """Stages with axial strain, as in the finite elements."""
        path = self.paper_path if self.inner else self.path
        return stages(
            **path, **strip_of(self), width_factor=self.factor, head=self.head, tail=self.tail,
            theory=self.theory, normal=self.normal,
        )  # fmt: skip

    @shared
    def _bent(self) -> Stages:
        """Stages with bending only."""
        return self.held()

    def warnings(self) -> Iterator[str]:
        """Warnings on limits of linear theory, width, working force and strength."""
        if self.share > LINEAR:
            yield (
                f"U_A is {self.share:.0%} of the free length: linear theory neglects the change of "
                "the lever arms, so that the true curve of the spring has another point A and "
                "another k_2"
            )
        if abs(self.tilt) > PARALLEL:
            yield (
                f"at A the angle between leaf and tip is {abs(math.degrees(self.tilt)):.1f}°: the "
                "contact force has this angle to the axis of the spring, which is neglected"
            )
        yield from self._width()
        if self.F is not None and self.F_A < self.F:
            which = "both tips touch" if self.F_B < self.F else "a tip touches"
            k = self.k3 if self.F_B < self.F else self.k2
            yield (
                f"F = {self.F:g} N is beyond A ({self.F_A:.4g} N): {which}, and the stiffness at F "
                f"is {k / 1e3:.4g} N/mm"
            )
        if self.R_p is not None and self.stress_at_A > self.R_p:
            yield (
                f"bending stress {self.stress_at_A / 1e6:.4g} MPa at A exceeds R_p = "
                f"{self.R_p / 1e6:.4g} MPa: the loops yield before the tips touch"
            )

    def _width(self) -> Iterator[str]:
        given = self.width_factor
        if given is not None:
            yield from other_width(given, h=self.h, leaf=self.leaf, nu=self.nu)
        elif self.h > 10 * self.b:
            yield (
                f"the bending stiffness of a strip {self.h / self.b:.0f} times as wide as thick is "
                f"between E I and E I/(1 - ν²): forces and stiffnesses may be up to "
                f"{self.widest - 1:.1%} larger than with E I (give width_factor)"
            )
