"""Check that supports and springs together prevent rigid motions of a body of revolution."""

from collections.abc import Sequence

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components
from skfem import Basis

from fem.fourier.supports import FREE, rigid_motions
from fem.plane.discretisation import Array


def check_held_or_sprung(basis: Basis, T: csr_array, n: int, pulls: Sequence[Array]) -> None:
    """Raise ValueError if supports and springs permit a rigid motion of a body in harmonic n.

    u = T q are the displacements that the supports permit. `pulls` are vectors c (free,), one for
    each stiffness of a spring, with the energy (c . q)^2/2.
    """
    motions = _of_bodies(basis, n)
    if not motions.shape[1]:
        return
    norm = np.asarray(T.multiply(T).sum(axis=0)).ravel()
    q = (T.T @ motions) / norm[:, None]
    rows = [motions - T @ q]
    if pulls:
        C = np.array(pulls)
        rows.append((C / np.linalg.norm(C, axis=1)[:, None]) @ q)
    s = np.linalg.svd(np.vstack(rows), compute_uv=False)
    free = int(np.count_nonzero(s < FREE))
    if free:
        raise ValueError(
            f"harmonic {n}: the bodies can still make {free} rigid motions (across the axis or "
            "tilting): prevent these motions by supports or springs"
        )


def _of_bodies(basis: Basis, n: int) -> Array:
    """Orthonormal rigid motions (unknowns, k) of every connected body."""
    whole = rigid_motions(basis, n, False)
    dofs = np.asarray(basis.element_dofs)
    links = csr_array(
        (np.ones(dofs.size), (dofs.ravel(), np.tile(np.arange(dofs.shape[1]), dofs.shape[0]))),
        (basis.N, dofs.shape[1]),
    )
    count, body = connected_components(links.T @ links, directed=False)
    found = [np.zeros((basis.N, 0))]
    for k in range(count):
        own = np.unique(dofs[:, body == k])
        part = np.zeros_like(whole)
        part[own] = np.linalg.qr(whole[own])[0] if whole.shape[1] else whole[own]
        found.append(part)
    return np.hstack(found)
