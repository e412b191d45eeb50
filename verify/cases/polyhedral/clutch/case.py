"""The whole clutch, parts to torque: the paper's formulas and the elastic ring."""

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
    """Every value of the paper's chain from dimensions, friction and pressure to the torque.

    It is compared with the torque of an elastic ring and elastic rollers, which finite elements
    confirm. The corrected Eq. 21 gives several times as much. Sizes and loads are assumed.
    """

    id = "polyhedral-clutch"
    title = "Polyhedral ring clutch, from its parts to its torque"
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
        "misprints corrected: the side of the polygon for its arc (13, 17, 20, 21), no factor "
        "β/360 in Eq. 21",
        "Eq. 20: K of the middle of the flats, lever apothem/cos ψ, γ = 0; Eq. 21: K = 1, lever "
        "d_i/2, γ = ψ, corners without fillets",
        "rollers with a wedge angle α carry N tan(α/2); without one they are at the limit μ N, as "
        "in Eqs. 4 and 17 to 21: α = 2 arctan μ, no force of a cage. What a cage adds to the "
        "race's torque does not pass through the ring",
        "the hub's force R leans by φ_1 towards the flat's middle: it makes ψ + φ_1 with the "
        "radius through its contact, as in Eq. 14",
        "series: complex potentials of the ring; unit pressure and unit hub force lift the middle "
        "of the flats by u_p and u_h1, a roller's force presses it back by u_N(a) N, local "
        "indentation included, and compresses the roller by δ(N); κ = R/N",
        "margin and pressure for the target torque are those of elastic ring and rollers",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain; ring and rollers in plane stress, the race rigid; rigid "
        "rollers set an upper bound of the torque",
        "friction at the rollers turns the ring against the hub: by symmetry it lifts nothing "
        "above the middle of the flats",
        "the hub's force at e counts as half of it on each side of the flat's middle",
    )

    comparisons = compared.comparisons

    def reference(self, level: int) -> Level:
        """Half a sector that its hub turns, with its roller."""
        return fem.solve(self, level)

    def figures(self) -> Iterator[Drawn]:
        """Torques side by side."""
        yield Drawn(lambda context: torques(self, context))

    def pictures(self) -> Iterator[Picture]:
        """The ring at its torque."""
        caption = (
            "Ring at its torque: pressure, hub (its symmetric part) and rollers; von Mises stress, "
            "coarse mesh"
        )
        yield picture("driven", "von_mises", caption, share=0.02)

    def sketch(self) -> Sketch:
        """The ring, its rollers and loads."""
        return sketch(self.ring, d=self.d, e=self.e, p_t=self.p_t)

    def warnings(self) -> Iterator[str]:
        """Warnings if the clutch has no torque or no limit, or if parts yield."""
        yield from self._about_torque()
        if self.alpha_need > self.alpha_ring:
            yield (
                "without a cage a wedge angle is required of "
                f"{degrees(self.alpha_need):.3g}°; available are "
                f"{degrees(self.alpha_ring):.2g}° under p_t, which carry {self.M_ring:.3g} N m: a "
                "cage transmits the remainder"
            )
        if self.b > WIDE * self.delta_1 and isfinite(self.M_wide):
            yield (
                f"b/δ_1 = {self.b / self.delta_1:.3g}: neither plane stress, as taken, nor plane "
                f"strain, which gives {self.M_wide:.4g} N m; rollers press more on the ends"
            )
        if self.hub_share >= 1:
            yield (
                f"the hub's share of N is {self.hub_share:.3g} by Eq. 16: friction that locks, "
                "Eqs. 17 to 20 set no limit to the torque"
            )
        yield from of_rollers(max(self.p_ring, self.p_race), " on the rollers")
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when=" under p_t")

    def _about_torque(self) -> Iterator[str]:
        if self.alpha is not None and not self.stays:
            yield (
                f"the rollers are expelled: tan(α/2) = {np.tan(self.alpha / 2):.4g} is not below "
                f"μ = {self.mu:g}; without a cage they carry nothing"
            )
        elif self.p_t <= self.p_1r:
            yield (
                f"p_t = {self.shown('p_t')} is not above p_1r = {self.shown('p_1r')}: the ring "
                "does not reach its rollers, no torque"
            )
        elif not isfinite(self.M_el):
            yield (
                "after contact the hub alone wedges the rollers further and further: strength "
                "limits the torque, not pressure; a larger e or a smaller μ restores that limit"
            )
        elif self.margin < 1:
            yield (
                f"elastic ring and rollers carry {self.M_el:.4g} N m, less than the "
                f"target of {self.M_t:.4g} N m: p_t must be {self.shown('p_need')}, under "
                f"which the fillets carry {self.shown('fillet_need')}"
            )

    def refusal(self) -> str:
        """Rows compare forces of rollers that pressure limits."""
        if not self.stays:
            return "the rollers are expelled: there is no torque to compare, check it without --fem"
        N = self.line_load
        if not isfinite(N):
            return "pressure does not limit the torque: nothing to compare, check it without --fem"
        if not self.hub.rises(self.line_need):
            return (
                f"no pressure holds M_t = {self.M_t:.4g} N m, the hub wedges the rollers further "
                "and further: nothing to compare, check it without --fem"
            )
        if 1e-3 * self.p_t * self.d_i > N:
            return (
                f"p_t = {self.shown('p_t')} hardly reaches the rollers: there is no torque to "
                "compare, check it without --fem"
            )
        return ""


CLUTCH = adapted(PolyhedralClutch)
