"""Results of an engagement without time steps: the clutch is a spring between its races.

The work balance needs only statics: without damping and with the outer race fixed, the first peak
is the state at which the work of the torque equals the energy of the spring. This model and the
equations of motion (Eqs. 14-16) have only the closure equations in common.
"""

import math

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from analytic.sprag.course import work
from analytic.sprag.events import ROLLS, Sprag, System
from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.race_spring import RaceSpring


def at_rest(w: RaceSpring, T: float) -> float:
    """Rotation theta [rad] in equilibrium under the torque T [N m].

    The result is nan if T exceeds the torque at the end of the profile.
    """
    resists = w.resistance()
    if float(resists(w.theta[-1])) < T:
        return math.nan
    return float(brentq(lambda x: float(resists(x)) - T, 0.0, w.theta[-1], xtol=1e-15))


def undamped(w: RaceSpring, T: float) -> float:
    """Rotation theta [rad] at the first peak, without damping and with a fixed outer race.

    At this rotation, T theta equals the stored energy. The result is nan if the profile ends
    at a smaller rotation.
    """
    work, rest, start = w.resistance().antiderivative(), at_rest(w, T), w.start

    def left(x: float) -> float:
        return float(T * (x - start) - work(x) + work(start))

    if math.isnan(rest) or left(w.theta[-1]) > 0:
        return math.nan
    return float(brentq(left, rest, w.theta[-1], xtol=1e-15))


def stored(w: RaceSpring, N: float) -> float:
    """Work [J] of the forces on all deflections, from the state `pressed` to N [N]."""
    return w.n_s * float(work(w.clutch, N) - work(w.clutch, w.pressed.N))


def by_turning(w: RaceSpring) -> float:
    """Work of the torque on the rotation by rolling, divided by the work of forces on deflections.

    Both works are taken up to the last state.
    """
    turned = CubicSpline(w.theta, w.states.T).integrate(0.0, w.theta[-1])
    return float(turned) / (w.n_s * float(work(w.clutch, w.end)))


def left_out(w: RaceSpring, N: float) -> float:
    """Fraction of the work `stored` that is done on the outward motion of the sprag centroids.

    Eq. 14 omits this work. The work is taken up to N [N].
    """
    now = w.states
    per_way = np.sin(now.beta + now.gamma) / now.OA - np.sin(now.gamma) / now.OB
    on_way = cumulative_trapezoid(now.T * per_way, now.OC_g, initial=0.0)
    return float(np.interp(N, now.N, on_way)) / stored(w, N)


def sprags_inertia(w: RaceSpring, theta: float, motion: Motion) -> float:
    """Inertia [kg m²] of the sprags, referred to the inner race, with a fixed outer race."""
    now = w.states
    alpha_b = np.gradient(now.alpha_b, w.theta, edge_order=2)
    alpha = np.gradient(now.alpha, w.theta, edge_order=2)
    turn = np.interp(theta, w.theta, now.OC_e / now.OB * alpha_b)
    around = np.interp(theta, w.theta, alpha) - turn
    OC_g = np.interp(theta, w.theta, now.OC_g)
    return float(w.n_s * (motion.m_g * (OC_g * around) ** 2 + motion.I_g * turn**2))


def frequency(w: RaceSpring, T: float, motion: Motion) -> float:
    """Frequency [Hz] of small oscillations about equilibrium under T, outer race fixed."""
    rest = at_rest(w, T)
    if math.isnan(rest):
        return math.nan
    k = float(w.resistance()(rest, 1))
    return math.sqrt(k / (motion.I_bi + sprags_inertia(w, rest, motion))) / (2 * math.pi)


def asked(w: RaceSpring, theta: float) -> float:
    """Required T_i/N at the rotation theta [rad]: tan(nu), reduced by the energizing springs."""
    N, OA = (np.interp(theta, w.theta, x) for x in (w.states.N, w.states.OA))
    return float(w.resistance()(theta) / (w.n_s * OA * N))


def asked_at_start(w: RaceSpring, T: float, motion: Motion) -> float:
    """Largest ratio of tangential to normal force that rolling requires at the start.

    The inner race is loaded by the torque T [N m].
    """
    system = System(Sprag(w.states, w.n_s, balanced=False), motion, Torque.step(T), unlimited=True)
    _, tangential, _, N = system.accelerations(0.0, system.rest(Speeds()), (ROLLS, ROLLS))
    return float(np.abs(tangential).max() / N)


def passed_on(w: RaceSpring, T: float) -> float:
    """Relative change of N at the undamped peak per relative change of the sprags' torque.

    The sprags' torque changes by the ratio e at all rotations. Its work up to the peak is T theta.
    If it is T* at the peak, (T* - T) dtheta = -e T theta. The magnitude is returned.
    """
    peak = undamped(w, T)
    if math.isnan(peak):
        return math.nan
    more = float(w.resistance()(peak)) / T - 1
    return float(w.force()(peak, 1)) * peak / float(w.force()(peak)) / more
