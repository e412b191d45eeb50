"""Case of a sphere on a rigid flat and on another sphere: errors of Hertz's theory."""

from collections.abc import Iterator
from typing import Any, ClassVar

from analytic.bounds.contact import point
from verify.case import (
    Comparison,
    Level,
    Quantity,
    Scan,
    State,
    approximation,
    balance,
)
from verify.cases.contact.expected import expected
from verify.cases.contact.sphere import figures as drawn
from verify.cases.contact.sphere.formulas import SphereFormulas
from verify.cases.contact.sphere.inputs import BODIES, END, PAIRS, WORDS
from verify.cases.contact.sphere.reference import solve
from verify.core.figures import Picture
from verify.form.adapter import adapted
from verify.form.figures import AlongLine, Drawn

ORDER = (
    "derived first-order correction for the finite size of the spheres, ± (a/R)² of the smaller "
    "sphere, at least 2e-4"
)
SURFACE = (
    "estimated: ± a/R, because the pressure on the curved surface is inclined by r/R (r: distance "
    "from the axis); this changes the shear stress on the axis by up to (a/R) p_0"
)
LEAST, BLUNT = 2e-4, 5e-3  # least slack, of Hertz and of his shear stress
SHARP = "accepted error of this quantity"
FIRST_ORDER = 0.04, "the expected error is an estimate of first order in a/R"
DIRECT = "direct solution: machine epsilon times the condition number, with cells from a/50 to R"


class Spheres(SphereFormulas):
    """Hertz's theory replaces each sphere by a half-space with a paraboloid on it.

    The reference consists of whole spheres that are pressed from both sides. The error of Hertz's
    radius and pressure is proportional to a/R and follows from the logarithmic term in the solution
    of a sphere. The error of Hertz's approach δ is due to the finite distance between contact and
    equator.
    """

    id = "contact-sphere"
    title = "Sphere on a rigid flat and on another sphere"
    source = "huang2018"
    place = "Eqs. 2-5, based on Hertz's contact; Table 1, radii of sprag and race"
    levels: ClassVar = (2, 4, 8)
    scans: ClassVar = (Scan(vary=("P=2N,16N,100N,500N,2000N", "R_2=4.02mm,11.11mm"), star=True),)
    readings: ClassVar = (
        "R_1 and R_2 are radii of the spheres; Hertz's formulas use the relative radius R",
        "the modulus of each body is E/(1 − ν²), as in Hertz's theory of point contact",
        "δ is the approach of the equatorial planes of the spheres, not of points at infinity",
    )
    assumptions: ClassVar = (
        "no friction, small strain",
        "the load and the material of the lower sphere are assumed; the spheres have the radii of "
        "the sprag and the inner race of the paper",
        "the same load acts on the opposite side of each sphere",
    )

    def reference(self, level: int) -> Level:
        """Results of the axisymmetric upper sphere, on a rigid flat and on the lower sphere."""
        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: errors of Hertz's theory on a flat and on a sphere; balances of the spheres."""
        for pair in PAIRS:
            at = self if pair == self.pair else self.of(pair)
            state = State(at, END[pair].lstrip("_"), WORDS[pair])
            yield from at.against_hertz(state)
            for body in BODIES[pair]:
                shear = Spheres.tau_upper if body == "upper" else Spheres.tau_lower
                yield approximation(
                    shear, order=2, state=state, symbol="τ_max",
                    expected=expected(point.axis_shear(beyond=at.beyond), SURFACE, least=BLUNT,
                                      sharp=0.02),
                    name=f"largest shear stress, {WORDS[pair]}, {body} body",
                    sensitivity=FIRST_ORDER,
                )  # fmt: skip
            for body in BODIES[pair]:
                yield balance(f"{body}_balance{END[pair]}",
                              f"balance of forces on the {body} sphere, {WORDS[pair]}",
                              "ΣF_y", "N",
                              of={"load": self.P}, bound=1e-7, because=DIRECT)  # fmt: skip

    def against_hertz(self, state: State) -> Iterator[Comparison]:
        """Rows: contact radius, pressure, approach and force in `state` against Hertz's theory."""
        finite, by = self.finite, Spheres
        kinds: tuple[tuple[Quantity, str, float, float, float], ...] = (
            (by.a, "contact radius", finite.a_excess, 1e-3, 2),
            (by.p_0, "peak pressure", finite.p_0_excess, 5e-4, 2),
            (by.approach, "approach", finite.approach_excess, 1e-3, 2),
            # at a given approach the pressure's edge, a square root, moves between nodes
            (by.force, by.force.what, self.force_excess, 2e-3, 1.5),
        )
        for q, what, excess, sharp, order in kinds:
            power = 1.5 if q is by.force else 1.0  # P is proportional to delta^(3/2)
            known = point.corrected(excess, beyond=self.beyond, power=power)
            yield approximation(
                q, order=order, state=state, name=f"{what}, {state.words}",
                expected=expected(known, ORDER, least=LEAST), sensitivity=(sharp, SHARP),
            )  # fmt: skip

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures: pressures, stresses on the axes, and errors of Hertz's theory."""
        both = [self.of(pair) for pair in PAIRS]
        for at, words in zip(both, ("a rigid flat", "the lower sphere"), strict=True):
            yield drawn.pressure(at, words)
        for body in BODIES["sphere"]:
            yield from drawn.stresses(self, body)
        for at in both:
            yield drawn.errors(at)

    def pictures(self) -> Iterator[Picture]:
        """Pictures of stresses near the contact of both spheres."""
        yield from drawn.pictures(self.width)

    sketch = drawn.sketch

    def refusal(self) -> str:
        """Reason for not solving very small approaches (round-off); "" for larger approaches."""
        ratio = max(self.R_1, self.R_2) / (self.width**2 / self.hertz["R"])
        if ratio <= 1e9:
            return ""
        return (
            f"an approach of R/{ratio:.1g} is too small against the round-off of the coordinates "
            "of the larger sphere: run `check` without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the contact is wide or if a body is loaded beyond its yield strength."""
        for pair in PAIRS:
            at: Any = self.of(pair)
            wide, where = at.beyond**0.5, WORDS[pair]
            if wide > 0.05:
                yield (
                    f"a/R = {wide:.2g}, {where}: error of Hertz's approach about "
                    f"{at.approach / at.approach_finite - 1:.1%}, of Hertz's pressure about "
                    f"{at.p_0 / at.p_0_finite - 1:.1%}"
                )
            shear = max(at.shear_of(body)[0] for body in BODIES[pair])
            if self.R_p is not None and shear > self.R_p / 2:
                yield (
                    f"shear stress {shear / 1e6:.4g} MPa ({where}) exceeds R_p/2 = "
                    f"{self.R_p / 2e6:.4g} MPa: the body yields below the surface (Tresca)"
                )
            softest = self.E_1 if pair == "flat" else min(self.E_1, self.E_2)
            if self.R_p is None and at.p_0 > 0.02 * softest:
                yield (
                    f"p_0 = {at.p_0 / 1e6:.4g} MPa ({where}) is {at.p_0 / softest:.1%} of E: "
                    "hardened steel yields below 2 %; enter R_p"
                )


SPHERE = adapted(Spheres)
