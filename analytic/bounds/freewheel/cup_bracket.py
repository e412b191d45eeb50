"""Expected interval of the approach of a cup, from the approaches of two rings.

The cup contains the ring whose bore circumscribes its corners (radius X_o/cos(pi/z)), and is
contained in the ring whose bore touches its flats (radius X_o). Therefore, its compliance as a ring
lies between the compliances of both rings. With the first ring, the rollers rest on the remaining
part of the flat, a column in which the load spreads as in a half plane. In units of P/(pi E'), the
displacement constants are -2 ln(a) + 2 ln 2 + 1 for a Hertz patch and -2 ln(h) + 2 for the
pressures at the depth h. The shortening of the column is 2 ln(2 h/a) - nu'. In total, the column
adds 1 - nu' to the constant k of the first ring.
"""

import math

import numpy as np

from analytic.bounds.freewheel.parts import FreewheelParts, approach, half_roller
from analytic.bounds.freewheel.ring_constants import free_ring


def expected_approach(cup: FreewheelParts, P: float) -> tuple[float, float, float]:
    """Smallest, expected and largest approach [length] of roller and cup under P [force/length].

    The expected value is that of a ring whose bore has the area enclosed by the flats. The smallest
    and the largest value are those of rings with the bore radii X_o and X_o/cos(pi/z).
    """
    half = math.pi / cup.z
    corner = cup.flat / math.cos(half)
    at_flats, at_corners = (_as_ring(cup, P, bore, 0.0) for bore in (cup.flat, corner))
    share = (cup.flat * math.sqrt(math.tan(half) / half) - cup.flat) / (corner - cup.flat)
    column = 1 - float(cup.plane[1])
    middle = at_flats + share * (at_corners - at_flats)
    return at_flats, middle, _as_ring(cup, P, corner, column)


def _as_ring(cup: FreewheelParts, P: float, bore: float, column: float) -> float:
    """Approach [length] of roller and ring, with `column` added to the constant k of the ring."""
    E, nu = cup.plane[0], float(cup.plane[1])
    load, a = np.asarray(P), cup.width_on_flat(P)
    k = free_ring(ratio=cup.R_a / bore, n=cup.z, nu=nu) + column
    c = -2 / 3 * (1 - nu)  # of a patch on a bore, by the waves' second order, (1 - nu)/m^2
    return float(half_roller(cup, load, a) + approach(load, a, E=E, l=bore, k=k, c=c))
