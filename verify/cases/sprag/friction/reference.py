"""Runge-Kutta steps with sliding contacts: limits of locking, sliding states, rejected time steps.

The band is the range of sliding speeds in which a contact may stick.

Each level has half the time step of the level before. Compiled code is imported inside functions.
"""

import math

import numpy as np

from analytic.sprag.motion import Speeds, Torque
from analytic.sprag.readings import first_slip, highest, steady, sticks, swings
from analytic.sprag.work_balance import frequency as small_oscillations
from verify.cases.sprag.engagement.formulas import MORE, swing, with_torque
from verify.cases.sprag.engagement.formulas import analytic as engagement_values
from verify.cases.sprag.engagement.model import motion, wedge
from verify.cases.sprag.engagement.reference import (
    SPLINES,
    STUCK,
    engaged_fem,
    held,
    partner_fem,
)
from verify.cases.sprag.friction.formulas import BELOW, asked, weak
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import FemResult
from verify.core.figures import Array

LEVELS = (1, 2, 4)  # steps in a step of the inputs
TORQUES = (0.6, 1.0, MORE)  # over T
OVER = np.array([0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, MORE])  # torques of the map, over T
BRACKET = (0.9, 1.1)  # over the required friction
HALVINGS = 12
SPEED = 100.0  # rad/s of a race that slides on
HEAVY = 1e9  # times its inertia, for constant speed
SLIDES, SETTLES = 16, 5  # periods of the engagement until sliding, and the end state, are steady
UNTIL = 1.3  # over the time of the first peak
NARROW = 1e-3  # m/s: the band of which the subject warns
NEARLY = 1e-9  # relative difference of 16 nearby torques
ROUGH = 1e-6  # tolerance of LSODA; 1e-3 is required
SWEEP = ((0.4, 1.0), (MORE, 1.0), (MORE, 2.0))  # torque over T, friction over mu_s
BANDS = (1.0, 0.1, 0.01, 1e-3, 1e-4)  # m/s
STEPS = (2.0, 1.0, 0.5, 0.2)  # over the time step, in the sweep of the check of the time step


def solve(q: EngagementInputs, level: int) -> FemResult:
    """Results of a level: limits and sliding states by Runge-Kutta steps.

    The finest level adds results by LSODA, and tests of pairs of speed band and time step.
    """
    dt = q.dt / level
    boundary, half = boundary_fem(q, dt)
    slides, wide = sliding_fem(q, dt, BELOW * math.tan(q.nu_0), SPEED)
    overruns, wide_over = sliding_fem(q, dt, q.mu_s, -SPEED)
    until = UNTIL * swing(q).peak[0]
    first, more = (engaged_fem(p, wedge(p), dt, duration=until, D_V=None)
                   for p in (weak(q), weak(q, MORE)))  # fmt: skip
    values = {
        "mu_b": boundary, "N_slides": slides, "N_overruns": overruns,
        "N_max": first.N_max, "N_max more": more.N_max, "sticks": sticks(more),
        "D_V": more.D_V,
    } | slipped_fem(q, dt, until)  # fmt: skip
    arrays: dict[str, Array] = {}
    if level == LEVELS[-1]:
        values |= partners_fem(q, until)
        arrays = (guarded_fem(q, until) | swept_fem(q, until) | boundaries_fem(q)
                  | map_fem(q) | narrow_fem(q))  # fmt: skip
    u_it = {
        "mu_b": half, "N_slides": wide, "N_overruns": wide_over, "slips": STUCK * dt,
        "sticks": STUCK * dt,
    }  # fmt: skip
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays)


def frequency(q: EngagementInputs) -> float:
    """Frequency [Hz] of small oscillations under the torque."""
    return small_oscillations(wedge(q), q.T, motion(q))


def settled(q: EngagementInputs) -> float:
    """Time [s], not less than t_end, after which an engagement has locked or slips permanently."""
    return max(q.t_end, q.t_ramp + SETTLES / frequency(q))


def rough(q: EngagementInputs, mu: float) -> EngagementInputs:
    """Inputs of the clutch with `mu` as static and Coulomb coefficient of friction."""
    return q.model_copy(update={"mu_s": mu, "mu_c": mu})


def boundary_fem(q: EngagementInputs, dt: float) -> tuple[float, float]:
    """Smallest friction coefficient that locks, and its uncertainty (half the search interval)."""
    mu, _ = asked(q)
    low, high = (share * mu for share in BRACKET)
    duration = settled(q)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        found = engaged_fem(rough(q, middle), wedge(q), dt, D_V=None, duration=duration)
        locks = found.verdict == "locks"
        low, high = (low, middle) if locks else (middle, high)
    return (low + high) / 2, (high - low) / 2


def boundaries_fem(q: EngagementInputs) -> dict[str, Array]:
    """Array with rows: torque [N m], μ_b/tan(nu), its uncertainty; the clutch locks above μ_b."""
    found = []
    for factor in TORQUES:
        boundary, half = boundary_fem(with_torque(q, factor), q.dt)
        tan = asked(q, factor)[1]
        found.append((factor * q.T, boundary / tan, half / tan))
    return {"boundaries": np.array(found)}


def sliding_fem(q: EngagementInputs, dt: float, mu: float, speed: float) -> tuple[float, float]:
    """Mean N [N] while the inner race slides at `speed` [rad/s], and fluctuation of N [N]."""
    moves = held(rough(q, mu), C_rl=0.0, I_bi=HEAVY * q.I_bi)
    found = engaged_fem(
        q, wedge(q), dt, moves, Torque.step(0.0), duration=SLIDES / frequency(q),
        speeds=Speeds(inner=speed), D_V=None,
    )  # fmt: skip
    late, wander = steady(found)
    # the closed form has lines through the clutch's states, the steps cubics
    return late, max(wander, late * max(swings(found, mu), SPLINES))


def between(q: EngagementInputs) -> float:
    """Friction coefficient midway between those required at rest and at the peak of the force."""
    return (asked(q)[0] + engagement_values(q)["mu_asked"]) / 2


def slipped_fem(q: EngagementInputs, dt: float, until: float) -> dict[str, float]:
    """Largest N [N], and time [s] of the first slip, with the friction coefficient `between`."""
    slipping = rough(q, between(q))
    found = engaged_fem(slipping, wedge(slipping), dt, duration=until, D_V=None)
    return {"N_max slipped": found.N_max, "slips": first_slip(found, slipping.mu_s)}


def partners_fem(q: EngagementInputs, until: float) -> dict[str, float]:
    """Results of LSODA with events for the engagements in which contacts slip, by name."""
    values: dict[str, float] = {}
    for name, p in (("", weak(q)), (" more", weak(q, MORE))):
        found = partner_fem(p, wedge(p), until)
        values[f"LSODA N_max{name}"] = highest(found)[1]
    slid = np.flatnonzero(found.rolls[:, 0] == 0)
    slipping = rough(q, between(q))
    slips = partner_fem(slipping, wedge(slipping), until)
    at = np.flatnonzero(slips.rolls[:, 0] == 0)
    values |= {"LSODA N_max slipped": highest(slips)[1], "LSODA slips": float(slips.t[at[0]])}
    residuals = [SPLINES]
    for name, one in (("", weak(q)), (" more", weak(q, MORE)), (" slipped", slipping)):
        less = partner_fem(one, wedge(one), until, every=2, rtol=ROUGH)
        residuals.append(abs(highest(less)[1] / values[f"LSODA N_max{name}"] - 1))
    return values | {
        "LSODA sticks": float(found.t[slid[-1]]) if len(slid) else 0.0,
        "LSODA residual": max(residuals),
    }


def narrow_fem(q: EngagementInputs) -> dict[str, Array]:
    """Results under 1.6 T with weak springs, with the automatic and with the narrow speed band.

    The check of the time step rejects the narrow band. Without this check, the result is chaotic:
    it depends on the last digits of the torque or of the arithmetic.
    """
    p = weak(q, MORE)
    w = wedge(p)
    runs = [engaged_fem(one, w, q.dt, D_V=NARROW, guard=False) for one in nearby(p)]
    wrong, right = runs[0], engaged_fem(p, w, q.dt, D_V=None)
    return {
        "narrow": np.array([refused_fem(p, q.dt, NARROW), right.N_max]),
        "unguarded": np.array([run.N_max for run in runs]),
        "t": right.t[::10], "right N": right.N[::10], "wrong t": wrong.t[::10],
        "wrong N": wrong.N[::10], "right v": right.v_i[:200], "wrong v": wrong.v_i[:200],
        "fine t": right.t[:200],
    }  # fmt: skip


def nearby(p: EngagementInputs) -> list[EngagementInputs]:
    """Inputs of the clutch under 16 torques that differ only in their last digits."""
    return [p.model_copy(update={"T": p.T * (1 + NEARLY * k)}) for k in range(16)]


def refused_fem(p: EngagementInputs, dt: float, D_V: float, duration: float | None = None) -> bool:
    """Whether the speed band D_V [m/s] is rejected because it is too narrow for the step dt [s]."""
    from analytic.sprag.transient import NarrowBandError

    try:
        engaged_fem(p, wedge(p), dt, D_V=D_V, duration=duration or p.t_end)
    except NarrowBandError:
        return True
    return False


def swept_fem(q: EngagementInputs, until: float) -> dict[str, Array]:
    """Array with rows: torque [N m], μ_s, N_max [N] with automatic speed bands, N_max by LSODA."""
    found = []
    for factor, share in SWEEP:
        p = weak(q, factor)
        p = p.model_copy(update={"mu_s": share * q.mu_s, "mu_c": min(q.mu_c, share * q.mu_s)})
        ours = engaged_fem(p, wedge(p), q.dt, duration=until, D_V=None).N_max
        found.append((p.T, p.mu_s, ours, partner_fem(p, wedge(p), until, rtol=ROUGH).N_max))
    return {"sweep": np.array(found)}


def guarded_fem(q: EngagementInputs, until: float) -> dict[str, Array]:
    """Array over speed bands and time steps: whether the pair is rejected, and error of N_max.

    The correct value is computed with one fifth of the time step and an automatic band. The force
    of a rejected run depends on the last digits; its error is then the median over nearby torques.
    """
    found = []
    for factor in (1.0, MORE):
        p = weak(q, factor)
        w = wedge(p)
        right = engaged_fem(p, w, STEPS[-1] * q.dt, D_V=None, duration=until).N_max
        for step in STEPS:
            for D_V in BANDS:
                dt = step * q.dt
                refused = refused_fem(p, dt, D_V, until)
                runs = [
                    engaged_fem(one, w, dt, D_V=D_V, guard=False, duration=until)
                    for one in (nearby(p) if refused else [p])
                ]
                errors = sorted((run.N_max / right - 1 for run in runs), key=abs)
                found.append((factor, step, D_V, refused, errors[len(errors) // 2]))
    return {"guard": np.array(found, dtype=np.float64)}


def map_fem(q: EngagementInputs) -> dict[str, Array]:
    """Array over torque: limits of the friction coefficient for locking, and for no slip at all.

    Above the first limit, the clutch locks; above the second, no contact slips. Both limits are
    given with the springs of the inputs and with weak springs.
    """
    rows = []
    for factor in OVER:
        row = [factor * q.T]
        for p in (with_torque(q, factor), weak(q, factor)):
            row += [boundary_fem(p, q.dt)[0], most_asked_fem(p)]
        rows.append(row)
    return {"map": np.array(rows)}


def most_asked_fem(q: EngagementInputs) -> float:
    """Largest ratio T/N of tangential to normal force of both contacts if they always stick."""
    found = engaged_fem(q, wedge(q), q.dt, motion(rough(q, 0.999)), D_V=None)
    pressed = found.N > 0
    most = np.maximum(np.abs(found.T_i), np.abs(found.T_e))[pressed] / found.N[pressed]
    return float(most.max())
