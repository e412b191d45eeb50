"""Supports of one harmonic: on named boundaries and on the axis; check of rigid motions.

At r = 0, a displacement must not depend on the angle. Therefore n = 0 permits only W at the axis
(antisymmetric: nothing), n = 1 permits U = -V (antisymmetric: U = V), and higher harmonics permit
no displacement.
"""

from collections.abc import Mapping

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components
from skfem import Basis

from fem.plane.axis import on_axis
from fem.plane.discretisation import Array, Indices, named_facets

COMPONENTS = "rtz"
MOTIONS = {
    (0, False): ("along z",),
    (0, True): ("about z",),
    (1, False): ("along x", "about y"),
    (1, True): ("along y", "about x"),
}
FREE = 1e-9  # singular values of held rigid motions over the values of the whole body


def node_dofs(basis: Basis) -> Indices:
    """Unknowns U, V, W (3, nodes) of every node: vertices, edge nodes, cell nodes."""
    blocks = [basis.nodal_dofs, basis.facet_dofs, basis.interior_dofs]
    return np.hstack([np.asarray(b) for b in blocks if b is not None and np.size(b)])


def boundary_dofs(basis: Basis, name: str) -> Indices:
    """Unknowns U, V, W (3, nodes) of the nodes on the boundary `name`."""
    facets = named_facets(basis.mesh, name)
    nodes = [basis.nodal_dofs[:, np.unique(basis.mesh.facets[:, facets])]]
    if basis.facet_dofs is not None and np.size(basis.facet_dofs):
        nodes.append(basis.facet_dofs[:, facets])
    return np.asarray(np.hstack(nodes))


def check_components(supports: Mapping[str, str]) -> None:
    """Raise ValueError unless every support names components out of r, t and z."""
    for name, components in supports.items():
        if not components or set(components) - set(COMPONENTS):
            raise ValueError(f"support {name!r}: components must be r, t or z, got {components!r}")


def free_unknowns(
    basis: Basis, supports: Mapping[str, str], n: int, antisymmetric: bool, place: Indices
) -> csr_array:
    """Matrix T (unknowns, free) of u = T q; q has the order of elimination `place` (unknowns,)."""
    fixed = np.zeros(basis.N, bool)
    for name, components in supports.items():
        dofs = boundary_dofs(basis, name)
        for component in components:
            fixed[dofs[COMPONENTS.index(component)]] = True
    U, V, W = nodes = node_dofs(basis)
    if n == 0:
        fixed[np.concatenate([U, W]) if antisymmetric else V] = True
    axis = on_axis(basis.mesh, basis.doflocs[:, U])
    linked = np.zeros(0, int)
    if n == 1:
        fixed[W[axis]] = True
        fixed[U[axis]] = fixed[V[axis]] = fixed[U[axis]] | fixed[V[axis]]
        linked = np.flatnonzero(axis & ~fixed[V])
    else:
        fixed[(nodes[:2] if n == 0 else nodes)[:, axis]] = True
    follows = np.arange(basis.N)
    follows[V[linked]] = U[linked]
    factor = np.ones(basis.N)
    factor[V[linked]] = 1.0 if antisymmetric else -1.0
    own = np.flatnonzero(~fixed & (follows == np.arange(basis.N)))
    column = np.full(basis.N, -1)
    column[own[np.argsort(place[own])]] = np.arange(own.size)
    rows = np.flatnonzero(~fixed)
    return csr_array((factor[rows], (rows, column[follows[rows]])), (basis.N, own.size))


def rigid_motions(basis: Basis, n: int, antisymmetric: bool) -> Array:
    """Amplitudes (unknowns, k) of the k rigid motions in harmonic n; k = 0 for n >= 2.

    n = 0: a shift along z, or (antisymmetric) the rotation V = r about z. n = 1: a shift along x
    and the rotation (z, 0, -x) about y; antisymmetric: a shift along y and the rotation (0, -z,
    y) about x.
    """
    U, V, W = node_dofs(basis)
    r, z = basis.doflocs[:, U]
    motions = np.zeros((basis.N, 0 if n > 1 else n + 1))
    sign = 1.0 if antisymmetric else -1.0
    if n == 0 and antisymmetric:
        motions[V, 0] = r
    elif n == 0:
        motions[W, 0] = 1.0
    elif n == 1:
        motions[U, 0], motions[V, 0] = 1.0, sign
        motions[U, 1], motions[V, 1], motions[W, 1] = -sign * z, -z, sign * r
    return motions


def check_held(basis: Basis, T: csr_array, n: int, antisymmetric: bool) -> None:
    """Raise ValueError if a body can move rigidly in harmonic `n`."""
    motions = rigid_motions(basis, n, antisymmetric)
    if not motions.shape[1]:
        return
    dofs = np.asarray(basis.element_dofs)
    links = csr_array(
        (np.ones(dofs.size), (dofs.ravel(), np.tile(np.arange(dofs.shape[1]), dofs.shape[0]))),
        (basis.N, dofs.shape[1]),
    )
    count, body = connected_components(links.T @ links, directed=False)
    for k in range(count):
        own = np.unique(dofs[:, body == k])
        whole = np.zeros_like(motions)
        whole[own], R = np.linalg.qr(motions[own])
        norm = np.sqrt(np.asarray(T.multiply(T).sum(axis=0)).ravel())
        kept = T @ ((T.T @ whole) / norm[:, None] ** 2)
        _, s, v = np.linalg.svd((whole - kept)[own], full_matrices=False)
        if s.min() < FREE:
            shares = abs(np.linalg.solve(R, v[-1]) * np.linalg.norm(motions[own], axis=0))
            how = " and ".join(
                word
                for word, share in zip(MOTIONS[n, antisymmetric], shares, strict=True)
                if share > FREE * shares.max()
            )
            raise ValueError(
                f"harmonic {n}: body {k + 1} of {count} can move rigidly {how}: "
                "support this body against this motion"
            )
