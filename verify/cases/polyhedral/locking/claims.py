"""What is claimed of the locked ring, and what is left of it on rings of one's own."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from verify.cases.polyhedral.locking import bounds
from verify.cases.polyhedral.locking.figures import curves
from verify.core.case import Context, Values
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.checks import Approximation, Exact, Fact, Identity

LOOSE = 0.05  # half of a band from which on a formula is shown, not judged
FINER = 0.5  # of half a band: meshes that resolve less cannot tell
WIDE = "what Hertz or a straight wall neglects is no longer small"
TWICE = 2.2  # half bands: what a formula can move by inside its band, with a margin


def undecided(rows: list[Row], band: tuple[float, float]) -> list[Row]:
    """`rows` of a ring of one's own: what meshes leave undecided about the `band` is shown."""
    row, half = rows[0], (band[1] - band[0]) / 2
    if row.grid is None or not row.fem or row.analytic is None:
        return rows
    steady = row.grid.behaviour not in ("diverging", "short")
    m, U = row.analytic / row.fem - 1, judge.expanded(row.u_num or 0.0) / abs(row.fem)
    outside = max(band[0] - m, m - band[1]) > U
    if steady and (outside or (FINER * half > U and row.status is not Status.FAIL)):
        return rows
    told = f"meshes resolve {U:.2g}" if steady else "meshes do not settle"
    reason = f"measured: {m:+.2%}; {told} where the formula allows {half:.2g}"
    return [
        replace(r, status=Status.SHOWN, reason=reason) if r.status is Status.FAIL else r
        for r in rows
    ]


def too_wide(rows: list[Row]) -> list[Row]:
    """`rows` of a claim whose band is no longer small: shown, but for convergence that holds."""
    first, *others = rows
    told = [first, *(row for row in others if row.status is Status.FAIL)]
    kept = [row for row in others if row.status is not Status.FAIL]
    shown = [replace(r, status=Status.SHOWN, reason=f"{r.reason}; {WIDE}") for r in told]
    return shown + kept


@dataclass(frozen=True, kw_only=True)
class OwnFormula(Approximation):
    """A formula with a band; on a ring of one's own the demand is that band where it is larger.

    `bent` [1] is what such a ring's bending adds to the band.
    """

    bent: Callable[[Any, Values], float] | None = None

    def band(self, q: Any, v: Values) -> tuple[float, float] | None:
        """The band on a ring of one's own, None where it is no longer small."""
        band = self.interval and self.interval(q, v)
        if not band:
            return None
        more = self.bent(q, v) if self.bent else 0.0
        low, high = band[0] - more, band[1] + more
        return (low, high) if high - low < 2 * LOOSE else None

    def rows(self, context: Context) -> list[Row]:
        if context.is_paper:
            return super().rows(context)
        band = self.band(context.inputs, context.analytic)
        widened = replace(self, interval=lambda _q, _v: band, bent=None)
        rows = Approximation.rows(widened, context)
        if band:
            return undecided(rows, band)
        return too_wide(rows)

    def demanded(self, context: Context) -> float:
        usual = super().demanded(context)
        band = None if context.is_paper else self.band(context.inputs, context.analytic)
        return max(usual, TWICE * (band[1] - band[0]) / 2) if band else usual


@dataclass(frozen=True, kw_only=True)
class OwnFillet(Identity):
    """A largest stress; on a ring of one's own it may miss what Hertz's neglect makes of N.

    `blur` is the analytic key of that, a standard uncertainty over the stress.
    """

    blur: str

    def rows(self, context: Context) -> list[Row]:
        if context.is_paper:
            return super().rows(context)
        blur = 2 * context.analytic[self.blur]
        rows = Identity.rows(replace(self, residual=self.blur), context)
        if blur < LOOSE:
            return undecided(rows, (-blur, blur))
        return too_wide(rows)

    def demanded(self, context: Context) -> float:
        usual = super().demanded(context)
        return usual if context.is_paper else max(usual, 2 * TWICE * context.analytic[self.blur])


def wider(context: Context) -> tuple[float, float]:
    """How much more of the pressure the widest roller's contact takes than the narrowest's."""
    eta = curves(context.fem)["rollers"][1]
    v = context.series("efficiency")[1]
    return float(eta[-1] - eta[0]), 3 * abs(v[-1] - v[-3])


def series(
    name: str, symbol: str, unit: str, key: str, widths: tuple[str, ...] = ("a",)
) -> OwnFormula:
    return OwnFormula(name=name, symbol=symbol, unit=unit, fem=key, analytic=key, formal=2,
                      interval=bounds.within(*widths), source=bounds.FORCES)  # fmt: skip


def hertz(
    name: str, symbol: str, unit: str, key: str, interval: bounds.Interval, *,
    source: str = bounds.CONTACT, bent: Callable[[Any, Values], float] | None = None,
) -> OwnFormula:  # fmt: skip
    return OwnFormula(name=name, symbol=symbol, unit=unit, fem=key, analytic=key, formal=2,
                      interval=interval, source=source, bent=bent)  # fmt: skip


BOTH = ("a elastic", "a race")

CHECKS = (
    series("force of a roller under pressure, series", "N/b", "N/mm", "N"),
    series("share of further pressure that reaches the rollers, series", "η", "1", "efficiency"),
    series("force of a roller under pressure and hub, series", "N/b", "N/mm", "N with hub"),
    series("share of a further hub force that reaches the rollers, series", "η_h", "1",
           "hub share"),
    hertz("half-width of the roller's contact, Hertz", "a", "µm", "a",
          bounds.on_ring(bounds.WIDTH, "a"), bent=bounds.bent),
    hertz("pressure between roller and ring, Hertz", "p_0", "MPa", "p_0",
          bounds.on_ring(bounds.PEAK, "a"), bent=bounds.bent),
    series("force of an elastic roller under pressure, series", "N/b", "N/mm", "N elastic", BOTH),
    series("share of further pressure that reaches elastic rollers, series", "η", "1",
           "efficiency elastic", BOTH),
    hertz("half-width of an elastic roller's contact on the ring, Hertz", "a", "µm", "a elastic",
          bounds.on_ring(bounds.WIDTH, "a elastic", elastic=True)),
    hertz("half-width of an elastic roller's contact on the race, Hertz", "a", "µm", "a race",
          bounds.on_race(bounds.WIDTH, "a race"), source=bounds.RACE),
    OwnFormula(name="force of a roller, Eqs. 13 and 16 without the hub", symbol="N/b",
                  unit="N/mm", fem="N", analytic="F", formal=2,
                  interval=bounds.predicted("N", hub=False), source=bounds.SERIES),
    OwnFormula(name="force of a roller, Eqs. 13 and 16 with the hub", symbol="N/b",
                  unit="N/mm", fem="N with hub", analytic="N Eq. 16", formal=2,
                  interval=bounds.predicted("N with hub", hub=True), source=bounds.SERIES),
    Identity(name="resultant of the pressure on a side, Eq. 13", symbol="F/b", unit="N/mm",
             fem="side", analytic="side", formal=4, demand=1e-3,
             demand_reason="statics: pressure on the chord between two corners"),
    OwnFillet(name="largest hoop stress in the fillets, locked", symbol="σ_max", unit="MPa",
              fem="fillet", analytic="fillet", formal=2, demand=5e-3, blur="fillet blur",
              demand_reason="a peak stress: half a per cent tells fillets apart"),
    Exact(name="Eq. 16 with the ring's hoop force: roller, hub, cuts, pressure", symbol="ΣF_x",
          unit="N/mm", fem="balance x", scale="side", bound=1e-8,
          bound_reason="acceptance figure; contact met to round-off"),
    Exact(name="the same along the flat", symbol="ΣF_y", unit="N/mm", fem="balance y",
          scale="side", bound=1e-8, bound_reason="acceptance figure; contact met to round-off"),
    Exact(name="forces on an elastic roller", symbol="ΣF_x", unit="N/mm", fem="balance roller",
          scale="side", bound=1e-8, bound_reason="acceptance figure; contact met to round-off"),
    Fact(name="a wider support takes more of the pressure", symbol="Δη", unit="1", margin=wider),
)  # fmt: skip
