r"""Stages of the spring for many candidates at once: free, and with leaves that touch.

With y the height above the line of the force, a = L1/2 and unit-load integrals along the centre
line,

.. math::
    k_1 = \frac{E I}{J}, \quad F_A = \frac{g_0 E I}{f_{FC}}, \quad U_A = \frac{F_A}{k_1}, \quad
    k_2 = \frac{E I}{J - m f_{FC}^2/f_{CC}}

J = ∫ y² ds over the spring, f_FC = ∫ y (y + a) ds and f_CC = ∫ (y + a)² ds over the loop between
the head's free tip and the leaf opposite to it, whose gap is g_0. A tail held in its mid-leaf has
such a tip too, m = 2; one held along its leaf has none, m = 1.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.spring import energy

Array = NDArray[np.float64]
THIN = np.finfo(float).tiny  # a thickness that adds nothing to the radius it is given with


@dataclass(frozen=True)
class Stages:
    """Stiffness before and after leaves touch, and the point A where they do; SI, arrays (N,)."""

    k1: Array
    U_A: Array
    F_A: Array
    k2: Array


def free_length(*, n: int, L1: Array, r: Array, b: Array, alpha: Array) -> Array:
    """L_0 [m] over all, leaf to leaf, on the true centre line R = r + b/2.

    >>> L1, r, b, alpha = (np.array([v]) for v in (11.6, 0.45, 0.1, np.radians(80)))
    >>> round(float(free_length(n=10, L1=L1, r=r, b=b, alpha=alpha)[0]), 2)  # the paper's, mm
    25.59
    """
    R = r + b / 2
    leaf = energy.leaf_length(L1=L1, r=r, b=b, alpha=alpha)
    unit = 2 * R * np.sin(alpha) + leaf * np.cos(alpha)
    return np.asarray(2 * R + (n - 2) * unit + b)


def stress(*, F: float, h: float, L1: Array, r: Array, b: Array) -> Array:
    """Bending stress [Pa] inside the apex of a loop, where M = F (L1/2 + R)."""
    kappa = energy.curvature_factor(b=b, r=r)
    return np.asarray(kappa * 6 * F * (L1 / 2 + r + b / 2) / (h * b**2))


def stages(
    *,
    n: int,
    L1: Array,
    r: Array,
    b: Array,
    alpha: Array,
    h: float,
    E: float,
    arcs: Literal["centre line", "inner"],
    tail: Literal["arc", "mid-leaf"],
) -> Stages:
    """Both stiffnesses and point A; the arcs of J have the true radius or the inner one."""
    R, a = r + b / 2, L1 / 2
    EI = E * h * b**3 / 12
    if arcs == "inner":
        J = energy.flexibility(n=n, L1=L1, r=r, b=b, alpha=alpha)
    else:
        J = energy.flexibility(n=n, L1=L1, r=R, b=np.full_like(b, THIN), alpha=alpha)
    m = 1
    if tail == "mid-leaf":
        J, m = J + a**3 / 3, 2
    top = a + R * np.cos(alpha)
    gap = R * (1 + np.sin(alpha)) + (top + a) / np.tan(alpha) - b / 2 * (1 + 1 / np.sin(alpha))
    f_FC, f_CC = _loop(a, R, alpha, top)
    F_A = gap * EI / f_FC
    k1 = EI / J
    return Stages(k1=k1, U_A=F_A / k1, F_A=F_A, k2=EI / (J - m * f_FC**2 / f_CC))


def _loop(a: Array, R: Array, alpha: Array, top: Array) -> tuple[Array, Array]:
    """f_FC and f_CC [m³]: half leaf, arc of 90 deg + alpha, leaf from `top` down to -a."""
    T = np.pi / 2 + alpha
    one, two = 1 - np.cos(T), T / 2 - np.sin(2 * T) / 4  # of sin and its square
    f_FC = (
        5 / 6 * a**3
        + R * (2 * a**2 * T + 3 * a * R * one + R**2 * two)
        + ((top**3 + a**3) / 3 + a * (top**2 - a**2) / 2) / np.sin(alpha)
    )
    f_CC = (
        7 / 3 * a**3
        + R * (4 * a**2 * T + 4 * a * R * one + R**2 * two)
        + (top + a) ** 3 / (3 * np.sin(alpha))
    )
    return np.asarray(f_FC), np.asarray(f_CC)
