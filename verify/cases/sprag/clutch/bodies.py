"""What the bodies of a sprag clutch bear and how they deform but for the paper's deflections."""

import math

import numpy as np

from analytic.ring import lame
from analytic.ring.fourier_ring import Wall
from analytic.ring.smeared import smeared_error
from analytic.sprag.closure import wedged
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.cases.sprag.wedge import model as sprag_wedge_model

APART = 0.9  # of half a pitch: patches that are wider would overlap


def hoop(q: SpragInputs, N: float, N_e: float) -> dict[str, float]:
    """Hoop stresses [Pa] at R_i, at the inner race's bore and at R_e, and Tresca's of both races.

    The forces are smeared; the inner race has its largest stress at its bore, the outer at R_e.
    """
    inner = {"r_i": q.R_id, "r_o": q.R_i, "p_i": 0.0, "p_o": q.z * N / (2 * math.pi * q.R_i * q.l)}
    outer = {"r_i": q.R_e, "r_o": q.R_ed, "p_i": q.z * N_e / (2 * math.pi * q.R_e * q.l)}
    _, around_i = lame.stresses([q.R_i, q.R_id], **inner)
    radial, around_e = lame.stresses(q.R_e, **outer)
    return {
        "s_i": float(around_i[0]), "s_id": float(around_i[1]), "s_e": float(around_e),
        "Tresca_i": float(-around_i[1]), "Tresca_e": float(around_e - radial),
    }  # fmt: skip


def uneven(q: SpragInputs, N: float, loaded: Wall) -> float:
    """Deflection of a race under each sprag, indentation excluded, over Eq. 6's smeared ring."""
    r, ratio = (q.R_i, q.R_i / q.R_id) if loaded == "rim" else (q.R_e, q.R_ed / q.R_e)
    a = sprag_wedge_model.bodies(q).half_widths(np.asarray(N))[loaded == "bore"]
    a_r = min(float(a) / r, APART * math.pi / q.z)
    return 1 / (1 + smeared_error(n=q.z, ratio=ratio, a_r=a_r, nu=q.nu, loaded=loaded).load)


def thrown(q: EngagementInputs) -> float:
    """Centrifugal force [N] of a sprag at the speed n, at the middle between the races."""
    return q.m_g * q.n**2 * (q.R_i + q.R_e) / 2


def least_force(q: SpragInputs, contact: int) -> float:
    """Inner normal force [N] at which the inner (0) or outer (1) race reaches R_p."""
    if q.R_p is None:
        return math.inf
    N_e = 1.0
    if contact == 1:  # the share of the outer contact hardly changes with the force
        now = wedged(built(q).clutch, sprag_wedge_model.rigid_force(q))
        N_e = float(now.N_e / now.N) if np.isfinite(now.N_e) else 1.0
    return q.R_p / hoop(q, 1.0, N_e)[("Tresca_i", "Tresca_e")[contact]]
