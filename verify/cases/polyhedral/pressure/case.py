"""Case of a round ring, thin and thick: pressure that closes the clearance to the rollers."""

from collections.abc import Iterator
from typing import Any, ClassVar, Self

import numpy as np

from analytic.bounds.polyhedral import thin_ring
from analytic.polyhedral import expansion
from analytic.ring import lame
from verify.case import (
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    approximation,
    balance,
    identity,
    limit,
    over_family,
    sketches,
    solved,
)
from verify.cases.polyhedral.thin_ring import ThinRing
from verify.cases.ring.walls import quarter_fem
from verify.core.figures import Picture, Sketch
from verify.form.adapter import adapted
from verify.form.fields import picture, plane_field
from verify.form.figures import Overlay

WALLS = (0.01, 0.0178, 0.0316, 0.0562, 0.1)  # δ_1/d_m: a decade
THICK = 0.15  # δ_1/d_m above which meshes are twice as fine
SOLID = 0.96  # δ_1/d_m at the end of figures; at 1 the bore vanishes
ACCEPTED = 5e-4, "accepted error of finite elements for a round ring under uniform pressure"
LAME = "derived: Lamé's pressure is d_m²/(d_i d_e) times p_1, in plane stress"
MEAN = (
    "derived: the mean stress over the wall is p d_i/(2 δ_1) for any pressure p, so that σ_t "
    "and p_1 have equal errors"
)
RIM = (
    "derived: the hoop strain at the free outer surface is j_D/d_e; "
    f"± {thin_ring.CELL:g} (δ_1/d_m)² for the error of stresses at the edges of cells"
)
BORE = (
    "Lamé: the hoop stress at the bore is (1 + (d_e/d_i)²)/2 E j_D/d_e; "
    f"± f {thin_ring.CELL:g} (δ_1/d_m)², with f from 1 (thin wall) to 2 (thick wall), "
    "for the error of stresses at the edges of cells"
)
OUTSIDE = (
    "Lamé: under the mean hoop stress σ_t, the outer diameter grows by d_i d_e/d_m² times σ_t d_m/E"
)
MIDDLE = "Lamé: growth of the mean diameter if the outer diameter grows by j_D"


class RingPressure(ThinRing):
    """A round ring under pressure is the basis of the theory of the polygonal ring.

    The formulas of the paper for a thin ring are compared with Lamé's formulas of a thick ring and
    with finite elements. Rings of varied wall thickness demonstrate that the error of the thin-ring
    formula approaches zero with the wall thickness. Dimensions are assumed, because the paper
    prints none.
    """

    id = "polyhedral-pressure"
    title = "Pressure that expands a round ring to its rollers"
    source = "belcin"
    place = "Eqs. 6, 8-10"
    scans: ClassVar = (
        Scan(vary=("delta_1=1mm,2mm,4mm,6mm,7mm,8mm,12mm", "nu=0.2,0.3,0.4"), star=True),
    )
    readings: ClassVar = (
        "j_D is the diametral clearance between the outer surface of the ring and the rollers",
        "the ring is free along its axis (plane stress); in plane strain, the pressure is "
        "1/(1 - ν²) times as large",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain",
        "a quarter of the ring is modelled, with symmetry on both cuts",
    )  # fmt: skip

    @Quantity("Δd_m", "µm", "growth of the mean diameter", equation="8",
              tex=r"\frac{\sigma_t d_m}{E}")  # fmt: skip
    def growth(self) -> float:
        return float(expansion.growth(sigma_t=self.sigma_t, d_m=self.mean_diameter, E=self.E))

    @Quantity("K", "1", "p divided by p_1, equal to K of a ring with many flats", role="step",
              source="Lamé", tex=r"\frac{d_m^2}{d_i d_e}")  # fmt: skip
    def K(self) -> float:
        return float(expansion.many_corners_factor(d_i=self.d_i, d_e=self.d_e))

    p = Quantity(
        "p", "MPa", "pressure that closes the clearance, plane stress", source="Lamé",
        tex=r"\frac{E j_D (d_e^2 - d_i^2)}{2 d_i^2 d_e} = K p_1",
    ).reads(lambda q: q.thick_ring("plane stress"))  # fmt: skip
    p_strain = Quantity(
        "p_l", "MPa", "pressure that closes the clearance, plane strain", source="Lamé",
        tex=r"\frac{p}{1 - \nu^2}",
    ).reads(lambda q: q.thick_ring("plane strain"))  # fmt: skip

    def thick_ring(self, ends: lame.Ends) -> float:
        """Pressure [Pa] that closes the clearance, by Lamé."""
        wall = {"d_i": self.d_i, "d_e": self.d_e}
        p = expansion.round_ring_pressure(j_D=self.j_D, **wall, E=self.E, nu=self.nu, ends=ends)
        return float(p)

    def of_wall(self, share: float) -> Self:
        """The ring with unchanged d_m and the wall `share` d_m; the inputs are not validated."""
        sizes = {"delta_1": share * self.d_m, "d_e": (1 + share) * self.d_m}
        return self.model_copy(update=sizes)

    def reference(self, level: int) -> Level:
        """Results under a pressure E/1000 in the bore, scaled to the pressure that closes j_D."""
        p_0, fine = self.E / 1000, 2 if self.delta_1 > THICK * self.d_m else 1

        def expanded(d_i: float, d_e: float, ends: Any) -> Any:
            return quarter_fem(self, d_i / 2, d_e / 2, ends, level * fine, pressures={"bore": p_0})

        def growth(solution: Any, place: str) -> float:
            along = solution.on_boundary(place)
            return 2 * float(along.mean(along.polar()[0]))

        def pressure(solution: Any) -> float:
            """Pressure [Pa] with which the outer diameter grows by j_D."""
            return p_0 * self.j_D / growth(solution, "rim")

        def thinner(wall: float) -> float:
            sizes = self.d_m * (1 - wall), self.d_m * (1 + wall)
            return pressure(expanded(*sizes, "plane stress"))

        narrow, long = (expanded(self.d_i, self.d_e, a) for a in ("plane stress", "plane strain"))
        rim, bore, p = narrow.on_boundary("rim"), narrow.on_boundary("bore"), pressure(narrow)
        cut = -narrow.reaction("x=0")[0]  # the hoop force of a wall, pulling on the quarter
        round_off = max(
            max(s.residual**0.5, abs(s.potential_energy / s.strain_energy + 1))
            for s in (narrow, long)
        )
        return solved(
            1 / level, plane_field(narrow, "von_mises", name="ring", scale=p / p_0),
            iteration=round_off, p=p, p_strain=pressure(long),
            mean_stress=cut / self.delta_1 * p / p_0,
            rim_stress=rim.mean(rim.polar()[2]) * p / p_0,
            bore_stress=bore.mean(bore.polar()[2]) * p / p_0,
            growth=self.j_D / growth(narrow, "rim") * growth(narrow, "middle"),
            growth_outside=growth(narrow, "rim") * self.straining * self.E / (cut / self.delta_1),
            balance=cut - p_0 * self.d_i / 2,
            thinner=np.array([thinner(wall) for wall in WALLS]),
        )  # fmt: skip

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: thin ring and Lamé against finite elements, for the given and for thinner walls."""
        ring, wall = RingPressure, {"d_e": self.d_e, "wall": self.delta_1}
        thin = thin_ring.pressure_error(**wall)
        outside = thin_ring.rim_stress_error(**wall)
        inside = thin_ring.bore_stress_error(**wall)
        middle = thin_ring.growth_error(**wall, j_D=self.j_D, E=self.E, nu=self.nu)
        taken = thin_ring.outside_growth_error(**wall)
        yield identity(ring.p, order=4, sensitivity=ACCEPTED)
        yield identity(ring.p_strain, order=4, sensitivity=ACCEPTED)
        yield approximation(ring.p_1, "p", order=4, expected=Expected(*thin, LAME))
        yield approximation(ring.sigma_t, "mean_stress", order=4,
                            against="the mean hoop stress over the wall",
                            expected=Expected(*thin, MEAN))  # fmt: skip
        yield approximation(ring.sigma_t, "rim_stress", order=2,
                            against="the hoop stress at the outer surface",
                            expected=Expected(*outside, RIM))  # fmt: skip
        yield approximation(ring.sigma_t, "bore_stress", order=2,
                            against="the hoop stress at the bore",
                            expected=Expected(*inside, BORE))  # fmt: skip
        yield approximation(ring.growth, order=4, expected=Expected(*middle, MIDDLE))
        yield approximation(ring.growth, "growth_outside", order=4, symbol="Δd_e",
                            against="the growth of the outer diameter",
                            expected=Expected(*taken, OUTSIDE))  # fmt: skip
        yield limit(ring.p_1,
                    "error of the pressure for a wall thickness that approaches zero, Eq. 10",
                    "p_1/p - 1", exponent=2,
                    points=over_family(ring.p_1, "thinner", at=WALLS, family=self.of_wall,
                                       order=4))  # fmt: skip
        yield balance("balance", "balance of hoop force and bore pressure", "ΣF_x", "N/mm",
                      of={"the pressure force": self.E / 1000 * self.d_i / 2}, bound=1e-9,
                      because="direct solution: machine epsilon × condition number")  # fmt: skip

    def figures(self) -> Iterator[Overlay]:
        """Figure of the pressure over the wall thickness."""
        thickest = min(max(0.2, 1.2 * self.delta_1 / self.d_m), SOLID)
        yield Overlay(
            title="Pressure that closes the clearance", x_label="wall δ_1/d_m",
            family=self.of_wall, over=np.linspace(WALLS[0], thickest, 60).tolist(),
            quantities=(RingPressure.p_1, RingPressure.p), reference="thinner", at=WALLS,
            note=f"The mean diameter is {self.shown('mean_diameter')}, the clearance "
            f"{self.shown('j_D')}. The error of the thin-ring formula grows with the square of the "
            "wall thickness.",
        )  # fmt: skip

    def pictures(self) -> Iterator[Picture]:
        """Picture of the von Mises stress of the whole ring."""
        caption = "Von Mises stress of the ring (plane stress) when the clearance is closed"
        yield picture("ring", "von_mises", caption, mirror="xy")

    def sketch(self) -> Sketch:
        """Sketch of the ring, its rollers and the pressure."""
        bore, at, r = self.d_i / self.d_e, 1.19, 0.13  # over d_e/2, clearance drawn much larger
        return sketches.sketch(
            f"round ring of {self.shown('d_e')} outer diameter under pressure in its bore. The "
            f"diametral clearance to the rollers is {self.shown('j_D')}; it is drawn much larger",
            sketches.ring(bore, 1.0), sketches.rollers(6, r, at), sketches.circle(at + r),
            sketches.radial_loads(6, bore - 0.22, bore, "p"),
            sketches.leader((-1.25, 0.92), (-0.383 * (1 + bore), 0.3215 * (1 + bore)),
                            f"wall {self.shown('delta_1')}"),
            sketches.leader((1.2, -1.1), (0.72, -0.72), f"d_e = {self.shown('d_e')}"),
        )  # fmt: skip

    def warnings(self) -> Iterator[str]:
        """Warning if the ring yields before it reaches its rollers."""
        tresca = 2 * self.d_e**2 / (self.d_e**2 - self.d_i**2) * self.p  # in the bore
        if self.R_p is not None and tresca > self.R_p:
            yield (
                f"Tresca stress {tresca / 1e6:.4g} MPa in the bore exceeds R_p = "
                f"{self.shown('R_p')}: the ring yields before it closes j_D = "
                f"{self.shown('j_D')}"
            )
        if self.R_p is None and self.straining > 3e-3:
            yield (
                f"the hoop strain that closes the clearance is {self.straining:.2%}: most steels "
                "yield at a smaller strain; enter the yield strength R_p"
            )


PRESSURE = adapted(RingPressure)
