"""What is claimed of the whole clutch: formulas and series beside finite elements."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from analytic.polyhedral.capacity import Driven
from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.cases.polyhedral.clutch.statics import filleted, first_design
from verify.core.case import Context, Values
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.checks import Approximation, Exact

BLUNT = 1e-3  # what the semi-ellipse of Hertz may miss at least
LOOSE = 0.1  # slack from which on a formula is shown, not judged
PEAK = 2e-3  # of a largest stress: the polynomial along the fillet and the mesh's own error
NO_LIMIT = "the side without a value sets no limit: the hub's friction locks"


def slack(q: ClutchInputs, hub: Driven, N: float) -> float:
    """What Hertz neglects of the closure under N [N/m], as a share.

    (2 a/d)² on ring and race, (a/wall)² and 1e-3.
    """
    a, wall = hub.contact.half_width(N), q.d_e / 2 - q.ring.apothem
    ends = a**2 + hub.contact.half_width_on_race(N) ** 2
    return 4 * ends / q.d**2 + (a / wall) ** 2 + BLUNT


@dataclass(frozen=True, kw_only=True)
class Claimed(Approximation):
    """A formula that Hertz's neglect blurs by `give`; shown where it has no value or much blur.

    On parameters of one's own the demand is that blur, both ways, where it is larger than usual.
    """

    give: str

    def rows(self, context: Context) -> list[Row]:
        given, found = context.analytic.get(self.analytic), context.fem[-1].values.get(self.fem)
        if given is not None and all(self.fem in level.values for level in context.fem):
            return super().rows(context)
        verdict = judge.Verdict(Status.SHOWN, NO_LIMIT)
        return [self._row(context.case, self.kind, verdict, analytic=given, fem=found)]

    def demanded(self, context: Context) -> float:
        usual = super().demanded(context)
        return usual if context.is_paper else max(usual, 2.2 * context.analytic[self.give])


Expected = Callable[[ClutchInputs, Values], float]


def predicted(expected: Expected, series: str, give: str) -> Callable[[ClutchInputs, Values], Any]:
    """Interval of a formula's error: what it should give, by other means, beside the series."""

    def interval(q: ClutchInputs, v: Values) -> tuple[float, float] | None:
        if not v[series] > 0:
            return 0.0, 0.0  # finite elements have a force, or they would not have been asked
        if v[give] > LOOSE:
            return None
        m = expected(q, v) / v[series] - 1
        return m - (1 + m) * v[give], m + (1 + m) * v[give]

    return interval


def stress(_: ClutchInputs, v: Values) -> tuple[float, float] | None:
    """The same of the fillets' stress, of which roller and hub make the part "driven"."""
    if not v["slack"] < LOOSE:
        return None
    give = PEAK + v["driven"] * v["slack"]
    return -give, give


HERTZ = "argued: (2 a/d)² of each contact, (a/wall)² and 1e-3 of the closure, times what it moves"
STATICS = (
    "vectors of pressure, hub and roller on a flat in balance, over the series; the same slack"
)


def row(
    name: str, symbol: str, unit: str, formula: str, fem_key: str, *,
    expected: Expected | None = None, give: str = "slack",
) -> Claimed:  # fmt: skip
    interval = predicted(expected or (lambda _, v: v[fem_key]), fem_key, give)
    return Claimed(name=name, symbol=symbol, unit=unit, fem=fem_key, analytic=formula, give=give,
                   formal=2, interval=interval, source=STATICS if expected else HERTZ)  # fmt: skip


CHECKS = (
    row("torque of the elastic ring, series", "M_t", "N m", "M series", "M series"),
    row("torque with rigid rollers, series", "M_t", "N m", "M rigid", "M rigid",
        give="slack rigid"),
    row("force of a roller, series", "N", "N", "N series", "N series"),
    row("pressure for the torque that is wanted, series", "p_t", "MPa", "p series", "p series",
        give="slack p"),
    row("torque, Eq. 20", "M_t", "N m", "M Eq. 20", "M series",
        expected=lambda q, v: filleted(q, v["touch"]).torque(q.p_t)),
    row("torque of the first design, Eq. 21", "M_t", "N m", "M Eq. 21", "M series",
        expected=lambda q, _: first_design(q).torque(q.p_t)),
    row("pressure for the torque that is wanted, Eqs. 17 to 20", "p_t", "MPa", "p Eq. 20",
        "p series", give="slack p", expected=lambda q, v: filleted(q, v["touch"]).pressure(q.M_t)),
    Claimed(name="largest hoop stress in the fillets", symbol="σ_max", unit="MPa", fem="fillet",
            analytic="fillet", formal=2, interval=stress, give="slack", source=
            "2e-3 of a peak stress between meshes, and what Hertz's neglect makes of the force"),
    *(
        Exact(name=f"balance of half a sector, {x}", symbol=f"ΣF_{x}", unit="N/mm",
              fem=f"balance {x}", scale="side", bound=1e-8,
              bound_reason="acceptance figure; contact met to round-off")
        for x in "xy"
    ),
    Exact(name="moments of hub and rollers about the axis", symbol="ΣM", unit="N m", fem="moment",
          scale="M series", bound=1e-9, bound_reason="statics: Eq. 14's lever and angle"),
)  # fmt: skip
