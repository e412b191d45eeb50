"""Criteria of the polyhedral ring clutch and of its parts."""

import math
from typing import Any

from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.answers.strengths import yield_strength
from verify.core.case import Values

EXPELLED = "the rollers are expelled from the wedge: tan(α/2) exceeds the friction coefficient"


def round_ring(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a round ring that pressure expands to the rollers: Tresca stress in the bore."""
    per_pressure = 2 * q.d_e**2 / (q.d_e**2 - q.d_i**2)
    strength = yield_strength(q.R_p, q.E, wall=q.delta_1)
    stress = per_pressure * v["p"]
    part.stress("tresca_stress", "Tresca stress in the bore", stress, strength)


def ring(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a polyhedral ring: hoop stress in the fillets."""
    strength = yield_strength(q.R_p, q.E, wall=q.delta_1)
    part.stress("fillet_stress", "hoop stress in the fillets", v["fillet"], strength)


def locking(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of locking: contact of ring and rollers, stress in the fillets, contact pressure."""
    part.at_least("pressure", "pressure p_t; at p_1r the ring reaches its rollers",
                  q.p_t, v["p_1r"], "MPa", "Eq. 11")  # fmt: skip
    ring(q, v, part)
    if "p_0" in v:
        part.pressure("contact_pressure", "contact pressure on the ring", v["p_0"], q.E)


def wedge(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a free roller in the wedge: required friction and Hertzian pressure."""
    part.below_input("friction", "required friction coefficient tan(α/2)",
                     math.tan(q.alpha / 2), q, "mu")  # fmt: skip
    p = v["p_0"] * math.sqrt(1 + q.d / (q.D_i - 2 * q.d))
    part.pressure("contact_pressure", "Hertzian pressure of the rollers on the convex ring", p, q.E,
                  given=q.p_lim, option="give p_lim")  # fmt: skip


def clutch(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of `polyhedral-clutch`: torque, stress in the fillets, pressures of the rollers."""
    if q.alpha is not None and math.tan(q.alpha / 2) >= q.mu:
        part.failures.append(EXPELLED)
    elif q.p_t <= v["p_1r"]:
        part.failures.append(
            f"at p_t = {q.p_t / 1e6:.4g} MPa the ring does not reach the rollers: this requires "
            "p_1r = "
            f"{v['p_1r'] / 1e6:.4g} MPa, and {_pressure_for_torque(v)}"
        )
    elif "M_el" not in v:
        part.unknowns.append(
            "the hub force alone wedges the rollers: the strength limits the torque, not the "
            "pressure; a larger e or a smaller μ avoids this"
        )
    else:
        _torque(q, v, part)
    ring(q, v, part)
    for key, body in (("p_ring", "ring"), ("p_race", "race")):
        if key in v:
            what = f"Hertzian pressure of the rollers on the {body}"
            part.pressure(f"contact_pressure_{body}", what, v[key], q.E)


def _torque(q: Any, v: Values, part: Assessment) -> None:
    """Add the criterion for the torque, and a remark if a cage is required.

    The design value is the torque in plane strain, the safe bound for a ring of finite width.
    """
    narrow, safe = v["M_el"], min(v["M_el"], v.get("M_wide", v["M_el"]))
    part.design = Quantity(
        key="permissible_torque", symbol="M_el", value=safe, unit="N m",
        what="torque with elastic ring and rollers in plane strain, the safe bound; in plane "
        f"stress {narrow:.4g} N m",
    )  # fmt: skip
    doubt = ""
    if safe < q.M_t <= narrow:
        doubt = f"plane strain gives {safe:.4g} N m"
        part.unknowns.append(
            f"the target torque of {q.M_t:.4g} N m lies between the torques in plane strain "
            f"({safe:.4g} N m) and plane stress ({narrow:.4g} N m)"
        )
    part.at_least("torque", "torque with elastic ring and rollers", narrow if doubt else safe,
                  q.M_t, "N m", "target torque M_t, given", doubt=doubt)  # fmt: skip
    if v["alpha_need"] > v["alpha_ring"]:
        part.remarks.append(
            "this torque requires a cage: without a cage, the wedge of "
            f"{math.degrees(v['alpha_ring']):.2g} deg carries {v['M_ring']:.3g} N m"
        )


def _pressure_for_torque(v: Values) -> str:
    if "p_need" not in v:
        return "no pressure gives the target torque"
    return f"{v['p_need'] / 1e6:.4g} MPa for the target torque"
