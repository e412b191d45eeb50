r"""Engagement by a second method: rolling is a constraint that begins and ends at events.

The method has neither a sticking band nor fixed time steps. Each contact rolls or slides. The
sliding speed of a rolling contact is exactly zero, because the speeds q' are B(alpha) u with the
independent speeds u:

.. math:: B^T M B\,\dot u = B^T (Q - M \dot B u), \qquad M\ddot q = Q + J^T T,

where M is the mass matrix of q = (theta_i, theta_e, phi, alpha); Q are the forces of springs,
damping, torque and elastic deflection; J q' are the sliding speeds. The second equation gives the
friction T that rolling requires. If T exceeds mu_s N, the contact begins to slide; at v = 0, it may
roll again. After each such event, the combination of rolling and sliding contacts is chosen whose
forces and accelerations are consistent. LSODA integrates between events.

`transient.engage` solves the same equations in compiled fixed steps. The interpolation of the force
over alpha in this module is independent of `transient`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline, PPoly
from scipy.optimize import brentq

from analytic.contact.checks import Array
from analytic.sprag.closure import Wedged
from analytic.sprag.motion import Motion, Speeds, Torque

ROLLS = 0  # else the sign of the sliding
Mode = tuple[int, int]
EVENTS = 5000
TOUCHING = 1e-9  # m/s: v at an event


@dataclass(frozen=True, kw_only=True, eq=False)
class Events:
    """Times [s], states (8 values each: q and q'), and the forces N, T_i, T_e [N] at the steps."""

    t: Array
    states: Array
    N: Array
    T_i: Array
    T_e: Array
    rolls: Array  # (steps, 2): whether inner and outer contact roll
    peaks: Array  # (peaks, 2): time [s] and N [N] where the sprag turns back
    over: bool  # past the end of the profile

    @property
    def N_max(self) -> float:
        """Largest normal force N [N]."""
        return float(max(self.N.max(), self.peaks[:, 1].max(initial=0.0)))

    @property
    def asked(self) -> float:
        """Required friction coefficient of rolling: largest |T|/N of both contacts."""
        touching = self.N > 0
        most = np.maximum(np.abs(self.T_i), np.abs(self.T_e))
        return float((most[touching] / self.N[touching]).max())


def rolling(mode: Mode) -> list[int]:
    """Indices of the contacts that roll; 0 is the inner one."""
    return [k for k in (0, 1) if mode[k] == ROLLS]


@lru_cache(maxsize=9)
def free(mode: Mode) -> tuple[list[int], list[int], list[int]]:
    """Indices of the rolling contacts, of the independent and of the dependent speeds.

    With one rolling contact, phi' is dependent; with two, phi' and alpha' are dependent.
    """
    bound = rolling(mode)
    kept = ([0, 1, 2, 3], [0, 1, 3], [0, 1])[len(bound)]
    return bound, kept, [k for k in range(4) if k not in kept]


class Sprag:
    """Force and lever arms of a sprag over alpha, from states with N increasing from 0."""

    def __init__(self, states: Wedged, n_s: int, *, balanced: bool) -> None:
        self.origin = float(states.alpha[0])
        alpha = states.alpha - self.origin
        self.n_s, self.end = n_s, float(alpha[-1])
        outer = np.cos(states.omega) / np.cos(states.nu) if balanced else 1.0
        columns = (states.N, states.OA, states.OB, states.OC_g, states.b_i, states.b_e,
                   states.h_i - outer * states.h_e)  # fmt: skip
        curve = CubicSpline(alpha, np.transpose(columns))
        slope = np.zeros_like(curve.c)  # one degree less
        slope[1:] = curve.derivative().c
        self._both = PPoly(np.concatenate([curve.c, slope], axis=-1), curve.x)

    def at(self, alpha: float) -> tuple[Array, Array]:
        """Values N, OA, OB, OC_g, b_i, b_e, h and their slopes at `alpha` [rad].

        For alpha <= 0, the values are those of first contact, and the slopes are 0.
        """
        both = self._both(max(alpha, 0.0))
        return both[:7], both[7:] if alpha > 0 else np.zeros(7)


class System:
    """Equations of motion for a given mode: which contacts roll, and which slide.

    With `unlimited` friction, contacts always roll.
    """

    def __init__(self, sprag: Sprag, motion: Motion, torque: Torque, *, unlimited: bool) -> None:
        self.sprag, self.motion, self.torque, self.unlimited = sprag, motion, torque, unlimited
        self.slack = motion.alpha_max - sprag.origin  # alpha counts from the first contact
        self.M = np.diag([motion.I_bi, motion.I_be, 0.0, 0.0])  # without the centroids
        self.M[2:, 2:] += sprag.n_s * motion.I_g * np.array([[1.0, -1.0], [-1.0, 1.0]])
        self._known: dict[tuple[float, bytes, Mode], tuple[Array, Array, Array, float]] = {}

    def rest(self, speeds: Speeds) -> Array:
        """Initial angles and speeds [rad, rad/s], shape (8,): only the springs act, and T_i = 0."""

        def excess(alpha: float) -> float:
            N, _, OB, _, _, b_e, h = self.sprag.at(alpha)[0]
            return float(h * N * OB / (OB - b_e) - self.motion.K_r * (self.slack - alpha))

        alpha = brentq(excess, 0.0, self.sprag.end, xtol=1e-16) if excess(0.0) < 0 else 0.0
        N, _, OB, _, _, b_e, h = self.sprag.at(alpha)[0]
        theta_e = -self.sprag.n_s * OB * h * N / (OB - b_e) / self.motion.k_out
        return np.array([0, theta_e, 0, alpha, speeds.inner, speeds.outer, speeds.phi, 0])

    def sliding(self, g: Array) -> Array:
        """Matrix J (2, 4), with which the sliding speeds (v_i, v_e) are J q'."""
        _, OA, OB, _, b_i, b_e, _ = g
        return np.array([[OA, 0.0, -OA, -b_i], [0.0, -OB, OB, -b_e]])

    def bound(self, J: Array, slope: Array, turn: float, mode: Mode) -> tuple[Array, Array]:
        """Matrix B of the constraint q' = B u, and its time derivative."""
        bound, kept, lost = free(mode)
        B, dB = np.zeros((4, len(kept))), np.zeros((4, len(kept)))
        B[kept, range(len(kept))] = 1.0
        if bound:
            J, J_dot = J[bound], self.sliding(slope)[bound] * turn
            inverse = np.linalg.inv(J[:, lost])
            B[lost] = -inverse @ J[:, kept]
            dB[lost] = -inverse @ (J_dot[:, kept] + J_dot[:, lost] @ B[lost])
        return B, dB

    def accelerations(self, t: float, y: Array, mode: Mode) -> tuple[Array, Array, Array, float]:
        """Accelerations q'', friction T, sliding speeds v and force N; stored for each state."""
        key = t, y.tobytes(), mode
        if key not in self._known:
            q_ddot, T, lacking, J, N = self._driven(t, y, mode)
            if bound := rolling(mode):
                T[bound] = np.linalg.lstsq(self.sprag.n_s * J[bound].T, lacking, rcond=None)[0]
            self._known[key] = q_ddot, T, J @ y[4:], N
        return self._known[key]

    def rates(self, t: float, y: Array, mode: Mode) -> Array:
        """Derivatives of the state, computed without the friction of rolling contacts."""
        return np.concatenate([y[4:], self._driven(t, y, mode)[0]])

    def _driven(self, t: float, y: Array, mode: Mode) -> tuple[Array, Array, Array, Array, float]:
        """Accelerations q'', T of sliding contacts, n_s J^T T of rolling contacts, J and N."""
        motion, n_s = self.motion, self.sprag.n_s
        g, slope = self.sprag.at(y[3])
        N, OC_g, h = g[0], g[3], g[6]
        q_dot = y[4:]
        J, M = self.sliding(g), self.M.copy()
        M[2, 2] += n_s * motion.m_g * OC_g**2
        between = motion.C_rl * (q_dot[0] - q_dot[1])
        blade = n_s * motion.K_r * (self.slack - y[3])
        loads = np.array([
            float(self.torque.at(t)) - between,
            between - motion.k_out * y[1],
            -blade,
            blade - n_s * h * N,
        ])  # fmt: skip
        T = np.zeros(2)
        if any(mode):  # friction reduces the driving force of the sliding
            drop = motion.mu_s - motion.mu_c
            mu = motion.mu_c + drop * np.exp(-motion.gamma_b * np.abs(J @ q_dot))
            T = np.array(mode) * mu * N
            loads = loads - n_s * J.T @ T
        B, dB = self.bound(J, slope, q_dot[3], mode)
        u = q_dot[free(mode)[1]]
        u_dot = np.linalg.solve(B.T @ M @ B, B.T @ (loads - M @ dB @ u))
        q_ddot = B @ u_dot + dB @ u
        return q_ddot, T, loads - M @ q_ddot, J, float(N)

    def mode(self, t: float, y: Array, lost: dict[int, int]) -> Mode:
        """Combination of rolling and sliding contacts with consistent forces and accelerations.

        `lost` are the contacts at which sliding has just begun, with the directions of sliding.
        """
        if self.unlimited:
            return ROLLS, ROLLS
        g, slope = self.sprag.at(y[3])
        v = self.sliding(g) @ y[4:]
        choices: list[tuple[int, ...]] = [
            (lost[k],) if k in lost
            else (ROLLS, 1, -1) if abs(v[k]) < TOUCHING
            else (int(np.sign(v[k])),)
            for k in (0, 1)
        ]  # fmt: skip
        J_dot = self.sliding(slope) * y[7]
        doubts = []
        for mode in ((i, e) for i in choices[0] for e in choices[1]):
            q_ddot, T, _, N = self.accelerations(t, y, mode)
            v_dot = self.sliding(g) @ q_ddot + J_dot @ y[4:]
            excess = 0.0
            for k in (0, 1):
                if mode[k] == ROLLS:
                    excess = max(excess, abs(T[k]) - self.motion.mu_s * N)
                elif abs(v[k]) < TOUCHING and k not in lost:
                    excess = max(excess, -mode[k] * v_dot[k])
            if excess <= 0:
                return mode
            doubts.append((excess, mode))
        return min(doubts)[1]

    def grip(self, t: float, y: Array, mode: Mode, k: int) -> float:
        """Margin mu_s N - |T| [N] of static friction at contact k."""
        _, T, _, N = self.accelerations(t, y, mode)
        return float(self.motion.mu_s * N - abs(T[k]))

    def slid(self, y: Array, mode: Mode, k: int) -> float:
        """Sliding speed [m/s] at contact k, positive in the direction in which sliding began."""
        return float(mode[k] * (self.sliding(self.sprag.at(y[3])[0]) @ y[4:])[k])

    def ends(self, mode: Mode) -> list[Callable[[float, Array], float]]:
        """Event functions: end of profile, reversal of the sprag, end of rolling or sliding."""

        def over(_: float, y: Array) -> float:
            return float(self.sprag.end - y[3])

        def turns(_: float, y: Array) -> float:
            return float(y[7])

        def contact(k: int) -> Callable[[float, Array], float]:
            if mode[k] == ROLLS:
                return lambda t, y: self.grip(t, y, mode, k)
            return lambda _, y: self.slid(y, mode, k)

        found = [over, turns, *(contact(k) for k in ((), (0, 1))[not self.unlimited])]
        for event in found:
            event.direction = -1  # type: ignore[attr-defined]
            event.terminal = event is not turns  # type: ignore[attr-defined]
        return found


def engage_by_events(
    states: Wedged,
    n_s: int,
    motion: Motion,
    torque: Torque,
    *,
    duration: float,
    speeds: Speeds | None = None,
    unlimited: bool = False,
    balanced: bool = False,
    rtol: float = 1e-9,
) -> Events:
    """Engagement over `duration` [s] with rolling as a constraint; SI units.

    It starts at rest under the energizing springs, except for the given `speeds`. With `unlimited`
    friction, the contacts always roll (assumption of Xu and Liu); `Events.asked` is then the
    required friction coefficient. For `balanced`, see `analytic.sprag.table`. Raises
    ArithmeticError if the solver fails or the number of events exceeds EVENTS.
    """
    system = System(Sprag(states, n_s, balanced=balanced), motion, torque, unlimited=unlimited)
    t, y, parts, peaks = 0.0, system.rest(speeds or Speeds()), [], []
    lost: dict[int, int] = {}
    for _ in range(EVENTS):
        mode = system.mode(t, y, lost)
        leg = solve_ivp(
            lambda t, y, mode=mode: system.rates(t, y, mode),
            (t, duration), y, method="LSODA", rtol=rtol, atol=rtol * 1e-3,
            events=system.ends(mode), max_step=1e-4,
        )  # fmt: skip
        if leg.status < 0:
            raise ArithmeticError(
                f"the time integration (LSODA) failed at t={leg.t[-1]:.6g} s: {leg.message}"
            )
        parts.append((mode, leg.t, leg.y.T))
        for when, what in zip(leg.t_events[1], leg.y_events[1], strict=True):
            peaks.append((when, float(system.sprag.at(what[3])[0][0])))
        t, y = leg.t[-1], leg.y[:, -1]
        _, T, _, _ = system.accelerations(t, y, mode)
        ended = [k for k in (0, 1) if len(leg.t_events) > 2 and len(leg.t_events[2 + k])]
        lost = {k: int(np.sign(T[k])) for k in ended if mode[k] == ROLLS}
        if leg.status == 0 or len(leg.t_events[0]):
            return _result(system, parts, peaks, over=bool(len(leg.t_events[0])))
    raise ArithmeticError(
        f"the engagement did not end within {EVENTS} events; the last event was at t={t:.6g} s"
    )


def _result(
    system: System,
    parts: list[tuple[Mode, Array, Array]],
    peaks: list[tuple[float, float]],
    *,
    over: bool,
) -> Events:
    rows = [
        (t, y, *system.accelerations(t, y, mode)[1:4:2], mode)
        for mode, ts, ys in parts for t, y in zip(ts, ys, strict=True)
    ]  # fmt: skip
    t, states, T, N, modes = (np.array(x) for x in zip(*rows, strict=True))
    return Events(
        t=t, states=states, N=N, T_i=T[:, 0], T_e=T[:, 1], rolls=modes == ROLLS,
        peaks=np.array(peaks).reshape(-1, 2), over=over,
    )  # fmt: skip
