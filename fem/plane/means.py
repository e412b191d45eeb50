"""Mean motions of boundaries that deform freely: distributing couplings.

    Mean({"r": 1e-3})        # mean rotation of 1 mrad about the origin
    Mean({"x": 0.0, "y": 0.0})

The mean displacement is int u dA / A; the mean rotation is int (arm x u) dA / int arm^2 dA. The
reactions are uniform tractions, or tractions proportional to the arm.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.linalg import qr
from scipy.sparse import csr_array, hstack
from skfem import Basis

from fem.plane.axis import depth
from fem.plane.discretisation import Array, facet_basis, named_facets
from fem.plane.loads import surface_load

COMPONENTS = "xyr"
INDEPENDENT = 1e-9  # relative to the largest singular value


@dataclass(frozen=True)
class Mean:
    """Prescribed mean motions of a boundary.

    `held` gives prescribed values of x, y [length] and r [rad, about the point `about`], or of some
    of these.
    """

    held: Mapping[str, float]
    about: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        if not self.held or set(self.held) - set(COMPONENTS):
            raise ValueError(
                f"mean motions must be named x, y or r, got {', '.join(self.held) or 'none'}"
            )
        if not np.all(np.isfinite([*self.held.values(), *self.about])):
            raise ValueError(f"mean motions must be finite, got {self}")


def mean_rows(basis: Basis, means: Mapping[str, Mean], *, turn: bool = False) -> csr_array:
    """Matrix C (k, unknowns) that gives the mean motions C u of displacements u.

    The rows are ordered by boundary, then by component.
    """
    rows = [np.zeros((0, basis.N))]
    for name, mean in means.items():
        if turn and set(mean.held) != {"y"}:
            raise ValueError(
                f"mean motion of {name!r}: in a body of revolution, only y can be prescribed"
            )
        side = facet_basis(basis, named_facets(basis.mesh, name))
        x = np.asarray(side.global_coordinates())
        dA = np.asarray(side.dx) * depth(x, turn)
        for component in mean.held:
            tractions = {name: _Motion(component, mean.about, x, dA)}
            rows.append(surface_load(basis, {}, tractions, turn=turn)[None])
    found = csr_array(np.vstack(rows))
    found.eliminate_zeros()
    return found


class _Motion:
    """Traction whose work with the displacements u is the mean motion."""

    def __init__(self, component: str, about: tuple[float, float], x: Array, dA: Array) -> None:
        self.component, self.about = component, np.reshape(about, (2, 1, 1))
        own = self._field(x)
        self.size = float(((own**2).sum(axis=0) * dA).sum())
        if not self.size > 0:
            raise ValueError(
                f"the mean motion {component!r} requires a boundary with a length above zero"
            )

    def __call__(self, x: Array) -> Array:
        return self._field(x) / self.size

    def _field(self, x: Array) -> Array:
        if self.component == "r":
            arm = x - self.about
            return np.array([-arm[1], arm[0]])
        field = np.zeros(x.shape)
        field["xy".index(self.component)] = 1.0
        return field


def held_means(T: csr_array, C: csr_array, surface: int = 0) -> tuple[csr_array, Array]:
    """Matrix of displacements with zero mean motions, and displacements of unit mean motions.

    The columns of the matrix are combinations of columns of `T` (unknowns, n). `C` (k, unknowns)
    gives the means. Each of the displacements of unit mean motions (unknowns, k) changes one mean
    by one and no other mean. The last `surface` columns of `T` are also the last columns of the
    matrix and must not contribute to a mean.
    """
    rows = (C @ T).tocsc()
    touched = np.flatnonzero(np.diff(rows.indptr))
    inner = T.shape[1] - surface
    if np.any(touched >= inner):
        raise ValueError("a boundary with a prescribed mean motion must not be in contact")
    own = rows[:, touched].toarray()
    Q, R, order = qr(own.T, pivoting=True)
    size = np.abs(np.diag(R))
    # relative to the rows without supports
    whole = np.sqrt(np.asarray((C * C).sum(axis=1)).ravel())[order]
    if size.size < len(own) or np.any(size <= INDEPENDENT * whole):
        raise ValueError(
            "a prescribed mean motion must not also be fixed by supports or another mean motion: "
            "remove one of them"
        )
    others = np.setdiff1d(np.arange(inner), touched)
    kept = T[:, touched]
    columns = [T[:, others], csr_array(kept @ Q[:, len(own) :]), T[:, inner:]]
    return hstack(columns).tocsr(), np.asarray(kept @ np.linalg.pinv(own))
