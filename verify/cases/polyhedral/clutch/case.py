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

    Each value of this chain is computed. The torque is compared with that of an elastic ring and
    elastic rollers, which finite elements confirm. The torque by the corrected Eq. 21 is several
    times as large. Dimensions and loads are assumed.
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
        "misprints are corrected: side of the polygon instead of its arc in Eqs. 13, 17, 20, 21; "
        "no factor β/360 in Eq. 21",
        "Eq. 20 uses K in the middle of the flats, the lever apothem/cos ψ and γ = 0; Eq. 21 uses "
        "K = 1, the lever d_i/2, γ = ψ and corners without fillets",
        "rollers with a given wedge angle α carry N tan(α/2). Without α, they carry the limit μ N, "
        "as in Eqs. 4 and 17 to 21: α = 2 arctan μ, no cage force. The torque that a cage adds "
        "at the race does not pass through the ring",
        "the hub force R is inclined by φ_1 towards the middle of the flat: its angle to the "
        "radius through its contact is ψ + φ_1, as in Eq. 14",
        "series: u_p, u_h1 and −u_N(a) N are outward displacements of the middle of a flat, under "
        "unit pressure, unit hub force and the roller force N. They follow from complex potentials "
        "of the ring, and the last includes local indentation. δ(N) is the compression of the "
        "roller; κ = R/N",
        "margin and pressure for the target torque hold for elastic ring and rollers",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain; ring and rollers in plane stress, race rigid; the torque "
        "with rigid rollers is an upper bound",
        "friction at the rollers rotates the ring against the hub; by symmetry, it does not "
        "displace the outside above the middle of the flats",
        "the hub force at e is replaced by half of it on each side of the middle of the flat",
    )

    comparisons = compared.comparisons

    def reference(self, level: int) -> Level:
        """Results of half a sector under pressure and hub force, with its roller."""
        return fem.solve(self, level)

    def figures(self) -> Iterator[Drawn]:
        """Figure: torques by formulas and finite elements."""
        yield Drawn(lambda context: torques(self, context))

    def pictures(self) -> Iterator[Picture]:
        """Picture of the ring under the pressure and its torque."""
        caption = (
            "Von Mises stress of the ring under pressure, hub force (symmetric part) and roller "
            "forces, coarse mesh"
        )
        yield picture("driven", "von_mises", caption, share=0.02)

    def sketch(self) -> Sketch:
        """Sketch of the ring, its rollers and loads."""
        return sketch(self.ring, d=self.d, e=self.e, p_t=self.p_t)

    def warnings(self) -> Iterator[str]:
        """Warnings if the clutch has no torque or no limit, or if parts are overstressed."""
        yield from self._about_torque()
        if self.alpha_need > self.alpha_ring:
            yield (
                "without a cage, the rollers require a wedge angle of "
                f"{degrees(self.alpha_need):.3g}°; the ring under p_t offers only "
                f"{degrees(self.alpha_ring):.2g}°, which transmits {self.M_ring:.3g} N m: a cage "
                "must transmit the remainder"
            )
        if self.b > WIDE * self.delta_1 and isfinite(self.M_wide):
            yield (
                f"b/δ_1 = {self.b / self.delta_1:.3g}: the ring is between plane stress (assumed) "
                f"and plane strain (torque {self.M_wide:.4g} N m); rollers load its ends more than "
                "its middle"
            )
        if self.hub_share >= 1:
            yield (
                f"the hub's share of N is {self.hub_share:.3g} by Eq. 16 (at least 1): "
                "the clutch locks by friction, and Eqs. 17 to 20 give no limit of the torque"
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
                "does not reach its rollers, the torque is zero"
            )
        elif not isfinite(self.M_el):
            yield (
                "after contact, the hub force alone clamps the rollers more and more: strength "
                "limits the torque, not pressure; a larger e or a smaller μ changes this"
            )
        elif self.margin < 1:
            yield (
                f"elastic ring and rollers transmit {self.M_el:.4g} N m, less than the "
                f"target torque of {self.M_t:.4g} N m: p_t must be {self.shown('p_need')}; the "
                f"hoop stress in the fillets is then {self.shown('fillet_need')}"
            )

    def refusal(self) -> str:
        """Reason for not solving inputs without a torque that pressure limits; "" if none."""
        if not self.stays:
            return "the rollers are expelled, the torque is zero: run `check` without --fem"
        N = self.line_load
        if not isfinite(N):
            return "pressure does not limit the torque: run `check` without --fem"
        if not self.hub.rises(self.line_need):
            return (
                f"no pressure belongs to M_t = {self.M_t:.4g} N m, as the hub force clamps the "
                "rollers more and more: run `check` without --fem"
            )
        if 1e-3 * self.p_t * self.d_i > N:
            return (
                f"p_t = {self.shown('p_t')} hardly presses the ring against the rollers, so "
                "that the torque is nearly zero: run `check` without --fem"
            )
        return ""


CLUTCH = adapted(PolyhedralClutch)
