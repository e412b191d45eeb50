"""Case of a roller's end face: finite elements of both bodies against the half-space."""

import math
from collections.abc import Iterator
from typing import ClassVar, Self

import numpy as np
from pydantic import model_validator

from analytic.bounds.contact.roller import local_pressure
from analytic.contact.edge import edge_exponent
from analytic.contact.half_space_roller import RollerContact, press_roller
from verify.case import (
    Comparison,
    Expected,
    Level,
    Quantity,
    State,
    approximation,
    drawn_by,
    given,
    shared,
    underived,
)
from verify.cases.contact.roller import end_figures
from verify.cases.contact.roller.comparisons import estimated
from verify.cases.contact.roller.end_fem import CROWNS, solve_fem
from verify.cases.contact.roller.end_figures import BODIES
from verify.cases.contact.roller.formulas import MIDDLE
from verify.cases.contact.roller.inputs import Crown
from verify.core.case import Context
from verify.core.figures import Picture
from verify.form.adapter import adapted
from verify.form.comparisons import key_of
from verify.judging.checks import Accepted, Approximation, Margin

mm = 1e-3
HALF_SPACE = (64, 512)  # cells across and along
FACE = 0.10  # of the load in the end zones d: least reduction by the face
SIZE_SHARE = 1 / 3  # of the reduction by the face: limit for that by the bodies' size
EDGE_LEFT = 5e-3  # of the slope at the edge itself: terms of the order of its distances
TERMS = (
    "estimated: terms of the order r/R, because the exponent is extrapolated from the distances "
    "r = 0.001 R and 0.002 R to the edge (R: radius of the shaft)"
)


class EndFace(Crown):
    """Slices, strips and boundary elements assume a half-space beyond the end of the roller.

    Finite elements of whole bodies, with Fourier series around the axes, give the error of this
    assumption at a free end face. In a control model, both bodies continue beyond the ends. The
    control model separates the effect of the end face from the effect of the finite size of the
    bodies. The roller is modelled with its crowned profile and with a flat profile, without crown.
    """

    id = "contact-roller-end"
    title = "End face of a roller"
    source = "huang2018"
    place = "Eqs. 2-5, based on influence coefficients of a half-space"
    levels: ClassVar = (2, 3, 4)
    readings: ClassVar = (
        "the race continues beyond the roller, as in a clutch",
        "two equal races press the roller on two opposite sides; each race is loaded by the roller "
        "and by an equal pressure on the opposite side of the race",
    )
    assumptions: ClassVar = (
        "linear elasticity, no friction; solid cylinders with circular sections",
        "the pressure acts along the common normal and is uniform in each cell of the contact",
        "Fourier terms around the axis are solved for selected wavelengths down to the length of a "
        "cell; the other terms are interpolated",
        "the exponent of the pressure at the edge is computed with an axisymmetric model of a ring "
        "shrunk onto a longer shaft",
    )
    crown: ClassVar[str] = "crowned"  # of the quantities

    overhang: float = given(
        "2 mm", "mm", "h", "length of the races beyond each end of the roller", gt=0, le=1e3
    )

    @model_validator(mode="after")
    def _race(self) -> Self:
        if self.R_2 <= 0:
            raise ValueError(
                f"R_2 must be positive, got R_2 = {self.R_2 / mm:g} mm: this case models the race "
                "as a shaft"
            )
        if not 0.2 <= self.R_2 / self.R_1 <= 20:
            raise ValueError(
                f"R_2/R_1 must be 0.2 to 20, got R_1 = {self.R_1 / mm:g} mm, "
                f"R_2 = {self.R_2 / mm:g} mm"
            )
        if not 0.05 * self.L <= self.overhang <= 3 * self.L:
            raise ValueError(
                f"the overhang h must be 0.05 l to 3 l, got "
                f"h = {self.overhang / mm:g} mm, l = {self.L / mm:g} mm"
            )
        if not 0.2 <= self.L / self.R_1 <= 20:
            raise ValueError(
                f"the length of the roller must be 0.2 R_1 to 20 R_1, got l = {self.L / mm:g} mm, "
                f"R_1 = {self.R_1 / mm:g} mm"
            )
        return self

    @Quantity("p_0", "MPa", "Hertz's pressure of the uniform line load", source="Hertz",
              tex=r"\sqrt{\frac{F E*}{\pi l R}}")  # fmt: skip
    def p_0(self) -> float:
        return math.sqrt(self.F / self.L * self.E_star / (np.pi * self.R))

    p_mid = Quantity("p", "MPa", f"{MIDDLE}, half-space", source="half-space",
                     safe="too high").reads(lambda q: q.contact.mid_pressure)  # fmt: skip
    p_mid_flat = Quantity("p_f", "MPa", f"{MIDDLE}, half-space, roller without crown",
                          source="half-space", role="step",
                          ).reads(lambda q: q.flat.p_mid)  # fmt: skip

    @Quantity("F_d", "N", "load in both end zones d, half-space", source="half-space",
              safe="too high",
              tex=r"\int_{-l/2}^{d - l/2} q\,dy + \int_{l/2 - d}^{l/2} q\,dy")  # fmt: skip
    def F_d(self) -> float:
        return sum(self.contact.end_load(self.d))

    @Quantity("F_d/F", "1", "share of the load in both end zones d, half-space", role="step",
              tex=r"\frac{F_d}{F}")  # fmt: skip
    def end_share(self) -> float:
        return self.F_d / self.F

    @Quantity("λ", "1", "exponent of the displacement field at a right-angled edge",
              source="Williams; Dundurs and Lee", role="step",
              tex=r"\lambda_{90},\quad p \propto r^{\lambda - 1}")  # fmt: skip
    def exponent(self) -> float:
        return 1 + self.sharpness

    @Quantity("λ − 1", "1", "exponent of the pressure at a right-angled edge, equal materials",
              source="Williams; Dundurs and Lee")  # fmt: skip
    def sharpness(self) -> float:
        return edge_exponent(np.pi / 2)

    @Quantity("1−λ", "1", "exponent of 1/r in the pressure at the edge; half-space: 0.5",
              source="Williams; Dundurs and Lee", role="step", tex=r"1 - \lambda")  # fmt: skip
    def less_sharp(self) -> float:
        return -self.sharpness

    @shared
    def contact(self) -> RollerContact:
        """Solution of the roller on a half-space, which has no end face."""
        gap = self.gap if self.crown == "crowned" else np.zeros_like
        return press_roller(gap, R=self.R, length=self.L, E_star=self.E_star, load=self.F,
                            cells=HALF_SPACE)  # fmt: skip

    @shared
    def flat(self) -> Self:
        """The roller without its crown."""
        return self.variant(crown="flat")

    @shared
    def states(self) -> tuple[State, State]:
        """States of the comparison: roller without and with the crown."""
        return State(self.flat, "flat", "flat"), State(self, "", "crowned")

    def reference(self, level: int) -> Level:
        """Results of bodies of revolution, solved for each harmonic around the axis."""
        return solve_fem(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: Hertz at mid-length, error of a half-space at the ends, exponent at the edge."""
        q = EndFace
        local = local_pressure(b=self.b, R=self.R_1, length=self.L)
        for crown in CROWNS:
            yield Comparison(quantity=q.p_0, numbers={"one": 1.0}, check=Approximation(
                name="ratio of the pressure at mid-length to Hertz's pressure of the local line "
                f"load, roller with {crown} profile; reference: {BODIES['end']}",
                symbol="p/p_H", unit="1", fem=f"local_end_{crown}",
                analytic="one", formal=2, interval=lambda *_: local, demand=4e-3,
                demand_reason="the assumption of uniform pressure in each cell causes an error",
                source="estimated: ± ((b/R_1)² + (2b/l)² + 1e-3 for the size of the cells)",
            ))  # fmt: skip
        cost = underived("this case measures the error of a half-space")
        for name, words in BODIES.items():
            for state in self.states:
                yield estimated(
                    q.F_d, f"F_d_{name}_{state.words}", state=state, symbol="F_d", order=1,
                    name=f"load in both end zones d, half-space, roller with {state.words} "
                         f"profile; reference: {words}",
                    expected=cost,
                )  # fmt: skip
        for what, margin in (
            (f"load in both end zones d: the end faces reduce it by {FACE:.0%} or more", face),
            ("load in both end zones d: the finite size of the bodies contributes less than a "
             "third of the reduction", mostly),
        ):  # fmt: skip
            for state in self.states:
                check = Accepted(name=f"{what} for the roller with {state.words} profile",
                                 symbol="F_d", unit="1", margin=margin(state))  # fmt: skip
                yield Comparison(check=check, quantity=q.F_d, state=state)
        yield approximation(q.sharpness, order=2, expected=Expected(-EDGE_LEFT, EDGE_LEFT, TERMS))

    figures = drawn_by(end_figures.drawn)

    def pictures(self) -> Iterator[Picture]:
        """Picture of the pressure on the contact patch."""
        yield end_figures.patch()

    sketch = end_figures.sketch

    def warnings(self) -> Iterator[str]:
        """Warning if the half-space overestimates the load near the ends."""
        if max(self.end_share, self.flat.end_share) > 1.2 * 2 * self.d / self.L:
            yield (
                "near a free end face, the half-space overestimates the load: the pressures of the "
                "half-space near a loaded end are too high"
            )


def face(state: State) -> Margin:
    """Function that returns the relative load reduction near the end face, minus FACE.

    The reduction is relative to the load by the half-space.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        here, on, U = end_loads(context, "end", state)
        beyond, _, _ = end_loads(context, "control", state)
        words = (
            f"load near the ends {here / on - 1:+.1%} relative to the half-space, "
            f"{here / beyond - 1:+.1%} relative to the control model"
        )
        return 1 - here / on - FACE, U, words

    return margin


def mostly(state: State) -> Margin:
    """Function that returns a positive margin if mainly the end faces reduce the load.

    The control model must differ from the half-space by less than SIZE_SHARE times this reduction.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        face_, on, U = end_loads(context, "end", state)
        size, _, U_size = end_loads(context, "control", state)
        left = SIZE_SHARE * (1 - face_ / on) - abs(1 - size / on)
        return (
            left,
            SIZE_SHARE * U + U_size,
            f"load relative to the half-space: {size / on - 1:+.1%} in the control model, "
            f"which has no end faces; {face_ / on - 1:+.1%} in the model with end faces",
        )

    return margin


def end_loads(context: Context, name: str, state: State) -> tuple[float, float, float]:
    """Loads near the ends by finite elements and by half-space, and uncertainty of their ratio."""
    v = context.series(f"F_d_{name}_{state.words}")[1]
    on = context.analytic[key_of(EndFace.F_d, state)]
    return v[-1], on, 3 * (max(v) - min(v)) / on


END = adapted(EndFace)
