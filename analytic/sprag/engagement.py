r"""Engagement of a sprag clutch in time: Eqs. 11-16 by Runge-Kutta with stick and slip (Eq. 12).

Sliding speeds and equations of motion (driving direction positive, N from the table over alpha):

.. math::
    v_i &= OA\,\dot\theta_i - (OA\,\dot\phi + b_i\dot\alpha), \qquad
    v_e = (OB\,\dot\phi - b_e\dot\alpha) - OB\,\dot\theta_e, \\
    I_{bi}\ddot\theta_i &= C - n_s OA\,T_i - C_{rl}(\dot\theta_i - \dot\theta_e), \\
    I_{be}\ddot\theta_e &= n_s OB\,T_e - k_{out}\theta_e - C_{rl}(\dot\theta_e - \dot\theta_i), \\
    m_g OC_g^2\ddot\phi &= (OA + b_i) T_i - (OB - b_e) T_e - h N, \\
    I_g(\ddot\alpha - \ddot\phi) &= b_i T_i + b_e T_e - h N + K_r(\alpha_{max} - \alpha).

In the sticking band |v| < D_V, friction is the force under which sliding decays,
:math:`\dot v = -v/\tau` with tau less than a step, limited to N mu_d(v). At v = 0, this is Eq. 12
with T_bis = mu_s N. As the limit is mu_d(v) and not mu_s, the force is continuous at the limits of
the band. Without the term v/tau (Leine), a sprag would creep permanently at the speed at which it
entered the band. The forces of both contacts follow from both conditions together.

A contact that comes to rest must be detected inside the band. In one step, its sliding speed
changes by |dv/dt| dt. If this exceeds the width of the band, friction changes its sign in every
step, and its mean is arbitrary: the sprag slides permanently, without any sign of the error. For a
light sprag in full sliding, dv/dt = d - a T is 1e4 to 1e6 m/s²; it is known only after the step.
The estimate for the inner race at rest, OA C/I_bi, about 100 m/s², is sufficient for engagements
from rest, but much too small if a race has an initial speed. Therefore, each step and each stage is
checked: if the speed of a contact that could have stuck changes its sign without a value inside the
band, the step is rejected unless `guard` is off.

All compiled code is in this file, because stored machine code is compiled again if this file
changes, but not if another file changes.

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

from analytic.contact.checks import Array
from analytic.sprag.history import Phase

OPEN, STICK, SLIP = (int(phase) for phase in Phase)
OUTPUTS = 9  # N, T_i, T_e, v_i, v_e, whether the contacts could stick, their phases
DONE, OVER, MISSED, NOT_FINITE = range(4)

F = TypeVar("F", bound=Callable[..., Any])


def compiled(function: F) -> F:
    """`function` compiled to machine code, which is stored on disk.

    The order of floating-point operations is retained.
    """
    try:
        return cast(F, njit(cache=True, fastmath=False)(function))
    except RuntimeError:  # no folder can be written: compiled again in every run
        return cast(F, njit(fastmath=False)(function))


class Law(NamedTuple):
    """Constants of the equations of motion, and a table of forces and geometry over alpha.

    `D_V` is the half-width of the sticking band, `tau` the decay time of residual sliding.
    """

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
    values: Array
    slopes: Array


class Place(NamedTuple):
    """Columns of the table at one rotation, and the derivatives of OA, OB, b_i and b_e by alpha."""

    N: float
    OA: float
    OB: float
    OC_g: float
    b_i: float
    b_e: float
    h: float
    slope_a: float
    slope_b: float
    slope_bi: float
    slope_be: float


class Contacts(NamedTuple):
    """Sliding speeds v of both contacts, their rates d - a T under friction T, friction limits."""

    v_i: float
    v_e: float
    d_i: float
    d_e: float
    a_ii: float
    a_ie: float
    a_ee: float
    most_i: float
    most_e: float


@compiled
def column(law: Law, c: int, k: int, u: float) -> tuple[float, float]:
    """Value of column c and its slope d/ds at the fraction u of the interval after knot k."""
    a, b = law.values[c, k], law.values[c, k + 1]
    da, db = law.step * law.slopes[c, k], law.step * law.slopes[c, k + 1]
    square, cube = 3 * (b - a) - 2 * da - db, 2 * (a - b) + da + db
    value = a + u * (da + u * (square + u * cube))
    return value, (da + u * (2 * square + 3 * u * cube)) / law.step


@compiled
def place(law: Law, alpha: float) -> Place:
    """Columns of the table at the rotation `alpha`; for alpha <= 0, those of first contact."""
    s = np.sqrt(max(alpha, 0.0))
    at = s / law.step
    k = min(int(at), law.values.shape[1] - 2)
    u = min(at - k, 1.0)
    N, _ = column(law, 0, k, u)
    OA, slope_a = column(law, 1, k, u)
    OB, slope_b = column(law, 2, k, u)
    OC_g, _ = column(law, 3, k, u)
    b_i, slope_bi = column(law, 4, k, u)
    b_e, slope_be = column(law, 5, k, u)
    h, _ = column(law, 6, k, u)
    turned = 1 / (2 * s) if s > 0.0 else 0.0  # ds/dalpha
    return Place(
        N, OA, OB, OC_g, b_i, b_e, h,
        slope_a * turned, slope_b * turned, slope_bi * turned, slope_be * turned,
    )  # fmt: skip


@compiled
def free_rates(y: Array, C: float, law: Law, g: Place) -> tuple[float, float, float, float]:
    """Accelerations of theta_i, theta_e, phi and alpha - phi without friction."""
    damping = law.C_rl * (y[4] - y[5])
    moment = law.K_r * (law.alpha_max - y[3]) - g.h * g.N
    return (
        (C - damping) / law.I_bi,
        (damping - law.k_out * y[1]) / law.I_be,
        -g.h * g.N / (law.m_g * g.OC_g * g.OC_g),
        moment / law.I_g,
    )


@compiled
def contacts(y: Array, law: Law, g: Place, free: tuple[float, float, float, float]) -> Contacts:
    """`Contacts` in the state `y`: sliding speeds, their rates d - a T, and friction limits."""
    inner, outer, phi, turn = y[4], y[5], y[6], y[7]
    v_i = g.OA * (inner - phi) - g.b_i * turn
    v_e = g.OB * (phi - outer) - g.b_e * turn
    J = law.m_g * g.OC_g * g.OC_g
    c_i, c_e = g.OA + g.b_i, g.OB - g.b_e
    d_i = g.OA * free[0] - c_i * free[2] - g.b_i * free[3]
    d_e = c_e * free[2] - g.b_e * free[3] - g.OB * free[1]
    span = law.mu_s - law.mu_c
    return Contacts(
        v_i=v_i,
        v_e=v_e,
        d_i=d_i + turn * (g.slope_a * (inner - phi) - g.slope_bi * turn),
        d_e=d_e + turn * (g.slope_b * (phi - outer) - g.slope_be * turn),
        a_ii=law.n_s * g.OA * g.OA / law.I_bi + c_i * c_i / J + g.b_i * g.b_i / law.I_g,
        a_ie=g.b_i * g.b_e / law.I_g - c_i * c_e / J,
        a_ee=law.n_s * g.OB * g.OB / law.I_be + c_e * c_e / J + g.b_e * g.b_e / law.I_g,
        most_i=g.N * (law.mu_c + span * np.exp(-law.gamma_b * abs(v_i))),
        most_e=g.N * (law.mu_c + span * np.exp(-law.gamma_b * abs(v_e))),
    )


@compiled
def clip(x: float, bound: float) -> float:
    """`x` limited to the range from -bound to bound."""
    return min(max(x, -bound), bound)


@compiled
def both(c: Contacts, d_i: float, d_e: float) -> tuple[float, float]:
    """Friction forces with d - a T = 0, or the nearest forces within the friction limits.

    They minimise T a T/2 - d T within the limits: inside the box or on one of its four edges.
    """
    det = c.a_ii * c.a_ee - c.a_ie * c.a_ie
    T_i, T_e = (c.a_ee * d_i - c.a_ie * d_e) / det, (c.a_ii * d_e - c.a_ie * d_i) / det
    if abs(T_i) <= c.most_i and abs(T_e) <= c.most_e:
        return T_i, T_e
    least = np.inf
    for edge in range(4):
        sign = 1.0 if edge % 2 == 0 else -1.0
        if edge < 2:
            x = sign * c.most_i
            y = clip((d_e - c.a_ie * x) / c.a_ee, c.most_e)
        else:
            y = sign * c.most_e
            x = clip((d_i - c.a_ie * y) / c.a_ii, c.most_i)
        value = x * (c.a_ii * x / 2 + c.a_ie * y - d_i) + y * (c.a_ee * y / 2 - d_e)
        if value < least:
            least, T_i, T_e = value, x, y
    return T_i, T_e


@compiled
def friction(c: Contacts, law: Law) -> tuple[float, float]:
    """Friction forces T_i, T_e (Eq. 12)."""
    near_i, near_e = abs(c.v_i) < law.D_V, abs(c.v_e) < law.D_V
    d_i, d_e = c.d_i + c.v_i / law.tau, c.d_e + c.v_e / law.tau
    if near_i and near_e:
        return both(c, d_i, d_e)
    T_i, T_e = c.most_i * np.sign(c.v_i), c.most_e * np.sign(c.v_e)
    if near_i:
        T_i = clip((d_i - c.a_ie * T_e) / c.a_ii, c.most_i)
    if near_e:
        T_e = clip((d_e - c.a_ie * T_i) / c.a_ee, c.most_e)
    return T_i, T_e


@compiled
def phase(N: float, v: float, T: float, most: float, D_V: float) -> int:
    """Phase of a contact: open, sticking or slipping."""
    if N <= 0.0:
        return OPEN
    return STICK if abs(v) < D_V and abs(T) < most else SLIP


@compiled
def rates(y: Array, C: float, law: Law, dy: Array, outputs: Array) -> None:
    """Write the rates of the state `y` to `dy`, and forces, sliding speeds, phases to `outputs`.

    C is the torque.
    """
    g = place(law, y[3])
    free = free_rates(y, C, law, g)
    c = contacts(y, law, g, free)
    T_i, T_e = friction(c, law)
    dphi = ((g.OA + g.b_i) * T_i - (g.OB - g.b_e) * T_e) / (law.m_g * g.OC_g * g.OC_g) + free[2]
    dy[:4] = y[4:8]
    dy[4] = free[0] - law.n_s * g.OA * T_i / law.I_bi
    dy[5] = free[1] + law.n_s * g.OB * T_e / law.I_be
    dy[6] = dphi
    dy[7] = dphi + free[3] + (g.b_i * T_i + g.b_e * T_e) / law.I_g
    dy[8] = C * y[4]
    dy[9] = law.n_s * law.K_r * (law.alpha_max - y[3]) * (y[7] - y[6])
    dy[10] = law.C_rl * (y[4] - y[5]) ** 2
    dy[11] = law.n_s * (T_i * c.v_i + T_e * c.v_e)
    outputs[0], outputs[1], outputs[2], outputs[3], outputs[4] = g.N, T_i, T_e, c.v_i, c.v_e
    outputs[5] = abs(c.d_i - c.a_ie * T_e) <= c.a_ii * law.mu_s * g.N
    outputs[6] = abs(c.d_e - c.a_ie * T_i) <= c.a_ee * law.mu_s * g.N
    outputs[7] = phase(g.N, c.v_i, T_i, c.most_i, law.D_V)
    outputs[8] = phase(g.N, c.v_e, T_e, c.most_e, law.D_V)


@compiled
def torque_at(t: float, times: Array, torques: Array) -> float:
    """Torque at time t, linearly interpolated between `times`."""
    k = np.searchsorted(times, t)
    if k == 0:
        return float(torques[0])
    if k == len(times):
        return float(torques[-1])
    part = (t - times[k - 1]) / (times[k] - times[k - 1])
    return float(torques[k - 1] + part * (torques[k] - torques[k - 1]))


@compiled
def missed(before: Array, now: Array, D_V: float) -> int:
    """Index, 0 or 1, of a contact that crossed the sticking band in one step; otherwise -1."""
    for contact in range(2):
        v, w = before[3 + contact], now[3 + contact]
        if v * w < 0 and min(abs(v), abs(w)) >= D_V and now[5 + contact] > 0:
            return contact
    return -1


@compiled
def run(
    y: Array, dt: float, law: Law, guard: bool, times: Array, torques: Array,
    states: Array, outputs: Array, seen: Array,
) -> tuple[int, int, int]:  # fmt: skip
    """Write `states` and `outputs` of each step; return the cause of the end, step and contact.

    If a contact passes the sticking band in a step, the outputs before and after this step are
    written to `seen`.
    """
    stages, at = np.empty((4, len(y))), np.empty(len(y))
    end = (law.step * (law.values.shape[1] - 1)) ** 2
    for n in range(len(states)):
        t = n * dt
        states[n] = y
        if not np.isfinite(y[3]):
            return NOT_FINITE, n, 0
        if y[3] > end:
            return OVER, n, 0
        rates(y, torque_at(t, times, torques), law, stages[0], outputs[n])
        contact = missed(outputs[n - 1], outputs[n], law.D_V) if guard and n > 0 else -1
        if contact >= 0:
            seen[:] = outputs[n - 1 : n + 1]
            return MISSED, n, contact
        for stage in range(1, 4):
            part = dt if stage == 3 else dt / 2
            for j in range(len(y)):
                at[j] = y[j] + part * stages[stage - 1, j]
            rates(at, torque_at(t + part, times, torques), law, stages[stage], seen[1])
            contact = missed(outputs[n], seen[1], law.D_V) if guard else -1
            if contact >= 0:
                seen[0] = outputs[n]
                return MISSED, n, contact
        for j in range(len(y)):
            y[j] += dt / 6 * (stages[0, j] + 2 * (stages[1, j] + stages[2, j]) + stages[3, j])
    return DONE, len(states), 0
