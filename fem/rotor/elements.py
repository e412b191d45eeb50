"""Closed-form matrices of beam elements that rotate about their axis.

In one plane, with the unknowns (u, phi) at both ends and phi = du/dz - shear angle, the shape
functions are exact for a beam with loads at its ends only. Therefore

    K = E I / (L^3 (1 + Phi)) [...],    Phi = 12 E I / (kappa G A L^2),

and the masses are consistent with these functions: `M_t` of rho A u^2, `M_r` of rho I phi^2. The
polar inertia is twice rho I; the gyroscopic matrix in complex coordinates is therefore G_1 = 2 M_r.

References: H. D. Nelson, J. Mech. Des. 102 (1980) 793-803; Z. Friedman, J. B. Kosmatka,
Comput. Struct. 47 (1993) 473-481.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Sections:
    """Properties of beam elements (m,): lengths, stiffnesses and masses.

    The stiffnesses are those of bending, shear, extension and torsion.
    """

    L: Array
    EI: Array
    shear: Array  # kappa G A, infinite where shear is neglected
    EA: Array
    GJ: Array
    mass: Array  # rho A
    rotary: Array  # rho I, zero where rotary inertia is neglected
    polar: Array  # rho J


def bending_stiffness(s: Sections) -> Array:
    """Bending stiffness K (m, 4, 4) on (u, phi) at both ends."""
    Phi, L = _slenderness(s), s.L
    c = s.EI / (L**3 * (1 + Phi))
    return _symmetric(
        [12 * c, 6 * L * c, -12 * c, 6 * L * c],
        [(4 + Phi) * L**2 * c, -6 * L * c, (2 - Phi) * L**2 * c],
        [12 * c, -6 * L * c],
        [(4 + Phi) * L**2 * c],
    )


def translational_mass(s: Sections) -> Array:
    """Translational mass M_t (m, 4, 4) of rho A u^2."""
    f, L = _slenderness(s), s.L
    c = s.mass * L / (1 + f) ** 2
    end = (13 / 35 + 7 * f / 10 + f**2 / 3) * c
    turn = (11 / 210 + 11 * f / 120 + f**2 / 24) * L * c
    across = (9 / 70 + 3 * f / 10 + f**2 / 6) * c
    far = (13 / 420 + 3 * f / 40 + f**2 / 24) * L * c
    own = (1 / 105 + f / 60 + f**2 / 120) * L**2 * c
    other = -(1 / 140 + f / 60 + f**2 / 120) * L**2 * c
    return _symmetric([end, turn, across, -far], [own, far, other], [end, -turn], [own])


def rotary_mass(s: Sections) -> Array:
    """Rotary mass matrices M_r (m, 4, 4): q M_r q is the integral of rho I phi^2."""
    f, L = _slenderness(s), s.L
    c = s.rotary / (L * (1 + f) ** 2)
    end, turn = 6 / 5 * c, (1 / 10 - f / 2) * L * c
    own = (2 / 15 + f / 6 + f**2 / 3) * L**2 * c
    other = (-1 / 30 - f / 6 + f**2 / 6) * L**2 * c
    return _symmetric([end, turn, -end, turn], [own, -turn, other], [end, -turn], [own])


def bar_stiffness(stiffness: Array, L: Array) -> Array:
    """Stiffness K (m, 2, 2) of a bar, from E A or G J (`stiffness`) and its length."""
    return (stiffness / L)[:, None, None] * np.array([[1.0, -1.0], [-1.0, 1.0]])


def bar_mass(density: Array, L: Array) -> Array:
    """Mass M (m, 2, 2) of a bar, from rho A or rho J [per length] (`density`) and its length."""
    return (density * L / 6)[:, None, None] * np.array([[2.0, 1.0], [1.0, 2.0]])


def _slenderness(s: Sections) -> Array:
    return np.asarray(12 * s.EI / (s.shear * s.L**2))


def _symmetric(*rows: list[Array]) -> Array:
    """Symmetric matrices (m, n, n) from the rows of the upper triangle."""
    n, m = len(rows), rows[0][0].size
    A = np.empty((m, n, n))
    for i, row in enumerate(rows):
        for j, value in enumerate(row, start=i):
            A[:, i, j] = A[:, j, i] = value
    return A
