"""Eqs. 1 to 7 of Wang et al. 2023 with the possible interpretations of their illegible signs.

`analytic.spring.energy` contains the adopted interpretation in closed form.
"""

import math
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

SIGNS = ("alternating", "all plus", "M_2 as printed")
LEAVES = {"L_1/sin α": 1.0, "2 L_1/sin α": 2.0}
OFFSETS = {"r + b/2": (1.0, "b"), "r + b": (2.0, "b"), "r": (0.0, "b"), "r + h/2": (1.0, "h")}
RADII = ("r", "r + b/2")
STARTS = {"F (L_1/2 + r)": 1.0, "F L_1/2": 0.0}


def flexibility(
    n: int,
    a: float,
    r: float,
    L2: float,
    alpha: float,
    signs: str,
    start: float,
    ends: tuple[float, float] = (math.pi / 2, math.pi / 2),
) -> float:
    """Integral of (M/F)^2 along the spring [length^3] with given signs and first couple.

    `n` is the number of segments, `a` half the straight length of head and tail, `r` the radius of
    the arcs, `L2` the straight length of a middle leaf, `alpha` the angle of the arcs [rad].
    `signs` is one of SIGNS. `start` is the fraction of `r` in the lever arm of the first couple.
    `ends` are the angles [rad] of the arcs of head and tail. Gauss' rule with 24 points per piece
    is exact to round-off. A straight half leaf of length a contributes a^3/3:

    >>> round(flexibility(2, 3.0, 0.0, 1.0, 1.0, "alternating", 1.0), 12)
    9.0
    """
    t, w = np.polynomial.legendre.leggauss(24)
    t, w = (t + 1) / 2, w / 2

    def over(length: float, moment: Any) -> float:
        return float(length * (w @ np.square(moment)))

    head, tail, angle, x = ends[0] * t, ends[1] * t, alpha * t, L2 * t
    total = over(a, a * t) + over(r * ends[0], a + r * np.sin(head))
    T, A = a + start * r, r * (1 - math.cos(alpha))
    for i in range(2, n):
        s = 1.0 if signs == "all plus" or i % 2 else -1.0
        total += over(r * alpha, T + s * r * (1 - np.cos(angle)))
        if signs == "M_2 as printed":  # the sign applies to T and the term of the arc, not to F x
            total += over(L2, x * math.sin(alpha) + s * (T + A))
        else:
            total += over(L2, T + s * (A + x * math.sin(alpha)))
        top = T + s * (A + L2 * math.sin(alpha))
        total += over(r * alpha, top + s * r * (np.cos(alpha - angle) - math.cos(alpha)))
        T = top + s * A
    return total + over(r * ends[1], T - r * (1 - np.cos(tail)))


@dataclass(frozen=True)
class Reading:
    """One interpretation of the equations and the resulting stiffness [N/m]."""

    leaf: str
    offset: str
    radius: str
    signs: str
    start: str
    k: float

    @property
    def is_adopted(self) -> bool:
        """True for the interpretation that `analytic.spring.energy` uses."""
        return (self.leaf, self.offset, self.radius, self.signs, self.start) == (
            "L_1/sin α", "r + b/2", "r", "alternating", "F (L_1/2 + r)",
        )  # fmt: skip


def readings(
    *, n: int, b: float, h: float, r: float, L1: float, alpha: float, E: float
) -> list[Reading]:
    """Stiffness for each interpretation of Eqs. 3 and 5, from quadrature of the printed moments.

    The spring has `n` segments of thickness `b` and width `h`, the inner radius `r` of the arcs,
    the straight length `L1` of head and tail, the angle `alpha` of the arcs [rad] and Young's
    modulus `E`.

    >>> found = readings(n=10, b=1e-4, h=56e-3, r=4.5e-4, L1=11.6e-3, alpha=1.4, E=206e9)
    >>> len(found), sum(one.is_adopted for one in found)
    (96, 1)
    """
    found = []
    for leaf, offset, radius, signs, start in product(LEAVES, OFFSETS, RADII, SIGNS, STARTS):
        arc = r if radius == "r" else r + b / 2
        halves, thickness = OFFSETS[offset]
        inner = r + halves * (b if thickness == "b" else h) / 2
        L2 = LEAVES[leaf] * L1 / math.sin(alpha) + 2 * inner / math.tan(alpha)
        f = flexibility(n, L1 / 2, arc, L2, alpha, signs, STARTS[start])
        found.append(Reading(leaf, offset, radius, signs, start, E * h * b**3 / 12 / f))
    return found
