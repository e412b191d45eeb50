"""Accordion spring as a strip of finite width, with shells as in the paper (Wang et al. 2023)."""

from collections.abc import Iterator
from typing import ClassVar, Self

from analytic.spring import frame
from analytic.spring.wide_leaf import TERMS, width_factor
from verify.case import (
    Case,
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    State,
    about,
    approximation,
    drawn_by,
    identity,
)
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.limits import Share
from verify.cases.spring.width import claims
from verify.cases.spring.width import figures as drawn
from verify.cases.spring.width import reference as shells
from verify.cases.spring.width.inputs import WidthInputs
from verify.cases.spring.width.reference import ENDS, RATIOS, WIDE, widths_of_both
from verify.core.case import Check
from verify.core.figures import Picture
from verify.form.adapter import adapted
from verify.judging.checks import Accepted, Limit
from verify.judging.published_checks import PrintedMeasurement
from verify.judging.tolerance_checks import BOTH_WAYS, Agreement, suites

MOST = 30  # largest number of segments for which shells are solved
FOIL = 3000  # length over thickness of a leaf, above which narrow shells are ill-conditioned
PLATE = 3.0  # width over thickness of a leaf, below which it is not a plate
SLENDER = 0.2  # length of an arc over the length of a leaf
HELD = 5e-4, "a shell whose edges are held in plane strain is equivalent to a beam"
PLATES = 5e-4, "a thin leaf is a Kirchhoff plate"
FIFTH = "one fifth of the accepted difference of 0.5 % from plane stress or plane strain"
HALF = "half of the required sensitivity of 1 %"
CURVE = "half of the difference accepted for the width factor that case spring-curve uses"
THEORY = "accepted difference between shell theory and a thin solid"
FITTED = "these end conditions are chosen because they give the printed stiffness"
FRAME = "force method on the true centre line"
RITZ = "Kirchhoff's plate theory of a leaf, solved by Ritz's method"
SMALL = "small displacements"
LOOPS = ("h/b = 20", "h/b = 100", "at the width of the spring")


class WideSpring(WidthInputs, Case):
    """Width factor f: bending stiffness of a wide strip over that of a narrow strip, E I.

    The factor is computed with shell elements for the whole spring, with solid elements for one
    loop, and with a plate model of one leaf by Ritz's method. The limits of f are plane stress
    (narrow strip) and plane strain (infinitely wide strip).
    """

    id = "spring-width"
    title = "Accordion spring as a strip of finite width"
    source = "wang2023"
    place = "Sec. 2, shell model; h in I = h b³/12"
    levels: ClassVar = shells.LEVELS
    scans: ClassVar = (
        Scan(
            vary=("h=14mm,28mm,56mm", "b=0.1mm,0.2mm,0.4mm", "n=6,10", "nu=0.27,0.3,0.34,0.4"),
            star=True,
        ),
    )
    readings: ClassVar = (
        "the force acts on a line across the head; this line remains straight, as at a roller",
        "r is the inner radius: the centre line of the arcs has the radius r + b/2",
        "the paper does not print the supports of tail and head: all four combinations are "
        "reported",
    )
    assumptions: ClassVar = (
        "small displacements, no contact",
        "the tail is clamped over the whole width, the edges are free",
        "the deformation is symmetric about the middle of the width",
    )

    @Quantity("R", "mm", "radius of the centre line of the arcs", role="geometry",
              tex=r"r + \frac{b}{2}")  # fmt: skip
    def radius(self) -> float:
        return self.R

    @Quantity("l", "mm", "straight length of a middle leaf", role="geometry",
              tex=r"\frac{L_1 + 2 R \cos\alpha}{\sin\alpha}")  # fmt: skip
    def leaf_length(self) -> float:
        return self.leaf

    @Quantity("h/l", "1", "width over the length of a leaf", role="step", tex=r"\frac{h}{l}")
    def h_over_l(self) -> float:
        return self.h / self.leaf

    @Quantity("f", "1", "width factor of the spring, estimated by the factor of one leaf",
              source=RITZ, tex=r"\frac{1}{3 (1-\nu^2)} \min_w \int\int w_{\xi\xi}^2 "
              r"+ \frac{l^4}{h^4} w_{\eta\eta}^2 + 2 \frac{l^2}{h^2} (\nu w_{\xi\xi} "
              r"w_{\eta\eta} + (1-\nu) w_{\xi\eta}^2)\, d\xi\,d\eta")  # fmt: skip
    def f(self) -> float:
        return float(width_factor(self.h, self.leaf, nu=self.nu))

    @Quantity("f_max", "1", "upper limit of the width factor", role="step",
              tex=r"\frac{1}{1 - \nu^2}")  # fmt: skip
    def f_wide(self) -> float:
        return self.widest

    k_narrow = Quantity("k_EI", "N/mm", "stiffness of a narrow strip",
                        source=FRAME).reads(lambda q: q._stiffness(plane_strain=False))  # fmt: skip
    k_wide = Quantity("k_PE", "N/mm", "stiffness of an infinitely wide strip",
                      source=FRAME).reads(lambda q: q._stiffness(plane_strain=True))  # fmt: skip

    @Quantity("k_1", "N/mm", "stiffness with the width factor of one leaf", source=FRAME)
    def k(self) -> float:
        return self.f * self.k_narrow

    @Quantity("f({0:g})", "1", "width factor of a leaf with h/l = {0:g}",
              source=RITZ).over(RATIOS)  # fmt: skip
    def leaf_factor(self, ratio: Share) -> float:
        return float(width_factor(ratio, 1.0, nu=self.nu))

    def _stiffness(self, *, plane_strain: bool) -> float:
        return frame.stiffness(
            **self.path, **strip_of(self), tail=self.tail, head=self.head, theory="shear",
            plane_strain=plane_strain,
        )  # fmt: skip

    def _left(self, ratio: Share) -> float:
        """Relative change of the width factor of a leaf if only half of Ritz's terms are used."""
        leaf = self.leaf_factor(ratio)
        return (float(width_factor(ratio, 1.0, nu=self.nu, terms=TERMS // 2)) - leaf) / leaf

    def held(self, tail: frame.Tail, head: frame.Head) -> Self:
        """The spring with the end conditions `tail` and `head`."""
        return self.model_copy(update={"tail": tail, "head": head})

    def reference(self, level: int) -> Level:
        """Reference: shells of the spring and of leaves, shells and solids of a loop."""
        return shells.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows that compare beams and plates with shells, solids and printed values."""
        spring = WideSpring
        states = {ends: State(self.held(*ends), shells.key_of(*ends), "", displayed=False)
                  for ends in ENDS}  # fmt: skip
        for (tail, head), state in states.items():
            name = f"stiffness of the shell in plane strain, tail clamped at {tail}, head {head}"
            yield identity(spring.k_wide, state=state, name=name, symbol="k", order=4,
                           sensitivity=HELD, shares=SMALL)  # fmt: skip
        yield identity(spring.k_narrow, name="stiffness of the shell in plane stress", order=4,
                       sensitivity=HELD, shares=SMALL)  # fmt: skip
        for ratio in RATIOS:
            q = spring.leaf_factor(ratio)
            yield identity(q, symbol="f", uncertainty=self._left(ratio), sensitivity=PLATES,
                           shares=SMALL)  # fmt: skip
        figure = Expected(-claims.ESTIMATE, claims.ESTIMATE, suites(CURVE), sharp=self.is_default)
        yield approximation(spring.f,
                            name="width factor of the spring, estimated by the factor of one leaf",
                            expected=figure, sensitivity=(2 * claims.ESTIMATE, BOTH_WAYS),
                            shares=SMALL)  # fmt: skip
        yield approximation(
            spring.k_narrow, "k",
            name="k_1 of a narrow strip (E I), compared with the shell model of the suite", order=2,
            expected=about(1 / self.f - 1, claims.SWEEP, f"1/f − 1, with f by {RITZ}"),
            shares=SMALL,
        )  # fmt: skip
        yield from _limits()
        yield from _accepted()
        yield Accepted(
            name="k_1 of the shell against the paper's shell model, head free, tail clamped at "
            "mid-leaf",
            symbol="k_1", unit="1", margin=claims.meets("mid-leaf", "free"), fitted=FITTED,
            paper_only=True,
        )  # fmt: skip
        for (tail, head), state in states.items():
            for printed, what in (("fea", "paper's shell model"), ("test", "paper's test")):
                yield Comparison(quantity=spring.k, state=state, check=PrintedMeasurement(
                    name=f"k_1, head {head}, tail clamped at {tail}, against the {what}",
                    symbol="k_1", unit="N/mm", analytic=f"k_{state.key}",
                    reference=f"wang2023:k1-{printed}",
                ))  # fmt: skip

    def refusal(self) -> str:
        """Reason why no shells are computed: the strip is too thin, or it has too many segments."""
        if self.leaf > FOIL * self.b:
            return (
                f"the length of the leaves is {self.leaf / self.b:.0f} times the thickness, more "
                f"than {FOIL}: shells of such foils are ill-conditioned; the plate model of a leaf "
                "is exact except for the arcs"
            )
        if self.n <= MOST:
            return ""
        return (
            f"n = {self.n} segments are more than {MOST}, the limit for shells: the factor does "
            f"not depend on n, check it with n = {MOST}"
        )

    figures = drawn_by(drawn.figures)

    def pictures(self) -> Iterator[Picture]:
        """Picture of the bending stress across a loop."""
        yield drawn.ACROSS

    tables = drawn.tables
    sketch = drawn.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings if the factor of a leaf does not represent the spring."""
        if self.h < PLATE * self.b:
            yield (
                f"a strip {self.h / self.b:.2g} times as wide as thick is not a plate: its width "
                "factor is nearer to 1 than by the plate model"
            )
        elif self.h < self.leaf:
            yield (
                f"the width is {self.h / self.leaf:.2g} times the length of a leaf: the arcs, "
                "which cannot bend across the width, stiffen the spring more than its leaves do; "
                f"the factor is at most 1 + {self.widest - 1:.1%} (compute it with --fem)"
            )
        if self.R * self.alpha > SLENDER * self.leaf:
            yield (
                f"the length of the arcs is {self.R * self.alpha / self.leaf:.0%} of that of the "
                "leaves: the factor of a leaf does not apply to such a spring (compute it with "
                "--fem)"
            )


def _limits() -> Iterator[Comparison]:
    """Rows of plane stress and plane strain as limits of a narrow and of a wide strip."""
    spring = WideSpring
    yield Comparison(quantity=spring.k_narrow, check=Limit(
        name="a narrow spring is in plane stress", symbol="f", unit="1", points=claims.narrow,
        exponent=None, demand=1e-3, demand_reason=FIFTH, paper_only=True,
    ))  # fmt: skip
    yield Comparison(quantity=spring.k_wide, check=Limit(
        name="a wide spring is in plane strain, except within about one leaf length of its edges",
        symbol="f", unit="1", points=claims.wide, exponent=1.0, demand=1e-3, demand_reason=FIFTH,
    ))  # fmt: skip
    for q, which, name in (
        (spring.k_narrow, 0,
         "width factor of the narrowest computed spring is within 0.5 % of the factor in plane "
         "stress"),
        (spring.k_wide, -1, f"width factor of a spring with h/l = {WIDE[-1]:g} is within 0.5 % of "
         "the factor in plane strain"),
    ):  # fmt: skip
        pair = claims.at_end(which)
        yield Comparison(quantity=q, check=_agrees(name, pair, claims.LIMIT, HALF))


def _accepted() -> Iterator[Comparison | Check]:
    """Rows with an accepted difference: other elements, widths, ends, factor of another case."""
    for name, what in zip(widths_of_both(WidthInputs()), LOOPS, strict=True):
        yield _agrees(f"stiffness of a loop by shell and by solid elements, {what}",
                      claims.solids(name), claims.SOLID, THEORY, by="solids")  # fmt: skip
    for name, pair, accepted, why in (
        ("width factors of one leaf and of the spring are equal within 0.1 %", claims.estimate,
         claims.ESTIMATE, CURVE),
        ("width factors of one leaf and of the spring are equal within 0.5 % at all computed "
         "widths", claims.estimates, claims.SWEEP, HALF),
    ):  # fmt: skip
        yield Comparison(quantity=WideSpring.f, check=_agrees(name, pair, accepted, why))
    yield _agrees("the width factor is the same for all end conditions", claims.ends, claims.HEAD,
                  "half of the difference accepted between leaf and whole spring",
                  by="lowest factor")  # fmt: skip
    yield _agrees("the width factor is the same for a straight head and for a uniform force on the "
                  "head", claims.uniform, claims.UNIFORM,
                  "one tenth of the difference accepted between end conditions",
                  by="uniform force")  # fmt: skip
    yield Agreement(
        paper_only=True,
        name="the width factor that case spring-curve uses", symbol="f", unit="1",
        pair=claims.taken, accepted=claims.TAKEN,
        source=suites("one fifth of the required sensitivity of 1 %"),
    )  # fmt: skip


def _agrees(
    name: str, pair: claims.OfContext, accepted: float, why: str, by: str = ""
) -> Agreement:
    """Row that requires two factors to be equal within `accepted`."""
    return Agreement(
        name=name, symbol="f", unit="1", pair=pair, accepted=accepted, source=suites(why), by=by
    )


WIDTH = adapted(WideSpring)
