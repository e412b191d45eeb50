"""Bodies condensed to their contact surfaces: a dense stiffness from a single factorisation.

The unknowns of the surface are eliminated last; therefore, the last block of the factors gives the
Schur complement S = K_ss - K_si K_ii^-1 K_is. For bodies supported by contact only, S is singular,
but K_ii is regular: K is factorised with springs M on the surface, which are then subtracted from S
exactly.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, diags_array

from fem.cholesky import Cholesky
from fem.plane.discretisation import Array


@dataclass(frozen=True)
class Condensed:
    """Stiffness `S` (s, s) of the last s unknowns, and the factors that give all unknowns."""

    factor: Cholesky
    S: Array
    springs: Array

    @property
    def surface(self) -> slice:
        return slice(self.factor.n - self.springs.size, None)

    def load(self, f: Array) -> Array:
        """Forces (s,) on the surface that are equivalent to `f` (unknowns,) on all unknowns."""
        at_rest = self.factor.solve(f)[self.surface]
        return self.S @ at_rest + self.springs * at_rest

    def inside(self, f: Array, on_surface: Array, surface: Array) -> Array:
        """All unknowns under the forces `f` (unknowns,) and surface displacements `surface` (s,).

        `on_surface` (s,) is the result of `load` for `f`.
        """
        f = f.copy()
        # with these forces on the sprung surface the factorised matrix moves it to `surface`
        f[self.surface] += self.S @ surface + self.springs * surface - on_surface
        return self.factor.solve(f)


def condense(K: csr_array, count: int) -> Condensed:
    """Condense `K` (unknowns, unknowns) to its last `count` unknowns.

    The unknowns of `K` must be in order of elimination.
    """
    n = K.shape[0]
    springs = K.diagonal()[n - count :].copy()
    none = springs <= 0
    springs[none] = springs.max(initial=0.0) or 1.0
    if np.any(none):
        K = K + diags_array(np.concatenate([np.zeros(n - count), springs]))
    else:
        K.setdiag(K.diagonal() + np.concatenate([np.zeros(n - count), springs]))
    factor = Cholesky(K)
    block = factor.last_block(count)
    S = block @ block.T
    S[np.diag_indices(count)] -= springs
    return Condensed(factor, S, springs)
