"""Criteria of sprag clutches at rest and during engagement."""

import math
from typing import Any

from analytic.sprag.work_balance import at_rest
from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.answers.strengths import yield_strength
from verify.answers.torque import criteria_under, permissible
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.recommendations import verdict, why
from verify.cases.sprag.crown.formulas import pressed
from verify.cases.sprag.engagement.model import crowned_for
from verify.cases.sprag.engagement.model import wedge as wedge_states
from verify.cases.sprag.friction.formulas import asked as required_friction
from verify.core.case import Values

FRICTION = "required friction coefficient tan ν of the inner contact"
NO_CROWN = (
    "without a crown (z_m = 0), the pressure at the sprag's ends increases with the number of "
    "slices"
)
MISSING = "give p_lim"
ROLLS_OVER = "the sprags reach the end of their profile and roll over"
STATIC_ONLY = (
    "the pressure is the static one; at the first force peak of an engagement it is larger, see "
    "sprag-crown"
)


def wedge(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a sprag in the wedge: roll-over torque and contact pressures.

    Friction is not an input of this case.
    """
    if "T_roll" in v:  # a disc has no flank
        part.at_most(
            "torque", "torque", q.T, v["T_roll"], "N m", "a contact reaches the sprag's flank"
        )
    for key, place in (("p_i", "inner"), ("p_e", "outer")):
        part.pressure(f"contact_pressure_{place}", f"pressure at the {place} race", v[key], q.E)
    part.unknowns.append(
        f"the friction coefficient is not an input: the sprags lock if it exceeds {v['mu_i']:.4g}; "
        "case sprag-clutch compares it with μ_s"
    )


def clutch(q: Any, _v: Values, part: Assessment) -> None:
    """Criteria under a slowly increasing torque: friction, pressure, roll-over, yielding."""
    state = verdict(q)
    if part.with_design:
        part.design = _permissible(q)
    part.below_input("friction", FRICTION, q.mu_req if q.state else q.mu_0, q, "mu_s")
    if state == "no state":
        part.failures.append(why(q))
    if math.isfinite(q.T_end):
        part.at_most("torque", "torque", q.T, q.T_end, "N m", "end of the sprags' profile")
    if state in ("slips", "rolls over", "no state"):
        return
    for p, place in ((q.p_i, "inner"), (q.p_o, "outer")):
        what = f"largest pressure at the {place} race"
        part.pressure(f"contact_pressure_{place}", what, p, q.E, given=q.p_lim,
                      option=MISSING)  # fmt: skip
    if q.z_m == 0:
        part.unknowns.append(NO_CROWN)
    walls = {"inner": q.R_i - q.R_id, "outer": q.R_ed - q.R_e}
    for stress, (place, wall) in zip(q.tresca, walls.items(), strict=True):
        strength = yield_strength(q.R_p, q.E, wall=wall)
        part.stress(
            f"tresca_stress_{place}", f"Tresca stress of the {place} race", stress, strength
        )


def _permissible(q: Any) -> Quantity | None:
    """Permissible torque if increased slowly; the crown of the sprags is given or assumed."""
    part_as_made = q.model_copy(update={"Q": crowned_for(q)})
    under = criteria_under(part_as_made, lambda _q: {}, clutch)
    return permissible(as_torque_grows(q), q.T, ", quasi-static", under)


def engagement(q: Any, v: Values, part: Assessment) -> None:
    """Criteria at the first force peak under a sudden torque: friction, roll-over and pressure."""
    if "N_max" not in v or q.rolls_over:
        part.failures.append(ROLLS_OVER)
        return
    what = "largest required friction coefficient"
    part.below_input("friction", what, v["mu_asked"], q, "mu_s")
    _largest_pressure(q, v["N_max"], "at the first force peak", part)
    _yield_is_elsewhere(q, part)


def stick_slip(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of stick-slip: required friction coefficient, and contact pressure at rest."""
    if "mu_b" not in v:
        part.failures.append(ROLLS_OVER)
        return
    part.below_input("friction", FRICTION, v["mu_b"], q, "mu_s")
    w = wedge_states(q)
    _largest_pressure(q, float(w.force()(at_rest(w, q.T))), "at rest", part)
    _yield_is_elsewhere(q, part)


def crown(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a crowned sprag: friction, and largest pressure at the first force peak."""
    if "p_peak" not in v:
        part.failures.append("no state within the sprags' profile carries the first force peak")
        return
    part.below_input("friction", FRICTION, required_friction(q)[0], q, "mu_s")
    if q.z_m == 0:
        part.unknowns.append(NO_CROWN)
    part.pressure("contact_pressure", "largest pressure at the first force peak", v["p_peak"], q.E,
                  given=q.p_lim, option=MISSING)  # fmt: skip


def optimum(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of the optimal crown under the static load: friction and pressure.

    The optimum itself is only computed by `check --fem`.
    """
    part.below_input("friction", FRICTION, v["mu_req"], q, "mu_s")
    part.pressure("contact_pressure", "largest pressure under the static load", v["static_peak"],
                  q.E, given=q.p_lim, option=MISSING)  # fmt: skip
    part.unknowns.append(STATIC_ONLY)


def _largest_pressure(q: Any, N: float, when: str, part: Assessment) -> None:
    """Add the criterion for the largest pressure on the inner race under the force `N` [N]."""
    if q.z_m == 0:
        part.unknowns.append(NO_CROWN)
    p = float(pressed(q, N).peak_pressure.max())
    part.pressure("contact_pressure", f"largest pressure {when}", p, q.E, given=q.p_lim,
                  option=MISSING)  # fmt: skip


def _yield_is_elsewhere(q: Any, part: Assessment) -> None:
    if q.R_p is not None:
        part.remarks.append(
            "this case does not compare the stress of the races with R_p: use case sprag-clutch"
        )
