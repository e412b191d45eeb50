"""Engagement of a sprag clutch under a sudden torque, computed from its dimensions in one call."""

from analytic.sprag.closure import at_torque
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.history import Engagement
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.table import tabulated
from analytic.sprag.transient import engage

REACH = 3.0  # normal force up to which states are tabulated, over that at rest


def engage_suddenly(
    parts: SpragClutchParts, motion: Motion, *, T: float, duration: float, dt: float = 1e-5
) -> Engagement:
    """Engagement of the clutch of `parts` under a constant torque T [N m] over `duration` [s].

    SI units; the contacts follow Palmgren's law; the time step is `dt` [s]. The result contains the
    normal force `N` [N] over `t` [s], its largest value `N_max`, its value at rest `N_static`,
    their ratio `peak_factor` and the `verdict`. Forces up to 3 times the static force are
    tabulated. Raises ValueError for invalid inputs, ArithmeticError if time steps are too long.
    """
    clutch = SpragClutch(sprag=parts.sprag, n_s=parts.n_s, compliance=parts.palmgren())
    table = tabulated(clutch, N_end=REACH * float(at_torque(clutch, T).N))
    return engage(table, motion, Torque.step(T), duration=duration, dt=dt)
