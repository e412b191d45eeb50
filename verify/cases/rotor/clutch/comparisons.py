"""Rows that compare the formulas of a clutch with struts, and rows on the paper's misprints."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np

from analytic.bounds.rotor import clutch as bounds
from analytic.bounds.rotor.clutch_tilted import PLACES, left_out
from analytic.contact import palmgren
from analytic.rotor import clutch_printed as printed
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import with_axial
from verify.case import (
    Comparison,
    Computed,
    Level,
    Quantity,
    approximation,
    balance,
    identity,
    limit,
)
from verify.cases.rotor.clutch.formulas import ENTRIES, FINE, UNEVEN, ClutchStiffness
from verify.cases.rotor.clutch.reference import ANGLES, HARD, SMALL, STIFFER
from verify.core.case import Check, Context
from verify.judging.checks import Fact
from verify.judging.misprints import Misprint
from verify.judging.tolerance_checks import SUBJECT, Agreement, Deviation, Pair

SAME = "formula and struts solve the same problem and differ only by round-off"
RIGID = "rigid races; each sprag is a strut with the deflection of two line contacts"
HELD = "sprags pinned to both races"
DIFFERENCES = 1e-8  # relative error of a tangent by central differences
INCLINED = "derived from the inclination ν of the sprag forces (cos ψ in Eq. 3 is replaced by "\
           "cos ψ − tan ν sin ψ) and from the rotation of these forces with the race; the "\
           "uncertainty is 5 % of both effects"  # fmt: skip
Points = tuple[list[float], list[float], list[float]]
link = ClutchStiffness


def rows(q: ClutchStiffness) -> Iterator[Comparison | Check]:
    """All rows of the clutch case, in the order of the report page."""
    yield from _states(q)
    yield from _along_struts(q)
    yield from _held_ends(q)
    yield from _balances(q)
    yield identity(link.exponent, order=2, sensitivity=(1e-9, "both methods give a power law"))
    yield from _limits(q)
    yield from _facts(q)
    yield from _misprints(q)


def _approximate(q: ClutchStiffness, one: Quantity, state: str) -> Comparison:
    of = q.in_state[state]

    def interval() -> bounds.Interval:
        taken = of.leaning if one.name == "K_tilt" else 0.0
        return bounds.around(of.general(one.name), of.inclined(one.name), taken, of.nu)

    return approximation(one, order=2, state=q.state(state), shares=RIGID,
                         expected=Computed(interval, INCLINED))  # fmt: skip


def _identical(q: ClutchStiffness, one: Quantity, state: str) -> Comparison:
    return identity(one, order=2, state=q.state(state), shares=RIGID, sensitivity=(1e-9, SAME))


def _states(q: ClutchStiffness) -> Iterator[Comparison]:
    """Rows of the entries of K under even and uneven load."""
    leading = "derived: Eq. 3 omits the inclination ν of the sprag forces, which causes the error "\
              "−tan²ν; the upper limit is −tan²ν + 2 tan⁴ν"  # fmt: skip
    for one in (link.K_xx, link.K_yy):
        yield approximation(one, order=2, state=q.state(""), shares=RIGID,
                            expected=Computed(partial(bounds.leading, q.nu), leading))  # fmt: skip
    yield _approximate(q, link.K_tilt, "")
    yield _identical(q, link.K_zz, "")

    def first_order() -> bounds.Interval | None:
        return bounds.first_order(q.nu, q.e / q.delta_0, q.Z)

    series = "derived from two terms that the formula omits: tan²ν, caused by the inclination of "\
             "the sprag forces, and the next term of the series in Δx/δ_0"  # fmt: skip
    yield approximation(link.K_xz_first, "K_xz_offset", order=2, symbol="K_xz", shares=RIGID,
                        expected=Computed(first_order, series))  # fmt: skip
    for one, state in (
        (link.K_xz, "offset"), (link.K_xx, "crown"), (link.K_tilt, "crown"), (link.K_xx, "gap"),
        (link.K_yy, "gap"), (link.K_tilt, "gap"),
    ):  # fmt: skip
        yield _approximate(q, one, state)
    yield _identical(q, link.K_xz, "gap")
    yield _identical(q, link.K_zz, "gap")
    for entry in ENTRIES:
        yield _approximate(q, getattr(link, entry), "together")
    tilted = "derived from the inclination ν of the sprag forces and from the radial and axial "\
             "motion of the contact points if the race tilts; the uncertainty is 5 % of both "\
             "effects"  # fmt: skip
    fine = q.clutch(n_s=FINE)
    for entry in PLACES:
        interval = partial(left_out, entry, fine, T=q.T, n_s=q.n_s, **q.aside)
        yield approximation(getattr(link, entry), order=2, shares=RIGID,
                            expected=Computed(interval, tilted))  # fmt: skip


def _along_struts(q: ClutchStiffness) -> Iterator[Comparison]:
    """Rows of entries that are zero by Eq. 3, but not with forces along the struts."""
    for state, demand in (
        ("gap", (1e-9, SAME)),
        ("together", (1e-6, "error caused by the finite length of the slices on a crown")),
    ):
        for one, scale in ((link.K_xy, "K_xx"), (link.K_yz, "K_xz")):
            whole = partial(getattr, q.in_state[state], scale)
            yield identity(one, order=2, state=q.state(state), sensitivity=demand, shares=RIGID,
                           scale={f"{scale} {UNEVEN[state][1]}": whole})  # fmt: skip


def _held_ends(q: ClutchStiffness) -> Iterator[Comparison]:
    def interval() -> bounds.Interval:
        return bounds.held_ends(q.nu, q.delta_0, q.R_e - q.R_i)

    source = "derived: Q/(k l) − tan²ν, with sprag force Q and length l between the contacts; "\
             "the uncertainty is the square of Q/(k l) + tan²ν"  # fmt: skip
    yield approximation(link.K_xx, "K_xx_pinned", name=f"stiffness along x, {HELD}", order=2,
                        expected=Computed(interval, source))  # fmt: skip
    yield identity(link.K_zz_pinned, order=2, symbol="K_zz", sensitivity=(1e-8, SAME))


def _balances(q: ClutchStiffness) -> Iterator[Comparison]:
    for words, key in (("even load", "off_diagonal"), (HELD, "off_diagonal_pinned")):
        yield balance(key, f"off-diagonal entries of the stiffness matrix, {words}", "K_ab", "N/mm",
                      of={"K_xx": q.K_xx}, bound=1e-12,
                      because="sums over evenly spaced sprags are zero, to round-off")  # fmt: skip
    yield balance("axial", "axial stiffness, even load", "K_z", "N/mm", of={"K_xx": q.K_xx},
                  bound=1e-12, because="all forces are perpendicular to the axis")  # fmt: skip
    for words, key in (("even load", "torque"), (HELD, "torque_pinned")):
        yield balance(key, f"balance of torque, {words}", "M_z − T", "N m", of={"T": q.T},
                      bound=1e-11, because="tolerance of Newton's method, 1e-12")  # fmt: skip


def _limits(q: ClutchStiffness) -> Iterator[Comparison]:
    """Rows on limiting cases: wedge angle, deflection or offset approaches zero."""

    def over_angle(levels: Sequence[Level]) -> Points:
        """Error of Eq. 3 over sin ν, at equal normal forces."""
        K = levels[-1].arrays["K_xx over nu"]
        sines = [math.sin(share * q.nu) for share in ANGLES]
        return sines, (HARD * q.K_xx / K - 1).tolist(), [1e-13] * len(sines)

    def over_yield(levels: Sequence[Level]) -> Points:
        """1 - K_zz/formula over delta_0/l, with K_zz of struts that are pinned to both races."""
        K = levels[-1].arrays["K_zz over deflection, pinned"]
        eps = [q.delta_0 / s / (q.R_e - q.R_i) for s in reversed(STIFFER)]
        d = (1 - K / (q.K_zz * np.array(STIFFER)))[::-1]
        return eps, d.tolist(), [1e-13] * len(eps)

    def over_offset(levels: Sequence[Level]) -> Points:
        """Relative error of the first-order coupling, divided by cos(nu)^2, over dx/delta_0.

        The uncertainty is the sum of the next term of the series and of round-off. Round-off
        matters because the coupling is a small difference of large numbers.
        """
        K = levels[-1].arrays["K_xz over small offsets"]
        formula = q.K_xz_first * np.array(SMALL) * q.delta_0 / q.e
        d = formula / math.cos(q.nu) ** 2 / K - 1
        return list(SMALL), d.tolist(), [1e-13 / eps + eps**4 for eps in SMALL]

    fine = (1e-8, SAME)
    yield limit(link.K_xx, "stiffness along x as the wedge angle vanishes", "d_0",
                points=over_angle, exponent=2, sensitivity=fine)  # fmt: skip
    yield limit(link.K_zz, f"torsional stiffness as deflections vanish, {HELD}", "d_0",
                points=over_yield, exponent=1, sensitivity=fine)  # fmt: skip
    yield limit(link.K_xz_first, "coupling of bending and torsion as the offset vanishes", "d_0",
                points=over_offset, exponent=2,
                sensitivity=(1e-6, "the next term of the series in Δx/δ_0"))  # fmt: skip


def _facts(q: ClutchStiffness) -> Iterator[Comparison | Check]:
    """Rows on the tangent stiffness, the number of displacements and the contact exponent."""

    def by_differences(_: Context) -> tuple[float, float, str]:
        """Largest deviation of the tangent stiffness from central differences of the loads.

        Some sprags are missing, so that no entry of the matrix is zero. A text is also returned.
        """
        gap = q.in_state["gap"]
        size = np.array([1.0, 1.0, q.L, q.L, q.d_t])
        h = 1e-5 * q.delta_0 / size
        clutch, at = gap.sums, gap.at_T
        found = (clutch.loads(at + np.diag(h)) - clutch.loads(at - np.diag(h))) / (2 * h[:, None])
        scaled = np.abs(found - gap.tangent) / np.outer(size, size)
        off = float(scaled.max() / q.K_xx)
        return off, 0.0, f"largest difference {off:.1e} of K_xx"

    def displacements(given: int) -> Callable[[Context], tuple[float, float]]:
        def margin(_: Context) -> tuple[float, float]:
            K = q.in_state["together"].tangent
            K = K if given == len(K) else with_axial(K)
            scale = 1 / np.sqrt(np.where(K.diagonal() > 0, K.diagonal(), 1.0))
            rank = np.linalg.matrix_rank(K * np.outer(scale, scale))
            return 0.5 - abs(len(K) - given) - abs(rank - 5), 0.0

        return margin

    def palmgrens(_: Context) -> Pair:
        one, two = (float(palmgren.approach(load=W, length=0.01)) for W in (1e3, 2e3))
        exponent = math.log(2) / math.log(two / one)
        return Pair(exponent, 10 / 9, 0.0, f"{exponent:.12g}")

    tangent = Deviation(name="tangent stiffness against central differences of the loads",
                        symbol="ΔK/K_xx",
                        unit="1", size=by_differences, accepted=DIFFERENCES, source=SUBJECT,
                        whole="K_xx", fem_needed=False, by="central differences of the loads",
                        everywhere=True)  # fmt: skip
    yield Comparison(check=tangent, quantity=link.K_xx, state=q.state("gap"))
    for number, words, symbol, id_ in ((5, "stiffness matrix of five displacements has rank 5",
                                        "K_ps", "clutch-stiffness-dofs"),
                                       (6, "stiffness matrix of six displacements has rank 5 (no "
                                           "axial stiffness)", "K_s",
                                        "clutch-element-dofs")):  # fmt: skip
        yield Fact(name=words, symbol=symbol, unit="1", margin=displacements(number),
                   fem_needed=False, printed=(f"huang2022:{id_}",))  # fmt: skip
    exponent = Agreement(name="exponent of the force law of a line contact", symbol="n", unit="1",
                         pair=palmgrens, accepted=1e-12,
                         source="Palmgren's law has the printed exponent, to round-off",
                         by="theory", fem_needed=False, everywhere=True,
                         printed=("huang2022:exponent-numerator",
                                  "huang2022:exponent-denominator"))  # fmt: skip
    yield Comparison(check=exponent, quantity=link.n)


def _misprints(q: ClutchStiffness) -> Iterator[Check]:
    def one_angle(_: Context) -> tuple[float, str]:
        """Positive margin if Eq. 9 with psi_i gives K = 0, but a force without displacement."""
        K = printed.radial_stiffness(q.sums, q.at_T)
        F = printed.radial_force(q.sums, q.at_T)
        share = abs(K) / q.K_xx
        words = (
            f"with the same angle ψ_i for all sprags, the stiffness is {share:.0e} K_xx, and the "
            f"force at zero displacement is {F:.4g} N"
        )
        return min(1e-9 - share, abs(F) / (q.Z * q.N) - 0.9), words

    def whole_displacement(_: Context) -> tuple[float, str]:
        """Positive margin if K of Eq. 10 times the total displacement is n (of Eq. 2) times T."""
        ratio = float((q.tangent @ q.at_T)[4] / q.T)
        n = 1 / uniform.secant_over_tangent()
        words = f"K times the total displacement is {ratio:.5f} times the load"
        return 1e-9 - abs(ratio - n), words

    def another_lever(_: Context) -> tuple[float, str]:
        """Positive margin if, with twice the lever, ∂M_z/∂x is twice ∂F_x/∂γ_z."""
        clutch, at = q.in_state["gap"].sums, q.in_state["gap"].at_T
        K = printed.stiffness_with_lever(clutch, at, lever=2 * clutch.d_t)
        ratio = float(K[4, 0] / K[0, 4])
        words = f"with the lever arm 2 d_t, ∂M_z/∂x is {ratio:.4g} times ∂F_x/∂γ_z"
        return 1e-9 - abs(ratio - 2), words

    def no_coupling(context: Context) -> tuple[float, str]:
        """Positive margin if formulas and struts have no coupling under torque alone."""
        formula = abs(q.coupling)
        struts = context.series("off_diagonal")[1][-1] / q.K_xx
        words = (
            f"under even load, K_xz/√(K_xx K_zz) by the formulas is {formula:.0e}, and the off-"
            f"diagonal entries of K in the model with struts are at most {struts:.0e} K_xx; by "
            f"the formulas, K_xz/√(K_xx K_zz) is {abs(q.in_state['offset'].coupling):.2%} with an "
            f"offset of {q.e * 1e6:g} µm and "
            f"{abs(q.in_state['gap'].coupling):.2%} with {q.missing} of {q.Z} sprags missing"
        )
        return 1e-12 - max(formula, struts), words

    for name, symbol, erratum, margin in (
        ("Eq. 9 with one angle for all sprags", "F_r", "eq-9-sprag-index", one_angle),
        ("Eq. 10 with total displacements", "P_s", "eq-10-increments", whole_displacement),
        ("symmetry of K if the lever arm of M_z in Eq. 9 differs from d_t of Eq. 4",
         "M_z", "eq-9-torque-row", another_lever),
        ("coupling of bending and torsion under torque alone", "K_xz", "eq-11-bending-torsion",
         no_coupling),
    ):  # fmt: skip
        yield Misprint(name=name, symbol=symbol, unit="1", erratum=f"huang2022:{erratum}",
                       margin=margin, fem_needed=margin is no_coupling)  # fmt: skip
