"""The claims about a roller freewheel under torque: at equal torque, force and angle."""

from collections.abc import Callable
from typing import Any

import numpy as np

from verify.cases.freewheel.inputs import StarInputs
from verify.cases.freewheel.torque.model import (
    STRAIGHT,
    Expected,
    Interval,
    times,
    under_force,
    under_torque,
)
from verify.core.case import Context, Values
from verify.judging.checks import Approximation, Exact, Limit
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded, suites

BRACKET = "a layer and two discs that enclose the star, its winding up, (a/r)² of Hertz"
SHARP = "acceptance of the subject"
OTHER = "as the torque of the other contact"
ALIKE = "as the torque"
BOTH = "2e-3 of either contact"
NOISE = 5e-6  # of F_t/N, from mesh to mesh at least
WIDEST = 8e-3  # interval that leaves a row of one's own sharp enough


def known(q: StarInputs, interval: Interval) -> Interval | None:
    """The interval, but for one's own star that its neighbours enclose too widely to judge by."""
    wide = interval[1] - interval[0] > WIDEST
    return None if wide and q != StarInputs() else interval


def at_torque(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[Expected], Interval],
    **more: Any,
) -> Approximation:  # fmt: skip
    told: dict[str, Any] = {"analytic": key, "fem": key, "source": BRACKET} | more
    return Approximation(
        name=name, symbol=symbol, unit=unit, formal=2,
        interval=lambda q, _v: known(q, interval(under_torque(q))), **told,
    )  # fmt: skip


def at_force(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[Expected], Interval],
    **more: Any,
) -> Approximation:  # fmt: skip
    told: dict[str, Any] = {"analytic": key, "fem": key, "source": BRACKET} | more
    return Approximation(
        name=f"{name}, at N = T/(z R tan α_0)", symbol=symbol, unit=unit, formal=2,
        interval=lambda q, _v: known(q, interval(under_force(q))), **told,
    )  # fmt: skip


def printed_torsion(q: StarInputs, _values: Values) -> Interval | None:
    """A star's flat taken for a circle of radius X: (R + X)/(2 X) times exact rolling."""
    return known(q, times(under_torque(q).torsion(), (q.R + q.X) / (2 * q.X), STRAIGHT))


def printed_torque(q: StarInputs, _values: Values) -> Interval | None:
    """The normal force's lever left out: X/R of the torque."""
    return known(q, times(under_force(q).slope(tilted=True), q.X / q.R))


def no_load(context: Context) -> tuple[list[float], list[float], list[float]]:
    """(F_t/N)² of finite elements over tan² alpha_0, less 1, contacts overlapping less and less.

    Times R + X + d_o - d_i over R + X (race and flat), tan² alpha is linear in d_i + d_o.
    """
    q, tan = context.inputs, np.tan(context.analytic["alpha_0"])
    found = []
    for r in context.fem[-2:]:
        d_i, d_o = r.arrays["loads"][3:5]
        found.append(
            (r.arrays["shares"].mean(axis=0) / tan) ** 2 * (1 + (d_o - d_i) / (q.race + q.flat))
        )
    overlap, u = d_i + d_o, np.maximum(np.abs(found[1] - found[0]), NOISE)
    return (overlap / overlap[-1]).tolist(), (found[1] - 1).tolist(), u.tolist()


def ratio(key: str, most: float, what: str, *, of_fem: bool = False) -> Callable[[Context], Pair]:
    """A ratio less 1, `key`, of formula and finite elements; where `of_fem`, theirs over it.

    How much the last meshes differ is its uncertainty.
    """

    def pair(context: Context) -> Pair:
        before, now = (r.values[key] for r in context.fem[-2:])
        words = f"{what} {now:+.2%}, {most:.1%} accepted"
        return Pair(1 / (1 + now) if of_fem else 1 + now, 1.0, 2 * abs(now - before), words)

    return pair


def accepted(
    name: str,
    symbol: str,
    key: str,
    most: float,
    what: str,
    *,
    of_fem: bool = False,
    by: str = "",
    source: str = SUBJECT,
) -> Agreement:
    return Agreement(name=name, symbol=symbol, unit="1", accepted=most, by=by, source=source,
                     pair=ratio(key, most, what, of_fem=of_fem), **demanded(most))  # fmt: skip


CHECKS = (
    at_torque("clamping angle under torque (Eqs. 4, 5)", "α(T)", "deg", "alpha", Expected.angle,
              demand=0.002, demand_reason=SHARP),
    at_torque("normal force under torque (Eqs. 2, 3)", "F_n(T)", "N", "N", Expected.force),
    at_torque("way of the rollers (Eq. 6)", "s(T)", "µm", "s", Expected.way),
    at_torque("torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)", "φ(T)", "deg", "phi",
              Expected.torsion, source=f"{BRACKET}, tangential deformation of 0.5 to 1 tan²α"),
    Approximation(name="torsion, Eq. 7 as printed, against ∫dU/T", symbol="φ(T)", unit="deg",
                  analytic="phi printed", fem="phi", interval=printed_torsion, formal=2,
                  source="rolling on a flat instead of on a circle: (R + X)/(2X)", demand=0.03,
                  demand_reason="a formula 22 % off: three per cent show it"),
    at_force("approach of roller and star", "d_i(N)", "µm", "d_i at N",
             lambda e: e.approach("d_i"), demand=0.025,
             demand_reason="as sharp as three bodies that enclose the star are"),
    at_force("approach of roller and ring", "d_o(N)", "µm", "d_o at N",
             lambda e: e.approach("d_o")),
    at_force("half-width on the star", "a_i", "µm", "a_i at N", Expected.contact),
    at_force("half-width on the ring", "a_o", "µm", "a_o at N", Expected.contact),
    at_force("peak pressure on the star", "p_i", "MPa", "p_i at N", Expected.contact),
    at_force("peak pressure on the ring", "p_o", "MPa", "p_o at N", Expected.contact),
    at_force("torque z R F_t (Eq. 3, corrected)", "T(N)", "N m", "T at N",
             lambda e: e.slope(tilted=True)),
    Approximation(name="torque z X F_t of the star, Eq. 3 as printed, at N = T/(z R tan α_0)",
                  symbol="T(N)", unit="N m", analytic="T printed at N", fem="T at N",
                  interval=printed_torque, formal=2,
                  source="F_n misses the axis by x: X/R of the torque is left"),
    Approximation(name="normal force at a given angle", symbol="F_n(ψ)", unit="N",
                  analytic="N at angle", fem="N at angle", formal=2, source=BRACKET,
                  own_demand=0.02, own_reason=SHARP,
                  interval=lambda q, _v: known(q, under_force(q).force_at_angle())),
    Limit(name="statics: F_t/F_n becomes tan α_0 without load (Eqs. 1, 4)", symbol="α_0", unit="1",
          points=no_load, exponent=1.0),
    accepted("F_t/F_n on the star against tan(ψ/2)", "F_t/F_n", "flat's F_t/N", 2e-3,
             "small displacements leave room beside the contacts' middles:", of_fem=True),
    accepted("F_t/F_n on the ring against tan(ψ/2)", "F_t/F_n", "race's F_t/N", 2e-3,
             "small displacements leave room beside the contacts' middles:", of_fem=True),
    accepted("torque against z R F_t of the ring (Eq. 3, corrected)", "T", "T on the race", 1e-3,
             "off by"),
    accepted("torque against z (F_n x − F_t X) of the star (Eq. 3, corrected)", "T",
             "T on the cam", 1e-3, "off by", source=suites(OTHER)),
    accepted("normal forces of both contacts alike (Eq. 2)", "F_n", "unlike N", 1e-3, "apart by",
             by="the flat's", source=suites(ALIKE)),
    accepted("tangential forces of both contacts alike (Eq. 2)", "F_t", "unlike F_t", 4e-3,
             "the same to either side of the bisector: apart by", by="the flat's",
             source=suites(BOTH)),
    accepted("∫dU/T against rolling", "φ", "rolling", 5e-3,
             "tangential forces deform as well: rolling is off by"),
    Exact(name="balance of both contact forces on a roller", symbol="ΣF", unit="1", fem="forces",
          scale="one", bound=1e-9, bound_reason="the solver's balance of a free body"),
)  # fmt: skip
