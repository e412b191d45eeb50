"""Case of a roller wedged between ring and race (Belcin et al., Eqs. 1-5)."""

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
    """A roller stays in a wedge of the angle α if tan(α/2) is below μ.

    The friction force on a free roller is then N tan(α/2). The printed torque μ N z D_i/2 (Eq. 3)
    applies only to rollers that a cage holds back until they slip. Finite elements of an elastic
    roller on an elastic race with friction confirm these three statements.
    """

    id = "polyhedral-wedge"
    title = "Roller wedged between ring and race"
    source = "belcin"
    place = "Eqs. 1-5"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (Scan(vary=("alpha=4deg,6deg,8deg", "N=500N,1500N,4000N"), star=True),)
    readings: ClassVar = (
        "α is the full angle between the tangents at both contacts; each contact normal is "
        "inclined by α/2 to the plane perpendicular to the bisector",
        "D_i is a diameter: the lever of T is D_i/2",
        "N and T are forces at one contact of one roller; z rollers transmit the torque",
        "only the forces at the two contacts act on a free roller; if a cage pushes the roller, "
        "its force acts along the bisector of α",
        "the rollers are long and therefore in plane strain, which affects only Hertz's half-width",
    )
    assumptions: ClassVar = (
        "α, μ, N, d and b are inputs with assumed default values, because the paper prints neither "
        "their values nor an equation for α",
        "the surfaces of ring and race are modelled as planes, and half of the roller is modelled, "
        "cut along the bisector. The curvature of ring and race changes the contact width, but not "
        "the balance of forces",
        "roller and race have the same material, so that tangential forces do not change the "
        "contact pressure; on a rigid race, nearly the whole contact would slip under the normal "
        "force alone",
        "the contact pressure acts, and the gap is measured, along the normal of the undeformed "
        "race, so that a sliding roller remains in the same wedge. For the stick zone, the normal "
        "of the deformed contact surface is used instead",
        "the stick zone is computed under another load, which is so small that Cattaneo's "
        f"half-planes are a good approximation: a/(μR) is at most {TILT:g}, a/R at most "
        f"{FLATTEST:g}",
        "the weight of the roller and the effect of speed are neglected; the coefficient of "
        "friction is equal at both contacts, for sticking and for sliding",
    )

    comparisons = compared.comparisons
    figures = drawn.figures
    pictures = drawn.pictures
    sketch = sketched.sketch

    def reference(self, level: int) -> Level:
        """Results of half a roller on an inclined race."""
        return fem.solve(self, level)

    def warnings(self) -> Iterator[str]:
        """Warnings if a free roller is expelled from its wedge or if the surfaces yield."""
        if not stays(self):
            yield (
                f"tan(α/2) = {np.tan(self.half):.4g} is not below μ = {self.mu:g} (Eq. 2): a free "
                "roller is expelled from the wedge and carries no torque"
            )
        elif self.wedged > 0.9:
            yield (
                f"tan(α/2) = {self.wedged:.3f} μ: a coefficient of friction lower by 10 % would "
                "release the roller from the wedge"
            )
        p_0 = self.shown("p_0")
        if self.p_lim is not None and self.p_0 > self.p_lim:
            yield f"p_0 = {p_0} exceeds p_lim = {self.shown('p_lim')}: the surfaces yield"
        if self.p_lim is None and self.p_0 > 0.02 * self.E:
            share = f"{self.p_0 / self.E:.1%}"
            yield f"p_0 = {p_0} is {share} of E: most steels yield at a lower p_0; enter p_lim"

    def refusal(self) -> str:
        """Reason for not solving a roller that is expelled; "" if it stays in the wedge."""
        if self.wedged < 1:
            return ""
        return (
            f"tan(α/2) = {np.tan(self.half):.4g} is not below μ = {self.mu:g}: the roller is "
            "expelled, and no equilibrium exists; run `check` without --fem"
        )


WEDGE = adapted(WedgedRoller)
