"""The ring locked against its rollers: how much of the pressure reaches them."""

from collections.abc import Iterator
from typing import Any, ClassVar

from analytic.bounds.polyhedral import flat
from analytic.bounds.polyhedral.contacts import (
    PEAK,
    WIDTH,
    RollerOnRing,
    about,
    over_series,
)
from verify.case import (
    Comparison,
    Drawn,
    Expected,
    Level,
    Quantity,
    Scan,
    State,
    balance,
    fact,
    identity,
    picture,
)
from verify.cases.polyhedral.locking import figures, sketch
from verify.cases.polyhedral.locking import reference as fem
from verify.cases.polyhedral.locking.formulas import LockedFormulas
from verify.cases.polyhedral.warnings import of_fillets
from verify.core.case import Check, Context
from verify.core.figures import Picture, Sketch
from verify.form.adapter import adapted
from verify.form.comparisons import key_of
from verify.judging.bands import OwnFillet, OwnFormula

PRESSED = 1.02  # of the pressure that touches: from there on forces are compared
STATIC_RATING = 4e9  # Pa, ISO 76: roller bearings at their static load rating
CHORD = 1e-3, "statics: pressure on the chord between two corners"
FILLET = 5e-3, "a peak stress: half a per cent tells fillets apart"
BALANCE = "acceptance figure; contact met to round-off"
HALVES = "plane stress; half of the hub's force on each side of the flat's middle"
PLANE = "plane stress, rigid race, no friction at the rollers"
FORCES = "argued: (2 a/d)² of the curvature, (a/wall)², and 1e-3, each once"
SERIES = "a rigid flat's statics by vectors over the series under the same loads; the same slack"
CONTACT = (
    "derived: the first order in βκa, with κ of the line on which the bodies meet; argued, each "
    "once: (2 a/d)², (a/wall)², 1e-3, and what the ring strains and bends, j_D/d_e (1 + R/wall)"
)
RACE = "derived: the first order in βκa; argued: (2 a/d)² and 1e-3, each once"


class LockedPolyhedralRing(LockedFormulas):
    """The paper assigns all of the blocking pressure to the rollers.

    The hoop force of the ring carries a good part of it. How much follows from finite elements with
    the roller as a contact, and from complex potentials with Hertz's patch. Sizes and loads are the
    project's.
    """

    id = "polyhedral-locking"
    title = "Polyhedral ring locked against its rollers"
    source = "belcin"
    place = "Eqs. 7, 13, 16, 19"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (
        Scan(vary=("p_t=15MPa,30MPa,60MPa,100MPa", "delta_1=3mm,4mm,6mm", "z=4,6,8"), star=True),
    )
    readings: ClassVar = (
        "rollers and race are rigid, the ring is in plane stress: all of the ring's own compliance",
        "rollers that are said to be elastic are of the ring's material, in plane stress; the race "
        "stays rigid",
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

    def reference(self, level: int) -> Level:
        """Half a sector and its roller in contact."""
        return fem.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """The series, Hertz and the paper against finite elements."""
        yield from self._series()
        yield from self._flat()
        case = LockedPolyhedralRing
        blur = {"fillet blur": self._roller.fillet_blur(self.from_rollers, self.a)}
        yield identity(case.side, symbol="F/b", order=4, sensitivity=CHORD)
        q = case.fillet
        check = OwnFillet(name=q.label, symbol=q.symbol, unit=q.unit, fem=q.name, analytic=q.name,
                          formal=2, demand=FILLET[0], demand_reason=FILLET[1],
                          blur="fillet blur")  # fmt: skip
        yield Comparison(check=check, quantity=q, numbers=blur, shares=HALVES)
        for key, axis, name in (
            ("balance_x", "x", "Eq. 16 with the ring's hoop force: roller, hub, cuts, pressure"),
            ("balance_y", "y", "the same along the flat"),
            ("balance_roller", "x", "forces on an elastic roller"),
        ):
            yield balance(key, name, f"ΣF_{axis}", "N/mm", of={"side": self.side}, bound=1e-8,
                          because=BALANCE)  # fmt: skip
        yield fact("a wider support takes more of the pressure", "Δη", wider)

    def _series(self) -> Iterator[Comparison]:
        """Complex potentials with Hertz's patch, rollers rigid and elastic."""
        case, soft = LockedPolyhedralRing, self.soft
        alone = State(self.alone, "alone", "under pressure alone")
        elastic = State(soft, "elastic", "elastic rollers under pressure alone")
        roller = self._roller
        rigid = Expected(*about(0.0, roller.reach(self.a)), FORCES)
        both = Expected(*about(0.0, roller.reach(soft.a, soft.a_race)), FORCES)
        hertz = Expected(*roller.on_ring(WIDTH, self.a), CONTACT)
        peak = Expected(*roller.on_ring(PEAK, self.a), CONTACT)
        bent = {"bent": roller.bent(R_b=self.R_b, e=self.e), "shares": HALVES}
        rows: tuple[tuple[Quantity, str, Any, State | None, dict[str, Any]], ...] = (
            (case.N, "force of a roller under pressure, series", rigid, alone, {}),
            (case.efficiency, "share of further pressure that reaches the rollers, series", rigid,
             alone, {}),
            (case.N, "force of a roller under pressure and hub, series", rigid, None,
             {"shares": HALVES}),
            (case.hub_share, "share of a further hub force that reaches the rollers, series", rigid,
             None, {"shares": HALVES}),
            (case.a, "half-width of the roller's contact, Hertz", hertz, None, bent),
            (case.p_0, "pressure between roller and ring, Hertz", peak, None, bent),
            (case.N, "force of an elastic roller under pressure, series", both, elastic, {}),
            (case.efficiency, "share of further pressure that reaches elastic rollers, series",
             both, elastic, {}),
            (case.a, "half-width of an elastic roller's contact on the ring, Hertz",
             Expected(*roller.on_ring(WIDTH, soft.a, elastic=True), CONTACT), elastic, {}),
            (case.a_race, "half-width of an elastic roller's contact on the race, Hertz",
             Expected(*roller.on_race(soft.a_race), RACE), elastic, {"symbol": "a"}),
        )  # fmt: skip
        for q, name, expected, state, more in rows:
            yield within_band(q, name, expected, state=state, **{"shares": PLANE} | more)

    def _flat(self) -> Iterator[Comparison]:
        """The paper's forces, which leave out the ring's hoop force."""
        case, touch = LockedPolyhedralRing, self.alone.locked.touch
        for q, where, reference, series, R_b in (
            (case.F, "without the hub", "N_alone", self.alone.N, 0.0),
            (case.N_16, "with the hub", "N", self.N, self.R_b),
        ):
            statics = flat.roller_force(
                p=self.p_t, touch=touch, d_i=self.d_i, z=self.z, R_b=R_b, tan_phi=self.tan_phi
            )
            slack = self._roller.reach(self.a)
            interval = over_series(statics, series, slack) if series > 0 else (0.0, 0.0)
            yield within_band(
                q, f"force of a roller, Eqs. 13 and 16 {where}", reference=reference, symbol="N/b",
                expected=Expected(*interval, SERIES, sharp=series > 0),
            )  # fmt: skip

    @property
    def _roller(self) -> RollerOnRing:
        return RollerOnRing(d=self.d, d_e=self.d_e, j_D=self.j_D, apothem=self.apothem, E=self.E,
                            nu=self.nu)  # fmt: skip

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
        """Where the rollers are loose, and where parts yield."""
        if not self.alone.N > 0:
            yield (
                f"p_t = {self.shown('p_t')} is below {self.shown('p_1r')}, at which the ring "
                "reaches its rollers: pressure alone does not lock them"
            )
        yield from of_fillets(self.fillet, E=self.E, R_p=self.R_p, when="")
        if self.p_0 > STATIC_RATING:
            yield (
                f"p_0 = {self.shown('p_0')} is beyond 4000 MPa, the static rating of hardened "
                "rollers (ISO 76)"
            )

    def refusal(self) -> str:
        """Rows compare forces of rollers, which there must be."""
        touch = self.alone.locked.touch
        if self.p_t < PRESSED * touch:
            return (
                f"p_t = {self.shown('p_t')} hardly presses the rollers, if at all: the ring "
                f"reaches them at {touch / 1e6:.4g} MPa and is compared from "
                f"{PRESSED * touch / 1e6:.4g} MPa on, check it without --fem"
            )
        return ""


def wider(context: Context) -> tuple[float, float]:
    """How much more of the pressure the widest roller's contact takes than the narrowest's."""
    eta = figures.curves(context.fem)["rollers"][1]
    v = context.series("efficiency_alone")[1]
    return float(eta[-1] - eta[0]), 3 * abs(v[-1] - v[-3])


def within_band(
    q: Quantity, name: str, expected: Expected, *, state: State | None = None, reference: str = "",
    symbol: str = "", bent: float = 0.0, shares: str = "",
) -> Comparison:  # fmt: skip
    """A quantity whose error lies in a band; `reference` and `symbol` are its own by default."""
    limits = (expected.low, expected.high) if expected.sharp else None
    key = key_of(q, state)
    check = OwnFormula(
        name=name, symbol=symbol or q.symbol, unit=q.unit, fem=reference or key, analytic=key,
        formal=2, interval=lambda *_: limits, source=expected.source, bent=lambda *_: bent,
    )  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, shares=shares)


LOCKING = adapted(LockedPolyhedralRing)
