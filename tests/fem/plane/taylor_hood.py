"""A second solver: plane strain by Taylor-Hood triangles, solved for all unknowns at once.

Displacements are quadratic, pressures linear and continuous; nothing is eliminated or projected,
and assembly, solution and stresses are scikit-fem's and SuperLU's.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import block_array
from skfem import (
    Basis,
    BilinearForm,
    ElementTriP1,
    ElementTriP2,
    ElementVector,
    FacetBasis,
    LinearForm,
    condense,
    solve,
)
from skfem.helpers import ddot, div, dot, sym_grad


@dataclass(frozen=True)
class TaylorHood:
    """Displacements `u` on `basis` and pressures `p` on `pressures`, shear modulus `mu`."""

    basis: Basis
    pressures: Basis
    u: np.ndarray
    p: np.ndarray
    mu: float
    residual: np.ndarray

    @classmethod
    def solved(cls, mesh, material, held, tractions):
        """`held` maps boundaries to components and values, `tractions` boundaries to vectors."""
        lam, mu = material.lame_constants("plane strain")
        basis = Basis(mesh, ElementVector(ElementTriP2()), intorder=4)
        pressures = basis.with_element(ElementTriP1())
        A = BilinearForm(lambda u, v, _: 2 * mu * ddot(sym_grad(u), sym_grad(v))).assemble(basis)
        B = BilinearForm(lambda u, q, _: -div(u) * q).assemble(basis, pressures)
        C = BilinearForm(lambda p, q, _: -p * q / lam).assemble(pressures)
        f = np.zeros(basis.N + pressures.N)
        for name, t in tractions.items():
            side = FacetBasis(mesh, basis.elem, facets=name)
            t = np.reshape(t, (2, 1, 1))
            f[: basis.N] += LinearForm(lambda v, _, t=t: dot(t, v)).assemble(side)
        x, fixed = np.zeros(f.size), []
        for name, values in held.items():
            for component, value in values.items():
                dofs = basis.get_dofs(name).all([f"u^{'xy'.index(component) + 1}"])
                x[dofs] = value
                fixed.append(dofs)
        K = block_array([[A, B.T], [B, C]]).tocsr()
        x = solve(*condense(K, f, x=x, D=np.unique(np.concatenate(fixed))))
        return cls(basis, pressures, *np.split(x, [basis.N]), mu, (K @ x - f)[: basis.N])

    def reaction(self, boundary, component):
        """Force of the supports on `boundary`."""
        dofs = self.basis.get_dofs(boundary).all([f"u^{'xy'.index(component) + 1}"])
        return self.residual[dofs].sum()

    def at(self, points):
        """Displacement (2, m) and stress xx, yy, xy (3, m) at `points` (2, m)."""
        cells = self.basis.mesh.element_finder()(*points)
        X = self.basis.mapping.invF(points[:, :, None], tind=cells)

        def field(basis, values):
            return [
                (basis.elem.gbasis(basis.mapping, X, k, tind=cells)[0], values[dofs[cells], None])
                for k, dofs in enumerate(basis.element_dofs)
            ]

        u = sum(np.asarray(phi) * c for phi, c in field(self.basis, self.u))[..., 0]
        grad = sum(phi.grad * c for phi, c in field(self.basis, self.u))[..., 0]
        p = sum(np.asarray(phi) * c for phi, c in field(self.pressures, self.p))[..., 0]
        shear = self.mu * (grad[0, 1] + grad[1, 0])
        return u, np.array([*(2 * self.mu * grad[i, i] - p for i in (0, 1)), shear])
