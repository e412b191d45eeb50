"""Comparisons of a wedged roller: balance of forces, limit of friction, stick zone."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from analytic.bounds.polyhedral import wedge as bounds
from analytic.bounds.polyhedral.wedge import STATICS
from analytic.polyhedral import wedging
from verify.case import Comparison, Expected, approximation, balance, fact, identity
from verify.cases.polyhedral.wedge.formulas import WedgeFormulas
from verify.cases.polyhedral.wedge.stick import SHARES, small
from verify.core.case import Check, Context
from verify.judging.checks import Fact
from verify.judging.tolerance_checks import Deviation

BALANCED = "the forces are in equilibrium on any mesh"
REST = 1e-3  # relative to N: counts as zero
EXPELLED = 1e-6  # how close T/N is to tan(alpha/2) in the sweep
L2 = 0.03  # acceptance of tractions
EDGES = 0.01  # limit of the slipping share of N if N and T grow together
FREE = "derived: the friction force of a free roller is tan(α/2)/μ times the limit μN"
HALF_PLANES = (
    "estimated: ± ((a/(μR))² for the inclined contact surface + 2 (a/R)² for the approximation by "
    "half-planes)"
)
SOLVER = "accuracy of the solver for a body that is supported by contacts only"
LIMIT = "Coulomb's law is satisfied at every node, except for round-off"
COULOMB = "Coulomb's law of friction"


def comparisons(self: WedgeFormulas) -> Iterator[Comparison | Check]:
    """Rows: free rollers, caged rollers, Eqs. 3 and 4 as printed, stick zones."""
    case, scale, angle = WedgeFormulas, {"N": self.N}, {"alpha": self.alpha, "mu": self.mu}
    too_much = Expected(*bounds.torque_error(**angle), FREE)
    too_little = Expected(*bounds.normal_force_error(**angle), FREE)
    reach = bounds.half_planes(a=small(self), R=self.R, mu=self.mu)
    half_planes = Expected(*reach, HALF_PLANES)
    free: dict[str, Any] = {"sensitivity": (STATICS, BALANCED)}
    caged: dict[str, Any] = free | {"shares": COULOMB}
    printed: dict[str, Any] = {"sensitivity": (1e-5, BALANCED)}
    yield identity(case.T, name="friction force of a free roller", **free)
    yield identity(case.M_free, name="torque of free rollers (Eq. 3, corrected)", **free)
    yield approximation(case.M_caged, "M_free", name="torque of free rollers, Eq. 3 as printed",
                        expected=too_much, **printed)  # fmt: skip
    yield identity(case.M_caged, "M_caged", name="torque of caged rollers (Eq. 3)", **caged)
    yield identity(case.C, name="cage force (Eq. 1)", scale=scale, **caged)
    yield identity(
        case.N_per_M, name="normal force per torque of free rollers (Eq. 5, corrected)", **free
    )
    yield approximation(case.N_per_M_caged, "N_per_M", expected=too_little,
                        name="normal force per torque of free rollers, Eq. 4 as printed",
                        **printed)  # fmt: skip
    yield identity(case.N_per_M_caged, "N_per_M_caged",
                   name="normal force per torque of caged rollers (Eq. 4)", **caged)  # fmt: skip
    yield identity(case.mu_c,
                   name="least coefficient of friction that holds a free roller (Eq. 2)",
                   shares=COULOMB,
                   sensitivity=(1e-4, "the bisection determines μ_c to five digits"))  # fmt: skip
    yield fact("friction coefficient 1 % above tan(α/2) holds the roller (Eq. 2)", "N", held)
    yield fact("friction coefficient 1 % below tan(α/2) releases the roller (Eq. 2)", "N",
               below(REST, "around", 0))  # fmt: skip
    yield Comparison(check=Deviation(
        name="deviation of T/(μN) from tan(α/2)/μ at wedge angles that hold the roller, and of N "
        "from zero at larger angles",
        symbol="ΔT/(μN)", unit="1",
        size=over_angles, accepted=EXPELLED, whole="μN", source=BALANCED, everywhere=True,
    ), quantity=case.wedged, shares=COULOMB)  # fmt: skip
    for k in SHARES:
        yield approximation(case.stick(k), symbol="c/a", order=1, expected=half_planes,
                            shares=COULOMB)  # fmt: skip
    together = "N and T grow together"
    for part, (words, symbol, bound) in enumerate((
        ("slipping nodes carry less than 1 % of N", "N_slip", EDGES),
        ("traction q deviates by less than 3 % from tan(α/2) p (L2 norm)", "q", L2),
    )):  # fmt: skip
        yield Fact(name=f"{together}: {words}", symbol=symbol, unit="1", paper_only=True,
                   margin=below(bound, "slipping", part))  # fmt: skip
    for residual, name in (
        ("along", "balance of forces along the bisector"),
        ("across", "balance of forces on half a roller, across the bisector"),
        ("cage", "balance of cage force and contact forces"),
    ):  # fmt: skip
        yield balance(residual, name, "ΣF", "N", of=scale, bound=1e-9, because=SOLVER)
    yield balance("unslipped", "residual of Coulomb's law, caged roller", "μp − q", "N",
                  of=scale, bound=1e-10, because=LIMIT)  # fmt: skip


def held(context: Context) -> tuple[float, float]:
    """Margin, positive if at least 90 % of N remain for mu 1 % above tan(alpha/2).

    The uncertainty is also returned.
    """
    return float(context.fem[-1].arrays["around"][1] - (1 - 0.1)), 0.0


def below(bound: float, array: str, k: int) -> Callable[[Context], tuple[float, float]]:
    """Function that returns a margin: `bound` minus element `k` of `array` on the finest mesh."""
    return lambda context: (float(bound - context.fem[-1].arrays[array][k]), 0.0)


def over_angles(context: Context) -> tuple[float, float, str]:
    """Largest deviation of T/(mu N) from tan(alpha/2)/mu, its uncertainty, and a text.

    For rollers that the wedge expels, the deviation is the remaining share of N times EXPELLED /
    REST.
    """
    share, left, ratio = context.fem[-1].arrays["over angles"]
    mu = context.inputs.mu
    stays = wedging.holds(alpha=2 * np.arctan(share * mu), mu=mu)
    missed = np.where(stays, np.abs(ratio - share), EXPELLED / REST * np.abs(left))
    return float(missed.max()), 0.0, f"largest deviation of T/(μN): {missed.max():.1e}"
