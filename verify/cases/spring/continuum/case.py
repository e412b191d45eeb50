"""Accordion spring in the free stage as a plane body: error of the thin frame."""

from collections.abc import Iterator
from functools import partial
from typing import ClassVar

from analytic.bounds.spring.thick_frame import Added, added
from analytic.spring import frame
from verify.case import (
    Comparison,
    Drawn,
    Expected,
    Level,
    Quantity,
    Scan,
    about,
    approximation,
    converged,
    picture,
)
from verify.cases.spring.continuum import reference as plane_body
from verify.cases.spring.free_stage import FRAME, FreeStage
from verify.cases.spring.inputs import strip_of
from verify.core.case import Context
from verify.core.figures import Dots, Picture
from verify.form.adapter import adapted

DEMAND = 1e-3, "required agreement of continuum and frame: 0.1 %"
SOURCE = (
    "derived: effects of shear and curvature up to the order (b/R)²; the uncertainty is b/R times "
    "each effect, at least 1e-5"
)
STRIPS = (("plane stress", False), ("plane strain", True))


class PlaneSpring(FreeStage):
    """Error of the thin frame against plane elasticity, with the true centre line.

    The thin frame neglects shear, axial force, and the effect of the ratio of thickness to radius
    on bending. The strip is computed as a narrow one (plane stress) and as a wide one (plane
    strain).
    """

    id = "spring-continuum"
    title = "Accordion spring, free stage, as a plane body"
    source = "wang2023"
    place = "Sec. 1.2, Eqs. 1-9"
    levels: ClassVar = plane_body.LEVELS
    scans: ClassVar = (
        Scan(
            vary=("b=0.05mm,0.1mm,0.2mm,0.4mm", "r=0.3mm,0.45mm,0.9mm", "nu=0.2,0.3,0.4"),
            star=True,
        ),
    )
    readings: ClassVar = (
        "r is the inner radius: the centre line of the arcs has the radius r + b/2",
        "the strip is 56 mm wide, and its loops have a diameter of only 1 mm: the bending "
        "stiffness of the strip is between E I and E I/(1 − ν²)",
    )
    assumptions: ClassVar = (
        "head free, tail clamped at the end of its arc",
        "force and reaction act on the end sections as parabolic shear stress, as in a rectangular "
        "section",
    )

    k_thick = Quantity("k_b", "N/mm", "stiffness of a thick curved frame, plane stress",
                       source=FRAME).reads(lambda q: q._stiffness("thick", wide=False))  # fmt: skip
    k_thick_wide = Quantity(
        "k_bw", "N/mm", "stiffness of a thick curved frame, plane strain", source=FRAME,
    ).reads(lambda q: q._stiffness("thick", wide=True))  # fmt: skip

    def _stiffness(self, theory: frame.Theory, *, wide: bool) -> float:
        return frame.stiffness(**self.path, **strip_of(self), theory=theory, plane_strain=wide)

    def reference(self, level: int) -> Level:
        """Reference: the plane body in plane stress and plane strain."""
        return plane_body.solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows that compare the thin and the thick frame with the plane body."""
        spring = PlaneSpring
        frames = {False: (spring.k, spring.k_thick), True: (spring.k_wide, spring.k_thick_wide)}
        for strip, wide in STRIPS:
            more = added(**self.path, b=self.b, nu=self.nu, wide=wide)
            expected = (self._expected(more, m) for m in (more.both, 0.0))
            words = ("thin frame", "thick curved frame")
            for q, what, interval in zip(frames[wide], words, expected, strict=True):
                yield approximation(
                    q, "k_wide" if wide else "k", name=f"stiffness, {what}, {strip}", symbol="k",
                    order=4, expected=interval, sensitivity=DEMAND, shares="small displacements",
                )  # fmt: skip

    def _expected(self, more: Added, neglected: float) -> Expected:
        """Expected error of the formula, with the next order of b/R as its uncertainty.

        If the next order exceeds half of the required sensitivity, the strip is too thick for an
        estimate, and the error is only reported.
        """
        unknown = max(more.next_order(self.b / self.R), DEMAND[0] / 100)  # no smaller tolerance
        return about(neglected, unknown, SOURCE)._replace(sharp=unknown <= DEMAND[0] / 2)

    refusal = plane_body.refusal

    def figures(self) -> Iterator[Drawn]:
        """Figures of the difference of each frame theory from the plane body."""
        for strip, wide in STRIPS:
            yield converged(partial(self._theories, strip, wide))

    def _theories(self, strip: str, wide: bool, context: Context) -> Dots:
        body = context.series("k_wide" if wide else "k")[1][-1]
        theories: tuple[tuple[frame.Theory, str], ...] = (
            ("bending", "thin frame, bending only"), ("shear", "thin frame, axial force, shear"),
            ("thick", "thick curved frame"),
        )  # fmt: skip
        items = tuple(
            (what, (self._stiffness(theory, wide=wide) / body - 1) * 1e4, None, "formula")
            for theory, what in theories
        )
        return Dots(
            title=f"Error of frame theories against the plane body, {strip}",
            label="k of the frame / k of the body − 1 [1/10 000]",
            items=(*items, ("plane body", 0.0, None, "fe")),
            note="The differences are caused by the effects that each theory neglects. The "
            "numerical uncertainties are smaller than a dot.",
        )

    def pictures(self) -> Iterator[Picture]:
        """Pictures of the von Mises stress in plane stress: whole spring, and its first loop."""
        R, top = self.R, self.L1 / 2
        yield picture("plane stress", "von_mises",
                      "Von Mises stress under 1 N, plane stress, element averages")  # fmt: skip
        yield picture("plane stress", "von_mises", "Von Mises stress in the loop of the head",
                      window=(-0.8 * R, top - 0.8 * R, 2.8 * R, top + 1.9 * R))  # fmt: skip


CONTINUUM = adapted(PlaneSpring)
