"""Loss of clamping force if a ring that cannot rotate slips axially under torque.

The slip has the direction of the resultant friction force: its axial and circumferential components
are proportional to F_a and F_t. If the ring cannot rotate, the rollers move out of their wedges.
The circumferential slip R dphi decreases both approaches, dd_i + dd_o = -tan(alpha) R dphi, until
they are zero.
"""

import numpy as np

from analytic.contact.checks import Array
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.state import at_normal_force, loaded

GRID = np.linspace(0.0, 1.0, 401)  # of N, along which rollers move out


def let_out(clutch: RollerClutch, *, T: float, mu: float) -> tuple[Array, Array]:
    """Axial slip [length] with the friction mu, and the torque as a fraction of T, both (m,).

    The m states are in reverse order: the slip begins at the last, with the torque T, and ends at
    the first, without force. The slip is nan if the clutch slips under T alone, tan(alpha) > mu.
    """
    state = at_normal_force(clutch, GRID * loaded(clutch, T).N)
    tan = np.tan(state.alpha)
    slope = np.sqrt((mu / tan) ** 2 - 1) / tan
    lost = np.diff(state.d_i + state.d_o) * (slope[1:] + slope[:-1]) / 2
    rest = np.concatenate([np.cumsum(lost[::-1])[::-1], [0.0]])
    return rest, np.asarray(state.T / state.T[-1])
