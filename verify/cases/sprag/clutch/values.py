"""All values of a sprag clutch: its sprags, its state under torque, its limits."""

import math
from functools import lru_cache

import numpy as np

from analytic.sprag.closure import wedged
from analytic.sprag.start import spring_equilibrium
from verify.cases.sprag.clutch.bodies import bodies
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.model import analytic_state, built, slopes
from verify.cases.sprag.clutch.variants import variants
from verify.cases.sprag.inputs import EngagementInputs

LAW = 2e-5  # of N, tan(nu): what the cubic between the loads of a contact's law may miss, standard
LAW_ALPHA = 1e-3  # the same of the turn and the yields, 0.15 % of the contacts' at the most


@lru_cache(maxsize=16)
def blades(q: EngagementInputs) -> float:
    """Force N_0 [N] of the springs alone; nan where no state that bears them is found."""
    clutch = built(q).clutch
    if not q.alpha_max > wedged(clutch, 0.0).alpha:
        return 0.0
    try:
        now, _ = spring_equilibrium(clutch, K_r=q.K_r, alpha_max=q.alpha_max)
    except ArithmeticError:
        return math.nan
    return float(now.N)


@lru_cache(maxsize=16)
def analytic(q: EngagementInputs) -> dict[str, float]:
    """SI values; those that the clutch does not have, or that are infinite, are left out."""
    sprag, one = q.sprag, built(q)
    found = {
        "nu_0": float(sprag.nu_0), "omega_0": float(sprag.omega_0), "m": float(np.asarray(sprag.m)),
        "beta_0": float(sprag.beta_0), "eta_0": float(sprag.eta_0), "r_e": float(sprag.r_e),
        "OC_e": float(sprag.OC_e), "mu_0": float(np.tan(sprag.nu_0)), "N_0": blades(q),
        "d_ce": float(np.max(one.parts.d_ce)), "law": LAW, "law alpha": LAW_ALPHA,
    }  # fmt: skip
    found |= {f"T {limit.key}": limit.at for limit in as_torque_grows(q)}
    found |= slopes(q) | analytic_state(q)
    if "N" in found:
        found |= bodies(q, found["N"], found["N_e"])
    if "mu_req" in found:
        found |= variants(q, found)
        found["law slip"] = LAW * found.get("per law", math.nan)
    return {key: value for key, value in found.items() if np.isfinite(value)}
