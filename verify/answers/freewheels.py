"""Criteria of roller freewheels: friction, contact pressure, tilting, end of the cam flats."""

import math
from typing import Any

from analytic.contact import hertz_line
from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.answers.strengths import yield_strength
from verify.answers.torque import criteria_under, permissible
from verify.cases.freewheel.clutch.classes import past_corners
from verify.cases.freewheel.clutch.messages import verdict
from verify.cases.ring.loads.case import OUTER, OuterRace
from verify.core.case import Values

LOST = 0.01  # share of the clutches within tolerance
NO_RING = "the bending stress of the outer ring is not checked"
MARGIN = "required friction coefficient"


def under_torque(q: Any, v: Values, part: Assessment) -> None:
    """Criteria under torque: contact pressures. Friction is not an input of these cases."""
    _pressures(q, v, part)
    part.unknowns.append(
        "the friction coefficient is not an input: the clutch locks if it exceeds "
        f"{v['mu_T']:.4g}; case "
        "freewheel-clutch compares it with μ"
    )


def cup(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of an outer cam: contact pressures, and the torque at pop-through."""
    part.at_most("torque", "torque", q.T, v["T_max"], "N m", "largest torque before pop-through")
    under_torque(q, v, part)


def with_axial_load(q: Any, v: Values, part: Assessment) -> None:
    """Criteria under torque and axial load: friction, and pressure on the flat."""
    part.below_input("friction", MARGIN, v["mu_req"], q, "mu")
    _flat_pressure(q, v["N"], v.get("pressure", 1.0), part)


def load_paths(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of the three load cases of the test rig: largest required friction coefficient."""
    part.below_input("friction_torque", f"{MARGIN} under torque alone", v["mu_T"], q, "mu")
    for case in (1, 2, 3):
        if f"peak_{case}" in v:
            part.below_input(f"friction_load_case_{case}", f"{MARGIN}, load case {case}",
                         v[f"peak_{case}"], q, "mu")  # fmt: skip
        else:
            part.unknowns.append(
                f"load case {case}: the formulas give no required friction "
                "coefficient with these inputs"
            )
    _flat_pressure(q, v["N"], 1.0, part)


def clutch(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of `freewheel-clutch`: friction, contact pressure, tilting, end of the cam flats."""
    if q.T < 0:
        part.unknowns.append("the torque acts against the locking direction: the clutch overruns")
        return
    what = f"{MARGIN} without load, tan α_0"
    part.below_input("friction_unloaded", what, v["mu_0"], q, "mu")
    if q.T == 0:
        if q.F_ax > 0:
            part.failures.append(
                "without torque the rollers are not pressed on: no friction carries the axial load"
            )
        elif part.with_design and v["mu_0"] <= q.mu:
            part.design = _permissible(q)
        return
    if part.with_design and v["mu_0"] <= q.mu:
        part.design = _permissible(q)
    _within_tolerances(v, part)
    if "safety" not in v:
        part.failures.append(verdict(q, v))
        return
    part.below_input("friction", MARGIN, v["mu_req"], q, "mu")
    worst = v.get("p_end", math.inf)
    part.pressure("contact_pressure", "largest contact pressure, rollers' ends included", worst,
                  *_moduli(q), given=q.p_lim, option="give p_lim")  # fmt: skip
    source = "one end lifts off" if q.e_lim is None else "given"
    part.at_most("tilting", "shift e/L of the contact forces by tilting", v["e_L"],
                 q.duty.allowed_shift, "1", source)  # fmt: skip
    if q.is_star:
        _outer_ring(q, v, part)
    if past_corners(q, v):
        part.failures.append("the rollers are beyond the end of the cam flats")


def _permissible(q: Any) -> Quantity | None:
    """Largest permissible torque at the given axial load; all tolerances are set to zero."""
    exact = q.model_copy(update={"X_tol": 0.0, "r_tol": 0.0, "R_tol": 0.0, "s_mu": 0.0})
    under = criteria_under(exact, lambda one: one.values, clutch)
    return permissible(q.duty.of_torque, q.T, " at this axial load", under)


def _flat_pressure(q: Any, N: float, factor: float, part: Assessment) -> None:
    """Add the criterion for the Hertzian pressure on the flat, times the `factor` for tilt."""
    E_star = q.E / (2 * (1 - q.nu**2))
    p = float(hertz_line.peak_pressure(P=N / q.L, R=q.r, E_star=E_star))
    part.pressure("contact_pressure", "largest contact pressure", factor * p, q.E)


def _outer_ring(q: Any, v: Values, part: Assessment) -> None:
    """Add the criterion for the hoop stress of the outer ring under its roller forces.

    The stress is computed as in the case ring-loads-outer. A housing counts as part of the ring,
    because R_a includes it.
    """
    E = _moduli(q)[2]
    try:
        ring = OuterRace(r_i=q.R, r_o=q.R_a, n=q.z, F=v["N"], L=q.L, R=q.r, E=E, nu=q.nu)
        stress = OUTER.analytic(ring)["largest hoop stress"]
    except ValueError:  # dimensions beyond those of the ring's case
        part.remarks.append(NO_RING)
        return
    strength = yield_strength(None, E, wall=q.R_a - q.R)
    part.stress("hoop_stress_ring", "hoop stress of the outer ring", stress, strength,
                "case ring-loads-outer accepts R_p")  # fmt: skip


def _within_tolerances(v: Values, part: Assessment) -> None:
    """Make the answer "cannot say" if clutches within the tolerances slip or do not wedge."""
    lost = sum(v.get(key, 0.0) for key in ("P_slip", "P_no_wedge", "P_no_state"))
    if lost > LOST:
        part.unknowns.append(
            f"a fraction {lost:.3g} of the clutches within the tolerances slips or does not wedge"
        )


def _moduli(q: Any) -> list[float]:
    return [q.E if E is None else E for E in (q.E_r, q.E_i, q.E_o)]


def _pressures(q: Any, v: Values, part: Assessment) -> None:
    for key, place in (("p_i", "inner"), ("p_o", "outer")):
        what = f"pressure of the {place} contacts"
        part.pressure(f"contact_pressure_{place}", what, v[key], q.E)
