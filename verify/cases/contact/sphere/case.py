"""Point contact: a sphere on a rigid flat and on another sphere; errors of Hertz's theory."""

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

ORDER = "first correction for finite spheres ± (a/R)² of the smaller one, 2e-4 at least"
SURFACE = (
    "± a/R: against the curved surface the pressure tilts by r/R, which changes the stress on the "
    "axis by that share of p_0"
)
LEAST, BLUNT = 2e-4, 5e-3  # least slack, of Hertz and of his shear stress
SHARP = "design limit for contact figures"
FIRST_ORDER = 0.04, "an estimate of first order in a/R"
DIRECT = "direct solve: machine epsilon times the condition of K, with cells from a/50 to R"


class Spheres(SphereFormulas):
    """Hertz replaces each sphere by a half space with a paraboloid on it.

    Against whole spheres, pressed from both sides, his radius and pressure err by a share of a/R
    that the logarithm in the solution of a sphere predicts, his approach by the finite distance to
    its middle.
    """

    id = "contact-sphere"
    title = "Sphere on a flat and on another sphere"
    source = "huang2018"
    place = "Eqs. 2-5, the contact behind them (Hertz); Table 1, radii of sprag and race"
    levels: ClassVar = (2, 4, 8)
    scans: ClassVar = (Scan(vary=("P=2N,16N,100N,500N,2000N", "R_2=4.02mm,11.11mm"), star=True),)
    readings: ClassVar = (
        "R_1 and R_2 are radii of the spheres; the relative one enters Hertz's formulas",
        "E/(1 − ν²) of each body: around a point no direction is free of strain",
        "the approach is that of the planes half-way to the opposite contact, not of points at "
        "infinity",
    )
    assumptions: ClassVar = (
        "no friction, small strain",
        "load and second material are assumed; the radii are those of the paper's sprag and inner "
        "race, as if they were balls",
        "every sphere is pressed by the same load from the opposite side",
    )

    def reference(self, level: int) -> Level:
        """Quarter discs turned about the axis, on a rigid flat and on each other."""
        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Hertz on a flat and on a sphere; balances of the spheres."""
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
                    name=f"largest shear stress {WORDS[pair]}, {body} body",
                    sensitivity=FIRST_ORDER,
                )  # fmt: skip
            for body in BODIES[pair]:
                yield balance(f"{body}_balance{END[pair]}",
                              f"balance of the {body} sphere {WORDS[pair]}", "ΣF_y", "N",
                              of={"load": self.P}, bound=1e-7, because=DIRECT)  # fmt: skip

    def against_hertz(self, state: State) -> Iterator[Comparison]:
        """Radius, pressure, approach and force of this contact."""
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
                q, order=order, state=state, name=f"{what} {state.words}",
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
        """Stresses about the contact of both spheres."""
        yield from drawn.pictures(self.width)

    sketch = drawn.sketch

    def refusal(self) -> str:
        """The approach must exceed the round-off of the larger sphere's coordinates."""
        ratio = max(self.R_1, self.R_2) / (self.width**2 / self.hertz["R"])
        if ratio <= 1e9:
            return ""
        return (
            f"an approach of R/{ratio:.1g} is lost in the round-off of the larger sphere's "
            "coordinates: check without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the contact is wide or a body yields."""
        for pair in PAIRS:
            at: Any = self.of(pair)
            wide, where = at.beyond**0.5, WORDS[pair]
            if wide > 0.05:
                yield (
                    f"a/R = {wide:.2g} {where}: Hertz's approach is off by about "
                    f"{at.approach / at.approach_finite - 1:.1%}, his pressure by "
                    f"{at.p_0 / at.p_0_finite - 1:.1%}"
                )
            shear = max(at.shear_of(body)[0] for body in BODIES[pair])
            if self.R_p is not None and shear > self.R_p / 2:
                yield (
                    f"shear stress {shear / 1e6:.4g} MPa {where} exceeds R_p/2 = "
                    f"{self.R_p / 2e6:.4g} MPa: it yields below the surface (Tresca)"
                )
            softest = self.E_1 if pair == "flat" else min(self.E_1, self.E_2)
            if self.R_p is None and at.p_0 > 0.02 * softest:
                yield (
                    f"p_0 = {at.p_0 / 1e6:.4g} MPa {where} is {at.p_0 / softest:.1%} of E: "
                    "hardened steel yields before; give R_p"
                )


SPHERE = adapted(Spheres)
