r"""Plane elasticity of a body between two opposite forces, by complex potentials.

Forces F and -F along AB act on the outline at A and B. The solution for one of them alone is
Flamant's. With the point z_0 of the force, Goursat's functions are

.. math:: \varphi = -\frac{F}{2\pi}\ln(z - z_0), \qquad
          \psi = \frac{\bar F}{2\pi}\ln(z - z_0) - \bar z_0\,\varphi'.

These potentials leave bounded tractions on the outline. Polynomials cancel these tractions in a
least-squares sense: the resultant force must be constant along both sides of the outline between A
and B,

.. math:: \varphi + z\,\overline{\varphi'} + \overline{\psi} = \text{const}, \qquad
          2G(u + iv) = \kappa\varphi - z\,\overline{\varphi'} - \overline{\psi}.

The rotation omega of the body is given by 2G omega = (kappa + 1) Im phi'.

References
----------
.. [1] N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity,
   Noordhoff 1953.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array

Complex = NDArray[np.complex128]
Goursat = tuple[Complex, Complex, Complex]  # phi, its derivative, psi
Force = tuple[complex, complex]  # point of application, force

DEGREE = 24  # of the polynomials: 4e-4 of a sprag's approach


@dataclass(frozen=True, kw_only=True)
class Outline:
    """Points A and B of the forces, x + iy [length], and both sides of the outline from A to B.

    With B above A, the body is to the right of `left` and to the left of `right`.
    """

    A: complex
    B: complex
    left: Complex
    right: Complex


def forces_along(outline: Outline) -> tuple[Force, Force]:
    """Pair of unit forces that compress the body at A and B, along AB."""
    along = (outline.B - outline.A) / abs(outline.B - outline.A)
    return (outline.A, along), (outline.B, -along)


def flamant(z: Complex, force: Force) -> Goursat:
    """Goursat's functions of one force; the branch cut of the logarithm lies outside the body."""
    z_0, F = force
    logarithm = np.log((z - z_0) / F)
    slope = np.asarray(-F / (2 * np.pi * (z - z_0)))
    psi = np.conj(F) / (2 * np.pi) * logarithm - np.conj(z_0) * slope
    return np.asarray(-F / (2 * np.pi) * logarithm), slope, np.asarray(psi)


def displaced(z: Complex, goursat: Goursat, kappa: float) -> Complex:
    """Displacements 2G (u + iv) at the points z."""
    phi, slope, psi = goursat
    return np.asarray(kappa * phi - z * np.conj(slope) - np.conj(psi))


def turns(goursat: Goursat, kappa: float) -> Array:
    """Rotations 2G omega, anticlockwise."""
    _, slope, _ = goursat
    return np.asarray((kappa + 1) * slope.imag)


def rest(
    outline: Outline, forces: tuple[Force, Force], degree: int
) -> Callable[[Complex], Goursat]:
    """Goursat's functions, as polynomials, of the field that cancels the tractions of `forces`."""
    z = np.concatenate([outline.right, outline.left])
    middle, size = (outline.A + outline.B) / 2, abs(outline.B - outline.A) / 2
    k = np.arange(1, degree + 1)

    def powers(z: Complex) -> tuple[Complex, Complex]:
        s = np.asarray((z - middle) / size)[:, None]
        return s**k, k * s ** (k - 1) / size

    given = sum(-displaced(z, (-phi, slope, psi), 1.0)
                for phi, slope, psi in (flamant(z, force) for force in forces))  # fmt: skip
    V, slopes = powers(z)
    side = np.zeros((z.size, 2))
    side[: outline.right.size, 0] = side[outline.right.size :, 1] = 1
    columns = np.hstack(
        [u * V + z[:, None] * np.conj(u * slopes) for u in (1, 1j)]
        + [np.conj(u * V) for u in (1, 1j)] + [u * side for u in (1, 1j)]
    )  # fmt: skip
    x, *_ = np.linalg.lstsq(
        np.vstack([columns.real, columns.imag]), -np.concatenate([given.real, given.imag]),
        rcond=1e-13,
    )  # fmt: skip
    a, b = (x[i : i + degree] + 1j * x[i + degree : i + 2 * degree] for i in (0, 2 * degree))

    def polynomials(z: Complex) -> Goursat:
        V, slopes = powers(z)
        return np.asarray(V @ a), np.asarray(slopes @ a), np.asarray(V @ b)

    return polynomials
