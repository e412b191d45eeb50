"""The ring locked against its rollers: share of the pressure that reaches them."""

from collections.abc import Iterator
from typing import ClassVar

from verify.case import Drawn, Level, Scan, picture
from verify.cases.polyhedral.locking import comparisons as compared
from verify.cases.polyhedral.locking import figures, sketch
from verify.cases.polyhedral.locking import reference as fem
from verify.cases.polyhedral.locking.formulas import LockedFormulas
from verify.cases.polyhedral.warnings import of_fillets, of_rollers
from verify.core.figures import Picture, Sketch
from verify.form.adapter import adapted

PRESSED = 1.02  # over the touching pressure: forces are compared above it


class LockedPolyhedralRing(LockedFormulas):
    """The paper assigns all of the blocking pressure to the rollers.

    The hoop force of the ring carries a large part of it. This part follows from finite elements
    with the roller as a contact, and from complex potentials with Hertz's patch. Sizes and loads
    are assumed.
    """

    id = "polyhedral-locking"
    title = "Polyhedral ring locked against its rollers"
    source = "belcin"
    place = "Eqs. 7, 13, 16, 19"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (
        Scan(
            vary=(
                "p_t=25MPa,30MPa,60MPa,100MPa",
                "delta_1=3mm,4mm,5mm",
                "z=4,6,8",
                "rho=1mm,2mm,4mm",
                "j_D=0.03mm,0.06mm,0.08mm",
            ),
            star=True,
        ),
    )
    readings: ClassVar = (
        "rollers and race are rigid, the ring is in plane stress: only the ring is compliant",
        "elastic rollers are of the ring's material, in plane stress; the race stays rigid",
        "p_2 is what p_t exceeds K_mid p_1 by (Eq. 19 with K in the middle of the flats)",
        "the hub's friction acts towards the flat's middle: R makes ψ + φ_1 with the radius "
        "through its contact (Eq. 14)",
        "the side of the polygon in Eq. 13, not its arc; γ = 0 in Eq. 16: along the flat's normal",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain; no friction at the rollers",
        "half a sector, symmetry on both cuts; the roller above the middle of the flat",
        "the hub's force at e counts as half of it on each side of the flat's middle",
    )

    comparisons = compared.comparisons

    def reference(self, level: int) -> Level:
        """Half a sector and its roller in contact."""
        return fem.solve(self, level)

    def figures(self) -> Iterator[Drawn]:
        """Force of a roller over the pressure, efficiency over the support."""
        yield Drawn(lambda context: figures.figures(self, context))

    def pictures(self) -> Iterator[Picture]:
        """The whole ring under all loads."""
        caption = "Locked ring under pressure, hub and rollers: von Mises stress, coarse mesh"
        yield picture("locked", "von_mises", caption, share=0.02)

    def sketch(self) -> Sketch:
        """The ring, its rollers and loads."""
        return sketch.sketch(self, d=self.d, e=self.e, p_t=self.p_t)

    def warnings(self) -> Iterator[str]:
        """Warnings if the rollers are loose or parts yield."""
        if not self.alone.N > 0:
            yield (
                f"p_t = {self.shown('p_t')} is below {self.shown('p_1r')}, at which the ring "
                "reaches its rollers: pressure alone does not lock them"
            )
        elif self.p_t <= self.touch_long:
            yield (
                f"p_t = {self.shown('p_t')} is below {self.touch_long / 1e6:.4g} MPa, at which a "
                "long ring in plane strain reaches its rollers: p_2l is negative, the pressure "
                "that is missing"
            )
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when="")
        yield from of_rollers(self.p_0)

    def refusal(self) -> str:
        """Rows compare forces of rollers and blocking pressures, which there must be."""
        touch, long = self.alone.locked.touch, self.touch_long
        least = max(PRESSED * touch, long)
        if self.p_t <= least:
            return (
                f"p_t = {self.shown('p_t')} hardly presses the rollers, if at all: the ring "
                f"reaches them at {touch / 1e6:.4g} MPa, a long one in plane strain at "
                f"{long / 1e6:.4g} MPa, and is compared above {least / 1e6:.4g} MPa, check it "
                "without --fem"
            )
        return ""


LOCKING = adapted(LockedPolyhedralRing)
