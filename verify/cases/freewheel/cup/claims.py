"""The claims about a drawn-cup clutch: at equal torque, force and angle, and at the summit."""

from collections.abc import Callable
from typing import Any

from verify.cases.freewheel.cup.expected import CupExpected, at_largest, under_force, under_torque
from verify.cases.freewheel.cup.inputs import CupInputs
from verify.cases.freewheel.cup.model import given_angle
from verify.cases.freewheel.torque.claims import ALIKE, BOTH, OTHER, accepted, no_load
from verify.cases.freewheel.torque.model import STRAIGHT, Interval, times
from verify.core.case import Context, Values
from verify.judging.checks import Approximation, Exact, Fact, Limit
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import suites

BRACKET = "rings that enclose the cup, with a column below the flat; winding up; (a/r)² of Hertz"
ENCLOSED = "rings enclose a cup to some per cent, and torques near the summit multiply that"
FINE, NEARLY, MEDIUM, COARSE = 0.015, 0.02, 0.04, 0.06  # what rows are asked to show
WIDE = 0.12  # a/r up to which finite elements, small in displacements, are judged at the summit


def known(q: CupInputs, interval: Interval, widest: float) -> Interval | None:
    """The interval, but for one's own cup that its neighbours enclose too widely to judge by."""
    wide = interval[1] - interval[0] > widest
    return None if wide and q != CupInputs() else interval


def row(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[CupInputs], Interval],
    demand: float = DEMAND, **more: Any,
) -> Approximation:  # fmt: skip
    """A row with its `demand`, which near it the paper's own cup meets the suite's with."""
    told: dict[str, Any] = {"analytic": key, "fem": key, "source": BRACKET} | more
    if demand > NEARLY:
        told |= {"demand": demand, "demand_reason": ENCLOSED}
    elif demand > DEMAND:
        told |= {"own_demand": demand, "own_reason": ENCLOSED}
    return Approximation(
        name=name, symbol=symbol, unit=unit, formal=2,
        interval=lambda q, _v: known(q, interval(q), demand), **told,
    )  # fmt: skip


def at_force(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[CupExpected], Interval],
    demand: float = DEMAND,
) -> Approximation:  # fmt: skip
    return row(f"{name}, at N = T/(z R_s tan α_0)", symbol, unit, key,
               lambda q: interval(under_force(q)), demand)  # fmt: skip


def printed_torsion(q: CupInputs) -> Interval:
    """A flat taken for a circle of radius X_o: (R_s + X_o)/(2 X_o) times exact rolling."""
    return times(under_torque(q).torsion(), (q.R_s + q.X_o) / (2 * q.X_o), STRAIGHT)


def summit(q: CupInputs, _values: Values) -> Interval | None:
    """The largest torque's, where contacts are narrow there."""
    e = at_largest(q)
    wide = max(float(e.state.a_i), float(e.state.a_o)) / q.r > WIDE
    return None if wide else known(q, e.summit(), COARSE)


def margin(key: str) -> Callable[[Context], tuple[float, float]]:
    """A value that is positive, with how much the last meshes differ."""

    def of(context: Context) -> tuple[float, float]:
        before, now = (r.values[key] for r in context.fem[-2:])
        return now, 2 * abs(now - before)

    return of


CHECKS = (
    row("clamping angle under torque (Eq. 5 for a cup)", "α(T)", "deg", "alpha",
        lambda q: under_torque(q).under_torque("alpha"), FINE),
    row("normal force under torque (Eqs. 2, 3)", "F_n(T)", "N", "N",
        lambda q: under_torque(q).under_torque("N"), NEARLY),
    row("F_t/F_n, mean of both contacts (Eqs. 1, 2)", "F_t/F_n", "1", "F_t/N",
        lambda q: under_torque(q).slope(), FINE),
    row("way of the rollers (Eq. 6)", "s(T)", "µm", "s",
        lambda q: under_torque(q).under_torque("s"), COARSE),
    row("torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)", "φ(T)", "deg", "phi",
        lambda q: under_torque(q).torsion(), COARSE,
        source=f"{BRACKET}, tangential deformation of 0.5 to 1 tan²α"),
    row("torsion, Eq. 7 as printed, with R_s and X_o, against ∫dU/T", "φ(T)", "deg", "phi printed",
        printed_torsion, COARSE, fem="phi",
        source="rolling on a flat instead of on a circle: (R_s + X_o)/(2X_o)"),
    at_force("approach of roller and shaft", "d_i(N)", "µm", "d_i at N",
             lambda e: e.approach("d_i"), FINE),
    at_force("approach of roller and cup", "d_o(N)", "µm", "d_o at N",
             lambda e: e.approach("d_o"), COARSE),
    at_force("half-width on the shaft", "a_i", "µm", "a_i at N", CupExpected.contact, FINE),
    at_force("half-width on the cup", "a_o", "µm", "a_o at N", CupExpected.contact, FINE),
    at_force("peak pressure on the shaft", "p_i", "MPa", "p_i at N", CupExpected.contact, FINE),
    at_force("peak pressure on the cup", "p_o", "MPa", "p_o at N", CupExpected.contact, FINE),
    at_force("torque z R_s F_t (Eq. 3 for a cup)", "T(N)", "N m", "T at N", CupExpected.torque,
             FINE),
    row("normal force at a given angle", "F_n(ψ)", "N", "N at angle",
        lambda q: under_force(q).force_at_angle(given_angle(q)), MEDIUM),
    Approximation(name="largest torque, before the rollers go through", symbol="T_max", unit="N m",
                  analytic="T summit", fem="T summit", interval=summit, formal=2, source=BRACKET,
                  demand=COARSE, demand_reason=ENCLOSED),
    Limit(name="F_t/F_n becomes tan α_0 without load (Eq. 4 for a cup)", symbol="α_0", unit="1",
          points=no_load, exponent=1.0),
    Fact(name="the clamping angle falls from state to state", symbol="α", unit="1",
         margin=margin("falls")),
    Fact(name="the torque falls beyond its summit, the normal force growing", symbol="T", unit="1",
         margin=margin("past the summit")),
    accepted("F_t/F_n on the cup against tan(ψ/2)", "F_t/F_n", "flat's F_t/N", 2e-3,
             "its flat tilts under load:", of_fem=True),
    accepted("F_t/F_n on the shaft against tan(ψ/2)", "F_t/F_n", "race's F_t/N", 2e-3,
             "its surface tilts under load:", of_fem=True),
    accepted("torque against z R_s F_t of the shaft (Eq. 3 for a cup)", "T", "T on the race", 1e-3,
             "off by"),
    accepted("torque against z (F_n x − F_t X_o) of the cup (Eq. 3 for a cup)", "T", "T on the cam",
             1e-3, "off by", source=suites(OTHER)),
    accepted("normal forces of both contacts alike (Eq. 2)", "F_n", "unlike N", 1e-3, "apart by",
             by="the flat's", source=suites(ALIKE)),
    accepted("tangential forces of both contacts alike (Eq. 2)", "F_t", "unlike F_t", 4e-3,
             "surfaces tilt to either side of the bisector: apart by", by="the flat's",
             source=suites(BOTH)),
    accepted("∫dU/T against rolling", "φ", "rolling", 5e-3,
             "tangential forces deform contacts and wind up shaft and cup: rolling is off by"),
    Exact(name="balance of both contact forces on a roller", symbol="ΣF", unit="1", fem="forces",
          scale="one", bound=1e-9, bound_reason="the solver's balance of a free body"),
)  # fmt: skip
