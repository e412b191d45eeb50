"""Matrices of many systems of one layout at once, in the complex coordinate of forward whirl.

Node n has the unknowns (r, phi) at 2n - 2 and 2n - 1: K v = Omega^2 (M - G_1) v is a critical
speed. Elements are those of `fem.rotor`, as is the assembled system, which a test compares.
"""

from functools import cache

import numpy as np

from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CLUTCH,
    DISCS,
    GROUNDED,
    HOLLOW,
    INNER,
    NU,
    OUTER,
    RHO,
    E,
    Layout,
)
from verify.core.figures import Array

UNKNOWNS = 2 * (OUTER + INNER)
FIRST = np.array([2 * i for i in range(OUTER + INNER - 1) if i != OUTER - 1])  # of an element
ENDS = FIRST[:, None] + np.arange(4)


@cache
def shear_fem() -> Array:
    """Shear coefficients (20,) of the elements."""
    from fem.rotor.parts import Element, Material

    steel = Material(E, NU, RHO)
    return np.array([Element(1.0, 1.0, bore, steel).kappa for bore in HOLLOW])


def elements_fem(s: Layout) -> tuple[Array, Array, Array]:
    """Stiffness, mass and gyroscopic matrices (m, 20, 4, 4) of the elements."""
    from fem.rotor.elements import Sections, bending_stiffness, rotary_mass, translational_mass

    A = np.pi / 4 * (s.d_o**2 - s.d_i**2)
    I = np.pi / 64 * (s.d_o**4 - s.d_i**4)  # noqa: E741 - the book's symbol
    GA = shear_fem() * E / (2 * (1 + NU)) * A
    sections = Sections(
        L=s.length.ravel(), EI=E * I.ravel(), shear=GA.ravel(), EA=E * A.ravel(),
        GJ=E / (1 + NU) * I.ravel(), mass=RHO * A.ravel(), rotary=RHO * I.ravel(),
        polar=2 * RHO * I.ravel(),
    )  # fmt: skip
    shape = (*s.length.shape, 4, 4)
    K, rotary = bending_stiffness(sections).reshape(shape), rotary_mass(sections).reshape(shape)
    return K, translational_mass(sections).reshape(shape) + rotary, 2 * rotary


def springs(s: Layout, *, across: bool, tilt: bool) -> list[tuple[int, int | None, Array]]:
    """Unknowns, the second None for the ground, and stiffness (m,) between them.

    The clutch is left out `across` or in `tilt` where that is False.
    """
    made: list[tuple[int, int | None, Array]] = [(2 * n - 2, None, s.k_g) for n in GROUNDED]
    made += [(2 * a - 2, 2 * b - 2, s.k_s) for a, b in BETWEEN]
    a, b = CLUTCH
    if across:
        made.append((2 * a - 2, 2 * b - 2, s.k_c))
    if tilt:
        made.append((2 * a - 1, 2 * b - 1, s.k_tilt))
    return made


def assembled_fem(
    s: Layout, *, across: bool = True, tilt: bool = True
) -> tuple[Array, Array, Array]:
    """K, M and G_1 (m, 44, 44) of the systems, without parts of the clutch where asked."""
    shape = (s.length.shape[0], UNKNOWNS, UNKNOWNS)
    K, M, G = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    for whole, parts in zip((K, M, G), elements_fem(s), strict=True):
        for e, at in enumerate(FIRST):
            whole[:, at : at + 4, at : at + 4] += parts[:, e]
    for i, node in enumerate(DISCS):
        r, phi = 2 * node - 2, 2 * node - 1
        M[:, r, r] += s.mass[:, i]
        M[:, phi, phi] += s.diametral[:, i]
        G[:, phi, phi] += s.polar[:, i]
    for i, j, k in springs(s, across=across, tilt=tilt):
        K[:, i, i] += k
        if j is not None:
            K[:, j, j] += k
            K[:, i, j] -= k
            K[:, j, i] -= k
    return K, M, G


def energies_fem(s: Layout, v: Array) -> tuple[Array, Array]:
    """V K v and v (M - G_1) v (m, k) of shapes v (m, 44, k)."""
    K, M, G = elements_fem(s)
    ends = v[:, ENDS]  # m, 20, 4, k
    stiff = np.einsum("meik,meik->mk", ends, K @ ends)
    inert = np.einsum("meik,meik->mk", ends, (M - G) @ ends)
    for i, node in enumerate(DISCS):
        inert += s.mass[:, i, None] * v[:, 2 * node - 2] ** 2
        inert += (s.diametral - s.polar)[:, i, None] * v[:, 2 * node - 1] ** 2
    for i, j, k in springs(s, across=True, tilt=True):
        stiff += k[:, None] * (v[:, i] - (0 if j is None else v[:, j])) ** 2
    return stiff, inert
