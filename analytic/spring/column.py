r"""Lateral buckling of an accordion spring: equivalent column of Haringx.

A spring under compression is a column with bending, shear and a large shortening. Its rigidities
are the stiffnesses of one middle unit (arc, leaf, arc) of pitch p. They follow from unit-load
integrals about the centre of the unit, which are exact for small loads:

.. math:: B = p / a_B, \qquad C = p / a_C, \qquad S = p \,/\, (a_S - p^2 a_B/12)

against a couple, an axial force and a lateral force, respectively. The bending by a lateral force
that is uniform over the pitch is not part of the shear compliance. The number of units is constant
while the spring shortens to :math:`L = L_0 (1 - \xi)`, so that all rigidities decrease in
proportion to L. In Haringx's theory, the shear force acts along the rotated section. The wave
number k of the deflected column under the force :math:`P = C \xi` then satisfies

.. math::

   (k L)^2 = \frac{P}{B}\Big(1 + \frac{P}{S}\Big) L^2
           = \frac{C L_0^2}{B}\,\xi \Big[1 - \Big(1 - \frac{C}{S}\Big)\xi\Big]

and the spring with a clamped tail buckles if kL reaches :math:`\pi/2` (head free), the root of
:math:`\tan kL = kL/(1 + P/S)` (head hinged) or :math:`2\pi` (head guided). As kL has a maximum, a
sufficiently short spring never buckles. :math:`\xi` depends only on the shape of the centre line,
as only ratios of lengths and forces have an effect.

Range: many units (errors of the order 1/n), shortening so small that the initial flexibilities of a
unit are valid.

References
----------
.. [1] J. A. Haringx, On highly compressible helical springs and rubber rods, Philips Res. Rep. 3
   (1948) 401-449.
.. [2] S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 2nd ed., McGraw-Hill 1961,
   art. 2.18 (helical springs).
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Head = Literal["free", "hinged", "guided"]

WAVES = {"free": math.pi / 2, "guided": 2 * math.pi}
SHEAR = 6 / 5  # energy factor of a rectangle


@dataclass(frozen=True)
class Unit:
    """Pitch [length] and compliances of one middle unit about its centre.

    `turn` [1/(force x length)] is the compliance under a couple. `axial` and `lateral`
    [length/force] are the compliances under forces along and across the spring.
    """

    pitch: Array
    turn: Array
    axial: Array
    lateral: Array


def unit(
    *,
    L1: ArrayLike,
    radius: ArrayLike,
    alpha: ArrayLike,
    b: ArrayLike,
    h: ArrayLike,
    E: ArrayLike,
    nu: ArrayLike = 0.3,
) -> Unit:
    r"""Pitch and compliances of a middle unit, by unit-load integrals over arc, leaf and arc.

    `radius` is the radius of the centre line of the arcs. With the angle :math:`\beta` between the
    tangent of the arc and the axis, its points are at

    .. math:: x = p/2 - R\sin\beta, \quad y = L_1/2 + R\cos\beta, \quad 0 \le \beta \le \alpha

    and the leaf between the arcs is straight. Bending, axial force and shear are included.

    >>> flat = unit(L1=11.6, radius=0.5, alpha=math.pi / 2, b=0.1, h=56, E=206e3)
    >>> round(float(flat.pitch), 12), round(float(flat.turn) * 961.333333, 4)  # E I: 11.6 + π/2
    (1.0, 13.1708)
    """
    L1, R, alpha, b, h, E, nu = (np.asarray(v, float) for v in (L1, radius, alpha, b, h, E, nu))
    if not all(np.all(v > 0) for v in (L1, R, b, h, E)):
        raise ValueError(
            f"L1, radius, b, h and E must be positive, got L1={L1} m, radius={R} m, b={b} m, "
            f"h={h} m, E={E} Pa"
        )
    if not np.all((alpha > 0) & (alpha <= np.pi / 2)):
        raise ValueError(f"alpha must lie in (0, 90] deg, got {np.degrees(alpha)} deg")
    sin, cos = np.sin(alpha), np.cos(alpha)
    leaf = (L1 + 2 * R * cos) / sin
    half = leaf * cos / 2 + R * sin  # of the pitch
    squared_cos = R * (alpha + sin * cos)  # of both arcs, along their length
    squared_sin = R * (alpha - sin * cos)
    y2 = leaf**3 * sin**2 / 12 + 2 * R * (alpha * L1**2 / 4 + L1 * R * sin) + R**2 * squared_cos
    x2 = leaf**3 * cos**2 / 12 + 2 * R * (alpha * half**2 - 2 * half * R * (1 - cos))
    x2 = x2 + R**2 * squared_sin
    along, across = leaf * cos**2 + squared_cos, leaf * sin**2 + squared_sin
    EI, EA = E * h * b**3 / 12, E * h * b
    shear = SHEAR * 2 * (1 + nu) / EA
    return Unit(
        pitch=2 * half,
        turn=(leaf + 2 * R * alpha) / EI,
        axial=y2 / EI + along / EA + shear * across,
        lateral=x2 / EI + across / EA + shear * along,
    )


def critical_shortening(
    head: Head, *, n: ArrayLike, L1: ArrayLike, radius: ArrayLike, alpha: ArrayLike,
    b: ArrayLike, nu: ArrayLike = 0.3,
) -> Array:  # fmt: skip
    r"""Relative shortening :math:`\xi = U_{cr}/L_0` at lateral buckling; NaN without buckling.

    L_0 is the distance along the axis between the centre lines of the leaves of head and tail. The
    thickness has only a small effect, by axial force and shear.

    >>> shape = dict(L1=11.6, radius=0.5, alpha=math.radians(80), b=0.1)
    >>> round(float(critical_shortening("free", n=10, **shape)), 4)
    0.0577
    >>> float(critical_shortening("guided", n=10, **shape))
    nan
    """
    part = unit(L1=L1, radius=radius, alpha=alpha, b=b, h=1.0, E=1.0, nu=nu)
    length = free_length(n=n, L1=L1, radius=radius, alpha=alpha)
    slender = length**2 * part.turn / part.axial  # C L_0^2 / B
    softer = (part.lateral - part.pitch**2 * part.turn / 12) / part.axial  # C / S
    if head != "hinged":
        return _shortening(WAVES[head] ** 2, slender, softer)
    x = np.full(np.shape(slender), 4.493409457909064)  # root of tan x = x
    for _ in range(40):
        xi = _shortening(x**2, slender, softer)
        x = _hinged_waves(1 + softer * xi / (1 - xi), x)
    return _shortening(x**2, slender, softer)


def critical_force(
    head: Head, *, n: ArrayLike, L1: ArrayLike, radius: ArrayLike, alpha: ArrayLike,
    b: ArrayLike, h: ArrayLike, E: ArrayLike, nu: ArrayLike = 0.3,
) -> Array:  # fmt: skip
    r"""Buckling force :math:`C \xi` [force], proportional to b^3; NaN without buckling."""
    part = unit(L1=L1, radius=radius, alpha=alpha, b=b, h=h, E=E, nu=nu)
    xi = critical_shortening(head, n=n, L1=L1, radius=radius, alpha=alpha, b=b, nu=nu)
    return np.asarray(part.pitch / part.axial * xi)


def free_length(*, n: ArrayLike, L1: ArrayLike, radius: ArrayLike, alpha: ArrayLike) -> Array:
    """Distance [length] along the axis between the centre lines of the leaves of head and tail."""
    n, R = np.asarray(n), np.asarray(radius, float)
    if np.any(n < 3):
        raise ValueError(f"a spring must have at least 3 segments, got n={n}")
    part = unit(L1=L1, radius=R, alpha=alpha, b=1.0, h=1.0, E=1.0)
    return np.asarray((n - 2) * part.pitch + 2 * R)


def _shortening(waves: ArrayLike, slender: Array, softer: Array) -> Array:
    """Smaller root of slender xi (1 - (1 - softer) xi) = waves; NaN without a real root."""
    bent = np.asarray(waves, float) / slender
    under = 1 - 4 * (1 - softer) * bent
    root = np.sqrt(np.where(under >= 0, under, np.nan))
    return np.asarray(2 * bent / (1 + root))


def _hinged_waves(stiffer: Array, x: Array) -> Array:
    """Root in (pi, 3 pi/2) of sin x - (x/stiffer) cos x, by Newton's method from `x`."""
    for _ in range(20):
        sin, cos = np.sin(x), np.cos(x)
        value, slope = sin - x / stiffer * cos, cos * (1 - 1 / stiffer) + x / stiffer * sin
        x = x - value / slope
    return np.asarray(x)
