"""The claims about a wedged sprag: at equal force through the stroke, and at equal torque."""

from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.sprag.closure import wedged
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.expected import SHARP, WIDEST, Expected, Interval, at_share, bending
from verify.cases.sprag.wedge.model import STROKE, elastic, rigid_force
from verify.core.case import Check, Context, Values
from verify.judging.checks import Accepted, Approximation, Exact, Fact
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import Agreement, Pair, suites

BENDS = "the column bends, its ends roll on: by complex potentials to a quarter of all parts"
YIELDS = "1e-3, (a/r)² and tan²ν/2, beside the elastic solutions of all parts"
TANGENTIAL = f"{YIELDS}; tangential deformation of 0.4 to 1.2 tan²ν"
HERTZ = "2e-3, and 2 (a/h)² of the smallest of radii, walls and width"
BETTI = "reciprocity: the mean is Lamé's wherever forces act; 1e-3 for what is of second order"
FULL, MOST = "N_0", "1.8 N_0"
WIDTH = f"{HERTZ}, no less than the 1 % that is accepted"
ONE = "1 % of Hertz is accepted"
RATIO, WORK = 2e-3, 5e-3  # accepted of force ratios and torque, and of the work
LIGHT, SLIDES = 1e-4, 1e-3  # accepted without load, and of the friction that just holds
ROLLERS = "a sprag's statics as sharp as those of a roller freewheel"
EDGE = 1  # order of what hangs on where a contact ends in a cell


def known(q: WedgeInputs, interval: Interval, demand: float) -> Interval | None:
    """The interval, but for one's own clutch of which too little is known to judge by."""
    wide = interval[1] - interval[0] > WIDEST * demand
    return None if wide and q != WedgeInputs() else interval


def of_own(demand: float, reason: str) -> dict[str, Any]:
    """What one's own clutch is asked to show."""
    return {"own_demand": demand, "own_reason": reason} if demand > DEMAND else {}


def through(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[Expected], Interval],
    source: str, *, fem: str = "", points: tuple[str, ...] = tuple(STROKE), formal: float = 2,
    own: float = DEMAND, reason: str = "", **more: Any,
) -> tuple[Check, ...]:  # fmt: skip
    """One row at each of the normal forces `points`; `own` is asked of one's own, for `reason`."""

    def row(point: str) -> Check:
        def expected(q: WedgeInputs, _values: Values) -> Interval | None:
            return known(q, interval(at_share(q, STROKE[point])), own)

        return Approximation(
            name=f"{name}, at {point}", symbol=symbol, unit=unit, analytic=f"{key}, {point}",
            fem=f"{fem or key}, {point}", formal=formal, source=source, interval=expected,
            **of_own(own, reason), **more,
        )  # fmt: skip

    return tuple(map(row, points))


def at_torque(
    name: str, symbol: str, unit: str, key: str, interval: Callable[[Expected], Interval],
    source: str, own: float = DEMAND, reason: str = "",
) -> Check:  # fmt: skip
    def expected(q: WedgeInputs, v: Values) -> Interval | None:
        return known(q, interval(Expected(q, v["N"])), own)

    return Approximation(
        name=f"{name}, at T", symbol=symbol, unit=unit, analytic=key, fem=key, formal=2,
        source=source, interval=expected, **of_own(own, reason),
    )  # fmt: skip


def no_load(context: Context) -> Pair:
    """tan(nu) of Eq. 10 over T_i/N_i in the lightest state: 1e-4 accepted."""
    clutch, found = elastic(context.inputs), []
    for result in context.fem[-2:]:
        N, _, share, *_ = result.arrays["loads"][:, 0]
        found.append(float(np.tan(wedged(clutch, N).nu) / share - 1))
    said = f"off by {found[1]:+.1e} at {N:.3g} N, 1e-4 accepted"
    return Pair(1 + found[1], 1.0, 2 * abs(found[1] - found[0]), said)


def ratio(key: str, most: float, what: str, *, of_fem: bool = False) -> Callable[[Context], Pair]:
    """A ratio less 1, `key`, of formula and finite elements; where `of_fem`, theirs over it.

    How much the last meshes differ is its uncertainty.
    """

    def pair(context: Context) -> Pair:
        before, now = (r.values[key] for r in context.fem[-2:])
        words = f"{what} {now:+.3%}, {most:.1%} accepted"
        return Pair(1 / (1 + now) if of_fem else 1 + now, 1.0, 2 * abs(now - before), words)

    return pair


def force_ratio(key: str) -> Callable[[Context], Pair]:
    """The strut's against that of finite elements, at its worst up to N_0."""
    names = [f"{key}, {point}" for point, share in STROKE.items() if share <= 1]

    def pair(context: Context) -> Pair:
        off = [{name: r.values[name] / context.analytic[name] - 1 for name in names}
               for r in context.fem[-2:]]  # fmt: skip
        before, now = (max(x.values(), key=abs) for x in off)
        worst = max(names, key=lambda name: abs(off[-1][name]))
        said = f"off by {now:+.2%} at most, {RATIO:.1%} accepted"
        found = context.fem[-1].values[worst]
        return Pair(context.analytic[worst], found, 2 * abs(now - before) * found, said)

    return pair


def force_ratio_bent(key: str) -> Callable[[Context], Pair]:
    """The strut's at 1.8 N_0 and what bending takes against that of finite elements."""

    def pair(context: Context) -> Pair:
        q, name = context.inputs, f"{key}, {MOST}"
        bent = bending(q, STROKE[MOST] * rigid_force(q)).whole
        before, now = (r.values[name] / context.analytic[name] - 1 for r in context.fem[-2:])
        said = f"off by {now:+.2%}, bending {bent:+.2%}: {RATIO:.1%} accepted of the rest"
        found = context.fem[-1].values[name]
        formula = context.analytic[name] * (1 + bent)
        return Pair(formula, found, 2 * abs(now - before) * found, said)

    return pair


def keeps_its_angle(context: Context) -> tuple[float, float, str]:
    """Least and largest force ratio of the stroke."""
    spread = [
        max(s) / min(s) - 1
        for s in ([r.values[f"tan nu, {p}"] for p in STROKE] for r in context.fem[-2:])
    ]
    said = f"T_i/N_i changes by {spread[1]:.2%} from N_0/4 to 1.8 N_0, 1 % accepted"
    return 0.01 - spread[1], 2 * abs(spread[1] - spread[0]), said


def inner_above_outer(context: Context) -> tuple[float, float]:
    """Least excess of p_i over p_o through the stroke, over p_o."""
    ratios = [
        min(r.values[f"p_i, {p}"] / r.values[f"p_e, {p}"] for p in STROKE) for r in context.fem[-2:]
    ]
    return ratios[1] - 1, 2 * abs(ratios[1] - ratios[0])


def onset(context: Context) -> Pair:
    """tan(nu) against the friction between what holds and what slides."""
    v = context.fem[0].values
    tan = float(np.tan(wedged(elastic(context.inputs), v["N at onset"]).nu))
    between, half = (v["holds"] + v["slides"]) / 2, abs(v["holds"] - v["slides"]) / 2
    said = f"holds at μ = {v['holds'] / tan:.4f} tan ν, slides out at {v['slides'] / tan:.4f} tan ν"
    return Pair(tan, between, half, said)


def agrees(
    name: str, symbol: str, pair: Callable[[Context], Pair], accepted: float, by: str = ""
) -> Agreement:
    return Agreement(name=name, symbol=symbol, unit="1", pair=pair, accepted=accepted, by=by,
                     source=suites(ROLLERS))  # fmt: skip


def of_a_race(which: str, race: str) -> tuple[Check, ...]:
    """What Eq. 6 says of a race at N_0, and what it leaves out."""
    symbol = f"δ_B{which.upper()}"
    return (
        *through(f"mean displacement of the {race} race (Eq. 6 as printed, thin)", symbol, "µm",
                 f"thin {which}", lambda e: e.thin(which), "plane stress for plane strain",
                 fem=f"mean {which}", points=(FULL,)),
        *through(f"displacement of the {race} race under a sprag", symbol, "µm", f"race {which}",
                 lambda e: e.race(which), "a ring under single loads; 1e-3 and (a/wall)²",
                 points=(FULL,)),
        *through(f"Eq. 6 alone for the {race} race under a sprag", symbol, "µm", f"thin {which}",
                 lambda e: e.thin_at_contact(which), "a ring under single loads",
                 fem=f"race {which}", points=(FULL,)),
    )  # fmt: skip


CHECKS: tuple[Check, ...] = (
    *through("T_i/N_i against the strut's tan ν (Eq. 10)", "tan ν", "1", "tan nu", Expected.angle,
             BENDS),
    *through("T_e/N_e against the strut's tan ω (Eq. 10)", "tan ω", "1", "tan omega",
             Expected.angle, BENDS),
    agrees("force ratio on the inner race against tan ν up to N_0", "tan ν",
           force_ratio("tan nu"), RATIO),
    agrees("force ratio on the outer race against tan ω up to N_0", "tan ω",
           force_ratio("tan omega"), RATIO),
    agrees("force ratio on the inner race at 1.8 N_0, but for the column's bending", "tan ν",
           force_ratio_bent("tan nu"), RATIO),
    agrees("force ratio on the outer race at 1.8 N_0, but for the column's bending", "tan ω",
           force_ratio_bent("tan omega"), RATIO),
    *through("excess of N_e over N_i, which the paper has equal", "N_e/N_i − 1", "1", "N_e/N_i",
             Expected.excess, BENDS, points=(FULL,), own=0.02,
             reason="an excess of 0.1 %, twice as blunt as the angles"),
    *through("torque n_s N tan(ν) OA", "T(N)", "N m", "T", Expected.torque, BENDS,
             points=(FULL, MOST)),
    at_torque("normal force (Eq. 10)", "N(T)", "N", "N", Expected.force, BENDS),
    at_torque("rotation of the sprags", "α(T)", "deg", "alpha", Expected.rotation_at_torque,
              YIELDS, own=0.02, reason="as sharp as N(T)"),
    *through("all yields of elastic bodies", "H(N)", "µm", "H", Expected.elastic, YIELDS,
             points=(FULL, MOST)),
    *through("rotation of the sprags with elastic yields", "α(N)", "deg", "alpha",
             Expected.elastic, YIELDS),
    *through("turn of the races by rolling, against n_s ∫dU/T", "θ(N)", "deg", "theta",
             Expected.turn, TANGENTIAL, own=0.015, reason="tangential compliance"),
    *through("rotation with half planes and Eq. 6, long", "α(N)", "deg", "alpha plane",
             Expected.plane, "elastic solutions of the same parts", fem="alpha", points=(FULL,)),
    *through("rotation with Eqs. 9, 10 as printed and elastic yields", "α(N)", "deg",
             "alpha printed", Expected.lost, "half of δ_HI and of δ_g left out of H", fem="alpha",
             points=(FULL,), own=0.02,
             reason="a formula 12 % off: two per cent show it"),
    Approximation(name="rotation with Palmgren's law, Eqs. 6 and 7, at N_0", symbol="α(N)",
                  unit="deg", analytic="alpha composite, N_0", fem="alpha, N_0", formal=2,
                  interval=None, source="Palmgren's law is of rollers of finite length"),
    Approximation(name="rotation as the paper has it, Palmgren's law in Eqs. 9, 10 as printed, "
                       "at T", symbol="α(T)", unit="deg", analytic="alpha printed", fem="alpha",
                  formal=2, interval=None,
                  source="too soft by a quarter, an eighth lost on the inner side"),
    *through("mean displacement of the inner race (Eq. 6, long)", "δ_BI", "µm", "mean i",
             lambda _: (-SHARP, SHARP), BETTI, points=(FULL, MOST)),
    *through("mean displacement of the outer race (Eq. 6, long)", "δ_BE", "µm", "mean e",
             lambda _: (-SHARP, SHARP), BETTI, points=(FULL, MOST)),
    *of_a_race("i", "inner"),
    *of_a_race("e", "outer"),
    *through("peak pressure on the inner race (Hertz)", "p_i", "MPa", "p_i", Expected.hertz, HERTZ,
             formal=EDGE, points=(FULL, MOST)),
    *through("peak pressure on the outer race (Hertz)", "p_o", "MPa", "p_e", Expected.hertz, HERTZ,
             formal=EDGE, points=(FULL, MOST)),
    *through("half-width on the inner race (Hertz)", "a_i", "µm", "a_i", Expected.width, WIDTH,
             formal=EDGE, points=(FULL,), own=0.02, reason=ONE),
    *through("half-width on the outer race (Hertz)", "a_o", "µm", "a_e", Expected.width, WIDTH,
             formal=EDGE, points=(FULL,), own=0.02, reason=ONE),
    Fact(name="the inner contact is pressed more than the outer, through the stroke", symbol="p_i",
         unit="1", margin=inner_above_outer),
    agrees("T_i/N_i becomes tan ν_0 without load (Eq. 10)", "ν_0", no_load, LIGHT),
    Accepted(name="the logarithmic spiral keeps its wedge angle", symbol="ν", unit="1",
             margin=keeps_its_angle),
    agrees("friction at which the sprag slides out against tan ν", "μ", onset, SLIDES),
    agrees("torque against n_s N tan(ν) OA of the strut where the sprag lies", "T",
           ratio("column", RATIO, "the column bends: off by", of_fem=True), RATIO),
    agrees("work ∫N dH on all yields against the elastic energy", "U",
           ratio("work", WORK, "tangential deformation takes the rest: off by"), WORK),
    Exact(name="balance of both contact forces on a sprag", symbol="ΣF", unit="1", fem="forces",
          scale="one", bound=1e-9, bound_reason="the solver's balance of a free body"),
    Exact(name="torque on the inner race against that on the outer", symbol="T", unit="1",
          fem="held", scale="one", bound=1e-3,
          bound_reason="forces act at surfaces a displacement apart"),
)  # fmt: skip
