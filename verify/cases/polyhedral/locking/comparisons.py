"""Comparisons of the locked ring: series, Hertz and paper against finite elements."""

from collections.abc import Iterator
from typing import Any

from analytic.bounds.polyhedral import flat
from analytic.bounds.polyhedral.contacts import PEAK, WIDTH, RollerOnRing, over_series
from analytic.bounds.polyhedral.contacts import about as around
from verify.case import (
    Comparison,
    Expected,
    Quantity,
    State,
    about,
    approximation,
    balance,
    fact,
    identity,
)
from verify.cases.polyhedral.locking import figures
from verify.cases.polyhedral.locking.formulas import LockedFormulas
from verify.core.case import Check, Context
from verify.form.comparisons import key_of
from verify.judging.bands import OwnFillet, OwnFormula

NEAR, ARC = 1e-4, "balance of forces: arc length between two corners in place of the side length"
CHORD = 1e-3, "statics: the pressure acts on the chord between two corners"
FILLET = 5e-3, "a change of the peak stress by 0.5 % would show a wrong fillet radius"
BALANCE = "accepted residual; the contact law is satisfied except for round-off"
HALVES = "plane stress; half of the hub force on each side of the middle of the flat"
PLANE = "plane stress, rigid race, no friction at the rollers"
FORCES = (
    "estimated: ± ((2 a/d)² for the curvature of the roller + (a/wall)² for the wall + 1e-3 for "
    "Hertz's elliptic pressure)"
)
SERIES = (
    "derived: value from the balance of forces on a rigid flat, divided by the value of the series "
    "under equal loads; ± the error estimated for the series"
)
CONTACT = (
    "derived: error of first order in βκa, with Dundurs' constant β and the curvature κ of the "
    "contact line; ± ((2 a/d)² + (a/wall)² + 1e-3 + j_D/d_e (1 + R/wall)), where the last term is "
    "the effect of strain and bending of the ring; R is the relative radius of roller and ring"
)
RACE = (
    "derived: error of first order in βκa, with Dundurs' constant β and the curvature κ of the "
    "contact line; ± ((2 a/d)² + 1e-3)"
)
ROUND = "derived: (K_mid − 1) p_1 divided by the blocking pressure p_2, with K_mid by the series"
WIDE = "the error of Hertz's theory or of a straight wall is not small"


def comparisons(self: LockedFormulas) -> Iterator[Comparison | Check]:
    """Rows: series, Hertz and paper against finite elements."""
    yield from _series(self)
    yield from _flat(self)
    case = LockedFormulas
    blur = {"fillet blur": _roller(self).fillet_blur(self.from_rollers, self.a)}
    yield identity(case.side, symbol="F/b", order=4, sensitivity=CHORD)
    arc = flat.arc_of_side(self.d_i, self.z)
    yield approximation(
        case.side_printed, "side", name="resultant of the pressure on a side, Eq. 13 as printed",
        symbol="F/b", order=4, expected=about(arc - 1, NEAR, ARC),
    )  # fmt: skip
    q = case.fillet
    check = OwnFillet(name=q.label, symbol=q.symbol, unit=q.unit, fem=q.name, analytic=q.name,
                      formal=2, demand=FILLET[0], demand_reason=FILLET[1],
                      blur="fillet blur", wide=WIDE)  # fmt: skip
    yield Comparison(check=check, quantity=q, numbers=blur, shares=HALVES)
    for key, axis, name in (
        ("balance_x", "x", "balance of forces normal to the flat: Eq. 16 with hoop forces added"),
        ("balance_y", "y", "balance of forces along the flat"),
        ("balance_roller", "x", "balance of forces on an elastic roller"),
    ):
        yield balance(key, name, f"ΣF_{axis}", "N/mm",
                      of={"the force of the pressure p_t on a side": self.side}, bound=1e-8,
                      because=BALANCE)  # fmt: skip
    yield fact("incremental load-transfer ratio is larger with the widest contact than with the "
               "narrowest", "Δη", wider)  # fmt: skip


def _series(self: LockedFormulas) -> Iterator[Comparison]:
    """Rows: complex potentials with Hertz's contact, for rigid and for elastic rollers."""
    case, soft = LockedFormulas, self.soft
    alone = State(self.alone, "alone", "under pressure alone")
    elastic = State(soft, "elastic", "elastic rollers under pressure alone")
    roller = _roller(self)
    rigid = Expected(*around(0.0, roller.reach(self.a)), FORCES)
    both = Expected(*around(0.0, roller.reach(soft.a, soft.a_race)), FORCES)
    hertz = Expected(*roller.on_ring(WIDTH, self.a), CONTACT)
    peak = Expected(*roller.on_ring(PEAK, self.a), CONTACT)
    bent = {"bent": roller.bent(R_b=self.R_b, e=self.e), "shares": HALVES}
    rows: tuple[tuple[Quantity, str, Any, State | None, dict[str, Any]], ...] = (
        (case.N, "force of a roller under pressure, series", rigid, alone, {}),
        (case.efficiency, "incremental load-transfer ratio, pressure to rollers, series", rigid,
         alone, {}),
        (case.N, "force of a roller under pressure and hub force, series", rigid, None,
         {"shares": HALVES}),
        (case.hub_share, "incremental load-transfer ratio, hub to rollers, series", rigid,
         None, {"shares": HALVES}),
        (case.a, "half-width of the contact between roller and ring, Hertz", hertz, None, bent),
        (case.p_0, "peak pressure between roller and ring, Hertz", peak, None, bent),
        (case.N, "force of an elastic roller under pressure, series", both, elastic, {}),
        (case.efficiency, "incremental load-transfer ratio, pressure to elastic rollers, series",
         both, elastic, {}),
        (case.a, "half-width of the contact between elastic roller and ring, Hertz",
         Expected(*roller.on_ring(WIDTH, soft.a, elastic=True), CONTACT), elastic, {}),
        (case.a_race, "half-width of the contact between elastic roller and race, Hertz",
         Expected(*roller.on_race(soft.a_race), RACE), elastic, {"symbol": "a"}),
    )  # fmt: skip
    for q, name, expected, state, more in rows:
        yield within_band(q, name, expected, state=state, **{"shares": PLANE} | more)


def _flat(self: LockedFormulas) -> Iterator[Comparison]:
    """Rows: pressure and forces of the paper, which neglects bending and hoop force."""
    case, soft = LockedFormulas, self.soft
    for reference, words, touch, plane in (
        ("p_2", "", self.p_1r, "plane stress"),
        (
            "p_2_long",
            ", against a long ring in plane strain",
            self.touch_long,
            "plane strain for a long ring",
        ),
    ):
        yield approximation(
            case.p_2_round, reference, name=f"blocking pressure, Eq. 19 with K = 1{words}",
            order=4, expected=_of_round_ring(self, touch), shares=plane,
        )  # fmt: skip
    reach = _roller(self).reach
    rigid, elastic = reach(self.a), reach(soft.a, soft.a_race)
    for q, words, reference, locked, R_b, slack in (
        (case.F, "a roller, Eqs. 13 and 16 without hub force", "N_alone", self.alone, 0.0, rigid),
        (case.N_16, "a roller, Eqs. 13 and 16 with hub force", "N", self, self.R_b, rigid),
        (case.F, "an elastic roller, Eqs. 13 and 16 without hub force", "N_elastic", soft, 0.0,
         elastic),
    ):  # fmt: skip
        statics = flat.roller_force(
            p=self.p_t, touch=self.alone.locked.touch, d_i=self.d_i, z=self.z, R_b=R_b,
            tan_phi=self.tan_phi,
        )  # fmt: skip
        interval = over_series(statics, locked.N, slack) if locked.N > 0 else (0.0, 0.0)
        yield within_band(
            q, f"force of {words}", reference=reference, symbol="N/b",
            expected=Expected(*interval, SERIES, sharp=locked.N > 0),
        )  # fmt: skip


def _of_round_ring(self: LockedFormulas, touch: float) -> Expected:
    """Expected error of Eq. 19 with p_1 if the ring reaches the rollers at `touch` [Pa]."""
    left = self.p_t - touch
    if left <= 0:
        return Expected(0.0, 0.0, ROUND, sharp=False)
    return about((touch - self.p_1) / left, NEAR, ROUND)


def _roller(self: LockedFormulas) -> RollerOnRing:
    return RollerOnRing(d=self.d, d_e=self.d_e, j_D=self.j_D, apothem=self.apothem, E=self.E,
                        nu=self.nu)  # fmt: skip


def wider(context: Context) -> tuple[float, float]:
    """Load-transfer ratio of the widest contact minus that of the narrowest; its uncertainty."""
    eta = figures.curves(context.fem)["rollers"][1]
    v = context.series("efficiency_alone")[1]
    return float(eta[-1] - eta[0]), 3 * abs(v[-1] - v[-3])


def within_band(
    q: Quantity, name: str, expected: Expected, *, state: State | None = None, reference: str = "",
    symbol: str = "", bent: float = 0.0, shares: str = "",
) -> Comparison:  # fmt: skip
    """Row that compares `q` with finite elements; its error must lie in the interval `expected`.

    `reference` and `symbol` default to those of `q`.
    """
    limits = (expected.low, expected.high) if expected.sharp else None
    key = key_of(q, state)
    check = OwnFormula(
        name=name, symbol=symbol or q.symbol, unit=q.unit, fem=reference or key, analytic=key,
        formal=2, interval=lambda *_: limits, source=expected.source, bent=lambda *_: bent,
        wide=WIDE,
    )  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, shares=shares)
