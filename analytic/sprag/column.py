r"""A sprag as an elastic body: how two opposed forces press a column with rounded ends.

Forces F and -F along AB press the outline at A and B. Alone, each would be Flamant's, with z_0 its
point and Goursat's functions

.. math:: \varphi = -\frac{F}{2\pi}\ln(z - z_0), \qquad
          \psi = \frac{\bar F}{2\pi}\ln(z - z_0) - \bar z_0\,\varphi' ,

which leaves bounded tractions on the outline. Polynomials take these off by least squares on the
resultant force, which is constant on either side between A and B,

.. math:: \varphi + z\,\overline{\varphi'} + \overline{\psi} = \text{const}, \qquad
          2G(u + iv) = \kappa\varphi - z\,\overline{\varphi'} - \overline{\psi} .

In the middle of a Hertz patch of half-width a the logarithm becomes ln(2/a) + 1/2. A disc comes out
to round-off (`hertz_line_approach.approach_to_centre`). Left out are (a/r)² and the square of the
angle between forces and normals.

References
----------
.. [1] N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity,
   Noordhoff 1953.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from analytic.contact.checks import Array, positive
from analytic.sprag.geometry import LogSprag

Complex = NDArray[np.complex128]
Goursat = tuple[Complex, Complex, Complex]  # phi, its derivative, psi
Force = tuple[complex, complex]  # where, and which

DEGREE = 24  # of the polynomials: 4e-4 of a sprag's approach
POINTS = 160  # of each smooth piece of the outline
STEEPEST = np.radians(75)  # from the line AB, where spiral and arc may end


@dataclass(frozen=True, kw_only=True)
class Outline:
    """Force points A and B as x + iy [length], and the outline between them on either side, (m,).

    The body lies to the right of `left` and to the left of `right`, as seen with B above A.
    """

    A: complex
    B: complex
    left: Complex
    right: Complex


def approach(outline: Outline, *, a: tuple[float, float], nu: float, degree: int = DEGREE) -> float:
    """Approach of A and B over P/E' in plane strain, under Hertz patches of half-widths a [length].

    >>> turn = np.exp(1j * np.linspace(-1.5, 1.5, 99))
    >>> disc = Outline(A=-1j, B=1j, left=-turn.conj(), right=turn)
    >>> exact = 2 * (2 * np.log(4 / 0.01) - 1) / np.pi
    >>> abs(approach(disc, a=(0.01, 0.01), nu=0.3) - exact) < 1e-9
    True
    """
    patches = positive(a, "half-width", "m")
    kappa = 3 - 4 * nu
    G = (kappa + 1) / 8  # of a body with E' = 1
    forces = _forces(outline)
    rest = _rest(outline, forces, degree)
    total = 0.0
    for (z, F), other, half in zip(forces, forces[::-1], patches, strict=True):
        there = np.array([z])
        u = sum(_displaced(there, g, kappa)[0] for g in (_flamant(there, other), rest(there)))
        local = 2 / np.pi * (np.log(2 / half) + 0.5) - 1 / (4 * np.pi * G)
        total += local + float((u * np.conj(F)).real) / (2 * G)
    return total


def sprag_outline(sprag: LogSprag, *, b: float, turned: float, alpha_b: float) -> Outline | None:
    """The sprag turned by alpha_b, theta - theta_0 = `turned` [rad]; None where a flank ends it.

    A column b [length] wide about the line through both contacts without load; the pole is 0.
    """
    rho_0, m, eta_0, r_e = (float(x) for x in (sprag.rho_0, sprag.m, sprag.eta_0, sprag.r_e))

    def spiral(theta: Array) -> Complex:
        return np.asarray(-1j * rho_0 * np.exp((m + 1j) * theta - m * eta_0))

    def arc(phi: Array) -> Complex:
        return np.asarray(1j * r_e * np.exp(-1j * phi))

    low, top = complex(spiral(np.array(eta_0))), 1j * r_e
    middle = (top - low) / abs(top - low)
    lean = float(np.angle(-1j * middle))  # anticlockwise
    below = _ends(lambda t: ((spiral(t) - low) / middle).imag, lean, b)
    above = _ends(lambda t: ((arc(t) - low) / middle).imag, -lean, b)
    theta, phi = eta_0 + turned, -alpha_b
    if below is None or above is None or not (
        below[1] < theta < below[0] and above[1] < phi < above[0]
    ):  # fmt: skip
        return None
    share = np.linspace(0, 1, POINTS + 1)[1:]
    right, left = (
        np.concatenate([
            spiral(theta + share * (t - theta)),
            spiral(t) + share * (arc(p) - spiral(t)),
            arc(phi + share * (p - phi))[-2::-1],
        ])
        for t, p in zip(below, above, strict=True)
    )  # fmt: skip
    return Outline(
        A=complex(spiral(np.array(theta))), B=complex(arc(np.array(phi))), left=left, right=right
    )


def _ends(
    leftwards: Callable[[Array], Array], middle: float, b: float
) -> tuple[Array, Array] | None:
    """Angles at which the curve is b/2 right and left of the middle line, or None."""
    low, high = middle - STEEPEST, middle + STEEPEST
    if not leftwards(np.array(high)) < -b / 2 < b / 2 < leftwards(np.array(low)):
        return None
    right, left = (
        np.array(brentq(lambda t, x=x: float(leftwards(np.array(t)) - x), low, high, xtol=1e-14))
        for x in (-b / 2, b / 2)
    )
    return right, left


def _forces(outline: Outline) -> tuple[Force, Force]:
    """Unit forces on the body at A and B."""
    along = (outline.B - outline.A) / abs(outline.B - outline.A)
    return (outline.A, along), (outline.B, -along)


def _flamant(z: Complex, force: Force) -> Goursat:
    """Goursat's functions of one force, cut outside the body."""
    z_0, F = force
    logarithm = np.log((z - z_0) / F)
    slope = np.asarray(-F / (2 * np.pi * (z - z_0)))
    psi = np.conj(F) / (2 * np.pi) * logarithm - np.conj(z_0) * slope
    return np.asarray(-F / (2 * np.pi) * logarithm), slope, np.asarray(psi)


def _displaced(z: Complex, goursat: Goursat, kappa: float) -> Complex:
    """2G (u + iv)."""
    phi, slope, psi = goursat
    return np.asarray(kappa * phi - z * np.conj(slope) - np.conj(psi))


def _rest(
    outline: Outline, forces: tuple[Force, Force], degree: int
) -> Callable[[Complex], Goursat]:
    """Polynomials that free the outline of the forces' tractions."""
    z = np.concatenate([outline.right, outline.left])
    middle, size = (outline.A + outline.B) / 2, abs(outline.B - outline.A) / 2
    k = np.arange(1, degree + 1)

    def powers(z: Complex) -> tuple[Complex, Complex]:
        s = np.asarray((z - middle) / size)[:, None]
        return s**k, k * s ** (k - 1) / size

    given = sum(-_displaced(z, (-phi, slope, psi), 1.0)
                for phi, slope, psi in (_flamant(z, force) for force in forces))  # fmt: skip
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
