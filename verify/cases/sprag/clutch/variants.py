"""Two variants of the paper's clutch on which its limit of friction and its speed are judged.

The spiral keeps its wedge angle: at the paper's friction no torque slips, and its clutch starts at
rest.
"""

import math

from analytic.sprag.limits import limits
from verify.cases.sprag.clutch.model import analytic_state, built
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs

FAST = 20_000 * 2 * math.pi / 60  # rad/s: the outer race grows by 2 µm


def fast(q: SpragInputs) -> SpragInputs:
    """The clutch with its outer race at 20,000 r/min."""
    return q.model_copy(update={"n": FAST})


def low_friction(v: dict[str, float]) -> float:
    """Friction twice as far above that of first contact as the torque's is: about 2 T slip it."""
    return 2 * v["mu_req"] - v["mu_0"]


def variants(q: SpragInputs, v: dict[str, float]) -> dict[str, float]:
    """Torque [N m] at which the contacts slip at low friction, turn [rad] and growth [m] at speed.

    `per law` is what a change of tan(nu) by one part changes that torque by, in parts.
    """
    if q != EngagementInputs():
        return {}
    mu, quick = low_friction(v), analytic_state(fast(q))
    slip = limits(built(q).clutch, mu=mu, theta_max=q.alpha_max).slip
    return {
        "mu low": mu, "T slip low": float(slip), "per law": mu / (mu - v["mu_0"]),
        "alpha fast": quick["alpha"], "theta fast": quick["theta"],
        "d_ce fast": float(built(fast(q)).parts.d_ce.max()),
    }  # fmt: skip
