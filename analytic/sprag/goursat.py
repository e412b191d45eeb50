r"""Plane elasticity of a body between two opposed forces, by complex potentials.

Forces F and -F along AB press the outline at A and B. Alone, each would be Flamant's, with z_0 its
point and Goursat's functions

.. math:: \varphi = -\frac{F}{2\pi}\ln(z - z_0), \qquad
          \psi = \frac{\bar F}{2\pi}\ln(z - z_0) - \bar z_0\,\varphi' ,

which leaves bounded tractions on the outline. Polynomials take these off by least squares on the
resultant force, which is constant on either side between A and B,

.. math:: \varphi + z\,\overline{\varphi'} + \overline{\psi} = \text{const}, \qquad
          2G(u + iv) = \kappa\varphi - z\,\overline{\varphi'} - \overline{\psi} .

The body turns by 2G omega = (kappa + 1) Im phi'.

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
    """Force points A and B as x + iy [length], and the outline between them on either side, (m,).

    The body is to the right of `left` and to the left of `right`, seen with B above A.
    """

    A: complex
    B: complex
    left: Complex
    right: Complex


def forces_along(outline: Outline) -> tuple[Force, Force]:
    """Unit forces on the body at A and B."""
    along = (outline.B - outline.A) / abs(outline.B - outline.A)
    return (outline.A, along), (outline.B, -along)


def flamant(z: Complex, force: Force) -> Goursat:
    """Goursat's functions of one force, cut outside the body."""
    z_0, F = force
    logarithm = np.log((z - z_0) / F)
    slope = np.asarray(-F / (2 * np.pi * (z - z_0)))
    psi = np.conj(F) / (2 * np.pi) * logarithm - np.conj(z_0) * slope
    return np.asarray(-F / (2 * np.pi) * logarithm), slope, np.asarray(psi)


def displaced(z: Complex, goursat: Goursat, kappa: float) -> Complex:
    """2G (u + iv)."""
    phi, slope, psi = goursat
    return np.asarray(kappa * phi - z * np.conj(slope) - np.conj(psi))


def turns(goursat: Goursat, kappa: float) -> Array:
    """2G omega, anticlockwise."""
    _, slope, _ = goursat
    return np.asarray((kappa + 1) * slope.imag)


def rest(
    outline: Outline, forces: tuple[Force, Force], degree: int
) -> Callable[[Complex], Goursat]:
    """Polynomials that free the outline of the forces' tractions."""
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
