"""What a clutch's formulas claim, beside struts: closed forms, uneven states, misprints."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from analytic.contact import palmgren
from analytic.rotor import clutch_printed as printed
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import LINE_CONTACT, with_axial
from analytic.rotor.clutch_state import under_torque
from verify import judge
from verify.case import Context, Values
from verify.cases.rotor_clutch_fem import ANGLES, HARD, SMALL, STIFFER, TORQUES
from verify.cases.rotor_clutch_inputs import ClutchInputs
from verify.cases.rotor_clutch_model import (
    ENTRIES,
    STATES,
    corrected,
    pinned_torsion,
    tangent,
    tilted,
)  # fmt: skip
from verify.checks import Approximation, Exact, Fact, Identity, Limit, Order
from verify.claims import Claim
from verify.results import Kind, Row, Status

Array = Any
SAME = "the same problem on both sides, to round-off"
SHARE = 0.05  # of what Eq. 3 leaves out, that expectations are given to
DIFFERENCES = 1e-8  # of a tangent by central differences
INCLINED = "derived: forces along struts inclined by ν, directions cos ψ − tan ν sin ψ in Eq. 3, "\
    "and what tilting forces take; to a twentieth of either"  # fmt: skip
UNITS = {"K_xx": "N/mm", "K_yy": "N/mm", "K_tilt": "N m/rad", "K_zz": "N m/rad", "K_xz": "N"}
WHAT = {
    "K_xx": "stiffness along x", "K_yy": "stiffness along y", "K_tilt": "tilting stiffness",
    "K_zz": "torsional stiffness", "K_xz": "coupling of bending and torsion",
}  # fmt: skip
IN_STATE = {
    "uniform": "uniform", "offset": "with an offset", "crown": "with a crown",
    "gap": "with sprags missing", "together": "with offset, crown and gap",
}  # fmt: skip


def expected(entry: str, state: str, key: str) -> Callable[[Any, Any], tuple[float, float]]:
    """Interval of formula/struts - 1, the formula being the analytic value `key`."""

    def interval(q: ClutchInputs, v: Values) -> tuple[float, float]:
        K = float(corrected(q, STATES[state])[ENTRIES[entry]])
        left_out = tilted(q, STATES[state]) if entry == "K_tilt" else 0.0
        width = SHARE * (math.tan(q.nu) ** 2 + left_out / K)
        m = v[key] / (K - left_out) - 1
        return m - width, m + width

    return interval


def approximation(entry: str, state: str, key: str = "", name: str = "") -> Approximation:
    key = key or f"{entry}, {state}"
    return Approximation(
        name=name or f"{WHAT[entry]}, {IN_STATE[state]}", symbol=entry, unit=UNITS[entry],
        fem=f"{entry}, {state}", analytic=key, formal=2, interval=expected(entry, state, key),
        source=INCLINED,
    )  # fmt: skip


def identity(entry: str, state: str, key: str = "") -> Identity:
    return Identity(
        name=f"{WHAT[entry]}, {IN_STATE[state]}", symbol=entry, unit=UNITS[entry], formal=2,
        fem=f"{entry}, {state}", analytic=key or f"{entry}, {state}", demand=1e-9,
        demand_reason=SAME,
    )  # fmt: skip


def leading(q: ClutchInputs, _: Values) -> tuple[float, float]:
    """Eq. 3 alone: cos^2 for cos^2 + tan^2 nu sin^2 of every sprag, and the next term twice."""
    neglected = math.tan(q.nu) ** 2
    return -neglected, -neglected + 2 * neglected**2


def held_ends(q: ClutchInputs, v: Values) -> tuple[float, float]:
    """The same with struts held in both races: their forces turn with them, by Q/l; squares off."""
    length = q.R_e - q.R_i
    terms = (math.tan(q.nu) ** 2, v["delta_0"] / (LINE_CONTACT * length))
    return terms[1] - terms[0] - sum(terms) ** 2, terms[1] - terms[0] + sum(terms) ** 2


def over_torque(context: Context) -> tuple[list[float], list[float]]:
    K = context.fem[-1].arrays["K_xx over T"]
    return [context.inputs.T * share for share in reversed(TORQUES)], K[::-1].tolist()


def over_angle(context: Context) -> tuple[list[float], list[float], list[float]]:
    """What Eq. 3 leaves out over sin ν, at the same normal forces."""
    K, v = context.fem[-1].arrays["K_xx over nu"], context.analytic
    sines = [math.sin(share * context.inputs.nu) for share in ANGLES]
    return sines, (HARD * v["K_xx"] / K - 1).tolist(), [1e-13] * len(sines)


def over_yield(context: Context) -> tuple[list[float], list[float], list[float]]:
    """1 - struts/formula over how much the contacts yield, delta_0/l, ends held in both races."""
    K, q, v = context.fem[-1].arrays["K_zz over yield, pinned"], context.inputs, context.analytic
    eps = [v["delta_0"] / s / (q.R_e - q.R_i) for s in reversed(STIFFER)]
    d = (1 - K / (v["K_zz"] * np.array(STIFFER)))[::-1]
    return eps, d.tolist(), [1e-13] * len(eps)


def over_offset(context: Context) -> tuple[list[float], list[float], list[float]]:
    """First-order coupling over that of struts, Eq. 3 corrected in both, over dx/delta_0.

    The term after the one that is fitted counts as uncertainty, beside round-off: the coupling is
    what little is left of entries that cancel.
    """
    K, q, v = context.fem[-1].arrays["K_xz over small offsets"], context.inputs, context.analytic
    formula = v["K_xz, first order"] * np.array(SMALL) * v["delta_0"] / q.e
    d = formula / math.cos(q.nu) ** 2 / K - 1
    return list(SMALL), d.tolist(), [1e-13 / eps + eps**4 for eps in SMALL]


def by_differences(context: Context) -> tuple[float, float]:
    """Tangent in the most uneven state against central differences of the loads."""
    q, state = context.inputs, STATES["together"]
    clutch = q.clutch(crowned=state.crowned, gap=state.gap)
    at = under_torque(clutch, T=q.T, offset=(q.e, 0, 0, 0))
    size = np.array([1.0, 1.0, q.L, q.L, q.d_t])
    h = 1e-4 * context.analytic["delta_0"] / size
    found = (clutch.loads(at + np.diag(h)) - clutch.loads(at - np.diag(h))) / (2 * h[:, None])
    K = clutch.stiffness(at)
    scaled = np.abs(found - K) / np.outer(size, size)
    return DIFFERENCES - float(scaled.max() / context.analytic["K_xx"]), 0.0


def displacements(given: int) -> Callable[[Context], tuple[float, float]]:
    def margin(context: Context) -> tuple[float, float]:
        K = tangent(context.inputs, STATES["together"])
        K = K if given == len(K) else with_axial(K)
        scale = 1 / np.sqrt(np.where(K.diagonal() > 0, K.diagonal(), 1.0))
        rank = np.linalg.matrix_rank(K * np.outer(scale, scale))
        return 0.5 - abs(len(K) - given) - abs(rank - 5), 0.0

    return margin


def palmgrens(_: Context) -> tuple[float, float]:
    one, two = (float(palmgren.approach(load=W, length=0.01)) for W in (1e3, 2e3))
    return 1e-12 - abs(math.log(2) / math.log(two / one) - 10 / 9), 0.0


@dataclass(frozen=True, kw_only=True)
class Misprint(Claim):
    """A printed form that contradicts itself, shown with numbers: NOTE with its ledger entry."""

    kind = Kind.FACT
    paper_only: ClassVar[bool] = True

    erratum: str
    margin: Callable[[Context], tuple[float, str]]
    fem_needed: bool = False

    @property
    def needs_fem(self) -> bool:
        return self.fem_needed

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        margin, words = self.margin(context)
        verdict = judge.fact(margin, 0.0)
        if verdict.status is Status.PASS:
            said = f"{words}; ledger {self.erratum}"
            verdict = replace(verdict, status=Status.NOTE, reason=said)
        return [self._row(context.case, Kind.FACT, verdict)]


def one_angle(context: Context) -> tuple[float, str]:
    """Eq. 9 with psi_i: no stiffness, and a force at rest."""
    q = context.inputs
    clutch = q.clutch()
    at = under_torque(clutch, T=q.T)
    K, F = printed.radial_stiffness(clutch, at), printed.radial_force(clutch, at)
    share = abs(K) / context.analytic["K_xx"]
    words = f"with ψ_i the stiffness is {share:.0e} K_xx, the force without displacement {F:.4g} N"
    return min(1e-9 - share, abs(F) / (q.Z * context.analytic["N"]) - 0.9), words


def whole_displacement(context: Context) -> tuple[float, str]:
    """Eq. 10 with the whole displacement: n times the load."""
    q = context.inputs
    clutch = q.clutch()
    at = under_torque(clutch, T=q.T)
    ratio = float((clutch.stiffness(at) @ at)[4] / q.T)
    n = 1 / uniform.secant_over_tangent()
    return 1e-9 - abs(ratio - n), f"K times the whole displacement is {ratio:.5f} times the load"


def another_lever(context: Context) -> tuple[float, str]:
    """Twice the lever: entries of K across the diagonal are 1 : 2."""
    q = context.inputs
    clutch = q.clutch(gap=True)
    at = under_torque(clutch, T=q.T)
    K = printed.stiffness_with_lever(clutch, at, lever=2 * clutch.d_t)
    ratio = float(K[4, 0] / K[0, 4])
    return 1e-9 - abs(ratio - 2), f"with twice the lever ∂M_z/∂x is {ratio:.4g} times ∂F_x/∂γ_z"


def no_coupling(context: Context) -> tuple[float, str]:
    """Under the torque alone, formulas and struts couple nothing."""
    v = context.analytic
    formula = abs(v["coupling, uniform"])
    struts = context.series("off-diagonal")[1][-1] / v["K_xx"]
    words = (
        f"uniform: formulas {formula:.0e}, struts {struts:.0e}; an offset of "
        f"{context.inputs.e * 1e6:g} µm couples {abs(v['coupling, offset']):.2%}, "
        f"{context.inputs.missing} missing {abs(v['coupling, gap']):.2%} of √(K_xx K_zz)"
    )
    return 1e-12 - max(formula, struts), words


CHECKS = (
    *(
        Approximation(name=f"{WHAT[entry]}, uniform", symbol=entry, unit="N/mm",
                      fem=f"{entry}, uniform", analytic=entry, formal=2, interval=leading,
                      source="derived: Eq. 3 leaves tan²ν out; the next term, twice")
        for entry in ("K_xx", "K_yy")
    ),
    approximation("K_tilt", "uniform", "K_tilt"),
    identity("K_zz", "uniform", "K_zz"),
    approximation("K_xz", "offset", "K_xz, first order",
                  f"{WHAT['K_xz']} by an offset, first order"),
    approximation("K_xz", "offset"),
    approximation("K_xx", "crown"),
    approximation("K_tilt", "crown"),
    approximation("K_xx", "gap"),
    approximation("K_yy", "gap"),
    approximation("K_tilt", "gap"),
    identity("K_xz", "gap"),
    identity("K_zz", "gap"),
    *(approximation(entry, "together") for entry in ENTRIES),
    Approximation(name="stiffness along x, ends held in both races", symbol="K_xx", unit="N/mm",
                  fem="K_xx, pinned", analytic="K_xx", formal=2, interval=held_ends,
                  source="derived: tan²ν and Q/(k l), their sum's square left out"),
    Identity(name="torsional stiffness, ends held in both races", symbol="K_zz", unit="N m/rad",
             fem="K_zz, pinned", analytic="K_zz, pinned", formal=2, demand=1e-8,
             demand_reason=SAME),
    *(
        Exact(name=f"entries off the diagonal, {name}", symbol="K_ab", unit="N/mm", fem=key,
              scale="K_xx", bound=1e-12, bound_reason="sums over even sprags, round-off")
        for name, key in (("uniform", "off-diagonal"),
                          ("ends held in both races", "off-diagonal, pinned"))
    ),
    Exact(name="axial stiffness, uniform", symbol="K_z", unit="N/mm", fem="axial", scale="K_xx",
          bound=1e-12, bound_reason="forces lie across the axis"),
    *(
        Exact(name=f"torque, {name}", symbol="M_z − T", unit="N m", fem=key, scale="T",
              bound=1e-11, bound_reason="Newton's tolerance 1e-12")
        for name, key in (("uniform", "torque"), ("ends held in both races", "torque, pinned"))
    ),
    Order(name="exponent of the stiffness over the torque", symbol="p", unit="1",
          errors=over_torque, order=1 - 1 / LINE_CONTACT, demand=1e-6,
          demand_reason="a power law on both sides"),
    Limit(name="stiffness along x as the wedge angle vanishes", symbol="d_0", unit="1",
          points=over_angle, exponent=2, demand=1e-8, demand_reason=SAME),
    Limit(name="torsional stiffness as yields vanish, ends held in both races", symbol="d_0",
          unit="1", points=over_yield, exponent=1, demand=1e-8, demand_reason=SAME),
    Limit(name="coupling linear in a small offset", symbol="d_0", unit="1", points=over_offset,
          exponent=2, demand=1e-6, demand_reason="the next term of the series"),
    Fact(name="tangent against differences of the loads, 1e-8", symbol="K", unit="1",
         margin=by_differences, fem_needed=False),
    Fact(name="five displacements, all of them held", symbol="K_ps", unit="1",
         margin=displacements(5), fem_needed=False, printed=("huang2022:clutch-stiffness-dofs",)),
    Fact(name="six displacements, the axial one free", symbol="K_s", unit="1",
         margin=displacements(6), fem_needed=False, printed=("huang2022:clutch-element-dofs",)),
    Fact(name="exponent of Palmgren's line contact", symbol="n", unit="1", margin=palmgrens,
         fem_needed=False,
         printed=("huang2022:exponent-numerator", "huang2022:exponent-denominator")),
    Misprint(name="Eq. 9 with one angle for all sprags", symbol="F_r", unit="1",
             erratum="eq-9-sprag-index", margin=one_angle),
    Misprint(name="Eq. 10 with whole displacements", symbol="P_s", unit="1",
             erratum="eq-10-increments", margin=whole_displacement),
    Misprint(name="a torque with another lever than Eq. 4's", symbol="M_z", unit="1",
             erratum="eq-9-torque-row", margin=another_lever),
    Misprint(name="bending and torsion coupled by the torque alone", symbol="K_xz", unit="1",
             erratum="eq-11-bending-torsion", margin=no_coupling, fem_needed=True),
)  # fmt: skip


def pinned_share(q: ClutchInputs, v: Values) -> float:
    """Share of the torsional stiffness that ends held in both races would take."""
    return 1 - pinned_torsion(q, k=v["k"], N=v["N"]) / v["K_zz"]
