"""The claims about a wedged roller: forces in balance, the limit of friction, the stick zone."""

from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.polyhedral import wedging
from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.stick import SHARES, small
from verify.core.case import Context, Values
from verify.core.results import Row
from verify.judging.checks import Approximation, Exact, Fact, Identity
from verify.judging.tolerance_checks import Deviation

BALANCED = "forces in balance, on any mesh"
STATICS = 1e-6  # of a value: what forces in balance may miss
MODEL = 2.0  # bound of what half planes leave out, over (a/R)²
REST = 1e-3  # of N: next to nothing
EXPELLED = 1e-6  # how close T/N is to tan(alpha/2) in the sweep
L2 = 0.03  # acceptance of tractions
EDGES = 0.01  # of the normal force: what may slip where N and T grow together


def too_much(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """Eq. 3 against a free roller, which uses tan(alpha/2)/mu of its friction."""
    m = 1 / q.wedged - 1
    return m - STATICS * (1 + m), m + STATICS * (1 + m)


def too_little(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """Eq. 4 against the same."""
    m = q.wedged - 1
    return m - STATICS, m + STATICS


def half_planes(q: WedgeInputs, _values: Values) -> tuple[float, float]:
    """What inclined surfaces do to the stick zone, and what half planes leave out of bodies."""
    geometry = small(q)
    tilt, size = geometry.a / (q.mu * q.R), geometry.a / q.R
    bound = tilt**2 + MODEL * size**2
    return -bound, bound


def held(context: Context) -> tuple[float, float]:
    """Nearly all of N is left with friction a per cent above tan(alpha/2)."""
    return float(context.fem[-1].arrays["around"][1] - (1 - 0.1)), 0.0


def let_out(context: Context) -> tuple[float, float]:
    """And next to nothing a per cent below."""
    return float(REST - context.fem[-1].arrays["around"][0]), 0.0


def over_angles(context: Context) -> tuple[float, float, str]:
    """How far T/(mu N) is off tan(alpha/2)/mu; where the roller is squeezed out nothing is left."""
    share, left, ratio = context.fem[-1].arrays["over angles"]
    mu = context.inputs.mu
    stays = wedging.holds(alpha=2 * np.arctan(share * mu), mu=mu)
    missed = np.where(stays, np.abs(ratio - share), EXPELLED / REST * np.abs(left))
    return float(missed.max()), 0.0, f"off by {missed.max():.1e} at most"


def no_slip(context: Context) -> tuple[float, float]:
    """Less than `EDGES` of the normal force is on slipping nodes."""
    return float(EDGES - context.fem[-1].arrays["slipping"][0]), 0.0


def even(context: Context) -> tuple[float, float]:
    """The traction is tan(alpha/2) p within `L2`."""
    return float(L2 - context.fem[-1].arrays["slipping"][1]), 0.0


class PaperFact(Fact):
    """A fact about these inputs: rollers near their limit, or heavily loaded, may differ."""

    paper_only = True

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if context.is_paper else []


def statics(name: str, symbol: str, unit: str, key: str, **more: Any) -> Identity:
    told: dict[str, Any] = {"demand": STATICS, "demand_reason": BALANCED} | more
    return Identity(name=name, symbol=symbol, unit=unit, fem=key, analytic=key, **told)


def printed(
    name: str, symbol: str, unit: str, key: str, fem: str, interval: Callable[..., Any]
) -> Approximation:
    return Approximation(
        name=name, symbol=symbol, unit=unit, analytic=key, fem=fem, interval=interval,
        source="statics of a free roller: it uses tan(α/2)/μ of its friction", demand=1e-5,
        demand_reason=BALANCED,
    )  # fmt: skip


SOLVER = "the solver's balance of a body that only contact holds"
CHECKS = (
    statics("friction force of a free roller", "T", "N", "T"),
    statics("torque of free rollers (Eq. 3, corrected)", "M_t", "N m", "M_free"),
    printed("torque of free rollers, Eq. 3 as printed", "M_t", "N m", "M_caged", "M_free",
            too_much),
    statics("torque of caged rollers (Eq. 3)", "M_t", "N m", "M_caged"),
    statics("cage force (Eq. 1)", "C", "N", "C", scale="N"),
    statics("normal force per torque, free (Eq. 5, corrected)", "N/M_t", "1/m", "N/M"),
    printed("normal force per torque, free, Eq. 4 as printed", "N/M_t", "1/m", "N/M caged", "N/M",
            too_little),
    statics("normal force per torque, caged (Eq. 4)", "N/M_t", "1/m", "N/M caged"),
    statics("least friction of a free roller (Eq. 2)", "μ_c", "1", "mu_c", demand=1e-4,
            demand_reason="bisection to five digits"),
    Fact(name="friction 1 % above tan(α/2) holds the roller (Eq. 2)", symbol="N", unit="1",
         margin=held),
    Fact(name="friction 1 % below tan(α/2) lets it out (Eq. 2)", symbol="N", unit="1",
         margin=let_out),
    Deviation(name="T/(μN) over wedge angles, to the limit and beyond", symbol="ΔT/(μN)",
              unit="1", size=over_angles, accepted=EXPELLED, whole="μN", source=BALANCED,
              everywhere=True),
    *(
        Approximation(name=f"stick half-width of a roller let go, T/(μN) = {k:g}", symbol="c/a",
                      unit="1", analytic=f"c/a, {k:g}", fem=f"c/a, {k:g}", formal=1,
                      interval=half_planes, source="argued: (a/(μR))² of the inclined surfaces, "
                      "2 (a/R)² of half planes")
        for k in SHARES
    ),
    PaperFact(name="N and T grow together: below 1 % of N slips", symbol="N_slip", unit="1",
              margin=no_slip),
    PaperFact(name="N and T grow together: traction within 3 % of tan(α/2) p in L2", symbol="q",
              unit="1", margin=even),
    Exact(name="balance along the bisector", symbol="ΣF", unit="N", fem="along", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="balance of cut and contact", symbol="ΣF", unit="N", fem="across", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="balance of cage and contact", symbol="ΣF", unit="N", fem="cage", scale="N",
          bound=1e-9, bound_reason=SOLVER),
    Exact(name="caged: all nodes at their limit", symbol="μp − q", unit="N", fem="unslipped",
          scale="N", bound=1e-10, bound_reason="Coulomb's law at every node, to round-off"),
)  # fmt: skip
