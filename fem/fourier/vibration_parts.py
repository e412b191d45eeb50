"""Inertia and gyroscopic forces of a rotating body of revolution, and motions of its boundaries.

A body rotates about its axis at the speed Omega. With respect to fixed axes, its displacement is
u = (U, -iV, W) exp i(n t - w s), where t is the angle and s the time. Because the particles rotate,
the rate of a particle's displacement is D = -iw + Omega (d/dt + J), where J rotates (u_r,
u_t) into (-u_t, u_r). This gives

    D = -i (w - Omega (n + P)),  P = [[0, 1, 0], [1, 0, 0], [0, 0, 0]] on (U, V, W),
    -D^2 = w^2 - 2 w Omega (n + P) + Omega^2 (n + P)^2.

The first two terms give the mass matrix and the gyroscopic matrix. The third term and the stiffness
due to the centrifugal stress are omitted; these two cancel each other for a rigid rotation.
"""

from collections.abc import Mapping

import numpy as np
from scipy.sparse import coo_array, csr_array
from skfem import Basis

from fem.fourier.harmonic_cells import HarmonicCells
from fem.fourier.loads import turn_of
from fem.plane.axis import has_area
from fem.plane.discretisation import Array, facet_basis, named_cells, named_facets
from fem.plane.geometry import shapes

SWAP = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])


def by_body(basis: Basis, values: float | Mapping[str, float], what: str) -> Array:
    """Value of each cell (cells,), from one value for all cells or one value for each body.

    Raises ValueError for unknown bodies, cells without a value, and values that are not finite.
    """
    mesh = basis.mesh
    if not isinstance(values, Mapping):
        found = np.full(mesh.nelements, float(values))
    else:
        found = np.full(mesh.nelements, np.nan)
        for name, value in values.items():
            found[named_cells(mesh, name)] = value
    if not np.all(np.isfinite(found)):
        bare = np.count_nonzero(~np.isfinite(found))
        raise ValueError(
            f"every cell needs a value, but {bare} of {mesh.nelements} cells have no finite {what}"
        )
    return found


def mass_matrix(
    cells: HarmonicCells, basis: Basis, n: int, density: Array, form: Array
) -> csr_array:
    """Matrix (unknowns, unknowns) of the integral of density u^T `form` u over the body.

    `form` (3, 3) acts on the amplitudes u = (U, V, W). `density` (cells,) is in mass/length^3, or
    is density times a speed.
    """
    N, _ = shapes(basis.elem.elem, basis.X)
    weight = turn_of(n) * density[:, None] * cells.dx
    scalar = np.einsum("aq,bq,mq->mab", N, N, weight, optimize=True)
    m, a, _ = scalar.shape
    local = np.einsum("mab,cd->macbd", scalar, form).reshape(m, 3 * a, 3 * a)
    rows, columns = np.repeat(cells.dofs, 3 * a, axis=1), np.tile(cells.dofs, 3 * a)
    return coo_array(
        (local.ravel(), (rows.ravel(), columns.ravel())), (cells.count, cells.count)
    ).tocsr()  # fmt: skip


def gyroscopic_form(n: int) -> Array:
    """Argument `form` (3, 3) with which `mass_matrix` gives the gyroscopic matrix: 2 (n I + P).

    The argument `density` is then density times speed. P exchanges U and V and has no entry for W.
    """
    return 2 * (n * np.eye(3) + SWAP)


def mean_motion(basis: Basis, boundary: str) -> Array:
    """Vectors (unknowns, 2) whose products with u are the lateral shift and tilt of `boundary`.

    u is a displacement in harmonic 1, with the amplitudes (U, V, W). Shift and tilt are a
    displacement along x and a rotation about y [rad] at the centre of the boundary. Both are from
    the least-squares fit of a rigid motion to u over the area of the boundary. Raises ValueError
    for an unknown boundary, or a boundary on the axis.
    """
    facets = named_facets(basis.mesh, boundary)
    if not has_area(basis.mesh, facets):
        raise ValueError(f"the boundary {boundary!r} has no mean motion, because it is on the axis")
    side = facet_basis(basis, facets)
    r, z = np.asarray(side.global_coordinates())
    area = side.dx * r
    middle = float((z * area).sum() / area.sum())
    # work of tractions (1, -1, 0) and (z, -z, -r), each over its squared length
    across = np.array([np.ones_like(r), -np.ones_like(r), np.zeros_like(r)])
    tilted = np.array([z - middle, middle - z, -r])
    found = np.zeros((basis.N, 2))
    dofs = np.asarray(side.element_dofs)
    for k, motion in enumerate((across, tilted)):
        norm = float(((motion**2).sum(axis=0) * area).sum())
        for j in range(dofs.shape[0]):
            value = np.asarray(side.basis[j][0])  # (3, facets, points)
            np.add.at(found[:, k], dofs[j], ((value * motion).sum(axis=0) * area).sum(axis=1))
        found[:, k] /= norm
    return found
