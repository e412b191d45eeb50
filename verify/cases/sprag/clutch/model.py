"""States of a sprag clutch under torque, by different models, and its limits."""

import math
from functools import lru_cache

import numpy as np

from analytic.sprag import printed
from analytic.sprag.closure import Wedged, at_torque, wedged
from analytic.sprag.crowned import Crowned
from analytic.sprag.laws import LOADS
from analytic.sprag.limits import SpragClutchLimits, sprag_torque_limits
from analytic.sprag.search import first_reach
from analytic.sprag.start import spring_equilibrium
from verify.cases.sprag.engagement.model import clutch, gap, parts
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs

WIDE = 0.15  # largest half-width for Hertz's law, over the inner contact's relative radius
MANY, FEW_LOADS = 61, 21  # number of slices above which a contact's law has fewer loads
HALF = 0.5  # load over N at which a crown's ends are unloaded and strips have a finite peak
FAST = 20_000 * 2 * math.pi / 60  # rad/s: the outer race grows by 2 µm


@lru_cache(maxsize=16)
def built(q: SpragInputs) -> Crowned:
    whole = parts(q)
    N_top = WIDE**2 * np.pi / 4 * q.l * float(whole.R_contact_i) * float(whole.E_star)
    found = clutch(q, 1.01 * N_top, LOADS if q.slices < MANY else FEW_LOADS)
    return Crowned(whole, found, gap(q), N_top)


@lru_cache(maxsize=16)
def under(q: SpragInputs) -> Wedged | None:
    """Equilibrium state under T; None if the force is beyond the range of the contact laws."""
    one = built(q)
    now = at_torque(one.clutch, q.T)
    return now if np.isfinite(now.N) and one.N_top >= now.N else None


@lru_cache(maxsize=16)
def rigid(q: SpragInputs) -> Wedged | None:
    """Equilibrium state under T with rigid races (Liu); None if `under` is None."""
    return None if under(q) is None else at_torque(built(q).clutch.rigid_races(), q.T)


@lru_cache(maxsize=16)
def literal(q: SpragInputs) -> Wedged | None:
    """Equilibrium state under T with Eqs. 9 and 10 as printed; None if `under` is None."""
    if (now := under(q)) is None:
        return None
    clutch = built(q).clutch
    N = first_reach(
        lambda F: printed.wedged(clutch, F).T, np.asarray(q.T), start=np.asarray(float(now.N))
    )
    return printed.wedged(clutch, N)


def normal_force(state: Wedged | None) -> float:
    """Normal force [N] on the inner race; nan without a state."""
    return math.nan if state is None else float(state.N)


@lru_cache(maxsize=16)
def spring_force(q: EngagementInputs) -> float:
    """Normal force N_0 [N] that the springs alone cause; nan if no equilibrium is found."""
    clutch = built(q).clutch
    if not q.alpha_max > wedged(clutch, 0.0).alpha:
        return 0.0
    try:
        now, _ = spring_equilibrium(clutch, K_r=q.K_r, alpha_max=q.alpha_max)
    except ArithmeticError:
        return math.nan
    return float(now.N)


@lru_cache(maxsize=16)
def grip(q: SpragInputs) -> SpragClutchLimits:
    """Limits of the torque [N m]: slip of the contacts, and contact at the end of the profile."""
    return sprag_torque_limits(built(q).clutch, mu=q.mu_s, theta_max=q.alpha_max)


def low_friction(q: SpragInputs) -> float:
    """Friction coefficient with which the contacts slip at about 2 T; nan if no state exists.

    The excess of this coefficient over tan(nu_0) is twice the excess that T requires. With the
    friction of the paper, no torque makes the contacts slip, because the wedge angle of the spiral
    is nearly constant.
    """
    now = under(q)
    required = math.nan if now is None else float(np.tan(float(now.nu)))
    return 2 * required - float(np.tan(q.sprag.nu_0))


def fast(q: SpragInputs) -> SpragInputs:
    """Inputs with the outer race at 20,000 r/min; the paper's outer race is at rest."""
    return q.model_copy(update={"n": FAST})
