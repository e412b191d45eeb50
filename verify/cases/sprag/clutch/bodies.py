"""Non-uniform deflection, centrifugal force and yield load of a sprag clutch."""

import math

import numpy as np

from analytic.ring.fourier_ring import Wall
from analytic.sprag.closure import wedged
from analytic.sprag.race_stress import hoop, over_smeared
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.engagement.model import parts
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.cases.sprag.wedge import model as sprag_wedge_model


def uneven(q: SpragInputs, N: float, loaded: Wall) -> float:
    """Ratio of the deflection of a race under a sprag (without indentation) to that of Eq. 6."""
    a = sprag_wedge_model.bodies(q).half_widths(np.asarray(N))[loaded == "bore"]
    return over_smeared(parts(q), float(a), loaded)


def centrifugal_force(q: EngagementInputs) -> float:
    """Centrifugal force [N] on a sprag at the speed n; the mass is midway between the races."""
    return q.m_g * q.n**2 * (q.R_i + q.R_e) / 2


def least_force(q: SpragInputs, contact: int) -> float:
    """Normal force [N] on the inner race that stresses the inner (0) or outer (1) race to R_p."""
    if q.R_p is None:
        return math.inf
    N_e = 1.0
    if contact == 1:  # the share of the outer contact hardly changes with the force
        now = wedged(built(q).clutch, sprag_wedge_model.rigid_force(q))
        N_e = float(now.N_e / now.N) if np.isfinite(now.N_e) else 1.0
    return q.R_p / hoop(parts(q), 1.0, N_e)[("Tresca_i", "Tresca_e")[contact]]
