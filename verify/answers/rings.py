"""Criteria of rings under pressure, sprag forces and rotation."""

from typing import Any

import numpy as np

from analytic.ring import lame
from verify.answers.assessment import Assessment
from verify.answers.strengths import yield_strength
from verify.core.case import Values

SPRAG_LOAD = (
    "the stress due to the sprag forces F is not included: see ring-loads-inner, ring-loads-outer"
)


def under_pressure(q: Any, _: Values, part: Assessment) -> None:
    """Criteria of a ring, free in the axial direction, under pressure: stress, buckling."""
    loads = {"r_i": q.r_i, "r_o": q.r_o, "p_i": q.p_i, "p_o": q.p_o}
    hoop = lame.stresses([q.r_i, q.r_o], **loads)[1]
    radial = np.array([-q.p_i, -q.p_o])
    largest = float(np.maximum.reduce([abs(hoop - radial), abs(hoop), abs(radial)]).max())
    strength = yield_strength(q.R_p, q.E, wall=q.r_o - q.r_i)
    part.stress("tresca_stress", "Tresca stress of the ring", largest, strength)
    if q.p_o > q.p_i:
        wall, radius = q.r_o - q.r_i, (q.r_i + q.r_o) / 2
        part.at_most("buckling_pressure", "outside pressure minus inside pressure", q.p_o - q.p_i,
                     q.E * wall**3 / (4 * radius**3), "MPa",
                     "elastic buckling of a thin ring, E t^3/(4 r^3)")  # fmt: skip


def under_sprags(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a race under sprag forces: hoop stress and contact pressure."""
    strength = yield_strength(q.R_p, q.E, wall=q.r_o - q.r_i)
    part.stress("hoop_stress", "hoop stress of the race", v["largest hoop stress"], strength)
    part.pressure("contact_pressure", "contact pressure under a sprag", v["p_0"], q.E)


def rotating(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a rotating race: hoop stress at its bore."""
    strength = yield_strength(q.R_p, q.E, wall=q.r_o - q.r_i)
    stress = v["hoop_bore"]
    part.stress("hoop_stress", "hoop stress of the race at its bore", stress, strength)
    part.remarks.append(SPRAG_LOAD)


def pressed_together(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a press fit: Tresca stress of both rings."""
    p = v["p"]
    surfaces = {"inner_bore": q.p_i, "inner_rim": p, "outer_bore": p, "outer_rim": q.p_o}
    tresca = {
        at: max(abs(v[f"hoop_{at}"] + load), abs(v[f"hoop_{at}"])) for at, load in surfaces.items()
    }
    walls = {"inner": q.r_f - q.r_i, "outer": q.r_o - q.r_f}
    moduli = {"inner": q.E_i, "outer": q.E_o}
    for ring, wall in walls.items():
        strength = yield_strength(q.R_p, moduli[ring], wall=wall)
        worst = max(tresca[f"{ring}_bore"], tresca[f"{ring}_rim"])
        part.stress(f"tresca_stress_{ring}", f"Tresca stress of the {ring} ring", worst, strength)
    if p <= 0:
        part.failures.append("the rings are not in contact: the fit pressure is not positive")
