"""Case of the ring locked against its rollers: part of the pressure that the rollers carry."""

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
    """The paper assigns the whole blocking pressure to the rollers.

    In fact, the hoop force of the ring balances a large part of this pressure. The roller force is
    computed with finite elements, and independently with complex potentials and Hertz's theory of
    contact. Dimensions and loads are assumed.
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
        "the ring is elastic and in plane stress, rollers and race are rigid; only in the rows "
        "that name elastic rollers, the rollers are also elastic",
        "elastic rollers have the material of the ring and are in plane stress",
        "p_2 = p_t − K_mid p_1 (Eq. 19 with K for the middle of the flats)",
        "the friction force of the hub on the ring acts towards the middle of the flat; the angle "
        "between the hub force R and the radius through the hub contact is ψ + φ_1 (Eq. 14)",
        "the corrected Eq. 13 contains the side length of the polygon instead of the arc length "
        "between two corners; Eq. 16 is used with γ = 0: N is normal to the flat. The incremental "
        "load-transfer ratio is the increase of the roller force, divided by the increase of the "
        "load that causes it: pressure force on a flat (η) or hub force (η_h)",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain; no friction at the rollers",
        "half a sector is modelled, with symmetry on both cuts; the roller is above the middle of "
        "the flat",
        "the hub force at e is replaced by two forces of half the amount, one on each side of the "
        "middle of the flat",
    )

    comparisons = compared.comparisons

    def reference(self, level: int) -> Level:
        """Results of half a sector in contact with its roller."""
        return fem.solve(self, level)

    def figures(self) -> Iterator[Drawn]:
        """Figures: force of a roller over the pressure, load transfer over the support width."""
        yield Drawn(lambda context: figures.figures(self, context))

    def pictures(self) -> Iterator[Picture]:
        """Picture of the whole ring under all loads."""
        caption = (
            "Von Mises stress of the locked ring under pressure, hub force and roller forces "
            "(coarse mesh)"
        )
        yield picture("locked", "von_mises", caption, share=0.02)

    def sketch(self) -> Sketch:
        """Sketch of the ring, its rollers and loads."""
        return sketch.sketch(self, d=self.d, e=self.e, p_t=self.p_t)

    def warnings(self) -> Iterator[str]:
        """Warnings if the ring does not reach its rollers or if parts are overstressed."""
        if not self.alone.N > 0:
            yield (
                f"p_t = {self.shown('p_t')} is below {self.shown('p_1r')}, at which the ring "
                "reaches its rollers: pressure alone does not lock the ring"
            )
        elif self.p_t <= self.touch_long:
            yield (
                f"p_t = {self.shown('p_t')} is below {self.touch_long / 1e6:.4g} MPa, at which a "
                "long ring in plane strain reaches its rollers: p_2l is negative, and its amount "
                "is the missing pressure"
            )
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when="")
        yield from of_rollers(self.p_0)

    def refusal(self) -> str:
        """Reason why finite elements do not solve a pressure that hardly loads rollers; else ""."""
        touch, long = self.alone.locked.touch, self.touch_long
        least = max(PRESSED * touch, long)
        if self.p_t <= least:
            return (
                f"p_t = {self.shown('p_t')} hardly loads the rollers: the ring reaches them "
                f"at {touch / 1e6:.4g} MPa, a long ring in plane strain at {long / 1e6:.4g} MPa; "
                f"finite elements need more than {least / 1e6:.4g} MPa: run `check` without --fem"
            )
        return ""


LOCKING = adapted(LockedPolyhedralRing)
