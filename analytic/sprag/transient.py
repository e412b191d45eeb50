"""Time integration of an engagement, from the table of a clutch, motion data and a torque."""

import numpy as np

from analytic.contact.checks import Array, positive
from analytic.sprag.engagement import MISSED, NOT_FINITE, OUTPUTS, OVER, Law, run
from analytic.sprag.history import STATES, Engagement
from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.rest import at_rest
from analytic.sprag.steps import MISSED as NO_ANSWER
from analytic.sprag.steps import LongStepError, missing
from analytic.sprag.table import Table

RELAXED = 0.6  # steps in which a residual sliding decays; Runge-Kutta is stable above 0.36
WIDER = 2.0  # band over the change of sliding speed in one step, if D_V is not given
TRIALS = 20


class NarrowBandError(ArithmeticError):
    """Raised if the sliding speed of a contact passes the whole sticking band in one step."""

    def __init__(self, *, contact: str, t: float, change: float, dt: float, D_V: float) -> None:
        self.change = change
        super().__init__(
            f"the band of sticking is too narrow: at t={t:.6g} s the {contact} contact's sliding "
            f"speed changes by {change:.4g} m/s in one step ({change / dt:.4g} m/s² x dt={dt:g} s) "
            f"and passes the band of D_V={D_V:g} m/s, so that the sprag would not stick; take D_V "
            f"above {change:.2g} m/s, or dt below {dt * D_V / change:.2g} s"
        )


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
    """Engagement over `duration` [s] in steps `dt` [s]; at the start, only energizing springs act.

    `D_V` [m/s] is the half-width of the band of sliding speed in which a contact may stick. With
    None, it is twice the change of the sliding speed of the inner contact in one step from rest; if
    the guard rejects a step, it is at least twice the change in this step. Raises NarrowBandError
    (an ArithmeticError) if a given band is too narrow, LongStepError if the time step is too
    long, and ValueError for invalid inputs. Without
    `guard`, the wrong result is returned without these errors.
    """
    positive(duration, "duration", "s")
    positive(dt, "dt", "s")
    start = at_rest(table, motion, speeds or Speeds())
    if D_V is not None:
        positive(D_V, "D_V", "m/s")
        return _engage(table, motion, torque, start, duration, dt, D_V, guard)
    rest = float(np.abs(torque.values).max() / motion.I_bi * table.values[1, 0])
    D_V = WIDER * dt * max(rest, 1.0)
    for _ in range(TRIALS):
        try:
            return _engage(table, motion, torque, start, duration, dt, D_V, True)
        except NarrowBandError as narrow:
            D_V = max(WIDER * narrow.change, WIDER * D_V)
    what = f"the band of sticking is too narrow even with D_V={D_V:g} m/s"
    raise LongStepError(what=what, dt=dt, table=table, motion=motion)


def _engage(
    table: Table,
    motion: Motion,
    torque: Torque,
    start: Array,
    duration: float,
    dt: float,
    D_V: float,
    guard: bool,
) -> Engagement:
    law = Law(
        n_s=float(table.n_s), m_g=motion.m_g, I_g=motion.I_g, I_bi=motion.I_bi, I_be=motion.I_be,
        K_r=motion.K_r, alpha_max=motion.alpha_max - table.origin, C_rl=motion.C_rl,
        k_out=motion.k_out, mu_s=motion.mu_s, mu_c=motion.mu_c, gamma_b=motion.gamma_b,
        D_V=float(D_V), tau=RELAXED * dt, step=table.step, values=table.values,
        slopes=table.slopes,
    )  # fmt: skip
    steps = round(duration / dt) + 1
    states, outputs = np.zeros((steps, STATES)), np.zeros((steps, OUTPUTS))
    seen = np.zeros((2, OUTPUTS))
    y = np.concatenate([start, np.zeros(STATES - len(start))])
    ended, n, contact = run(y, dt, law, guard, torque.times, torque.values, states, outputs, seen)
    if ended == MISSED:
        change = float(abs(np.diff(seen[:, 3 + contact])[0]))
        raise NarrowBandError(
            contact=("inner", "outer")[contact], t=n * dt, change=change, dt=dt, D_V=D_V
        )
    if ended == NOT_FINITE:
        what = f"the motion diverges at t={n * dt:.6g} s"
        raise LongStepError(what=what, dt=dt, table=table, motion=motion)
    found = Engagement(
        table=table, motion=motion, torque=torque, D_V=D_V, dt=dt, over=ended == OVER,
        states=states[:n], outputs=outputs[:n],
    )  # fmt: skip
    if guard and not (lost := missing(found)) <= NO_ANSWER:
        what = f"the energy balance is off by {lost:.2g} of the work put in"
        raise LongStepError(what=what, dt=dt, table=table, motion=motion)
    return found
