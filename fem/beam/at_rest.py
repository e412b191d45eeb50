"""Linear displacements of a frame from its unloaded shape, accurate also for thin strips."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.sparse.linalg import LinearOperator, eigsh, splu

CORRECTIONS = 4  # of a linear solution, each of which gains digits


@dataclass(frozen=True)
class AtRest:
    """Solver of small displacements from the unloaded shape, in extended precision.

    `strain`, `stretch` and `tangent` describe the undeformed `elements`; `free` are the unknowns
    that no support fixes. Strains and residuals are computed in extended precision, because the
    strains of a thin strip are differences of nearly equal displacements: in double precision, only
    four digits of the axial force of a spring with L/b = 250 would be correct. The remaining error
    is mainly that of the node coordinates, which are rounded to double precision.
    """

    elements: Any
    strain: Any
    stretch: Any
    tangent: Any
    free: Any

    @cached_property
    def S(self) -> Any:
        return self.elements.increments(self.strain, self.tangent)

    @cached_property
    def K(self) -> Any:
        return self.stiffness(0 * self.strain, self.elements)[self.free][:, self.free]

    @cached_property
    def factor(self) -> Any:
        return splu(self.K.tocsc())

    def stiffness(self, stress: Any, elements: Any) -> Any:
        """Stiffness (n, n) of the `elements` under the section forces `stress` (N, V, M)."""
        return elements.tangent_stiffness(self.S, self.strain, self.tangent, stress)

    def solve(self, load: Any) -> Any:
        """Displacements (n,) under the `load` (n,), in extended precision."""
        e, none = self.elements, 0 * self.strain
        u = np.zeros(self.free.size, np.longdouble)
        for _ in range(CORRECTIONS):
            left = load - e.change_of_forces(
                self.S, self.strain, self.tangent, none, u.reshape(-1, 3)
            )
            u[self.free] += self.factor.solve(left[self.free].astype(float))
        return u

    def strains(self, u: Any) -> Any:
        """Small strains (m, q, 3) from displacements (n,), in extended precision."""
        e = self.elements
        nodes = u.reshape(-1, 3)[e.nodes]
        change = (e.slope @ (nodes - nodes[:, :1]))[..., [0, 1, 2, 2]]
        change[..., 2] = nodes[:, :, 2] @ e.shape.T
        return (self.S @ change[..., None])[..., 0].astype(float)

    def lowest(self, G: Any, push: Any) -> Any:
        """Mode (n,) at the smallest positive load factor for which K + factor x G is singular.

        The iteration begins with the displacements under the load `push` (n,). Round-off errors of
        K limit the accuracy of the mode.
        """
        own, start = G[self.free][:, self.free], self.factor.solve(push[self.free])
        inverse = LinearOperator(own.shape, self.factor.solve)
        _, modes = eigsh(-own, 1, self.K, which="LA", Minv=inverse, v0=start)
        mode = np.zeros(self.free.size, np.longdouble)
        mode[self.free] = modes[:, 0]
        return mode

    def load(self, mode: Any, G: Any) -> float:
        """Load factor of a mode by Rayleigh's quotient, with the elastic energy from strains."""
        e, shape = self.elements, mode.astype(float)
        energy = ((e.moduli * self.strains(mode) ** 2).sum(axis=-1) * e.weight).sum()
        return float(-energy / (shape @ (G @ shape)))
