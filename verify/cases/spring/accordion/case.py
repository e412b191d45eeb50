"""Accordion spring in the free stage: Eqs. 1-9 of Wang et al. 2023 against curved frames."""

import math
from collections.abc import Iterator
from typing import Any, ClassVar, Self

from analytic.spring import energy, frame
from analytic.spring.garbled import flexibility
from verify.case import (
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    State,
    about,
    approximation,
    as_printed,
    drawn_by,
    errors_of,
    identity,
    underived,
)
from verify.cases.spring import readings as definitions
from verify.cases.spring.accordion import figures as drawn
from verify.cases.spring.accordion import reference as frames
from verify.cases.spring.accordion.ends import COMBINED, FIVE, PAPER, Ends
from verify.cases.spring.free_stage import FRAME, FreeStage
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.limits import too_slender
from verify.core.case import Check, Context, Portion
from verify.core.figures import Picture, Table
from verify.form.adapter import adapted
from verify.judging.checks import Order
from verify.judging.published_checks import Contradiction, PrintedMeasurement

TEST_FORCE = 11.0  # N, the largest of Sec. 4
EQ_9_SOURCE = "strain energy of axial force and shear by the force method, ± 10 %"
CENTRE_LINE = 0.02  # over the error by the radius: effect of elements and shear
RADIUS_SOURCE = "force method on the centre line, with axial force and shear"
PRINTED = ("wang2023:k1-theory", "wang2023:k1-fea", "wang2023:k1-test")
SHARED = "beam theory, small displacements, E I of a narrow strip"
EXACT = 5e-4, "the only error of the frame is that chords replace the arcs"


def solve_paper(q: Any, level: int) -> Level:
    """Stiffness by curved elements with the lengths of Eqs. 1-9."""
    return frames.solve_curved(q.held(PAPER), level)


class AccordionSpring(FreeStage):
    """Energy formula for the stiffness before the leaves touch, against two frame models.

    Both models are frames of the centre line: one of straight beam elements, one of curved
    quadratic elements.
    """

    id = "spring-accordion"
    title = "Accordion spring, free stage, as a frame"
    source = "wang2023"
    place = "Sec. 1.2, Eqs. 1-9; Table 1"
    levels: ClassVar = (4, 8, 16, 32)
    ends: ClassVar[Ends] = COMBINED[0]  # ends for the stiffnesses k_N and k_V
    portions: ClassVar = (
        Portion(name="k_1", fem=solve_paper, levels=(4, 8, 16), keys=(PAPER.named("k_V"),)),
    )
    scans: ClassVar = (
        Scan(vary=("n=4:16:7", "b=0.05mm,0.1mm,0.2mm,0.3mm,0.4mm"), only=("Eqs. 1-9",)),
        Scan(
            vary=("r=0.2mm,0.45mm,0.8mm,1.2mm", "alpha=65deg:85deg:5", "L1=6mm,9mm,11.6mm,16mm"),
            only=("Eqs. 1-9",), star=True,
        ),
        Scan(
            vary=("n=4,10,16", "b=0.05mm,0.1mm,0.4mm", "alpha=65deg,80deg"),
            only=("straight elements", "curved elements"), star=True,
        ),
    )  # fmt: skip
    readings: ClassVar = (
        "r is the inner radius. Eqs. 1-9 as printed contain r as radius of the centre line of the "
        "arcs, but r + b/2 in L_2. With r + b/2 everywhere, k_1 of the paper's spring is 3.2 % "
        "smaller",
        "the term 2 L_1/sin α of Eq. 3 means 2 (L_1/2)/sin α, and its h/2 means b/2",
        "the signs of Eq. 3 alternate from segment to segment; T_0 in the text is "
        "T_1 = F (L_1/2 + r)",
        "the head is free to rotate and to move sideways; the tail is clamped at the end of its "
        "arc",
    )
    assumptions: ClassVar = (
        "small displacements, no contact between leaves",
        "Eqs. 1-9 contain bending only; the frames also contain axial force and shear",
        "narrow strip: E I without the factor 1/(1 − ν²)",
    )

    k_N = Quantity("k_N", "N/mm", "stiffness with bending and axial force",
                   source=FRAME).reads(lambda q: q._stiffness("thin"))  # fmt: skip
    k_V = Quantity("k_V", "N/mm", "stiffness with bending, axial force and shear",
                   source=FRAME).reads(lambda q: q._stiffness("shear"))  # fmt: skip

    @Quantity("k_1", "N/mm", "stiffness with the leaf length",
              equation="3", form="as printed", form_of="k1")  # fmt: skip
    def k1_printed_leaves(self) -> float:
        leaf = 2 * self.L1 / math.sin(self.alpha) + (2 * self.r + self.h) / math.tan(self.alpha)
        J = flexibility(self.n, self.L1 / 2, self.r, leaf, self.alpha, "alternating", 1.0)
        return self.E * self.h * self.b**3 / 12 / J

    @Quantity("k_1", "N/mm", "stiffness with the inner radius in the arc of the head",
              equation="2", form="as printed", form_of="k1")  # fmt: skip
    def k1_inner_head(self) -> float:
        return self._of_radii(head=self.r, segments=self.R)

    @Quantity("k_1", "N/mm", "stiffness with the inner radius in the inner segments",
              equation="4", form="as printed", form_of="k1")  # fmt: skip
    def k1_inner_segments(self) -> float:
        return self._of_radii(head=self.R, segments=self.r)

    @Quantity("k_1", "N/mm", "stiffness with the printed tail of Eq. 5", equation="5",
              form="as printed", form_of="k1", when=lambda q: q.n % 2)  # fmt: skip
    def k1_printed_tail(self) -> float:
        T = energy.apex_moments(**self._printed)[-1]
        printed, right = (energy.tail_flexibility(n, T, r=self.r) for n in (self.n + 1, self.n))
        return self.E * self.h * self.b**3 / 12 / (self.J + float(printed - right))

    @Quantity("σ_n", "MPa",
              "nominal bending stress at F, or at the largest test force if F is not given",
              tex=r"\frac{6 F (L_1/2 + r)}{h b^2}")  # fmt: skip
    def nominal_stress(self) -> float:
        return self.bending_stress(self.F or TEST_FORCE) / self.kappa

    @Quantity("L_0/b", "1", "free length over thickness, with arcs of the inner radius",
              source="smallest value: L_0 does not contain the leaf thickness")  # fmt: skip
    def slenderness(self) -> float:
        return frame.end_point(**self.paper_path, tail="mid-leaf")[0] / self.b

    def _of_radii(self, head: float, segments: float) -> float:
        """Stiffness [N/m] with arc radii `head`, `segments` [m]; the tail has its true radius."""
        a = self.L1 / 2
        ends = [float(energy.head_flexibility(L1=self.L1, r=r)) for r in (head, self.R, segments)]
        to_tail = flexibility(self.n, a, segments, self.L2, self.alpha, "alternating", 1.0,
                              (math.pi / 2, 0.0))  # fmt: skip
        J = ends[0] + (to_tail - ends[2]) + (ends[1] - a**3 / 3)  # the tail has no leaf
        return self.E * self.h * self.b**3 / 12 / J

    def _stiffness(self, theory: frame.Theory) -> float:
        head, tail, hold = self.ends.head, self.ends.tail, self.ends.hold
        return frame.stiffness(
            **self.lengths, **strip_of(self), head=head, tail=tail, hold=hold, theory=theory
        )

    @property
    def lengths(self) -> dict[str, Any]:
        """Arguments of the paper's centre line if `ends.inner`, otherwise of the true one."""
        return self.paper_path if self.ends.inner else self.path

    def held(self, ends: Ends) -> Self:
        """The spring with the end conditions `ends`."""
        return self.variant(ends=ends)

    @property
    def of_five(self) -> Self:
        """The spring with five segments."""
        return self.at(n=5).variant(ends=FIVE)

    def reference(self, level: int) -> Level:
        """Reference: straight and curved frames with all end conditions, and with five segments."""
        held = (self.held(ends) for ends in (PAPER, *COMBINED))
        return frames.solve((*held, self.of_five), level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: Eqs. 1-9 against printed values and curved beams; force method against frames."""
        spring = AccordionSpring
        yield as_printed(spring.k1, "wang2023:k1-theory", name="stiffness by Eqs. 1-9")
        for words, printed in (("shell model", "fea"), ("test", "test")):
            yield Comparison(quantity=spring.k1, check=PrintedMeasurement(
                name=f"k_1 by Eqs. 1-9, compared with the paper's {words}", symbol="k_1",
                unit="N/mm", analytic="k1", reference=f"wang2023:k1-{printed}",
            ))  # fmt: skip
        yield approximation(
            spring.k1, PAPER.named("k_V"),
            name="stiffness by Eqs. 1-9 against curved beam elements", order=4,
            expected=self._neglected(),
            sensitivity=(5e-4, "required accuracy of frame elements, 0.05 %"),
            printed=PRINTED, shares=SHARED,
        )  # fmt: skip
        yield approximation(
            spring.k1, COMBINED[0].named("k_V"), order=4, expected=self._of_inner_radius(),
            name="stiffness by Eqs. 1-9 with the inner radius in all arcs, against a frame with "
            "the true centre line",
            shares=SHARED,
        )  # fmt: skip
        for one, where in (
            (spring.k1_inner_head, "in the arc of one end, head or tail (Eqs. 1, 2, 6)"),
            (spring.k1_inner_segments, "in the inner segments (Eqs. 3, 4)"),
        ):
            yield approximation(
                one, COMBINED[0].named("k_V"), order=4, shares=SHARED,
                name=f"stiffness by Eqs. 1-9 with the inner radius only {where}",
                expected=underived("only one part of the spring has the inner radius"),
            )  # fmt: skip
        yield approximation(
            spring.k1_printed_leaves, PAPER.named("k_V"), order=4, shares=SHARED,
            name="stiffness by Eqs. 1-9 with the leaf length as printed in Eq. 3",
            expected=underived("Eq. 3 contains the width for the thickness, and 2 L_1 for L_1"),
        )  # fmt: skip
        yield from self._odd()
        yield Comparison(quantity=spring.nominal_stress, check=Contradiction(
            name="bending stress at the largest test force, compared with the yield strength",
            symbol="σ", unit="MPa", analytic="nominal_stress", reference="wang2023:yield-strength",
            erratum="wang2023:yield-strength",
        ))  # fmt: skip
        yield Comparison(quantity=spring.slenderness, check=Contradiction(
            name="L_0/b of the paper's spring against the limit of Eq. 13", symbol="L_0/b",
            unit="1", analytic="slenderness", reference="wang2023:rule-length-thickness-max",
            erratum="wang2023:eq-13-printed-spring",
        ))  # fmt: skip
        for q, elements, order in ((spring.k_N, "straight", 2), (spring.k_V, "curved", 4)):
            for ends in (PAPER, *COMBINED):
                held = State(self.held(ends), ends.key, ends.words, displayed=not ends.key)
                yield identity(
                    q, state=held, symbol="k", order=order,
                    name=f"stiffness, {ends.words}: {elements} elements", sensitivity=EXACT,
                    shares=SHARED,
                )  # fmt: skip
        yield Order(name="order of convergence of the stiffness by straight elements", symbol="p",
                    unit="1", order=2, errors=errors_of(spring.k_N))  # fmt: skip

    def _odd(self) -> Iterator[Comparison]:
        """Rows on Eqs. 1-9 for an odd number of segments, for which the printed Eq. 5 is wrong."""
        five = State(self.of_five, FIVE.key, "five segments", displayed=False)
        more: dict[str, Any] = {"order": 4, "shares": SHARED, "state": five}
        yield approximation(
            AccordionSpring.k1, FIVE.named("k_V"), expected=self.of_five._neglected(),
            name="stiffness of a spring with five segments by Eqs. 1-9", **more,
        )  # fmt: skip
        yield approximation(
            AccordionSpring.k1_printed_tail, FIVE.named("k_V"),
            name="stiffness of a spring with five segments, Eq. 5 (tail) with the printed sign",
            expected=underived("the printed sign applies to an even number of segments"), **more,
        )  # fmt: skip

    def _neglected(self) -> Expected:
        """Expected relative increase of the compliance by axial force and shear, ± 10 % of it."""
        bending = frame.stiffness(**self.paper_path, **strip_of(self), theory="bending")
        m = bending / self.held(PAPER).k_V - 1
        return Expected(0.9 * m, 1.1 * m, EQ_9_SOURCE)

    def _of_inner_radius(self) -> Expected:
        """Expected relative increase of the stiffness if the arcs have the inner radius."""
        bending = frame.stiffness(**self.paper_path, **strip_of(self), theory="bending")
        m = bending / self.held(COMBINED[0]).k_V - 1
        return about(m, CENTRE_LINE * abs(m), RADIUS_SOURCE)

    refusal = too_slender
    figures = drawn_by(drawn.moments, drawn.open_questions)

    def pictures(self) -> Iterator[Picture]:
        """Picture of the bending stress of the paper's spring."""
        yield drawn.bending_stress(self)

    def tables(self, context: Context) -> Iterator[Table]:
        """Tables of all readings of ends, radius, strip and equations."""
        yield drawn.sensitivity(self)
        yield from definitions.tables(context)


ACCORDION = adapted(AccordionSpring)
