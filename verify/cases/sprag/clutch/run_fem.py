"""Engagements of a sprag clutch by the equations of motion, with their pressures."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from analytic.sprag.crowned import Crowned
from analytic.sprag.history import Engagement
from analytic.sprag.motion import Speeds, Torque
from analytic.sprag.table import tabulated
from verify.cases.sprag.clutch.model import built, spring_force, under
from verify.cases.sprag.engagement.model import motion
from verify.cases.sprag.inputs import EngagementInputs

AHEAD, WIDER = 4.0, 3.0  # end of the table over the static force; factor for the next table
INSIDE = 1 - 1e-6


@dataclass(frozen=True, eq=False)
class Run:
    """Engagement, with the clutch for which it was computed."""

    one: Crowned
    engagement: Engagement
    end_of_profile: bool  # the table ends with the profile, not with the formulas

    @property
    def peaks(self) -> tuple[float, float]:
        """Largest pressures [Pa] of inner and outer contacts over the whole engagement."""
        return self.one.peaks(self.engagement.N_max)


@lru_cache(maxsize=32)
def run_fem(q: EngagementInputs) -> Run:
    """Engagement of the clutch. Raises ArithmeticError or ValueError if no engagement is found."""
    one, now = built(q), under(q)
    least = np.nanmax([spring_force(q), float(now.N) if now else one.N_top])
    return engaged_fem(one, q, AHEAD * float(least))


def engaged_fem(one: Crowned, q: EngagementInputs, N_end: float) -> Run:
    """Engagement of a clutch with solved contacts.

    The table of forces ends at N_end [N]; if the engagement exceeds it, the table is extended.
    """
    from analytic.sprag.transient import engage

    N_end = min(N_end, INSIDE * one.N_top)
    while True:
        table = tabulated(one.clutch, N_end=N_end, theta_max=q.alpha_max)
        found = engage(
            table, motion(q), Torque.step(q.T, t_ramp=q.t_ramp), duration=q.t_end, dt=q.dt,
            D_V=q.D_V, speeds=Speeds(inner=q.w_i),
        )  # fmt: skip
        profile_ends = bool(table.values[0, -1] < (1 - 1e-9) * N_end)
        if not found.over or profile_ends or N_end >= INSIDE * one.N_top:
            return Run(one, found, profile_ends)
        N_end = min(WIDER * N_end, INSIDE * one.N_top)
