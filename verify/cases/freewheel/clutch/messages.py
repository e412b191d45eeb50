"""First messages on a freewheel: its class, its limits and the effect of tolerances."""

import math
from collections.abc import Sequence

from analytic.freewheel.duty import Limit
from analytic.freewheel.scatter import DRAWS
from verify.cases.freewheel.clutch.classes import light, past_corners
from verify.cases.freewheel.clutch.course import axial, tilted, torque, where_friction_holds
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.numbers import newton, newton_metres, pascal, share
from verify.cases.freewheel.clutch.recommendations import advice, sensitive
from verify.core.case import Values

DEGREE = math.degrees(1.0)


def findings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = [f"{light(q, v)}: {verdict(q, v)}", *advice(q, v)]
    if q.duty.under is not None and v["mu_0"] <= q.mu:
        found += torque(q, v)
        if not past_corners(q, v):
            found += axial(q, v) + tilted(q, v)
    found += scattered(q, v) + sensitive(q, v)
    if q.duty.under is not None and light(q, v) in ("red", "yellow"):
        found.append(
            "forces, pressures, roller travel and wind-up below are computed as if the clutch held"
        )
    return found


def verdict(q: ClutchInputs, v: Values) -> str:
    """Reason for the class, by Coulomb's law."""
    if q.T < 0:
        return "the torque turns against the locking direction: the clutch overruns, and the "\
            "criterion does not apply"  # fmt: skip
    if v["mu_0"] > q.mu:
        ratio = "" if "safety" not in v else f" (μ/μ_req = {v['safety']:.3g})"
        return f"tan α_0 = {v['mu_0']:.4g} exceeds μ = {q.mu:g}: the clutch releases itself; any "\
               f"torque drives the rollers out of their wedges{ratio}"  # fmt: skip
    if q.T == 0:
        if q.F_ax == 0:
            wedge = f"tan α_0 = {v['mu_0']:.4g} does not exceed μ = {q.mu:g}, so the rollers wedge"
            return f"no load; {wedge}; {where_friction_holds(q)}"
        return "without torque the rollers are not pressed: no friction resists "\
            f"F_ax = {newton(q.F_ax)}"  # fmt: skip
    if "safety" not in v:
        last = "pop_through" if math.isfinite(q.duty.of_torque_alone.pop_through) else "hertz"
        return f"no equilibrium at T = {newton_metres(q.T)}: {Limit(last, q.duty.end).words} at "\
            f"{newton_metres(q.duty.end)}"  # fmt: skip
    needs = f"required friction coefficient {v['mu_req']:.4g}, available {q.mu:g}"
    ratio = f"μ/μ_req = {v['safety']:.4g}"
    if past_corners(q, v):
        alone = "friction alone would hold" if v["safety"] >= 1 else "the contacts would slip, too"
        at = f"T_c = {newton_metres(v['T_corner'])}"
        return f"the rollers are beyond the ends of the cam flats ({at}); {alone}, {ratio}"
    if light(q, v) == "overloaded":
        return f"{ratio}: friction holds ({needs}), {beyond(q, v)}"
    if v["safety"] >= 1:
        return f"{ratio}: by Coulomb's law the clutch holds ({needs})"
    seen = "; class yellow follows the paper's observations" if light(q, v) == "yellow" else ""
    return f"{ratio}: by Coulomb's law the clutch slips ({needs}){seen}"


def beyond(q: ClutchInputs, v: Values) -> str:
    """The exceeded limits of an overloaded clutch."""
    found = []
    if q.p_lim is not None and v.get("p_end", math.inf) > q.p_lim:
        even = max(v["p_i"], v["p_o"])
        part = "inner" if v["p_i"] >= v["p_o"] else "outer"
        most = f"{pascal(even)} at the {part} contacts" if even > q.p_lim else \
            f"{pascal(v['p_end'])} at the rollers' ends" if "p_end" in v else \
            "one end of the rollers carries the whole load"  # fmt: skip
        found.append(f"contacts are overloaded: {most}, p_lim is {pascal(q.p_lim)}")
    if v["e_L"] > q.duty.allowed_shift:
        found.append(f"the rollers tilt: e/L = {v['e_L']:.3g} exceeds {q.duty.allowed_shift:.3g}")
    return " and ".join(found)


def scattered(q: ClutchInputs, v: Values) -> list[str]:
    if "P_slip" not in v:
        return []
    given = [
        f"±{t * 1e6:.3g} µm on {name}"
        for name, t in (("X", q.X_tol), ("r", q.r_tol), ("R", q.R_tol)) if t > 0
    ] + ([f"μ = {q.mu:g} (standard deviation {q.s_mu:g})"] if q.s_mu > 0 else [])  # fmt: skip
    shares = ", ".join(f"{share(v[f'share_{c}'])} {c}" for c in ("green", "yellow", "red"))
    through = "pop through" if not q.is_star else "have contacts too wide for the formulas"
    lost = [
        f"{share(v[f'P_{key}'])} {words}"
        for key, words in (("no_wedge", "have no wedge"), ("no_state", through),
                           ("corner", "have rollers beyond the ends of the flats"))
        if f"P_{key}" in v
    ]  # fmt: skip
    spread = ""
    if "alpha_below_5" in v:
        spread = (
            "; 90 % of the clutches whose rollers can wedge have α_0 from "
            f"{v['alpha_0_below_5'] * DEGREE:.3f}° to {v['alpha_0_below_95'] * DEGREE:.3f}° and "
            f"μ/μ_req from {v['safety_below_5']:.3g} to {v['safety_below_95']:.3g}"
        )
    slips = ", ".join([*lost, f"{share(v['P_slip'])} slip"])
    return [
        f"random sample of {DRAWS:,} clutches with {', '.join(given)}; all rollers of a clutch "
        f"are identical; of these clutches, {slips} (classes by μ/μ_req: {shares}){spread}"
    ]


def warnings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = reached(q) + default_poisson(q)
    if q.p_lim is not None and v.get("p_end", 0.0) > q.p_lim:
        found.append(
            f"the pressure of {pascal(v['p_end'])} at the rollers' ends exceeds p_lim = "
            f"{pascal(q.p_lim)}: the surfaces yield"
        )
    if v.get("e_L", 0.0) > q.duty.allowed_shift:
        found.append(
            f"the rollers tilt: e/L = {v['e_L']:.3g} exceeds its limit {q.duty.allowed_shift:.3g}"
        )
    return found


def default_poisson(q: ClutchInputs) -> list[str]:
    """Warnings for parts with a separate Young's modulus but without a given Poisson's ratio."""
    return [
        f"E_{part} is given without ν_{part}: ν = {q.nu:g} is used for this part"
        for part in "rio"
        if getattr(q, f"E_{part}") not in (None, q.E) and getattr(q, f"nu_{part}") is None
    ]


def reached(q: ClutchInputs) -> list[str]:
    """A warning if X_tol + 2 r_tol + R_tol reaches the clearance that the wedge requires."""
    used, room = q.X_tol + 2 * q.r_tol + q.R_tol, float(q.cam.room)
    if used < room:
        return []
    rule = "R - 2 r - X" if q.is_star else "R + 2 r - X"
    return [
        f"the tolerances exceed {rule} = {room * 1e6:.4g} µm: X_tol + 2 r_tol + R_tol = "
        f"{used * 1e6:.4g} µm; clutches within tolerance may have no wedge"
    ]
