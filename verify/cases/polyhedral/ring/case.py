"""Case of a ring with polygonal bore: pressure at which it reaches the rollers."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, Self

import numpy as np

from analytic.polyhedral import bore_pressure, expansion, printed, wall_stress
from analytic.polyhedral.hub_force import hub_force
from verify.case import (
    AlongLine,
    Comparison,
    Expected,
    Level,
    Quantity,
    Scan,
    State,
    about,
    approximation,
    balance,
    identity,
    picture,
    shared,
)
from verify.cases.polyhedral.fem import UNIT, stations
from verify.cases.polyhedral.inputs import HubRing
from verify.cases.polyhedral.ring import reference as fem
from verify.cases.polyhedral.ring import sketch as sketched
from verify.cases.polyhedral.thin_ring import SERIES, PolygonSeries
from verify.cases.polyhedral.warnings import of_fillets
from verify.core.case import Portion
from verify.core.figures import Array, Picture
from verify.form.adapter import adapted

STRESS = 30.0  # times the series' residual: stress in the fillet is worse by one or two digits
PEAK = 1e-4  # relative error of a largest stress by the polynomial along the fillet
NEAR = 1e-3  # about the series' predictions: a hundred times their residual
HALVED = 1e-3, "accepted change when the cell size is halved: 0.1 %"
LARGEST = "derived from the largest stress in the fillets by the series, ± 0.5 %"
FILLET = 5e-3, "a change of the peak stress by 0.5 % would show a wrong fillet radius"
PLACES = {"e": "e", "corner": "the corner"}  # places of the hub's force
WHERE = {"mid": "middle of the flats", "corner": "corners"}
HUB = "symmetric part of the hub force, equal for all flats; plane stress"
BALANCE = "accepted residual of a direct solution"


class PolyhedralRing(PolygonSeries, HubRing):
    """The flats of a polygonal bore bulge under pressure, and the corners restrain the ring.

    The paper has a correction factor K for this effect, but does not derive K and assumes K = 1.
    Here, K is computed with complex potentials, independently of the finite elements. Dimensions
    are assumed, because the paper prints none.
    """

    id = "polyhedral-ring"
    title = "Polyhedral ring under pressure"
    source = "belcin"
    place = "Eqs. 8-12, K before Eq. 11"
    # Displacements at a point err by a third order in h beside the fourth, often of the other sign:
    # on 2, 3, 4 both are of one size for one ring in seven, whose differences then grow.
    levels: ClassVar = (2, 3, 4, fem.FINEST)
    portions: ClassVar = (
        Portion(name="K", fem=fem.stiffness_fem, levels=(1, 2, 3),
                keys=("K_mid", "K_mean", "flexibility")),
        Portion(name="K in plane stress and strain", fem=fem.both_fem, levels=(1, 2, 3),
                keys=("K_mid", "K_mean", "flexibility", "K_mid_strain")),
    )  # fmt: skip
    scans: ClassVar = (
        Scan(
            vary=("z=3:12:10", "delta_1=2mm,3mm,4mm,5mm,6mm,8mm"),
            only=("K of the paper", "K = 1", "K in the middle of the flats",
                  "K for the mean displacement of the outer surface"),
            at=("e=2mm",),
        ),
        Scan(vary=("rho=0.5mm,1mm,2mm,4mm", "delta_1=2mm,4mm,8mm"), star=True),
    )  # fmt: skip
    readings: ClassVar = (
        "d_i is the diameter of the circle that touches the fillets in the corners of the bore, so "
        "that δ_1 is the smallest wall thickness. If d_i is instead the diameter of the circle "
        "through the sharp corners of the polygon (without fillets), K of rings with three to six "
        "flats is 10 to 47 % larger",
        "K refers to the pressure at which the outer surface above the middle of the flats, where "
        "the rollers are, has moved by j_D/2. K for the mean displacement of the outer surface and "
        "K for the displacement at the corners are also reported",
        "the ring is narrow (plane stress); in plane strain, K is 1/(1 - ν²) times as large",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain",
        "half a sector is modelled, with symmetry on both cuts",
        "the hub force at e is replaced by its symmetric part: two forces of half the amount, one "
        "on each side of the middle of the flat, equal for all flats",
    )

    @Quantity("K", "1", "K of the paper", source="before Eq. 11", tex="1", safe="too high")
    def K(self) -> float:
        return 1.0

    K_mean = Quantity("K_mean", "1", "K for the mean displacement of the outer surface",
                      source=SERIES).reads(lambda q: q.factors.mean)  # fmt: skip
    K_corner = Quantity("K_corner", "1", "K for the displacement at the corners; negative if the "
                        "corners move inwards", source=SERIES,
                        role="step").reads(lambda q: q.factors.corner)  # fmt: skip

    @Quantity("1/K_corner", "1", "reciprocal of K at the corners")
    def flexibility(self) -> float:
        return 1 / self.K_corner

    @Quantity("K_∞", "1", "limit of K for many flats", source="Lamé", role="step",
              tex=r"\frac{d_m^2}{d_i d_e}")  # fmt: skip
    def K_many(self) -> float:
        return float(expansion.many_corners_factor(d_i=self.d_i, d_e=self.d_e))

    @Quantity("p_1r", "MPa", "pressure at which the ring reaches its rollers", equation="11",
              safe="too high", role="step")  # fmt: skip
    def p_1r(self) -> float:
        return self.K_mid * self.p_1

    @Quantity("σ_tr", "MPa", "mean hoop stress in the corners", equation="12", safe="too high",
              form="corrected",
              tex=r"\frac{p_{1r} d_i}{2 \delta_1} = K_{mid} \sigma_t")  # fmt: skip
    def sigma_tr(self) -> float:
        return float(expansion.mean_hoop_stress(p=self.p_1r, d_i=self.d_i, d_e=self.d_e))

    @Quantity("σ_tr", "MPa", "mean hoop stress in the corners", equation="12", safe="too high",
              form="as printed", form_of="sigma_tr", tex=r"K_{mid}^2 \sigma_t")  # fmt: skip
    def sigma_tr_printed(self) -> float:
        return float(printed.mean_hoop_stress(sigma_t=self.sigma_t, K=self.K_mid))

    growth = Quantity(
        "u_r(0)", "µm", "displacement of the outer surface at the middle of the flats",
        role="step", source="complex potential φ at the outer surface",
        tex=r"\frac{4}{E}\,e^{-i\theta}\,\varphi(r_e e^{i\theta}) - i u_\theta",
    ).reads(lambda q: q.outside(np.zeros(1))[0])  # fmt: skip

    @Quantity("σ_max", "MPa", "largest hoop stress in the fillets", source=SERIES,
              safe="too high")  # fmt: skip
    def fillet(self) -> float:
        return float(wall_stress.largest_fillet_stress(sector=self.sector)[0] * self.p_1r)

    @Quantity("σ_max/σ_t", "1", "σ_max divided by the hoop stress of the round ring", role="step")
    def fillet_factor(self) -> float:
        return self.fillet / self.sigma_t

    @Quantity("u_{1}({0})", "µm", "displacement of the outer surface at point {1} under "
              "the hub force at point {0} (point mid: middle of a flat; point e: at the distance e "
              "from the middle)",
              source=SERIES).over(tuple(PLACES), tuple(WHERE))  # fmt: skip
    def hub(self, at: str, where: str) -> float:
        return self._lifts[at, where]

    @shared
    def _hubs(self) -> Mapping[str, Any]:
        """Solutions under the hub force at e, and under its normal component in the corner."""
        normal, along = self.R_b / np.hypot(1, self.tan_phi) * np.array([1, -self.tan_phi])
        places = {"e": (self.e, along), "corner": (self.sector.half_bore, 0.0)}
        return {
            at: hub_force(sector=self.sector, e=e, normal=normal, along=pull)
            for at, (e, pull) in places.items()
        }

    @shared
    def _lifts(self) -> Mapping[tuple[str, str], float]:
        """Displacements [m] of points of the outer surface, by (place of hub force, point)."""
        return {
            (at, where): float(u)
            for at, hub in self._hubs.items()
            for where, u in zip(
                WHERE, hub.rim_displacement([0.0, self.half_angle]).real / self.E, strict=True
            )
        }

    def outside(self, theta: Array) -> Array:
        """Radial displacements [m] of the outer surface at the angles `theta` under p_1r, (m,)."""
        load: dict[str, Any] = {"p": self.p_1r, "E": self.E, "nu": self.nu}
        u = bore_pressure.rim_displacement(
            theta, sector=self.sector, assumption="plane stress", **load
        )
        return np.asarray(u.real)

    def as_wide(self) -> Self:
        """The ring in plane strain."""
        return self.variant(ends="plane strain")

    def reference(self, level: int) -> Level:
        """Results of half a sector under pressure in its bore, and under the hub force."""
        return fem.solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: series against finite elements, and K = 1 against finite elements."""
        ring, residual = PolyhedralRing, self.factors.residual
        left = max(residual, *(hub.correction.residual for hub in self._hubs.values()))
        same: dict[str, Any] = {"order": 4, "sensitivity": HALVED, "uncertainty": left,
                                "shares": "plane stress"}  # fmt: skip
        yield identity(ring.K_mid, **same)
        yield identity(ring.K_mean, **same)
        yield identity(ring.flexibility, scale={"1/K_mid": 1 / self.K_mid}, **same)
        long = self.as_wide()
        wide = State(long, "strain", "plane strain")
        yield identity(ring.K_mid, state=wide, **same | {"shares": "plane strain for a long ring"})
        yield approximation(ring.K, "K_mid", order=4, expected=of_one(self.K_mid),
                            printed=("belcin:k-predimensioning",),
                            shares="plane stress")  # fmt: skip
        yield approximation(ring.K, "K_mean", order=4, shares="plane stress",
                            expected=of_one(self.K_mean),
                            name="K = 1 against K for the mean displacement of the outer "
                            "surface")  # fmt: skip
        yield approximation(ring.K, "K_mid_strain", order=4, shares="plane strain for a long ring",
                            expected=of_one(long.K_mid),
                            name="K = 1 against K in the middle of the flats, plane "
                            "strain")  # fmt: skip
        yield identity(ring.sigma_tr, **same)
        twice = about(
            self.K_mid - 1,
            NEAR,
            "derived: K_mid − 1 by the series, because the printed formula applies K_mid twice",
        )
        yield approximation(ring.sigma_tr_printed, "sigma_tr", order=4, expected=twice,
                            name="mean hoop stress in the corners, Eq. 12 as printed",
                            shares="plane stress")  # fmt: skip
        hoop = self.E * self.j_D / (self.d_e - self.delta_1)  # of a thin ring of this mean diameter
        for q, stress, name in (
            (ring.sigma_t, hoop,
             "hoop stress, Eq. 9, against the largest hoop stress in the fillets"),
            (ring.sigma_tr, self.K_mid * hoop,
             "mean hoop stress, Eq. 12, against the largest hoop stress in the fillets"),
        ):  # fmt: skip
            share = stress / self.fillet
            yield approximation(q, "fillet", name=name, order=2, shares="plane stress",
                                expected=about(share - 1, FILLET[0] * share, LARGEST))  # fmt: skip
        peak = {"order": 2, "sensitivity": FILLET, "uncertainty": max(PEAK, STRESS * residual)}
        yield identity(ring.fillet, **same | peak)
        scale = {
            "the largest displacement of the outer surface under a hub force at the corner": max(
                abs(self.hub("corner", where)) for where in WHERE
            )
        }
        for at, place in PLACES.items():
            for where, words in WHERE.items():
                yield identity(ring.hub(at, where),
                               name=f"displacement of the outer surface at the {words} under the "
                               f"hub force at {place}",
                               symbol=f"u_{where}", scale=scale,
                               **same | {"order": 2, "shares": HUB})  # fmt: skip
        for x in "xy":
            yield balance(
                f"balance_{x}", f"balance of forces on half a sector, {x}", f"ΣF_{x}", "N/mm",
                of={"the pressure times d_i/2": UNIT * self.d_i / 2}, bound=1e-8, because=BALANCE,
            )  # fmt: skip

    def figures(self) -> Iterator[AlongLine]:
        """Figure: displacement of the outer surface when the ring reaches its rollers."""
        degree = np.degrees
        yield AlongLine(
            title="Radial displacement of the outer surface when the ring reaches its rollers",
            x=("angle from the middle of a flat [°]", "1"), y=("u_r", "µm"),
            at=degree(stations(self)), points=degree(np.linspace(0, self.half_angle, 121)),
            curve=lambda x: self.outside(np.radians(x)), reference="outside", order=3,
            scale=self.j_D / 2, scale_name="half the clearance",
            note="The roller is at 0°, the corner at the largest angle. Line: complex potentials.",
        )  # fmt: skip

    def pictures(self) -> Iterator[Picture]:
        """Pictures of the ring and of rings with other numbers of flats."""
        for z in dict.fromkeys((*fem.DRAWN, self.z)):
            caption = f"Von Mises stress of a ring with {z} flats when the clearance is closed"
            yield picture(f"z = {z}", "von_mises", caption, share=0.02)

    sketch = sketched.sketch

    def warnings(self) -> Iterator[str]:
        """Warnings if the fillets yield or the corners move inwards."""
        when = " when the ring reaches its rollers"
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when=when)
        if self.flexibility < 0:
            yield "the corners move inwards under pressure; the ring expands only above the flats"


def of_one(K: float) -> Expected:
    """Expected error of K = 1, if the series gives the value `K`."""
    return about(1 / K - 1, NEAR, "derived: 1/K − 1 with K of the series (complex potentials)")


RING = adapted(PolyhedralRing)
