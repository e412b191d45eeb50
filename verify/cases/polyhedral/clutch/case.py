"""Case of the whole clutch: torque by the formulas of the paper and by the elastic ring."""

from collections.abc import Iterator
from math import degrees, isfinite
from typing import ClassVar

import numpy as np

from verify.case import Drawn, Level, Scan, picture
from verify.cases.polyhedral.clutch import comparisons as compared
from verify.cases.polyhedral.clutch import reference as fem
from verify.cases.polyhedral.clutch.comparisons import ClutchFormulas
from verify.cases.polyhedral.clutch.figures import torques
from verify.cases.polyhedral.locking.sketch import sketch
from verify.cases.polyhedral.warnings import of_fillets, of_rollers
from verify.core.figures import Picture, Sketch
from verify.form.adapter import adapted

WIDE = 2.0  # walls: wider rings are not in plane stress throughout


class PolyhedralClutch(ClutchFormulas):
    """The formulas of the paper give the torque from dimensions, friction and pressure.

    All intermediate values of the formulas are computed. A series solution gives the torque of an
    elastic ring with elastic rollers; finite elements confirm this solution. The corrected Eq. 21
    gives several times this torque. Dimensions and loads are assumed.
    """

    id = "polyhedral-clutch"
    title = "Torque of a polyhedral ring clutch"
    source = "belcin"
    place = "Eqs. 3-4, 6-21"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (
        Scan(
            vary=(
                "p_t=25MPa,30MPa,45MPa,60MPa",
                "delta_1=3mm,4mm,5mm",
                "mu=0.06,0.08,0.1",
                "z=4,6,8",
                "M_t=50N m,100N m,200N m,300N m",
                "e=4mm,6mm,9mm,12mm",
                "D_i=100.03mm,100.06mm,100.08mm",
                "tan_phi=0,0.05,0.1",
            ),
            star=True,
        ),
    )
    readings: ClassVar = (
        "misprints are corrected: the corrected Eqs. 13, 17, 20 and 21 contain the side length of "
        "the polygon instead of the arc length between two corners; the corrected Eq. 21 has no "
        "factor β/360",
        "Eq. 20 uses K for the middle of the flats, the lever a_f/cos ψ (a_f is the distance of "
        "the flats from the axis) and γ = 0; Eq. 21 uses K = 1, the lever d_i/2, γ = ψ and corners "
        "without fillets",
        "if the wedge angle α is given, the tangential force of a roller is N tan(α/2). If α is "
        "not given, the tangential force is the friction limit μ N, as in Eqs. 4 and 17 to 21; "
        "this corresponds to α = 2 arctan μ without a cage force. The torque that a cage adds at "
        "the race does not act on the ring",
        "the hub force R is inclined by φ_1 towards the middle of the flat; the angle between R "
        "and the radius through the hub contact is ψ + φ_1, as in Eq. 14",
        "symbols of the series: u_p is the outward displacement of the outer surface above the "
        "middle of a flat under unit pressure; u_h1 is this displacement under unit hub force; "
        "−u_N(a) N is this displacement under the roller force N, including the local indentation. "
        "All three follow from complex potentials of the ring. δ(N) is the compression of the "
        "roller; κ = R/N",
        "the margin and the pressure for the target torque are computed with elastic ring and "
        "elastic rollers",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain; ring and rollers are in plane stress, the race is rigid. "
        "The torque with rigid rollers is an upper bound of the torque with elastic rollers",
        "friction at the rollers rotates the ring relative to the hub; by symmetry, friction does "
        "not displace the outer surface above the middle of the flats in radial direction",
        "the hub force at e is replaced by two forces of half the amount, one on each side of the "
        "middle of the flat",
    )

    comparisons = compared.comparisons

    def reference(self, level: int) -> Level:
        """Results of half a sector under pressure and hub force, with its roller."""
        return fem.solve(self, level)

    def figures(self) -> Iterator[Drawn]:
        """Figure: torques by formulas and finite elements."""
        yield Drawn(lambda context: torques(self, context))

    def pictures(self) -> Iterator[Picture]:
        """Picture of the ring under pressure, hub force and roller forces."""
        caption = (
            "Von Mises stress of the ring under pressure, roller forces and the symmetric part of "
            "the hub force (coarse mesh)"
        )
        yield picture("driven", "von_mises", caption, share=0.02)

    def sketch(self) -> Sketch:
        """Sketch of the ring, its rollers and loads."""
        return sketch(self.ring, d=self.d, e=self.e, p_t=self.p_t)

    def warnings(self) -> Iterator[str]:
        """Warnings if the torque is zero or has no limit, or if parts are overstressed."""
        yield from self._about_torque()
        if self.alpha_need > self.alpha_ring:
            yield (
                "without a cage, the rollers require a wedge angle of "
                f"{degrees(self.alpha_need):.3g}°. The largest slope of the deformed outer surface "
                f"of the ring, relative to a circle, is only {degrees(self.alpha_ring):.2g}° under "
                f"p_t. A wedge of this angle transmits {self.M_ring:.3g} N m; a cage must transmit "
                "the remaining torque"
            )
        if self.b > WIDE * self.delta_1 and isfinite(self.M_wide):
            yield (
                f"b/δ_1 = {self.b / self.delta_1:.3g}: the state of this wide ring is between "
                "plane stress, which is assumed, and plane strain, in which the torque would be "
                f"{self.M_wide:.4g} N m. The rollers load the axial ends of the ring more than the "
                "middle of its width"
            )
        if self.hub_share >= 1:
            yield (
                f"the share s of N due to the hub force is {self.hub_share:.3g} by Eq. 16, not "
                "below 1: the clutch locks itself by friction, and Eqs. 17 to 20 give no limit of "
                "the torque"
            )
        yield from of_rollers(max(self.p_ring, self.p_race), " on the rollers")
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when=" under p_t")

    def _about_torque(self) -> Iterator[str]:
        if self.alpha is not None and not self.stays:
            yield (
                f"the rollers are expelled: tan(α/2) = {np.tan(self.alpha / 2):.4g} is not below "
                f"μ = {self.mu:g}; without a cage, they carry no torque"
            )
        elif self.p_t <= self.p_1r:
            yield (
                f"p_t = {self.shown('p_t')} must exceed p_1r = {self.shown('p_1r')}: the ring "
                "does not reach its rollers, and the torque is zero"
            )
        elif not isfinite(self.M_el):
            yield (
                "as soon as the ring touches the rollers, the hub force clamps the rollers without "
                "more pressure: the strength limits the torque, not the pressure. With a larger e "
                "or a smaller μ, the pressure limits the torque"
            )
        elif self.margin < 1:
            yield (
                f"elastic ring and rollers transmit {self.M_el:.4g} N m, less than the target "
                f"torque of {self.M_t:.4g} N m, which requires p_t = {self.shown('p_need')}; the "
                f"hoop stress in the fillets is then {self.shown('fillet_need')}"
            )

    def refusal(self) -> str:
        """Reason why finite elements do not solve these inputs, such as zero torque; else ""."""
        if not self.stays:
            return "the rollers are expelled, the torque is zero: run `check` without --fem"
        N = self.line_load
        if not isfinite(N):
            return "pressure does not limit the torque: run `check` without --fem"
        if not self.hub.rises(self.line_need):
            return (
                f"no pressure corresponds to M_t = {self.M_t:.4g} N m, because the hub force "
                "clamps the rollers without more pressure: run `check` without --fem"
            )
        if 1e-3 * self.p_t * self.d_i > N:
            return (
                f"p_t = {self.shown('p_t')} hardly presses the ring against the rollers, so "
                "that the torque is nearly zero: run `check` without --fem"
            )
        return ""


CLUTCH = adapted(PolyhedralClutch)
