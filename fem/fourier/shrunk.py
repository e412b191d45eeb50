"""Ring shrunk on a shaft: contact pressure, and its singularity at the edge of the contact."""

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline

from fem.fourier.compliance import surface_flexibility
from fem.fourier.solid import FourierSolid
from fem.plane.discretisation import Array


def shrink_pressure(bodies: Sequence[tuple[FourierSolid, str]], stations: Array) -> Array:
    """Contact pressure (cells,) of two surfaces that are fitted with the interference 1 [length].

    The cells lie between the axial `stations` (cells + 1,). Each body is given with the name of its
    surface. Both bodies deflect uniformly around the axis.
    """
    G = sum(surface_flexibility(solid, name, stations=stations)[0, :, 0] for solid, name in bodies)
    return np.asarray(np.linalg.solve(G, np.diff(stations)), dtype=np.float64)


def edge_slope(distance: Array, pressure: Array, at: float) -> float:
    """Exponent of p ~ r^slope at an edge, from pressures at decreasing distances r from the edge.

    The slope of ln p over ln r at r = `at` has an error of first order in r. This error is removed
    by extrapolation to r = 0.

    >>> r = np.geomspace(1.0, 1e-4, 50)
    >>> round(edge_slope(r, 3 * r**-0.25, 1e-3), 9)
    -0.25
    """
    s = CubicSpline(np.log(distance[::-1]), np.log(pressure[::-1]))
    return float(2 * s(np.log(at), 1) - s(np.log(2 * at), 1))
