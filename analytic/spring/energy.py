r"""Free stage of the accordion spring: stiffness by the energy method (Wang et al. 2023, Eqs. 1-9).

The equations are corrected; the errata list contains the printed forms. The bending couple is
:math:`M = F y` with the height y of the centre line above the line of action of the force, which
passes through the middle of the head. Head and tail are half leaves with a quarter arc. Each of the
n - 2 units between them is a leaf with an arc of the angle alpha at both ends. Every part is
integrated in closed form. The arcs have the inner radius r as in the paper, although the radius of
the centre line is r + b/2; `analytic.spring.frame` accepts both.

Range: small displacements, thin strip (b << r), head free to rotate and to move laterally, tail
clamped at the end of its arc, no contact between the parts.

References
----------
.. [1] Wang et al., Trans. Nanjing Univ. Aeronaut. Astronaut. 40 (2023) 264-272, Eqs. 1-9.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def leaf_length(*, L1: ArrayLike, r: ArrayLike, b: ArrayLike, alpha: ArrayLike) -> Array:
    r"""Straight length L_2 [length] of a middle unit (in Eq. 3).

    .. math:: L_2 = \frac{L_1}{\sin\alpha} + \frac{2 (r + b/2)}{\tan\alpha}

    >>> round(float(leaf_length(L1=11.6, r=0.45, b=0.1, alpha=np.pi / 2)), 12)
    11.6
    """
    L1, r, b, alpha = _geometry(L1, r, b, alpha)
    return np.asarray(L1 / np.sin(alpha) + 2 * (r + b / 2) / np.tan(alpha))


def head_flexibility(*, L1: ArrayLike, r: ArrayLike) -> Array:
    r"""Integral :math:`\int (M/F)^2 ds` [length^3] of the head, leaf and arc (Eqs. 1 and 2).

    .. math:: M/F = x, \quad 0 \le x \le L_1/2; \qquad
        M/F = L_1/2 + r \sin\theta, \quad 0 \le \theta \le \pi/2
    """
    a, r = np.asarray(L1, float) / 2, np.asarray(r, float)
    return np.asarray(a**3 / 3 + r * (np.pi / 2 * a**2 + 2 * a * r + np.pi / 4 * r**2))


def apex_moments(
    *, n: int, L1: ArrayLike, r: ArrayLike, b: ArrayLike, alpha: ArrayLike
) -> tuple[Array, ...]:
    r"""Moments T_1 to T_(n-1) per force [length]; T_i is at the apex of the last arc of unit i.

    .. math:: T_1 = L_1/2 + r, \qquad T_i = T_{i-1} + s_i\,(2A + L_2 \sin\alpha), \qquad
        A = r (1 - \cos\alpha), \quad s_i = (-1)^{i+1}

    Eq. 3 omits this recursion; it follows from the last line of Eq. 3 at theta = alpha.
    """
    L1, r, b, alpha = _geometry(L1, r, b, alpha)
    if n < 3:
        raise ValueError(f"a spring must have at least 3 segments, got n={n}")
    rise = 2 * r * (1 - np.cos(alpha)) + leaf_length(L1=L1, r=r, b=b, alpha=alpha) * np.sin(alpha)
    T = [L1 / 2 + r]
    for i in range(2, n):
        T.append(T[-1] + _sign(i) * rise)
    return tuple(T)


def unit_flexibility(
    i: int, T: ArrayLike, *, L1: ArrayLike, r: ArrayLike, b: ArrayLike, alpha: ArrayLike
) -> Array:
    r"""Integral :math:`\int (M/F)^2 ds` [length^3] of unit i, for T = T_(i-1) (Eqs. 3, 4).

    .. math::
        M/F = T + s\,r (1-\cos\theta); \quad T + s (A + x \sin\alpha); \quad
        T + s\,(A + L_2\sin\alpha + r(\cos(\alpha-\theta) - \cos\alpha))
    """
    L1, r, b, alpha = _geometry(L1, r, b, alpha)
    T, s = np.asarray(T, float), _sign(i)
    L2, A = leaf_length(L1=L1, r=r, b=b, alpha=alpha), r * (1 - np.cos(alpha))
    c0 = T + s * A
    c1 = c0 + s * L2 * np.sin(alpha)
    leaf: Array = L2 * (c0**2 + c0 * c1 + c1**2) / 3
    # the second arc mirrored: from its apex couple c1 + s A it runs back with the other sign
    return _arc(T, s, r, alpha) + leaf + _arc(c1 + s * A, -s, r, alpha)


def tail_flexibility(n: int, T: ArrayLike, *, r: ArrayLike) -> Array:
    r"""Integral :math:`\int (M/F)^2 ds` [length^3] of the tail arc, for T = T_(n-1) (Eqs. 5, 6).

    .. math:: M/F = T + s_n\, r (1 - \cos\theta), \quad 0 \le \theta \le \pi/2

    s_n = -1 for the even n of the paper. A spring with odd n ends on the other side, with s_n = +1.
    """
    return _arc(np.asarray(T, float), _sign(n), np.asarray(r, float), np.asarray(np.pi / 2))


def flexibility(*, n: int, L1: ArrayLike, r: ArrayLike, b: ArrayLike, alpha: ArrayLike) -> Array:
    r"""Integral :math:`\int (M/F)^2 ds` [length^3] of the whole spring, the sum of Eq. 7."""
    T = apex_moments(n=n, L1=L1, r=r, b=b, alpha=alpha)
    units: Any = sum(
        unit_flexibility(i, T[i - 2], L1=L1, r=r, b=b, alpha=alpha) for i in range(2, n)
    )
    return np.asarray(head_flexibility(L1=L1, r=r) + units + tail_flexibility(n, T[-1], r=r))


def strain_energy(*, F: ArrayLike, E: ArrayLike, h: ArrayLike, **geometry: Any) -> Array:
    r"""Strain energy V [force x length] under F (Eq. 7): :math:`F^2 \int (M/F)^2 ds / (2 E I)`."""
    return np.asarray(F, float) ** 2 * flexibility(**geometry) / (2 * _EI(E, h, geometry["b"]))


def deflection(*, F: ArrayLike, E: ArrayLike, h: ArrayLike, **geometry: Any) -> Array:
    r"""Deflection [length] of the head under F (Eq. 8): :math:`\Delta = \partial V/\partial F`."""
    return np.asarray(F, float) * flexibility(**geometry) / _EI(E, h, geometry["b"])


def stiffness(
    *,
    n: int,
    b: ArrayLike,
    h: ArrayLike,
    r: ArrayLike,
    L1: ArrayLike,
    alpha: ArrayLike,
    E: ArrayLike,
) -> Array:
    r"""Stiffness k_1 [force/length] of the free stage, before the tips touch (Eq. 9).

    .. math:: k_1 = E I \Big/ \int (M/F)^2 ds, \qquad I = h b^3/12

    >>> k_1 = stiffness(n=10, b=0.1, h=56, r=0.45, L1=11.6, alpha=np.radians(80), E=206e3)
    >>> round(float(k_1), 5)  # N/mm; the paper prints 0.601
    0.60096
    """
    return 1 / deflection(F=1.0, E=E, h=h, n=n, b=b, r=r, L1=L1, alpha=alpha)


def bending_stress(
    *, F: ArrayLike, b: ArrayLike, h: ArrayLike, r: ArrayLike, L1: ArrayLike
) -> Array:
    r"""Largest bending stress [stress], at the inner side of the apex of a loop.

    .. math:: \sigma = \kappa\,\frac{6 M}{h b^2}

    with M = F (L_1/2 + r) and the factor :math:`\kappa` of `curvature_factor`. This stress occurs
    in the loops of head and tail.
    """
    F, b, h, r, L1 = (np.asarray(v, float) for v in (F, b, h, r, L1))
    return np.asarray(curvature_factor(b=b, r=r) * 6 * F * (L1 / 2 + r) / (h * b**2))


def curvature_factor(*, b: ArrayLike, r: ArrayLike) -> Array:
    r"""Ratio of the largest stress of a curved bar in pure bending to 6M/(hb²) of a straight bar.

    .. math::
        \kappa = \frac{2 b^2}{3 N}\left[2 b_o^2 \ln\frac{b_o}{r} - (b_o^2 - r^2)\right], \qquad
        N = (b_o^2 - r^2)^2 - 4 r^2 b_o^2 \ln^2\frac{b_o}{r}, \quad b_o = r + b

    Golovin's solution in plane elasticity (S. P. Timoshenko, J. N. Goodier, Theory of Elasticity,
    3rd ed., art. 29); r is the inner radius.

    >>> round(float(curvature_factor(b=1.0, r=1.0)) * 6, 3)  # their table: 7.755 M/a² at b/a = 2
    7.755
    """
    b, r = np.asarray(b, float), np.asarray(r, float)
    o = r + b
    log = np.log(o / r)
    N = (o**2 - r**2) ** 2 - 4 * r**2 * o**2 * log**2
    return np.asarray(2 * b**2 / (3 * N) * (2 * o**2 * log - (o**2 - r**2)))


def _arc(T: Array, s: int, r: Array, angle: Array) -> Array:
    """Integral of (T + s r (1 - cos t))^2 r dt from 0 to `angle`."""
    one = angle - np.sin(angle)
    two = 1.5 * angle - 2 * np.sin(angle) + np.sin(2 * angle) / 4
    return np.asarray(r * (T**2 * angle + 2 * s * T * r * one + r**2 * two))


def _sign(i: int) -> int:
    return 1 if i % 2 else -1


def _EI(E: ArrayLike, h: ArrayLike, b: ArrayLike) -> Array:
    E, h, b = (np.asarray(v, float) for v in (E, h, b))
    if not (np.all(E > 0) and np.all(h > 0) and np.all(b > 0)):
        raise ValueError(f"E, h and b must be positive, got E={E!s} Pa, h={h!s} m, b={b!s} m")
    return np.asarray(E * h * b**3 / 12)


def _geometry(*lengths_and_angle: ArrayLike) -> tuple[Array, Array, Array, Array]:
    L1, r, b, alpha = (np.asarray(v, dtype=np.float64) for v in lengths_and_angle)
    if not (np.all(L1 > 0) and np.all(r > 0) and np.all(b > 0)):
        raise ValueError(f"L1, r and b must be positive, got L1={L1} m, r={r} m, b={b} m")
    if not np.all((alpha > 0) & (alpha <= np.pi / 2)):
        raise ValueError(f"alpha must lie in (0, 90] deg, got {np.degrees(alpha)} deg")
    return L1, r, b, alpha
