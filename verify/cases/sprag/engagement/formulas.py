"""Formulas of an engagement: statics, energy, small oscillation, and two races on one spring.

Contacts that roll tie the sprags' motion to the turn theta of the races against each other. Where
the sprags' mass is left out the clutch is a spring T(theta), N(theta), whose statics balance work,
and two races swing on it:

    I_bi theta_i'' = C - T - C_rl theta',   I_be theta_e'' = T + C_rl theta' - k_out theta_e.

That shares with the equations of motion (Eqs. 14-16) the closure alone.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.integrate import cumulative_trapezoid, solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from analytic.sprag.course import work
from analytic.sprag.events import ROLLS, Sprag, System
from analytic.sprag.motion import Speeds, Torque
from analytic.sprag.start import spring_equilibrium
from verify.cases.sprag.engagement.model import Wedge, crowned_for, motion, wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.figures import Array

MORE = 1.6  # torque of the second engagement: 40 N m for the paper's 25
SAMPLES = 1201  # over the time followed
FINE = 20_001  # turns at which the spring is known
RTOL = 1e-8


@dataclass(frozen=True, eq=False)
class Swing:
    """Turn of the races [rad], N [N] and its largest with its time [s], over times t [s]."""

    t: Array
    theta: Array
    N: Array
    peak: tuple[float, float]
    over: bool  # past the end of the profile


def torque_at(q: EngagementInputs, t: float) -> float:
    """Torque [N m] on the inner race."""
    return q.T * min(t / q.t_ramp, 1.0) if q.t_ramp > 0 else q.T


def time_to_rest(q: EngagementInputs) -> float:
    """Time [s] after which the torque has stopped a race that overruns, drag left out."""
    if q.w_i >= 0:
        return 0.0

    def impulse(t: float) -> float:
        return q.T * (t - q.t_ramp / 2 if t > q.t_ramp else t**2 / (2 * q.t_ramp))

    if q.t_ramp > 0:
        late = q.I_bi * -q.w_i / q.T + q.t_ramp
        return float(brentq(lambda t: impulse(t) + q.I_bi * q.w_i, 0.0, 2 * late))
    slowed = q.C_rl * -q.w_i / q.T
    return q.I_bi * -q.w_i / q.T * (math.log1p(slowed) / slowed if slowed else 1.0)


@lru_cache(maxsize=64)
def swing(q: EngagementInputs, *, rigid: bool = False) -> Swing:
    """Two races on the clutch as a spring: rolling, massless sprags.

    A race that overruns comes to rest first and engages from there.
    """
    w = wedge(q, rigid=rigid)
    rest = time_to_rest(q)
    force, start = w.force(), w.start
    fine = np.linspace(0, w.theta[-1], FINE)
    resists = w.resistance()(fine)

    def spring(theta: float) -> float:
        return float(np.interp(theta, fine, resists))

    def rates(t: float, y: Array) -> list[float]:
        T = spring(y[0] - y[1]) + q.C_rl * (y[2] - y[3])
        outer = T - q.k_out * y[1]
        return [y[2], y[3], (torque_at(q, t) - T) / q.I_bi, outer / q.I_be]

    def turns(_: float, y: Array) -> float:
        return float(y[2] - y[3])

    def over(_: float, y: Array) -> float:
        return float(w.theta[-1] - (y[0] - y[1]))

    turns.direction = -1  # type: ignore[attr-defined]
    over.terminal = True  # type: ignore[attr-defined]
    t = np.linspace(min(rest, q.t_end * (1 - 1e-3)), q.t_end, SAMPLES)
    found = solve_ivp(
        rates, (t[0], q.t_end), [start, 0.0, max(q.w_i, 0.0), 0.0], method="LSODA", rtol=RTOL,
        atol=1e-12, t_eval=t, events=(turns, over), max_step=q.t_end / 100,
    )  # fmt: skip
    if found.status < 0:
        raise ArithmeticError(f"two races on a spring: {found.message}")
    theta = found.y[0] - found.y[1]
    N = np.where(theta > 0, force(np.maximum(theta, 0)), 0.0)
    peaks = [
        (float(when), float(force(y[0] - y[1])))
        for when, y in zip(found.t_events[0], found.y_events[0], strict=True)
        if y[0] > y[1]
    ]
    last = (float(found.t[-1]), float(N[-1]))
    return Swing(
        found.t, theta, N, max([*peaks, last], key=lambda p: p[1]),
        over=len(found.t_events[1]) > 0,
    )  # fmt: skip


def at_rest(w: Wedge, T: float) -> float:
    """Turn [rad] at which the clutch bears T [N m] at rest; nan where its profile ends before."""
    resists = w.resistance()
    if float(resists(w.theta[-1])) < T:
        return math.nan
    return float(brentq(lambda x: float(resists(x)) - T, 0.0, w.theta[-1], xtol=1e-15))


def undamped(w: Wedge, T: float) -> float:
    """Turn [rad] of the first peak without damping, outer race held: T theta = the work done."""
    work, rest, start = w.resistance().antiderivative(), at_rest(w, T), w.start

    def left(x: float) -> float:
        return float(T * (x - start) - work(x) + work(start))

    if math.isnan(rest) or left(w.theta[-1]) > 0:
        return math.nan
    return float(brentq(left, rest, w.theta[-1], xtol=1e-15))


def stored(w: Wedge, N: float) -> float:
    """Work [J] of the forces on all that yields, from the blades' start to N [N]; no rolling."""
    q = w.q
    first, _ = spring_equilibrium(w.clutch, K_r=q.K_r, alpha_max=q.alpha_max)
    return q.z * float(work(w.clutch, N) - work(w.clutch, first.N))


def by_turning(w: Wedge) -> float:
    """Work of the torque over the turn by rolling, to the last state, over that on the yields."""
    turned = CubicSpline(w.theta, w.states.T).integrate(0.0, w.theta[-1])
    return float(turned) / (w.q.z * float(work(w.clutch, w.end)))


def left_out(w: Wedge, N: float) -> float:
    """Share of that work, to N [N], on the centroid's way outwards, which Eq. 14 leaves out."""
    now = w.states
    per_way = np.sin(now.beta + now.gamma) / now.OA - np.sin(now.gamma) / now.OB
    on_way = cumulative_trapezoid(now.T * per_way, now.OC_g, initial=0.0)
    return float(np.interp(N, now.N, on_way)) / stored(w, N)


def sprags_inertia(w: Wedge, theta: float) -> float:
    """Inertia [kg m²] of the sprags on the inner race's turn, outer race held."""
    q, now = w.q, w.states
    alpha_b = np.gradient(now.alpha_b, w.theta, edge_order=2)
    alpha = np.gradient(now.alpha, w.theta, edge_order=2)
    turn = np.interp(theta, w.theta, now.OC_e / now.OB * alpha_b)
    around = np.interp(theta, w.theta, alpha) - turn
    OC_g = np.interp(theta, w.theta, now.OC_g)
    return float(q.z * (q.m_g * (OC_g * around) ** 2 + q.I_g * turn**2))


def frequency(w: Wedge, T: float) -> float:
    """Frequency [Hz] of small oscillations about the state at rest under T, outer race held."""
    rest = at_rest(w, T)
    if math.isnan(rest):
        return math.nan
    k = float(w.resistance()(rest, 1))
    return math.sqrt(k / (w.q.I_bi + sprags_inertia(w, rest))) / (2 * math.pi)


def asked(w: Wedge, theta: float) -> float:
    """T_i/N that the clutch asks for at the turn [rad]: tan(nu), less what the springs bear."""
    N, OA = (np.interp(theta, w.theta, x) for x in (w.states.N, w.states.OA))
    return float(w.resistance()(theta) / (w.q.z * OA * N))


def asked_at_start(q: EngagementInputs) -> float:
    """Largest |T|/N with which both contacts would begin to roll under the whole torque."""
    system = System(
        Sprag(wedge(q).states, q.z, balanced=False), motion(q), Torque.step(q.T), unlimited=True
    )
    _, T, _, N = system.accelerations(0.0, system.rest(Speeds()), (ROLLS, ROLLS))
    return float(np.abs(T).max() / N)


def passed_on(w: Wedge, T: float) -> float:
    """What a change of the torque, at every turn alike, changes the undamped peak's N by.

    From T theta = work: (T* - T) dtheta = -work dT/T at the peak's turn and torque T*.
    """
    peak = undamped(w, T)
    if math.isnan(peak):
        return math.nan
    more = float(w.resistance()(peak)) / T - 1
    return float(w.force()(peak, 1)) * peak / float(w.force()(peak)) / more


def analytic(q: EngagementInputs) -> Mapping[str, float]:
    """Values in SI units; what has no answer is left out."""
    w = wedge(q)
    first, found, force = w.states, swing(q), w.force()
    rest, peak = at_rest(w, q.T), undamped(w, q.T)
    N, N_max = float(force(rest)), found.peak[1]
    more = swing(with_torque(q)).peak[1]
    rigid = swing(q, rigid=True).peak[1]
    values = {
        "N_max": N_max, "t_max": found.peak[0], "factor": N_max / N, "N": N, "theta": rest,
        "alpha": float(np.interp(rest, w.theta, first.alpha)),
        "k": float(w.resistance()(rest, 1)), "f": frequency(w, q.T),
        "N_undamped": float(force(peak)), "N_max more": more, "N_max rigid": rigid,
        "ratio": more / N_max, "rigid": rigid / N_max,
        "mu_asked": asked(w, float(np.interp(N_max, first.N, w.theta))),
        "work": q.T * float(np.interp(N_max, first.N, w.theta)),
        "unequal": float(np.interp(N_max, first.N[1:], first.N_e[1:] / first.N[1:])) - 1,
        "left out": left_out(w, float(force(peak))), "by turning": by_turning(w),
        "passed on": passed_on(w, q.T), "inertia": sprags_inertia(w, rest) / q.I_bi,
        "over": float(found.over), "over more": float(swing(with_torque(q)).over),
        "start": asked_at_start(q) if q.t_ramp == 0 else 0.0,
    }  # fmt: skip
    return {key: value for key, value in values.items() if math.isfinite(value)}


def with_torque(q: EngagementInputs, factor: float = MORE) -> EngagementInputs:
    """The same clutch under `factor` times the torque, its crown as it was."""
    return q.model_copy(update={"T": factor * q.T, "Q": crowned_for(q)})
