"""Rows of a freewheel on the rig's load paths: loads and times of slip, behaviour before slip."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.bounds.freewheel.intervals import Interval
from analytic.freewheel import criterion
from verify.case import Comparison, Expected, Quantity, State, approximation, fact, underived
from verify.cases.freewheel.bounds import of_star
from verify.cases.freewheel.paths.reference import MU_REQ
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.judging.checks import Accepted, Margin
from verify.judging.published_checks import Adopted
from verify.judging.tolerance_checks import Agreement, Deviation, Pair, demanded, farthest, suites

MU, TORQUE, SLIP = 2e-3, 5e-3, 1e-2  # accepted errors of mu_req, torque, load at slip
ROOTED = (
    "twice the tolerance of 0.5 % for the friction cone, because an error of tan α causes a larger "
    "error of the load"
)
STATICS = "the same tolerance as for F_t/F_n compared with tan(ψ/2)"
SETTLES = 1 / 3  # creep of the last cycle over the first
GOES_ON = 0.9  # creep of a cycle over the cycle before
ANGLE = (
    "compliance of the star, which lies between the smallest and the largest compliance of three "
    "bodies: a layer as thick as the star at the flats, a disc of the radius of the flats, and a "
    "disc of the radius of the corners; tilt of the surfaces under the normal force"
)
COULOMB = "Coulomb's law of friction"
RULE = (
    "the limit is an average over the test runs of clutch A in load case 1; it is used as printed "
    "and not derived"
)


def _required(context: Context, at: int, name: str) -> tuple[Array, Array]:
    """mu_req in the states of a path: by finite elements, and by Eq. 9.

    Eq. 9 is evaluated with the clamping angle and the loads of the finite elements.
    """
    arrays, q = context.fem[at].arrays, context.inputs
    (tan, T, unit), table = arrays["at rest"], arrays[name]
    found = criterion.required_friction_of_contact(
        F_n=1.0, F_t=table[:, 1:3], F_a=table[:, 3:5]
    ).mean(axis=1)
    F_ax = np.abs(table[:, 0]) * unit
    return found, criterion.required_friction(alpha=np.arctan(tan), T=T, F_ax=F_ax, R=q.R)


def along(context: Context, name: str) -> Pair:
    """Pair of mu_req by Eq. 9 and by the contact forces, where they differ most along a path.

    The uncertainty is the difference between the two finest meshes.
    """
    pairs = (_required(context, at, name) for at in (-2, -1))
    before, now = (farthest(needed, found, 0.0) for found, needed in pairs)
    off, earlier = (one.value / one.reference - 1 for one in (now, before))
    words = f"largest error {abs(off):.2%}, {MU:.1%} accepted"
    return replace(now, U=abs(abs(off) - abs(earlier)) * now.reference, words=words)


def torque(context: Context) -> tuple[float, float, str]:
    """Largest relative change of the torque that the axial load causes, up to the limit load."""
    before, now = (
        max(float(np.abs(r.arrays[name][:, 6] - 1).max()) for name in ("ramp", "growing"))
        for r in context.fem[-2:]
    )
    return now, abs(now - before), f"largest change {now:.2%}, {TORQUE:.1%} accepted"


def at_slip(context: Context, case: int) -> Pair:
    """Pair of the axial load [N] at slip by Eq. 9 and by finite elements (finest mesh only)."""
    F, half = slips(context, case)
    needed = context.analytic["F_lim_3" if case == 3 else "F_lim"]
    words = f"{F:.5g} N by finite elements, error {needed / F - 1:+.2%}, {SLIP:.0%} accepted"
    return Pair(needed, F, half, words)


def slips(context: Context, case: int) -> tuple[float, float]:
    """Axial load [N] at which finite elements slip, and its uncertainty [N]."""
    last = context.fem[-1]
    if case == 1:
        return last.values["F_1"], last.u_it["F_1"]
    F, half = last.arrays["slips"][case - 2]
    return float(F), float(half)


def settles(context: Context) -> tuple[float, float, str]:
    """Margin, positive if creep under a small alternating load decreases from cycle to cycle.

    The ratio of the creep in the last cycle to that in the first must be below `SETTLES`.
    """
    before, now = (
        float(walk[-1] / walk[0]) for walk in (r.arrays["cycles"][0] for r in context.fem[-2:])
    )
    first, last = 1e9 * context.fem[-1].arrays["cycles"][0][[0, -1]]
    words = (
        f"at 0.4 of the axial load at slip, the bore of the ring creeps by {first:.3g} nm in the "
        f"first cycle and by {last:.2g} nm in the fourth"
    )
    return SETTLES - now, abs(now - before), words


def walks(context: Context) -> tuple[float, float, str]:
    """Margin, positive if creep under a large alternating load continues (ratcheting).

    The ratio of the creep in the last cycle to that in the cycle before must exceed `GOES_ON`.
    """
    before, now = (
        float(walk[-1] / walk[-2]) for walk in (r.arrays["cycles"][1] for r in context.fem[-2:])
    )
    ends = [1e9 * r.arrays["cycles"][1][-1] for r in context.fem[-2:]]
    rate, spread = ends[-1], abs(ends[1] - ends[0])
    words = (
        f"at 0.8 of the axial load at slip, the bore of the ring creeps by {rate:.0f} nm in the "
        f"last cycle (difference between meshes {spread:.0f} nm), which is {now:.3f} times the "
        "creep in the cycle before"
    )
    return now - GOES_ON, abs(now - before), words


def falls(context: Context) -> tuple[float, float]:
    """Relative amount by which mu_req at the largest torque exceeds mu_req at a low torque."""
    key, low = MU_REQ.values()
    before, now = (r.values[key] / r.values[low] - 1 for r in context.fem[-2:])
    return now, abs(now - before)


def in_time(context: Context, case: int) -> Pair:
    """Pair of the times of slip by the formula and by finite elements, with the accepted interval.

    The accepted interval contains the times of slip if the axial load at slip differs by up to the
    fraction `SLIP`. The formula gives the time within one time step; half a step is
    added to the uncertainty.
    """
    q, course = context.inputs, context.inputs.courses[case]
    F, half = slips(context, case)
    step = float(course.t[1] - course.t[0])
    t = course.slips_at - step / 2
    if not math.isfinite(t):
        return Pair(t, math.nan, 0.0, "the path ends before the clutch slips")
    mu_req = tuple(context.fem[-1].values[key] for key in MU_REQ.values())
    tan = q.rig.tangent(tuple(MU_REQ), mu_req)
    early, below, found, above, late = (
        q.rig.time_of_slip(case, F + d, tan) for d in (-SLIP * F, -half, 0.0, half, SLIP * F)
    )
    words = (
        f"{t:.5f} s, finite elements {found:.5f} s; accepted {early:.5f} to {late:.5f} s, the "
        f"times of slip if the axial load at slip is {SLIP:.0%} lower and higher"
    )
    allowed = early / found - 1, late / found - 1
    U = max(above - found, found - below) + step / 2
    return Pair(t, found, U, words, allowed)


def accepted(name: str, symbol: str, margin: Margin) -> Accepted:
    return Accepted(name=name, symbol=symbol, unit="1", margin=margin)


def agrees(
    q: Quantity, name: str, pair: Callable[[Context], Pair], figure: float, why: str, unit: str,
    symbol: str = "",
) -> Comparison:  # fmt: skip
    """Row that compares formula and finite elements; this suite requires the tolerance `figure`."""
    check = Agreement(name=name, symbol=symbol or q.symbol, unit=unit, pair=pair, accepted=figure,
                      source=suites(why), **demanded(figure))  # fmt: skip
    return Comparison(check=check, quantity=q, shares=COULOMB)


def slips_in_time(q: Quantity, case: int) -> Comparison:
    """Row of the time of slip of a path."""
    check = Agreement(
        name=f"time of slip, load case {case}", symbol="t", unit="s", accepted=SLIP,
        pair=lambda c: in_time(c, case),
        source=suites("times at which the axial load is "
                      f"{SLIP:.0%} below or above its value at slip in the finite elements"),
    )  # fmt: skip
    return Comparison(check=check, quantity=q, shares=COULOMB)


def in_phase(q: Any, mu_req: Quantity) -> Iterator[Comparison]:
    """Rows of the required friction of load case 3 in its last cycle."""
    for sine, key in MU_REQ.items():
        there = q.in_phase(sine)
        low, high = of_star(there, there.state).slope(tilted=True)
        state = State(there, key.removeprefix("mu_req_"),
                      f"load case 3, at {sine:g} times the load amplitudes")  # fmt: skip
        yield approximation(
            mu_req, state=state, order=2, shares=COULOMB, expected=Expected(low, high, ANGLE),
            name=f"required friction, load case 3, at {sine:g} times the load amplitudes (Eqs. 8, "
                 "9)",
        )  # fmt: skip


def comparisons(q: Any, path: Any) -> Iterator[Comparison | Check]:
    """Rows of the inputs `q`; the class `path` defines the quantities."""
    yield from _loads(q, path)
    yield from in_phase(q, path.mu_req)
    yield fact("load case 3: required friction is largest at the largest torque", "μ_req", falls)
    yield agrees(
        path.mu_req, "required friction along load case 1, Eqs. 8, 9 with the clamping "
        "angle of the finite elements", lambda c: along(c, "ramp"), MU, STATICS, "1",
    )  # fmt: skip
    yield agrees(
        path.mu_req, "required friction at the peaks of the axial load in load case 2, Eqs. 8, 9 "
        "with the clamping angle of the finite elements", lambda c: along(c, "growing"), MU,
        STATICS, "1",
    )  # fmt: skip
    for case in (1, 2, 3):
        yield slips_in_time(path.slip(case), case)
    yield Deviation(name="torque is constant up to the axial load at slip", symbol="T/T_0 − 1",
                    unit="1",
                    size=torque, accepted=TORQUE, whole="torque without axial load",
                    source=suites("half of the required sensitivity of 1 %"))  # fmt: skip
    yield accepted("creep per cycle decreases under a small alternating axial load (shakedown)",
                   "RΔφ", settles)  # fmt: skip
    yield accepted("creep continues under a large alternating axial load without slip (ratcheting)",
                   "RΔφ",
                   walks)  # fmt: skip
    yield from _adopted(path)


def _loads(q: Any, path: Any) -> Iterator[Comparison]:
    """Rows of the axial loads at slip of the three paths."""
    interval: Interval | None = q.limit_of(q.T)
    expected = underived(ANGLE) if interval is None else Expected(*interval, ANGLE)
    yield approximation(
        path.F_lim, "F_1", name="axial load at slip, steady torque (load case 1)", symbol="F_ax",
        order=2, expected=expected,
        own=(0.03, "an error of tan α causes a larger error of the load"), shares=COULOMB,
    )  # fmt: skip
    yield agrees(path.F_lim, "amplitude of the axial load at slip, steady torque (load case 2)",
                 lambda c: at_slip(c, 2), SLIP, ROOTED, "N", "F_ax")  # fmt: skip
    yield agrees(path.F_lim_3, "amplitude of the axial load at slip, torque and axial load in "
                               "phase (load case 3)",
                 lambda c: at_slip(c, 3), SLIP, ROOTED, "N", "F_ax")  # fmt: skip


def _adopted(path: Any) -> Iterator[Comparison | Check]:
    """Rows of numbers of the paper that are used as printed."""
    for name, key, why in (
        ("upper limit of class red",
         "red-yellow", "by Coulomb's law the clutch slips if μ/μ_req is below 1 (erratum "
                                    "traffic-light-wording)"),
        ("lower limit of class green",
         "yellow-green", "it is the limit of Coulomb's law, at which the clutch still holds "
                                       "(erratum eq-10-strictness)"),
    ):  # fmt: skip
        check = Adopted(name=f"μ/μ_req at the {name}", symbol="μ/μ_req", unit="1",
                        analytic="coulomb",
                        reference=f"nagler2021:friction-ratio-{key}", why=f"{RULE}; {why}"
                        )  # fmt: skip
        yield Comparison(check=check, numbers={"coulomb": 1.0})
    yield Comparison(
        check=Adopted(name="wind-up that the rig allows", symbol="φ", unit="deg", analytic="phi",
                      reference="nagler2021:rig-torsion-angle",
                      why="limit of the test rig, for comparison with the wind-up under the "
                          "largest torque"),
        quantity=path.phi,
    )  # fmt: skip
    yield Adopted(
        name="axial displacement that the rig allows", symbol="u_z", unit="mm",
        reference="nagler2021:rig-axial-displacement",
        why="limit of the test rig: before slip, the axial displacement of the clutch is only a "
            "few µm; all further displacement is slip",
    )  # fmt: skip
    yield Adopted(
        name="number of test runs with each clutch", symbol="n", unit="1",
        reference="nagler2021:test-runs-per-clutch",
        why="the paper does not print the settings of the test runs (Table 1): three paths "
            "represent the load cases",
    )  # fmt: skip
