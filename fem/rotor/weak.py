"""Rotating shafts as weak forms on a line, to verify the closed-form elements.

In the complex coordinate r = x + i y, with the slope p = dr/dz minus the shear angle,

    Timoshenko   a = int EI p' q' + S (r' - p)(s' - q),   m = int rho A r s + rho I p q,
                 g = int 2 rho I p q,                      quadratic r and p
    Euler        a = int EI r'' s'',  m = int rho A r s,  Rayleigh adds rho I r' s' to m
                 and 2 rho I r' s' to g,                   Hermite's cubics

The equation is K v + w Omega G v - w^2 M v = 0 at the speed Omega. Shear is integrated at two
Gauss points per cell, at which the linear function r' can equal the quadratic function p. With more
points, slender shafts lock.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import eigh
from scipy.sparse import bmat, csr_array
from skfem import (
    Basis,
    BilinearForm,
    ElementLineHermite,
    ElementLineP2,
    MeshLine,
)
from skfem.helpers import dd, dot, grad

from fem.rotor.splitting import Whirl, gyroscopic_splitting

Array = NDArray[np.float64]
THEORIES = ("timoshenko", "rayleigh", "euler")


@BilinearForm
def product(u, v, w):
    return w.c * u * v


@BilinearForm
def slopes(u, v, w):
    return w.c * dot(grad(u), grad(v))


@BilinearForm
def shear_mixed(u, v, w):
    return -w.c * grad(u)[0] * v


@BilinearForm
def curvatures(u, v, w):
    return w.c * dd(u)[0][0] * dd(v)[0][0]


@dataclass(frozen=True)
class WeakShaft:
    """Matrices K, M and G (n, n) of a shaft along a line mesh, and `basis` of its deflection."""

    K: csr_array
    M: csr_array
    G: csr_array
    basis: Basis

    def deflection_at(self, z: float) -> int:
        """Index of the unknown r at the node at `z` [m]. Raises ValueError if there is no node."""
        nodes = np.flatnonzero(np.isclose(self.basis.mesh.p[0], z, rtol=0, atol=1e-12))
        if nodes.size != 1:
            raise ValueError(f"the mesh has no node at z={z:g} m")
        return int(self.basis.nodal_dofs[0, nodes[0]])

    def on_springs(self, springs: Mapping[float, float]) -> "WeakShaft":
        """Shaft on springs to the ground.

        `springs` gives the lateral stiffness [N/m] (value) at each axial position [m] (key).
        """
        K = self.K.tolil(copy=True)
        for z, k in springs.items():
            place = self.deflection_at(z)
            K[place, place] += k
        return replace(self, K=csr_array(K))

    def whirl(self, speed: float, *, held: ArrayLike = (), count: int = 3) -> tuple[Array, Array]:
        """Lowest positive frequencies (count,) [rad/s] of forward and backward whirl at `speed`.

        The deflection is zero at the positions `held` [m]. Raises numpy.linalg.LinAlgError if the
        shaft can move rigidly.
        """
        left, right = _linearised(speed, *self._matrices(held))
        inverse = eigh(right, left, eigvals_only=True)
        return 1 / inverse[::-1][:count], -1 / inverse[:count]

    def splitting(self, speed: float, *, held: ArrayLike = (), count: int = 3) -> Array:
        """Forward minus backward frequency (count,) [rad/s] of the lowest modes at `speed`.

        Small differences have the same relative accuracy as the frequencies. The arguments are
        those of :meth:`whirl`.
        """
        K, M, G = self._matrices(held)
        inverse, x = eigh(*_linearised(speed, K, M, G)[::-1])
        shapes = x[: len(K)]
        ahead = Whirl(1 / inverse[::-1][:count], shapes[:, ::-1][:, :count])
        behind = Whirl(-1 / inverse[:count], shapes[:, :count])
        return gyroscopic_splitting(speed, M, G, ahead, behind)

    def _matrices(self, held: ArrayLike) -> tuple[Array, Array, Array]:
        """Matrices K, M and G of the free unknowns."""
        fixed = [self.deflection_at(float(z)) for z in np.ravel(held)]
        own = np.setdiff1d(np.arange(self.K.shape[0]), fixed)
        K, M, G = (part[own][:, own].toarray() for part in (self.K, self.M, self.G))
        return K, M, G


def _linearised(speed: float, K: Array, M: Array, G: Array) -> tuple[Array, Array]:
    """Matrices A (positive definite) and B of A x = w B x with x = (v, w v)."""
    zero = np.zeros_like(K)
    return np.block([[K, zero], [zero, M]]), np.block([[-speed * G, M], [M, zero]])


def weak_shaft(
    mesh: MeshLine,
    *,
    bending: ArrayLike,
    shear: ArrayLike,
    mass: ArrayLike,
    rotary: ArrayLike,
    theory: str = "timoshenko",
) -> WeakShaft:
    """Shaft with the properties E I, kappa G A, rho A and rho I [SI] along the line `mesh`.

    Each property is a single value, or one value per cell of `mesh`.
    Raises ValueError for an unknown theory, and for values that are not positive.
    """
    if theory not in THEORIES:
        raise ValueError(f"theory must be one of {', '.join(THEORIES)}, got {theory!r}")
    named = {"bending": bending, "shear": shear, "mass": mass, "rotary": rotary}
    cells = {k: np.broadcast_to(np.asarray(v, float), mesh.nelements) for k, v in named.items()}
    for name, values in cells.items():
        if not np.all((values > 0) & np.isfinite(values)):
            raise ValueError(f"{name} must be positive and finite, got {values.min():g}")
    if theory == "timoshenko":
        return _timoshenko(mesh, cells)
    return _euler(mesh, cells, rotary=theory == "rayleigh")


def _timoshenko(mesh: MeshLine, c: dict[str, Array]) -> WeakShaft:
    """Weak form of the Timoshenko shaft; the unknowns are r, then p."""
    full, two = (Basis(mesh, ElementLineP2(), quadrature=_gauss(n)) for n in (3, 2))

    def of(form, basis, name):
        return form.assemble(basis, c=c[name][:, None] + 0 * basis.dx)

    mixed = of(shear_mixed, two, "shear")  # rows q, columns r
    bend = of(slopes, two, "bending") + of(product, two, "shear")
    rotary = of(product, full, "rotary")
    K = bmat([[of(slopes, two, "shear"), mixed.T], [mixed, bend]])
    M = bmat([[of(product, full, "mass"), None], [None, rotary]])
    G = bmat([[0 * rotary, None], [None, 2 * rotary]])
    return WeakShaft(csr_array(K), csr_array(M), csr_array(G), full)


def _euler(mesh: MeshLine, c: dict[str, Array], *, rotary: bool) -> WeakShaft:
    basis = Basis(mesh, ElementLineHermite(), quadrature=_gauss(4))

    def of(form, name):
        return form.assemble(basis, c=c[name][:, None] + 0 * basis.dx)

    turning = of(slopes, "rotary") * float(rotary)
    M = of(product, "mass") + turning
    return WeakShaft(
        csr_array(of(curvatures, "bending")), csr_array(M), csr_array(2 * turning), basis
    )


def _gauss(points: int) -> tuple[Array, Array]:
    """Gauss rule on a cell, exact for polynomials up to the degree 2 `points` - 1."""
    x, w = np.polynomial.legendre.leggauss(points)
    return (x[None] + 1) / 2, w / 2
