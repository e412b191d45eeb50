"""A roller wedged between ring and race (Belcin et al., Eqs. 1-5) against contact with friction."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from verify.case import Level, Scan
from verify.cases.polyhedral.wedge import comparisons as compared
from verify.cases.polyhedral.wedge import figures as drawn
from verify.cases.polyhedral.wedge import reference as fem
from verify.cases.polyhedral.wedge import sketch as sketched
from verify.cases.polyhedral.wedge.formulas import WedgeFormulas, stays
from verify.cases.polyhedral.wedge.stick import FLATTEST, TILT
from verify.form.adapter import adapted


class WedgedRoller(WedgeFormulas):
    """A roller stays in a wedge if tan(α/2) is below μ.

    Friction on the roller is then at most N tan(α/2). The printed torque μ N z D_i/2 applies to
    rollers that a cage holds back until they slip. Finite elements of an elastic roller on an
    elastic race with friction confirm both.
    """

    id = "polyhedral-wedge"
    title = "Roller wedged between ring and race"
    source = "belcin"
    place = "Eqs. 1-5"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (Scan(vary=("alpha=4deg,6deg,8deg", "N=500N,1500N,4000N"), star=True),)
    readings: ClassVar = (
        "α is the full angle between both tangents: each normal is α/2 off the roller's middle "
        "plane",
        "D_i is a diameter: the lever of T is D_i/2",
        "N and T are forces at one contact of one roller, and z rollers carry the torque",
        "a free roller is held by its contacts alone; a cage force acts along the bisector",
        "rollers are long: plane strain, which moves Hertz's half-width alone",
    )
    assumptions: ClassVar = (
        "α, μ, N, d and b are user inputs: the paper prints no number for them, nor an equation "
        "for α",
        "ring and race are equal flats about the roller: half of it is modelled, its cut on the "
        "bisector; the race's convexity changes the contact's width, not the statics",
        "roller and race of one material: tangential forces leave the pressure alone; on a rigid "
        "flat pressing alone would make nearly all of the contact slip",
        "gap and pressure act along the flat race's normal, so that a roller which slides stays "
        "in the same wedge; along the deformed surfaces between both where the stick zone is "
        "measured",
        "the stick zone is measured under a separate load, small enough for Cattaneo's half "
        f"planes: a/(μR) = {TILT:g}, a/R at most {FLATTEST:g}",
        "roller without weight, one coefficient of friction, no rate",
    )

    comparisons = compared.comparisons
    figures = drawn.figures
    pictures = drawn.pictures
    sketch = sketched.sketch

    def reference(self, level: int) -> Level:
        """Half a roller on an inclined race."""
        return fem.solve(self, level)

    def warnings(self) -> Iterator[str]:
        """Warnings if a free roller leaves its wedge or surfaces yield."""
        if not stays(self):
            yield (
                f"tan(α/2) = {np.tan(self.half):.4g} is not below μ = {self.mu:g} (Eq. 2): a free "
                "roller is squeezed out of the wedge and carries no torque"
            )
        elif self.wedged > 0.9:
            yield (
                f"tan(α/2) = {self.wedged:.3f} μ: friction a tenth lower releases the roller "
                "from the wedge"
            )
        p_0 = self.shown("p_0")
        if self.p_lim is not None and self.p_0 > self.p_lim:
            yield f"p_0 = {p_0} exceeds p_lim = {self.shown('p_lim')}: the surfaces yield"
        if self.p_lim is None and self.p_0 > 0.02 * self.E:
            share = f"{self.p_0 / self.E:.1%}"
            yield f"p_0 = {p_0} is {share} of E: most steels yield before; give p_lim"

    def refusal(self) -> str:
        """A roller that is squeezed out has no equilibrium."""
        if self.wedged < 1:
            return ""
        return (
            f"tan(α/2) = {np.tan(self.half):.4g} is not below μ = {self.mu:g}: the roller is "
            "squeezed out, and there is no equilibrium to compute; check it without --fem"
        )


WEDGE = adapted(WedgedRoller)
