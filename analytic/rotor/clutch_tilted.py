"""Clutch with simultaneous offset and tilt: coupling of lateral forces with tilts.

Due to the tilt, the offset at one end of the sprags is twice as large as in the middle, and zero at
the other end. Therefore, the load is non-uniform both around the circumference and along the
sprags. Eq. 7 then couples a force along y with a tilt about x, and a force along x with a tilt
about y. A uniform load, or a load that varies only around the circumference, causes no such
coupling.
"""

import math
from dataclasses import replace

from analytic.rotor.clutch import SpragCoupling, even_angles
from analytic.rotor.clutch_state import under_torque

LARGEST = 0.25  # relative to the deflection, so that every slice remains in contact
TILTS = {"K_y_tilt_x": (1, 2), "K_x_tilt_y": (0, 3)}


def aside(offset: float, L: float, delta_0: float) -> tuple[float, float]:
    """Offset dx along x [m], at most a quarter of `delta_0`, and tilt 2 dx/L about y [rad].

    The tilt moves the ends of sprags of length L by the offset.

    >>> aside(1.0, 4.0, 8.0)  # dx = offset
    (1.0, 0.5)
    >>> aside(1.0, 4.0, 2.0)  # dx = delta_0/4
    (0.5, 0.25)
    """
    dx = min(offset, LARGEST * delta_0)
    return dx, 2 * dx / L


def couplings(clutch: SpragCoupling, *, T: float, dx: float, tilt: float) -> dict[str, float]:
    """Coupling stiffnesses [N] by Eqs. 3 to 11 under the torque T [N m].

    The first sprag is half a pitch from the x axis. With four sprags, of which one is on the x
    axis, the coupling of the force along y with the tilt about x would be zero.
    """
    turned = replace(clutch, psi=even_angles(Z=clutch.Z, psi_0=math.pi / clutch.Z))
    K = turned.stiffness(under_torque(turned, T=T, offset=(dx, 0, 0, tilt)))
    return {entry: float(K[at]) for entry, at in TILTS.items()}
