"""Correction of the flexibility of a thin frame by plane elasticity, to second order in b/R.

The correction has a closed form. The centre line of the spring is symmetric about the line of the
force. The middle of each leaf, of slope alpha, is on this line. The centres of the arcs are at the
distance L1/2 from the line, their apexes at L1/2 + R. At the angle t from the apex, the lever arm
of an arc is y = L1/2 + R cos t, and a unit force causes M = y, N = -cos t and V = sin t. On the
leaves, N and V are cos alpha and sin alpha. In units of 1/(EA), each unit of length adds

- N^2 + 12/5 (1 + nu) V^2: axial force, and shear of a rectangle;
- on arcs 2/5 (M/R)^2: a curved bar in pure bending is softer by (b/R)^2/30 in Golovin's solution;
- on arcs 2 (1 + 6 nu/5) N M/R: coupling of M and N; positive M puts the outer fibre in tension.

M^2/I = 12 M^2/(A b^2) is the part of the thin frame. The neglected terms are of fourth order in
b/R.

S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, Secs. 29 and 33.
"""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Added:
    """Relative corrections of the flexibility of a thin frame [1], by `shear` and `curvature`.

    `shear` includes the axial force.
    """

    shear: float
    curvature: float

    @property
    def both(self) -> float:
        """Relative error [1] of the stiffness of the thin frame: sum of both corrections."""
        return self.shear + self.curvature

    def next_order(self, slenderness: float) -> float:
        """Estimated size [1] of the neglected next term: `slenderness` b/R times the corrections.

        The magnitudes of the corrections are added, because they partly cancel.
        """
        return slenderness * (abs(self.shear) + abs(self.curvature))


@dataclass(frozen=True)
class _Arc:
    """Integrals over an arc from its apex to the angle t [rad], divided by the radius."""

    R: float
    c: float  # from the line of the force to the centre
    t: float

    @property
    def cos(self) -> float:
        return math.sin(self.t)

    @property
    def cos2(self) -> float:
        return self.t / 2 + math.sin(2 * self.t) / 4

    @property
    def lever(self) -> float:
        """Integral of y cos t over the arc."""
        return self.c * self.cos + self.R * self.cos2

    @property
    def square(self) -> float:
        """Integral of y^2 over the arc."""
        return self.c**2 * self.t + 2 * self.c * self.R * self.cos + self.R**2 * self.cos2


def added(
    *, n: int, L1: float, radius: float, alpha: float, b: float, nu: float, wide: bool
) -> Added:
    """Corrections for a free head and a tail clamped at the end of its arc.

    The spring has `n` segments, the straight length `L1` of head and tail, the `radius` R of the
    centre line of the arcs, the thickness `b` [length] and the angle `alpha` of the arcs [rad].
    `wide` is plane strain: nu/(1 - nu) in place of nu.

    >>> shape = {"n": 4, "L1": 10.0, "radius": 1.0, "alpha": 1.5, "nu": 0.3, "wide": False}
    >>> thick, thin = added(b=0.2, **shape), added(b=0.1, **shape)
    >>> round(thick.shear / thin.shear, 12), round(thick.curvature / thin.curvature, 12)
    (4.0, 4.0)
    """
    if wide:
        nu = nu / (1 - nu)
    R, c = radius, L1 / 2
    middle = n - 2  # leaves, each with an arc at both ends; a quarter turn at head and tail
    arcs = ((2.0, _Arc(R, c, math.pi / 2)), (2.0 * middle, _Arc(R, c, alpha)))

    def round_arcs(of: str) -> float:
        return R * sum(count * float(getattr(arc, of)) for count, arc in arcs)

    reach = c + R * math.cos(alpha)  # of a leaf's ends
    leaves = middle * 2 * reach / math.sin(alpha)
    squares = c**3 / 3 + leaves * reach**2 / 3 + round_arcs("square")
    across = leaves * math.sin(alpha) ** 2 + round_arcs("t") - round_arcs("cos2") + c
    along = leaves * math.cos(alpha) ** 2 + round_arcs("cos2")
    shear = along + 12 / 5 * (1 + nu) * across
    together = -round_arcs("lever") / R
    curvature = 2 / 5 * round_arcs("square") / R**2 + 2 * (1 + 6 / 5 * nu) * together
    thin = 12 / b**2 * squares
    return Added(shear / thin, curvature / thin)
