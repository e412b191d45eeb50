r"""Engagement of a sprag clutch in time: Eqs. 11-16 by Runge-Kutta with stick and slip (Eq. 12).

Speeds of sliding and equations of motion (driving positive, N from the table over alpha):

.. math::
    v_i &= OA\,\dot\theta_i - (OA\,\dot\phi + b_i\dot\alpha), \qquad
    v_e = (OB\,\dot\phi - b_e\dot\alpha) - OB\,\dot\theta_e, \\
    I_{bi}\ddot\theta_i &= C - n_s OA\,T_i - C_{rl}(\dot\theta_i - \dot\theta_e), \\
    I_{be}\ddot\theta_e &= n_s OB\,T_e - k_{out}\theta_e - C_{rl}(\dot\theta_e - \dot\theta_i), \\
    m_g OC_g^2\ddot\phi &= (OA + b_i) T_i - (OB - b_e) T_e - h N, \\
    I_g(\ddot\alpha - \ddot\phi) &= b_i T_i + b_e T_e - h N + K_r(\alpha_{max} - \alpha).

Friction inside the band |v| < D_V is the force that lets the sliding die away,
:math:`\dot v = -v/\tau` with tau two steps, as far as N mu_d(v) allows. At v = 0 this is Eq. 12
with T_bis = mu_s N; taking mu_d(v) instead of mu_s over the whole band joins it to the sliding
branch at the band's edge, and without the term v/tau (Leine's) a sprag would creep on for ever with
the speed at which it was caught. Both forces follow from both conditions together.

A contact that comes to rest must be seen inside the band. In one step its sliding changes by
|dv/dt| dt; where that crosses the whole band, friction changes sign step by step and its mean is
anything: the sprag slides for ever, and nothing tells. Such a step, at a contact that could have
stuck, is refused unless `guard` is off.

References
----------
.. [1] C. Huang, Y. Zhao, M. Liu (2018), Eqs. 11-16.
.. [2] D. Karnopp, Computer simulation of stick-slip friction in mechanical dynamic systems, J.
   Dynamic Systems, Measurement, and Control 107 (1985) 100-103.
.. [3] R. I. Leine et al., Stick-slip vibrations induced by alternate friction models, Nonlinear
   Dynamics 16 (1998) 41-54.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
from numba import njit

from analytic.contact.checks import Array, positive
from analytic.sprag.history import STATES, Engagement, Phase
from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.rest import at_rest
from analytic.sprag.table import Table

APART, STICK, SLIP = (int(phase) for phase in Phase)
RELAXED = 2.0  # tau in steps: Runge-Kutta is stable above 0.36
DONE, OVER, MISSED, NOT_FINITE = range(4)
WIDER = 2.0  # band over the change in a step, where the band is chosen here
TRIALS = 12

F = TypeVar("F", bound=Callable[..., Any])


def compiled(function: F) -> F:
    """`function` in machine code, exact in its order of operations, kept between runs."""
    return cast(F, njit(cache=True, fastmath=False)(function))


class Law(NamedTuple):
    """Constants of the motion as the compiled code takes them."""

    n_s: float
    m_g: float
    I_g: float
    I_bi: float
    I_be: float
    K_r: float
    alpha_max: float
    C_rl: float
    k_out: float
    mu_s: float
    mu_c: float
    gamma_b: float
    D_V: float
    tau: float
    step: float


@compiled
def _column(values: Array, slopes: Array, c: int, k: int, u: float, step: float) -> float:
    """Column c between the knots k and k + 1, at the part u of the interval."""
    a, b = values[c, k], values[c, k + 1]
    da, db = step * slopes[c, k], step * slopes[c, k + 1]
    return float(a + u * (da + u * (3 * (b - a) - 2 * da - db + u * (2 * (a - b) + da + db))))


@compiled
def _slope(values: Array, slopes: Array, c: int, k: int, u: float, step: float) -> float:
    a, b = values[c, k], values[c, k + 1]
    da, db = step * slopes[c, k], step * slopes[c, k + 1]
    return float(
        (da + u * (2 * (3 * (b - a) - 2 * da - db) + 3 * u * (2 * (a - b) + da + db))) / step
    )


@compiled
def _clip(x: float, bound: float) -> float:
    return min(max(x, -bound), bound)


@compiled
def _friction(
    a_ii: float, a_ie: float, a_ee: float, d_i: float, d_e: float, most_i: float, most_e: float
) -> tuple[float, float]:
    """Forces that make d - a T vanish, or come nearest to it within their bounds.

    The least of T a T/2 - d T in the box: inside, or the best of the best points of its edges.
    """
    det = a_ii * a_ee - a_ie * a_ie
    T_i, T_e = (a_ee * d_i - a_ie * d_e) / det, (a_ii * d_e - a_ie * d_i) / det
    if abs(T_i) <= most_i and abs(T_e) <= most_e:
        return T_i, T_e
    best, best_i, best_e = np.inf, 0.0, 0.0
    for edge in range(4):
        sign = 1.0 if edge % 2 == 0 else -1.0
        if edge < 2:
            x = sign * most_i
            y = _clip((d_e - a_ie * x) / a_ee, most_e)
        else:
            y = sign * most_e
            x = _clip((d_i - a_ie * y) / a_ii, most_i)
        value = x * (a_ii * x / 2 + a_ie * y - d_i) + y * (a_ee * y / 2 - d_e)
        if value < best:
            best, best_i, best_e = value, x, y
    return best_i, best_e


@compiled
def _rates(
    y: Array, C: float, law: Law, values: Array, slopes: Array, dy: Array, told: Array
) -> None:
    """Rates `dy` of the state and works `y`; `told`: N, T_i, T_e, v_i, v_e, holds and phases."""
    alpha = y[3]
    place = max(alpha, 0.0) / law.step
    k = min(int(place), values.shape[1] - 2)
    u = min(place - k, 1.0)
    N = _column(values, slopes, 0, k, u, law.step)
    OA = _column(values, slopes, 1, k, u, law.step)
    OB = _column(values, slopes, 2, k, u, law.step)
    OC_g = _column(values, slopes, 3, k, u, law.step)
    b_i = _column(values, slopes, 4, k, u, law.step)
    b_e = _column(values, slopes, 5, k, u, law.step)
    h = _column(values, slopes, 6, k, u, law.step)
    inner, outer, phi, turn = y[4], y[5], y[6], y[7]
    v_i = OA * (inner - phi) - b_i * turn
    v_e = OB * (phi - outer) - b_e * turn
    J = law.m_g * OC_g * OC_g
    damping = law.C_rl * (inner - outer)
    blades = law.K_r * (law.alpha_max - alpha)
    free_i, free_e = (C - damping) / law.I_bi, (damping - law.k_out * y[1]) / law.I_be
    free_phi, free_spin = -h * N / J, (blades - h * N) / law.I_g
    c_i, c_e = OA + b_i, OB - b_e  # arms about O of the forces' parts across OC_g
    a_ii = law.n_s * OA * OA / law.I_bi + c_i * c_i / J + b_i * b_i / law.I_g
    a_ee = law.n_s * OB * OB / law.I_be + c_e * c_e / J + b_e * b_e / law.I_g
    a_ie = b_i * b_e / law.I_g - c_i * c_e / J
    d_i = OA * free_i - c_i * free_phi - b_i * free_spin
    d_e = c_e * free_phi - b_e * free_spin - OB * free_e
    if alpha > 0.0:
        d_i += turn * (
            _slope(values, slopes, 1, k, u, law.step) * (inner - phi)
            - _slope(values, slopes, 4, k, u, law.step) * turn
        )
        d_e += turn * (
            _slope(values, slopes, 2, k, u, law.step) * (phi - outer)
            - _slope(values, slopes, 5, k, u, law.step) * turn
        )
    span = law.mu_s - law.mu_c
    most_i = N * (law.mu_c + span * np.exp(-law.gamma_b * abs(v_i)))
    most_e = N * (law.mu_c + span * np.exp(-law.gamma_b * abs(v_e)))
    near_i, near_e = abs(v_i) < law.D_V, abs(v_e) < law.D_V
    if near_i and near_e:
        T_i, T_e = _friction(
            a_ii, a_ie, a_ee, d_i + v_i / law.tau, d_e + v_e / law.tau, most_i, most_e
        )
    elif near_i:
        T_e = most_e * np.sign(v_e)
        T_i = _clip((d_i + v_i / law.tau - a_ie * T_e) / a_ii, most_i)
    elif near_e:
        T_i = most_i * np.sign(v_i)
        T_e = _clip((d_e + v_e / law.tau - a_ie * T_i) / a_ee, most_e)
    else:
        T_i, T_e = most_i * np.sign(v_i), most_e * np.sign(v_e)
    dphi = free_phi + (c_i * T_i - c_e * T_e) / J
    dy[0], dy[1], dy[2], dy[3] = inner, outer, phi, turn
    dy[4] = free_i - law.n_s * OA * T_i / law.I_bi
    dy[5] = free_e + law.n_s * OB * T_e / law.I_be
    dy[6] = dphi
    dy[7] = dphi + free_spin + (b_i * T_i + b_e * T_e) / law.I_g
    dy[8] = C * inner
    dy[9] = law.n_s * blades * (turn - phi)
    dy[10] = damping * (inner - outer)
    dy[11] = law.n_s * (T_i * v_i + T_e * v_e)
    told[0], told[1], told[2], told[3], told[4] = N, T_i, T_e, v_i, v_e
    told[5] = abs((d_i - a_ie * T_e) / a_ii) <= law.mu_s * N
    told[6] = abs((d_e - a_ie * T_i) / a_ee) <= law.mu_s * N
    told[7] = APART if N <= 0 else STICK if near_i and abs(T_i) < most_i else SLIP
    told[8] = APART if N <= 0 else STICK if near_e and abs(T_e) < most_e else SLIP


@compiled
def _torque(t: float, times: Array, torques: Array) -> float:
    k = np.searchsorted(times, t)
    if k == 0:
        return float(torques[0])
    if k == len(times):
        return float(torques[-1])
    part = (t - times[k - 1]) / (times[k] - times[k - 1])
    return float(torques[k - 1] + part * (torques[k] - torques[k - 1]))


@compiled
def _run(
    y: Array, dt: float, law: Law, guard: bool, times: Array, torques: Array,
    values: Array, slopes: Array, states: Array, told: Array,
) -> tuple[int, int, int]:  # fmt: skip
    """States and what is told of them at each step; how it ended, where, at which contact."""
    stages, at, aside = np.empty((4, len(y))), np.empty(len(y)), np.empty(told.shape[1])
    end = law.step * (values.shape[1] - 1)
    for n in range(len(states)):
        t = n * dt
        states[n] = y
        if not np.isfinite(y[3]):
            return NOT_FINITE, n, 0
        if y[3] > end:
            return OVER, n, 0
        _rates(y, _torque(t, times, torques), law, values, slopes, stages[0], told[n])
        for contact in range(2 if guard and n > 0 else 0):
            before, after = told[n - 1, 3 + contact], told[n, 3 + contact]
            crossed = before * after < 0 and min(abs(before), abs(after)) >= law.D_V
            if crossed and told[n, 5 + contact] > 0:
                return MISSED, n, contact
        for stage in range(1, 4):
            part = dt if stage == 3 else dt / 2
            for j in range(len(y)):
                at[j] = y[j] + part * stages[stage - 1, j]
            _rates(at, _torque(t + part, times, torques), law, values, slopes, stages[stage], aside)
        for j in range(len(y)):
            y[j] += dt / 6 * (stages[0, j] + 2 * (stages[1, j] + stages[2, j]) + stages[3, j])
    return DONE, len(states), 0


def engage(
    table: Table,
    motion: Motion,
    torque: Torque,
    *,
    duration: float,
    dt: float = 1e-5,
    D_V: float | None = None,
    speeds: Speeds | None = None,
    guard: bool = True,
) -> Engagement:
    """Engagement over `duration` [s] in steps of `dt` [s], from rest under the blades alone.

    `D_V` [m/s] is the half-width of the band in which a contact may stick; None: twice the largest
    change of sliding in a step that the engagement itself has. ArithmeticError where the band is
    too narrow, ValueError for what makes no sense.
    """
    duration, dt = (
        float(positive(x, what, "s")) for x, what in ((duration, "duration"), (dt, "dt"))
    )
    start = at_rest(table, motion, speeds or Speeds())
    if D_V is not None:
        return _engage(
            table, motion, torque, start, duration, dt, float(positive(D_V, "D_V", "m/s")), guard
        )
    band = WIDER * dt * max(abs(float(v)) for v in torque.values) / motion.I_bi * table.values[1, 0]
    for _ in range(TRIALS):
        try:
            return _engage(table, motion, torque, start, duration, dt, max(band, 1e-12), True)
        except BandTooNarrow as narrow:
            band = WIDER * narrow.change
    raise ArithmeticError(
        f"no band of sliding speeds holds the contacts with dt={dt} s, the last was {band} m/s"
    )


class BandTooNarrow(ArithmeticError):
    """A contact that could have stuck passed the whole band in one step."""

    def __init__(self, *, contact: str, t: float, change: float, dt: float, D_V: float) -> None:
        self.change = change
        super().__init__(
            f"the band of sticking is too narrow: at t={t:.6g} s the {contact} contact's sliding "
            f"speed changes by {change:.4g} m/s in one step ({change / dt:.4g} m/s² x dt={dt:g} s) "
            f"and passes D_V={D_V:g} m/s unseen, and the sprag would slide on for ever; take "
            f"D_V above {change:.2g} m/s or dt below {dt * D_V / change:.2g} s"
        )


def _engage(
    table: Table, motion: Motion, torque: Torque, start: Array,
    duration: float, dt: float, D_V: float, guard: bool,
) -> Engagement:  # fmt: skip
    law = Law(
        n_s=float(table.n_s), m_g=motion.m_g, I_g=motion.I_g, I_bi=motion.I_bi, I_be=motion.I_be,
        K_r=motion.K_r, alpha_max=motion.alpha_max, C_rl=motion.C_rl, k_out=motion.k_out,
        mu_s=motion.mu_s, mu_c=motion.mu_c, gamma_b=motion.gamma_b, D_V=D_V, tau=RELAXED * dt,
        step=table.step,
    )  # fmt: skip
    steps = round(duration / dt) + 1
    states, told = np.zeros((steps, STATES)), np.zeros((steps, 9))
    ended, n, contact = _run(
        np.concatenate([start, np.zeros(STATES - len(start))]), dt, law, guard, torque.times,
        torque.values, table.values, table.slopes, states, told,
    )  # fmt: skip
    if ended == MISSED:
        change = abs(float(told[n, 3 + contact] - told[n - 1, 3 + contact]))
        raise BandTooNarrow(
            contact=("inner", "outer")[contact], t=n * dt, change=change, dt=dt, D_V=D_V
        )
    if ended == NOT_FINITE:
        raise ArithmeticError(
            f"the motion is no longer finite at t={n * dt:.6g} s: dt={dt:g} s is too long"
        )
    return Engagement(
        table=table, motion=motion, torque=torque, D_V=D_V, dt=dt, over=ended == OVER,
        states=states[:n], told=told[:n],
    )  # fmt: skip
