"""Criteria of sprag clutches at rest and in their engagement."""

import math
from typing import Any

from verify.answers.assessment import Assessment
from verify.answers.strengths import yield_strength
from verify.answers.torque import permissible
from verify.case import Values
from verify.cases.sprag_clutch_advice import why
from verify.cases.sprag_clutch_limits import as_torque_grows, verdict

FRICTION = "required friction coefficient tan ν of the inner contact"
NO_CROWN = (
    "without a crown (z_m = 0) the pressure at the sprag's ends grows with the number of slices"
)
MISSING = "give p_lim"


def wedge(q: Any, v: Values, part: Assessment) -> None:
    """Roll-over torque and contact pressures; friction is not an input of this case."""
    part.at_most("torque", "torque", q.T, v["T_roll"], "N m", "a contact reaches the sprag's flank")
    for key, place in (("p_i", "inner"), ("p_e", "outer")):
        part.pressure(f"contact_pressure_{place}", f"pressure at the {place} race", v[key], q.E)
    part.unknowns.append(
        f"the friction coefficient is not an input: the sprags grip above {math.tan(v['nu']):.4g}; "
        "case sprag-clutch compares it with μ_s"
    )


def clutch(q: Any, v: Values, part: Assessment) -> None:
    """Friction, pressures, end of the profile and yielding of the races, torque rising slowly."""
    state = verdict(q, v)
    if part.with_design:
        part.design = permissible(as_torque_grows(q), ", rising slowly")
    part.below_input("friction", FRICTION, v.get("mu_req", v["mu_0"]), "mu_s", q.mu_s, "1")
    if state == "no state":
        part.failures.append(why(q, v))
    if "T end" in v:
        part.at_most("torque", "torque", q.T, v["T end"], "N m", "end of the sprags' profile")
    if state in ("slips", "rolls over", "no state"):
        return
    for key, place in (("p_i", "inner"), ("p_o", "outer")):
        what = f"largest pressure at the {place} race"
        part.pressure(f"contact_pressure_{place}", what, v[key], q.E, given=q.p_lim,
                      option=MISSING)  # fmt: skip
    if q.z_m == 0:
        part.unknowns.append(NO_CROWN)
    walls = {"inner": ("Tresca_i", q.R_i - q.R_id), "outer": ("Tresca_e", q.R_ed - q.R_e)}
    for place, (key, wall) in walls.items():
        strength = yield_strength(q.R_p, q.E, wall=wall)
        part.stress(
            f"tresca_stress_{place}", f"Tresca stress of the {place} race", v[key], strength
        )


def engagement(q: Any, v: Values, part: Assessment) -> None:
    """Friction and rolling over during the first peak of a torque that rises suddenly."""
    if "N_max" not in v:
        part.failures.append("the sprags roll over, or no state exists, in the first peak")
        return
    what = "largest required friction coefficient"
    part.below_input("friction", what, v["mu_asked"], "mu_s", q.mu_s, "1")


def stick_slip(q: Any, v: Values, part: Assessment) -> None:
    """Static friction beside that at which the sprags begin to slide."""
    part.below_input("friction", FRICTION, v["mu_b"], "mu_s", q.mu_s, "1")


def crown(q: Any, v: Values, part: Assessment) -> None:
    """Largest pressure of the first peak along the crowned sprag."""
    if "p peak" not in v:
        part.failures.append("no state within the sprags' profile carries the first peak")
        return
    if q.z_m == 0:
        part.unknowns.append(NO_CROWN)
    part.pressure("contact_pressure", "largest pressure in the first peak", v["p peak"], q.E,
                  given=q.p_lim, option=MISSING)  # fmt: skip


def optimum(q: Any, v: Values, part: Assessment) -> None:
    """Friction and pressure under the static load; the optimum itself needs `check --fem`."""
    part.below_input("friction", FRICTION, v["mu_req"], "mu_s", q.mu_s, "1")
    part.pressure("contact_pressure", "largest pressure under the static load", v["static peak"],
                  q.E, given=q.p_lim, option=MISSING)  # fmt: skip
