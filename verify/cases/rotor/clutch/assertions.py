"""What a clutch's formulas say without an interval: facts, and printed forms that contradict."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from analytic.contact import palmgren
from analytic.rotor import clutch_printed as printed
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import with_axial
from analytic.rotor.clutch_state import under_torque
from verify.cases.rotor.clutch.model import STATES, tangent
from verify.core.case import Context
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim
from verify.judging.tolerance_checks import Pair

DIFFERENCES = 1e-8  # of a tangent by central differences


def by_differences(context: Context) -> tuple[float, float, str]:
    """Tangent with sprags missing, which fills it, against central differences of the loads."""
    q = context.inputs
    clutch = q.clutch(gap=True)
    at = under_torque(clutch, T=q.T)
    size = np.array([1.0, 1.0, q.L, q.L, q.d_t])
    h = 1e-5 * context.analytic["delta_0"] / size
    found = (clutch.loads(at + np.diag(h)) - clutch.loads(at - np.diag(h))) / (2 * h[:, None])
    K = clutch.stiffness(at)
    scaled = np.abs(found - K) / np.outer(size, size)
    off = float(scaled.max() / context.analytic["K_xx"])
    return off, 0.0, f"off by {off:.1e} of K_xx at most"


def displacements(given: int) -> Callable[[Context], tuple[float, float]]:
    def margin(context: Context) -> tuple[float, float]:
        K = tangent(context.inputs, STATES["together"])
        K = K if given == len(K) else with_axial(K)
        scale = 1 / np.sqrt(np.where(K.diagonal() > 0, K.diagonal(), 1.0))
        rank = np.linalg.matrix_rank(K * np.outer(scale, scale))
        return 0.5 - abs(len(K) - given) - abs(rank - 5), 0.0

    return margin


def palmgrens(_: Context) -> Pair:
    one, two = (float(palmgren.approach(load=W, length=0.01)) for W in (1e3, 2e3))
    exponent = math.log(2) / math.log(two / one)
    return Pair(exponent, 10 / 9, 0.0, f"{exponent:.12g}")


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
