"""Force-displacement curve of an accordion spring in all stages (Wang et al. 2023)."""

import math
from collections.abc import Iterator
from typing import Any, ClassVar

from analytic.spring.stages import Stages, stages
from verify.case import Case, Comparison, Level, Quantity, drawn_by, identity, shared
from verify.cases.spring.claims import other_width
from verify.cases.spring.curve import comparisons as stated
from verify.cases.spring.curve import figures as drawn
from verify.cases.spring.curve import reference as beams
from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.limits import too_slender
from verify.cases.spring.stages import sketch as sketched
from verify.cases.spring.stages.readings import eq10
from verify.core.case import Check
from verify.form.adapter import adapted
from verify.judging.published_checks import PrintedMeasurement

LINEAR = "closed form, linear theory"
FINE = 5e-4, "required accuracy of frame elements, 0.05 %"


def of_paper(q: CurveInputs) -> bool:
    """Whether Eq. 10 applies to this spring."""
    return q.is_paper


class CurveSpring(CurveInputs, Case):
    """Force over displacement in all stages, by geometrically exact beams with contact.

    The curve is compared with the straight lines of linear theory and, for readings of the paper's
    spring, with Eq. 10.
    """

    id = "spring-curve"
    title = "Accordion spring, force-displacement curve in all stages"
    source = "wang2023"
    place = "Sec. 2, Eq. 10, Fig. 9; Table 1"
    levels: ClassVar = beams.LEVELS
    quick: ClassVar = False
    readings: ClassVar = (
        "r is the radius of the centre line of the arcs, as in a shell model drawn with the "
        "printed dimensions; this reading of r, tail and head is chosen only by its k_1 "
        "(calibrated)",
        "the tail is clamped in the middle of its leaf; the head moves along the axis without "
        "rotation",
        "k_1 and k_2 of a curve are slopes of least-squares lines before and after the leaves "
        "touch",
        "the width factor f is the result of the shell model in case spring-width",
    )
    assumptions: ClassVar = (
        "plane deformation of a strip with one bending stiffness; linear elastic",
        "the free ends of leaves are rounded with the radius b/2",
        "Coulomb friction between leaves; no friction at the head, whose displacement is "
        "prescribed",
    )

    @Quantity("EI", "N mm^2", "bending stiffness of the strip", role="step",
              tex=r"f \frac{E h b^3}{12}")  # fmt: skip
    def EI(self) -> float:
        return self.width_factor * self.E * self.h * self.b**3 / 12

    k1 = Quantity(
        "k_1", "N/mm", "initial stiffness of the unloaded spring",
        source="geometrically exact beam",
        tex=r"\left.\frac{dF}{dU}\right|_0 \quad (\varepsilon=t\cdot r' - 1, \quad "
        r"\gamma=n\cdot r', \quad \kappa=\varphi')",
    ).reads(lambda q: q.linear.k1)  # fmt: skip
    U_A = Quantity("U_A", "mm", "displacement at which the first tip touches, linear theory",
                   source=LINEAR, tex=r"\frac{F_A}{k_1}").reads(lambda q: q.linear.U_A)  # fmt: skip
    F_A = Quantity("F_A", "N", "force at which the first tip touches, linear theory",
                   source=LINEAR).reads(lambda q: q.linear.F_A)  # fmt: skip
    k2 = Quantity("k_2", "N/mm", "stiffness after the first tip touches, linear theory",
                  source=LINEAR).reads(lambda q: q.linear.k2)  # fmt: skip

    @Quantity("U_10", "mm", "displacement at the intersection of Eq. 10's lines", role="step",
              source="Eq. 10", tex=r"\frac{0.0055 + 1.62}{749 - 613}", fitted=True,
              when=of_paper)  # fmt: skip
    def U_10(self) -> float:
        return eq10().U

    @Quantity("F_10", "N", "force at the intersection of Eq. 10's lines", role="step",
              source="Eq. 10", tex=r"613 U_{10} + 0.0055 = 749 U_{10} - 1.62", fitted=True,
              when=of_paper)  # fmt: skip
    def F_10(self) -> float:
        return eq10().F

    @shared
    def linear(self) -> Stages:
        """Linear theory in closed form: F(U) is straight before contact, and straight after it."""
        ends: dict[str, Any] = {"head": self.head, "tail": self.tail}
        factor = self.width_factor
        return stages(**self.path, **strip_of(self), **ends, width_factor=factor, theory="shear")

    def reference(self, level: int) -> Level:
        """Reference: beams with contact for the curve, its variants and the readings."""
        return beams.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows of the closed form against beams, and claims on the curve, Eq. 10 and the tests."""
        spring = CurveSpring
        yield identity(spring.k1, order=4, sensitivity=FINE,
                       shares="beam theory, E I with one width factor")  # fmt: skip
        slender = (
            (spring.U_A, "displacement at which the first tip touches"),
            (spring.F_A, "force at which the first tip touches"),
            (spring.k2, "stiffness after the first tip touches"),
        )  # fmt: skip
        for k, (q, words) in enumerate(slender):
            yield Comparison(quantity=q, check=stated.slender(k, q.symbol, words))
        yield from stated.deviations()
        yield from stated.accepted()
        for q in (spring.k1, spring.k2):
            for name, what in (("fea", "paper's shell model"), ("test", "paper's test")):
                yield Comparison(quantity=q, check=PrintedMeasurement(
                    name=f"{q.symbol} of the closed form against the {what}", symbol=q.symbol,
                    unit="N/mm", analytic=q.name, reference=f"wang2023:{q.name}-{name}",
                ))  # fmt: skip

    def refusal(self) -> str:
        """Reason why no curve is computed (unguided head or too slender strip), or empty.

        A free head buckles, and a hinged head moves sideways.
        """
        if self.head != "guided":
            return (
                f"head = {self.head}: the whole curve is computed only for a guided head; for "
                "other heads, see case spring-stages (first stage) and case spring-buckling "
                "(sideways movement)"
            )
        return too_slender(self)

    figures = drawn_by(drawn.figures)
    tables = drawn.tables
    sketch = sketched.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings: a free head buckles, the width factor does not suit the leaf, no tips touch."""
        if self.head == "free":
            yield "a spring with a free head buckles laterally at a low load: see spring-buckling"
        yield from other_width(self.width_factor, h=self.h, leaf=self.leaf, nu=self.nu)
        if not math.isfinite(self.U_A):
            yield "by linear theory, no leaves touch with these end conditions"


CURVE = adapted(CurveSpring)
