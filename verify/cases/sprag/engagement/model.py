"""A sprag clutch as an engagement needs it: its statics, its table, what moves, and its spring.

Everything here is formulas: nothing is compiled.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline

from analytic.contact import crown
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.course import energy, rolled
from analytic.sprag.laws import LOADS, sliced_law
from analytic.sprag.motion import Motion
from analytic.sprag.parts import Parts
from analytic.sprag.start import spring_equilibrium
from analytic.sprag.table import INTERVALS, Table, tabulated
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.core.figures import Array

KEPT = 64  # clutches in memory
STATES = 401  # on the way from no load to the end of the profile
HEADROOM = 2.5  # of the static load: a load that comes at once swings to twice, or a little less
SHARE = 1.3  # of the energy put in, which the end of the table must bear
LONGEST = 60  # times that the largest load is raised


def parts(q: SpragInputs) -> Parts:
    """Dimensions and material."""
    return Parts(
        sprag=q.sprag, n_s=q.z, l=q.l, b=q.b, R_id=q.R_id, R_ed=q.R_ed, E=q.E, nu=q.nu,
        rho=q.density, omega=q.n,
    )  # fmt: skip


def crowned_for(q: SpragInputs) -> float:
    """Load [N] that the crown is made for: Q, or the static load without yields."""
    return q.Q or q.T / (q.z * q.R_i * math.tan(q.nu_0))


def gap(q: SpragInputs) -> Array:
    """Drop [m] of the crown at the slices' centres, (slices,)."""
    y = crown.slice_centres(length=q.l, slices=q.slices)
    if q.z_m == 0:
        return np.zeros_like(y)
    return crown.logarithmic(
        y, K_1=q.K_1, K_2=q.K_2, z_m=q.z_m, load=crowned_for(q), length=q.l,
        E_star=float(parts(q).E_star),
    )  # fmt: skip


def clutch(q: SpragInputs, N_end: float, loads: int = LOADS) -> Clutch:
    """The clutch with contacts in slices, solved at some loads up to N_end [N]."""
    whole, E_star = parts(q), float(parts(q).E_star)
    inner, outer = (
        sliced_law(gap(q), l=q.l, R=float(R), E_star=E_star, N_max=N_end, loads=loads)
        for R in (whole.R_contact_i, whole.R_contact_e)
    )
    return Clutch(
        sprag=q.sprag, n_s=q.z, compliance=whole.compliance(contact_i=inner, contact_e=outer)
    )


@dataclass(frozen=True, eq=False)
class Wedge:
    """A clutch with its states (n,) from no load to `end`, and the races' turn theta [rad] there.

    `ends` says whether the profile ends there, or only the force.
    """

    q: EngagementInputs
    clutch: Clutch
    states: Wedged
    theta: Array
    ends: bool

    @property
    def end(self) -> float:
        """The largest force [N]."""
        return float(self.states.N[-1])

    def table(self, intervals: int = INTERVALS) -> Table:
        """The same over the rotation."""
        return _table(self, intervals)

    @property
    def blades(self) -> Array:
        """What the blades add to the torque [N m] as the races turn, (n,)."""
        q, now = self.q, self.states
        turn = now.OC_e / now.OB * np.gradient(now.alpha_b, self.theta, edge_order=2)
        return np.asarray(q.z * q.K_r * (q.alpha_max - now.alpha) * turn)

    def force(self) -> CubicSpline:
        """N [N] over the turn [rad]."""
        return CubicSpline(self.theta, self.states.N)

    def resistance(self) -> CubicSpline:
        """Torque [N m] that the sprags resist with over the turn [rad], less the blades'."""
        return CubicSpline(self.theta, self.states.T - self.blades)

    @property
    def start(self) -> float:
        """Turn [rad] at which the blades alone press the sprags on their races."""
        N, _ = spring_equilibrium(self.clutch, K_r=self.q.K_r, alpha_max=self.q.alpha_max)
        return float(np.interp(N.N, self.states.N, self.theta))


@lru_cache(maxsize=KEPT)
def _table(w: Wedge, intervals: int) -> Table:
    return tabulated(w.clutch, N_end=w.end, intervals=intervals)


@lru_cache(maxsize=KEPT)
def wedge(q: EngagementInputs, *, rigid: bool = False) -> Wedge:
    """The clutch up to what an engagement can reach, or the end of the profile.

    `rigid` races are Liu's.
    """
    N = HEADROOM * crowned_for(q)
    for _ in range(LONGEST):
        found = clutch(q, N)
        found = found.rigid_races() if rigid else found
        states = wedged(found, N * np.linspace(0, 1, STATES) ** 2)
        inside = np.isfinite(states.alpha) & (states.alpha - states.alpha[0] <= q.alpha_max)
        if not inside.all():
            return _to_profile_end(q, found, N)
        put_in = q.T * rolled(found, N) + q.I_bi * q.w_i**2 / 2 + _sprung(q, states.alpha)
        if q.z * energy(found, N) > SHARE * put_in:
            return _of(q, found, N, ends=False)
        N *= 2
    raise ValueError(f"no force bears the torque T = {q.T:g} N m")


def _sprung(q: EngagementInputs, alpha: Array) -> float:
    """What the blades do [J] on the way from the first of the rotations to the last."""
    left = q.alpha_max - alpha
    return float(q.z * q.K_r * (left[0] ** 2 - left[-1] ** 2) / 2)


def _to_profile_end(q: EngagementInputs, found: Clutch, N: float) -> Wedge:
    low, high = 0.0, N
    first = float(wedged(found, 0.0).alpha)
    for _ in range(60):
        middle = (low + high) / 2
        alpha = float(wedged(found, middle).alpha) - first
        low, high = (middle, high) if alpha <= q.alpha_max else (low, middle)
    return _of(q, found, low, ends=True)


def _of(q: EngagementInputs, found: Clutch, N: float, *, ends: bool) -> Wedge:
    loads = N * np.linspace(0, 1, STATES) ** 2
    return Wedge(q, found, wedged(found, loads), rolled(found, loads), ends)


def motion(q: EngagementInputs) -> Motion:
    """Inertias, springs, damping, friction."""
    return Motion(
        m_g=q.m_g, I_g=q.I_g, I_bi=q.I_bi, I_be=q.I_be, K_r=q.K_r, alpha_max=q.alpha_max,
        C_rl=q.C_rl, k_out=q.k_out, mu_s=q.mu_s, mu_c=q.mu_c, gamma_b=q.gamma_b,
    )  # fmt: skip
