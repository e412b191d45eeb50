"""Comparisons of the whole clutch: formulas and series against finite elements."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import inf, nan

import numpy as np

from analytic.bounds.polyhedral.contacts import PEAK_STRESS, RollerOnRing, over_series
from analytic.bounds.polyhedral.flat import FlatParts, filleted, first_design
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.fillet_stress import driven_fillet_stress
from verify.case import Comparison, Quantity, balance
from verify.cases.polyhedral.clutch.chain import PaperChain
from verify.cases.polyhedral.clutch.formulas import ElasticClutch
from verify.core.case import Context
from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.checks import Approximation

LOOSE = 0.1  # slack above which a formula is not judged
NO_LIMIT = (
    "a missing value means that pressure does not limit the torque: the clutch locks itself by "
    "friction of the hub"
)
HERTZ = (
    "estimated: ± ((2 a/d)² of each contact + (a/wall)² + 1e-3), which is the relative error of "
    "Hertz's theory for the deflection of the contacts, times the sensitivity of the result to "
    "this deflection"
)
STATICS = (
    "derived: value from the balance of forces on a rigid flat (pressure, hub, roller), divided by "
    "the value of the series; ± the error estimated for the series"
)
STRESS = (
    "estimated: ± (2e-3 for the mesh error of a peak stress + the part due to the error of Hertz's "
    "theory)"
)
BALANCE = "accepted residual; the contact law is satisfied except for round-off"
PLANE = "plane stress, rigid race; half of the hub force on each side of the middle of the flat"


class ClutchFormulas(PaperChain, ElasticClutch):
    """Formulas of the elastic clutch and of the paper, and errors that Hertz's theory causes."""

    @property
    def slack(self) -> float:
        """Relative error of `M_el` due to the error of Hertz's theory; nan without a torque."""
        return self._blur(self.hub, self.line_load)

    @property
    def slack_p(self) -> float:
        """Relative error that Hertz's theory causes in the pressure for the target torque."""
        N = self.line_need
        if not 0 < self.line_load < inf:
            return nan
        return self._neglect(self.hub, N) * self.hub.pressure_sensitivity(N)

    @property
    def slack_block(self) -> float:
        """Relative error due to Hertz's theory in the blocking pressure for the target torque."""
        return self.slack_p * self.p_need / self.p_block

    @property
    def slack_rigid(self) -> float:
        """Relative error that Hertz's theory causes in the torque with rigid rollers."""
        return self._blur(self.stiff, self.line_rigid)

    def _blur(self, hub: Driven, N: float) -> float:
        return self._neglect(hub, N) * hub.force_sensitivity(N) if 0 < N < inf else nan

    def _neglect(self, hub: Driven, N: float) -> float:
        """Relative error that Hertz's theory causes in the approach of bodies under N [N/m]."""
        roller = RollerOnRing(d=self.d, d_e=self.d_e, j_D=self.j_D, apothem=self.ring.apothem,
                              E=self.E, nu=self.nu)  # fmt: skip
        return roller.closure(hub.contact.half_width(N), hub.contact.half_width_on_race(N))

    @property
    def flat(self) -> FlatParts:
        """Loads and dimensions of the flats, for their balance of forces."""
        return FlatParts(z=self.z, d_i=self.d_i, D_i=self.D_i, b=self.b, e=self.e, mu=self.mu,
                         apothem=self.ring.apothem, phi_1=self.phi_1, alpha=self.alpha)  # fmt: skip

    def torque_of_first_design(self) -> float:
        """Torque [N m] under the assumption of Eq. 21 (rigid flat), by the balance of forces."""
        ring = {"d_m": self.ring.d_m, "wall": self.delta_1, "j_D": self.j_D, "E": self.E}
        return first_design(self.flat, **ring).torque(self.p_t)

    def pressure_over_the_arc(self) -> float:
        """Pressure [Pa] for the target torque with the arc of a side in place of its chord."""
        touch = self.touch
        rest = filleted(self.flat, touch).pressure(self.M_t) - touch
        return touch + rest / self.flat.arc

    @property
    def from_rollers(self) -> float:
        """Fraction of the fillet stress that rollers and hub cause; nan without a roller force."""
        if not 0 < self.line_load < inf:
            return nan
        return abs(1 - driven_fillet_stress(self.hub, 0.0, self.p_t) / self.fillet)


@dataclass(frozen=True, kw_only=True)
class Claimed(Approximation):
    """Comparison of a formula; `give` is the name of the half-width of its error interval.

    The interval results from the error of Hertz's theory. A formula without a value is not judged.
    For user inputs, the required sensitivity is at least twice the half-width.
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


Interval = tuple[float, float] | None


def _claimed(
    q: Quantity, name: str, symbol: str, give: tuple[str, Callable[[], float]],
    interval: Callable[[], Interval], *, source: str = HERTZ, reference: str = "",
) -> Comparison:  # fmt: skip
    check = Claimed(
        name=name, symbol=symbol, unit="N" if q.unit == "kN" else q.unit, fem=reference or q.name,
        analytic=q.name, give=give[0], formal=2, interval=lambda *_: interval(), source=source,
    )  # fmt: skip
    shares = PLANE if source is not STATICS else ""
    return Comparison(check=check, quantity=q, numbers={give[0]: give[1]}, shares=shares)


def comparisons(self: ClutchFormulas) -> Iterator[Comparison]:
    """Rows: series, formulas of the paper, stress, balances."""
    case, arc = ClutchFormulas, self.flat.arc
    slack = ("slack", lambda: self.slack)
    rigid, p = ("slack rigid", lambda: self.slack_rigid), ("slack p", lambda: self.slack_p)
    block = ("slack block", lambda: self.slack_block)
    for q, name, symbol, give in (
        (case.M_el, "torque with elastic ring and rollers, series", "M_t", slack),
        (case.M_rigid, "torque with rigid rollers, series", "M_t", rigid),
        (case.N_el, "force of a roller, series", "N", slack),
        (case.p_need, "pressure for the target torque, series", "p_t", p),
    ):
        yield _claimed(q, name, symbol, give, _around(self, q, give[1], None))
    for q, name, symbol, give, series, statics in (
        (case.M_20, "torque, Eq. 20", "M_t", slack, case.M_el,
         lambda: filleted(self.flat, self.touch).torque(self.p_t)),
        (case.M_21, "torque of the first design, Eq. 21", "M_t", slack, case.M_el,
         self.torque_of_first_design),
        (case.p_20, "pressure for the target torque, Eqs. 17 to 20", "p_t", p, case.p_need,
         lambda: filleted(self.flat, self.touch).pressure(self.M_t)),
        (case.M_20_printed, "torque, Eq. 20 as printed", "M_t", slack, case.M_el,
         lambda: arc * filleted(self.flat, self.touch).torque(self.p_t)),
        (case.M_21_printed, "torque of the first design, Eq. 21 as printed", "M_t", slack,
         case.M_el, lambda: arc / self.z * self.torque_of_first_design()),
        (case.p_17_printed, "pressure for the target torque, Eq. 17 as printed", "p_t", p,
         case.p_need, self.pressure_over_the_arc),
        (case.p_17, "blocking pressure for the target torque, Eq. 17", "p_2", block, case.p_block,
         lambda: filleted(self.flat, self.touch).pressure(self.M_t) - self.touch),
        (case.p_17_arc, "blocking pressure for the target torque, Eq. 17 as printed", "p_2", block,
         case.p_block, lambda: self.pressure_over_the_arc() - self.touch),
    ):  # fmt: skip
        yield _claimed(q, name, symbol, give, _around(self, series, give[1], statics),
                       source=STATICS, reference=series.name)  # fmt: skip
    yield _claimed(case.fillet, "largest hoop stress in the fillets", "σ_max", slack,
                   lambda: _of_stress(self), source=STRESS)  # fmt: skip
    for x in "xy":
        yield balance(
            f"balance_{x}", f"balance of forces on half a sector, {x}", f"ΣF_{x}", "N/mm",
            bound=1e-8, of={"the force of the pressure p_t on a side":
                            self.p_t * self.ring.d_i * float(np.sin(np.pi / self.z))},
            because=BALANCE,
        )  # fmt: skip
    yield balance("moment", "balance of moments of hub and rollers", "ΣM", "N m",
                  of={"the torque by the series": self.M_el}, bound=1e-9,
                  because="statics with the lever and the angle of Eq. 14")  # fmt: skip


def _around(
    q: ClutchFormulas, series: Quantity, slack: Callable[[], float],
    statics: Callable[[], float] | None,
) -> Callable[[], Interval]:  # fmt: skip
    """Function that returns the interval of the error of a formula.

    The centre of the interval is the ratio of the value by `statics`, an independent derivation, to
    the value by the series, minus 1. Without `statics`, the centre is zero.
    """

    def interval() -> Interval:
        value, give = getattr(q, series.name), slack()
        if not value > 0:
            return 0.0, 0.0  # finite elements are used only with a positive force
        if give > LOOSE:
            return None
        return over_series(statics() if statics else value, value, give)

    return interval


def _of_stress(q: ClutchFormulas) -> Interval:
    """Interval of the error of the fillet stress; roller and hub cause a part of this stress."""
    if not q.slack < LOOSE:
        return None
    give = PEAK_STRESS + q.from_rollers * q.slack
    return -give, give
