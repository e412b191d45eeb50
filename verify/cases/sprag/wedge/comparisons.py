"""Rows of a wedged sprag: formulas and finite elements at equal normal force or equal torque."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from analytic.bounds.sprag.wedge import SHARP, Bounds, Interval
from verify.case import Comparison, Computed, Quantity, approximation, balance, fact, underived
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge import agreements as found
from verify.cases.sprag.wedge.formulas import KEYS, STROKE
from verify.cases.sprag.wedge.formulas import WedgeFormulas as Wedge
from verify.cases.sprag.wedge.model import bounds
from verify.judging.checks import Accepted
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import Agreement, suites

Bound = Callable[[Bounds], Interval]

BENDS = "bending of the sprag and rolling of its ends, computed with complex potentials, ± 25 %"
YIELDS = (
    "four errors of the elastic solutions: 1e-3, (a/r)², tan²ν/2, and the lateral motion of the "
    "sprag ends"
)
TANGENTIAL = (
    f"{YIELDS}; tangential deformation increases the wind-up by 0.4 tan²ν to 1.2 tan²ν (relative)"
)
HERTZ = "sum of 2e-3 and 2 (a/h)², where h is the smallest radius, wall thickness or width"
BETTI = (
    "by reciprocity, Lamé's mean displacement applies to any position of the forces; 1e-3 for "
    "effects of second order"
)
PALMGREN = "Palmgren's law applies to rollers of finite length"
RIGID = "races and sprag are rigid"
HALF_ARMS = "the printed lever arms are half of the radii"
PAPER = "the deflections are one quarter too large, but Eqs. 9, 10 omit one eighth of them"
FULL, MOST = "N_0", "1.8 N_0"
WIDTH = f"{HERTZ}; at least 1 %, the accepted error"
ONE = 0.02, "a difference of 1 % from Hertz is accepted"
BLUNT = 0.02, "the excess is only 0.1 %; twice the required sensitivity of the angles is sufficient"
AS_FORCE = 0.02, "same required sensitivity as N(T)"
SLIPPING = 0.015, "the formula neglects the tangential compliance of the contacts"
EIGHTH = 0.02, "2 % are sufficient for a formula with an error of 12 %"
ROLLERS = "same tolerance as for the statics of a roller freewheel"
EDGE = 1  # order of values that depend on the end of a contact within a cell
PLANE = "plane strain"
WIDEST = 1.5  # widest interval over the required sensitivity of a user's row
COLUMN = f"{PLANE}, the sprag as a column with rounded ends"


def expected(q: Any, bound: Bound, source: str, sensitivity: float) -> Computed:
    """Expected error: interval by `bound`; None for a user's clutch if the interval is too wide."""

    def interval() -> Interval | None:
        low, high = bound(bounds(q.part, q.N))
        wide = high - low > WIDEST * sensitivity
        return None if wide and q.part != WedgeInputs() else (low, high)

    return Computed(interval, source)


def through(
    q: Wedge, formula: Quantity, name: str, symbol: str, bound: Bound, source: str, *,
    reference: str = "", points: tuple[str, ...] = tuple(STROKE), order: float = 2,
    own: tuple[float, str] = (DEMAND, ""), shares: str = COLUMN,
) -> Iterator[Comparison]:  # fmt: skip
    """Rows that compare `formula` with its reference under each of the normal forces `points`."""
    compared = partial(approximation, own=own) if own[1] else approximation
    for point in points:
        state = q.stroke[point]
        yield compared(
            formula, f"{reference}_{KEYS[point]}" if reference else "", state=state,
            expected=expected(state.case, bound, source, own[0]), name=f"{name}, at {point}",
            symbol=symbol, order=order, shares=shares,
        )  # fmt: skip


def comparisons(q: Wedge) -> Iterator[Comparison]:
    """All rows of the case, in the order of the page."""
    yield from _angles(q)
    yield from _forces(q)
    yield from _rotations(q)
    yield from _of_rigid_races(q)
    yield from _races(q)
    yield from _contacts(q)
    yield from _statics()


def _angles(q: Wedge) -> Iterator[Comparison]:
    tan_nu, tan_omega = "force ratio T_i/N_i against tan ν", "force ratio T_e/N_e against tan ω"
    yield from through(q, Wedge.mu_i, f"{tan_nu} (Eq. 10)", "tan ν", Bounds.angle, BENDS)
    yield from through(q, Wedge.mu_e, f"{tan_omega} (Eq. 10)", "tan ω", Bounds.angle, BENDS)
    races = (("inner", "ν", Wedge.mu_i), ("outer", "ω", Wedge.mu_e))
    for race, angle, mu in races:
        yield agrees(f"force ratio on the {race} race against tan {angle}, largest difference "
                     "up to N_0",
                     f"tan {angle}", found.force_ratio(mu.name), found.RATIO, mu)  # fmt: skip
    for race, angle, mu in races:
        yield agrees(f"force ratio on the {race} race at 1.8 N_0, corrected for sprag bending",
                     f"tan {angle}", found.force_ratio_bent(mu.name), found.RATIO, mu)  # fmt: skip
    yield from through(q, Wedge.excess, "excess of N_e over N_i (zero in the paper)",
                       "N_e/N_i − 1", Bounds.excess, BENDS, points=(FULL,), own=BLUNT)  # fmt: skip


def _forces(q: Wedge) -> Iterator[Comparison]:
    yield from through(q, Wedge.torque, "torque n_s N tan(ν) OA", "T(N)", Bounds.torque, BENDS,
                       points=(FULL, MOST))  # fmt: skip
    yield approximation(
        Wedge.torque_printed, "T_rigid", state=q.stroke[FULL], expected=underived(HALF_ARMS),
        name="torque with the lever arm of Eq. 16 as printed, at N_0", symbol="T(N)", order=2,
        shares=COLUMN,
    )  # fmt: skip
    yield approximation(
        Wedge.N, expected=expected(q, Bounds.force, BENDS, DEMAND), order=2, symbol="N(T)",
        name="normal force (Eq. 10), at T", shares=COLUMN,
    )  # fmt: skip
    yield approximation(
        Wedge.alpha, expected=expected(q, Bounds.rotation_at_torque, YIELDS, AS_FORCE[0]), order=2,
        own=AS_FORCE, symbol="α(T)", name="rotation of the sprags, at T", shares=COLUMN,
    )  # fmt: skip


def _rotations(q: Wedge) -> Iterator[Comparison]:
    at_full: dict[str, Any] = {"reference": "alpha", "points": (FULL,)}
    yield from through(q, Wedge.H, "total deflection of elastic bodies", "H(N)",
                       Bounds.elastic, YIELDS, points=(FULL, MOST))  # fmt: skip
    yield from through(q, Wedge.alpha, "rotation of the sprags with elastic deflections", "α(N)",
                       Bounds.elastic, YIELDS)  # fmt: skip
    yield from through(q, Wedge.theta,
                       "wind-up of the races by rolling, compared with the wind-up from the "
                       "strain energy",
                       "θ(N)", Bounds.turn, TANGENTIAL, own=SLIPPING)  # fmt: skip
    yield from through(q, Wedge.alpha_plane,
                       "rotation of the sprags with half planes and Eq. 6 for plane strain", "α(N)",
                       Bounds.plane, "deflections of half planes and uniformly loaded rings, "
                       "compared with elastic solutions of the same parts",
                       **at_full, shares=PLANE)  # fmt: skip
    yield from through(q, Wedge.alpha_printed,
                       "rotation of the sprags with Eqs. 9, 10 as printed and elastic deflections",
                       "α(N)", Bounds.lost, "the equations omit half of δ_HI and of δ_g",
                       own=EIGHTH, **at_full)  # fmt: skip
    yield approximation(
        Wedge.alpha_composite, expected=underived(PALMGREN), state=q.stroke[FULL],
        name="rotation of the sprags with Palmgren's law, Eqs. 6 and 7, at N_0", symbol="α(N)",
        order=2,
    )  # fmt: skip
    yield approximation(
        Wedge.alpha_contacts, expected=underived(PALMGREN), state=q.stroke[FULL],
        name="rotation of the sprags with Palmgren's law and Eq. 6, without Eq. 7, at N_0",
        symbol="α(N)", order=2,
    )  # fmt: skip
    yield approximation(
        Wedge.alpha_paper, expected=underived(PAPER), symbol="α(T)", order=2,
        name="rotation of the sprags as in the paper, with Palmgren's law in Eqs. 9, 10 as "
        "printed, at T",
    )  # fmt: skip


def _of_rigid_races(q: Wedge) -> Iterator[Comparison]:
    yield approximation(
        Wedge.theta_rigid_races, expected=underived(RIGID), state=q.stroke[FULL], order=2,
        name="wind-up of a clutch with rigid races by Palmgren's law (Huang 2022, Eqs. 2, 4), at "
        "N_0", symbol="θ(N)",
    )  # fmt: skip
    yield approximation(
        Wedge.secant, expected=underived(RIGID), state=q.stroke[FULL], order=2, symbol="T/θ",
        name="torsional stiffness of a clutch with rigid races by Palmgren's law (Huang 2022, "
        "Eq. 11), at N_0",
    )  # fmt: skip


def _races(q: Wedge) -> Iterator[Comparison]:
    races = (("inner", "i", Wedge.mean_i, Wedge.thin_i, Wedge.race_i),
             ("outer", "e", Wedge.mean_e, Wedge.thin_e, Wedge.race_e))  # fmt: skip
    for race, which, mean, *_ in races:
        yield from through(
            q, mean, f"mean displacement of the {race} race (Eq. 6 for plane strain)",
            f"δ_B{which.upper()}", lambda _: (-SHARP, SHARP), BETTI, points=(FULL, MOST),
            shares=PLANE,
        )  # fmt: skip
    for race, which, mean, thin, under in races:
        symbol = f"δ_B{which.upper()}"
        at_full: dict[str, Any] = {"points": (FULL,)}
        yield from through(
            q, thin, f"mean displacement of the {race} race (Eq. 6 as printed, for plane stress)",
            symbol, partial(Bounds.thin, which=which), "Eq. 6 as printed is for plane stress, the "
            "reference is in plane strain",
            reference=mean.name, shares="", **at_full,
        )  # fmt: skip
        yield from through(
            q, under, f"displacement of the {race} race under a sprag", symbol,
            partial(Bounds.race, which=which),
            "sum of 1e-3 (effects of second order) and (a/h)², where h is the wall thickness",
            shares=PLANE, **at_full,
        )  # fmt: skip
        yield from through(
            q, thin, f"displacement of the {race} race under a sprag, taken as the mean "
            "displacement by Eq. 6", symbol,
            partial(Bounds.thin_at_contact, which=which), "mean displacement by Eq. 6, "
            "compared with the displacement of a ring under concentrated forces",
            reference=under.name, shares="", **at_full,
        )  # fmt: skip


def _contacts(q: Wedge) -> Iterator[Comparison]:
    for race, formula, symbol in (("inner", Wedge.p_i, "p_i"), ("outer", Wedge.p_e, "p_o")):
        yield from through(
            q, formula, f"peak pressure on the {race} race (Hertz)", symbol, Bounds.hertz, HERTZ,
            order=EDGE, points=(FULL, MOST), shares=PLANE,
        )  # fmt: skip
    for race, formula, symbol in (("inner", Wedge.a_i, "a_i"), ("outer", Wedge.a_e, "a_o")):
        yield from through(
            q, formula, f"half-width of the contact on the {race} race (Hertz)", symbol,
            Bounds.width, WIDTH, order=EDGE, points=(FULL,), own=ONE, shares=PLANE,
        )  # fmt: skip


def _statics() -> Iterator[Comparison]:
    yield fact("peak pressure on the inner race exceeds that on the outer, under all compared "
               "forces", "p_i", found.inner_above_outer)  # fmt: skip
    yield agrees("T_i/N_i under the smallest computed load is tan ν (Eq. 10)", "tan ν",
                 found.no_load, found.LIGHT, Wedge.mu_i)  # fmt: skip
    yield Comparison(check=Accepted(
        name="the wedge angle of the logarithmic spiral is constant", symbol="ν", unit="1",
        margin=found.keeps_its_angle,
    ))  # fmt: skip
    yield agrees("friction coefficient at which the sprag slips, against tan ν", "μ", found.onset,
                 found.SLIDES, Wedge.mu_i)  # fmt: skip
    yield agrees("torque compared with n_s N tan(ν) OA at the computed position of the sprag", "T",
                 found.ratio("column", found.RATIO, "bending of the column changes the torque by",
                             of_fem=True),
                 found.RATIO, Wedge.torque)  # fmt: skip
    yield agrees("work ∫N dH on all deflections, compared with the strain energy", "U",
                 found.ratio("work", found.WORK, "tangential deformation changes the energy by"),
                 found.WORK)  # fmt: skip
    one = {"one": 1.0}
    yield balance("forces", "balance of both contact forces on a sprag", "ΣF", "1", of=one,
                  bound=1e-9, because="the solver balances the forces on a free body")  # fmt: skip
    yield balance("held", "torque on the inner race, compared with that on the outer", "T", "1",
                  of=one, bound=1e-3, because="the forces act on displaced surfaces")  # fmt: skip


def agrees(
    name: str, symbol: str, pair: found.Function, accepted: float, judged: Quantity | None = None
) -> Comparison:
    """Row that requires two values to agree within `accepted`, a tolerance of the suite."""
    check = Agreement(name=name, symbol=symbol, unit="1", pair=pair, accepted=accepted,
                      source=suites(ROLLERS))  # fmt: skip
    return Comparison(check=check, quantity=judged, shares=COLUMN if judged else "")
