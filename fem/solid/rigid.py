"""Test whether supports permit a rigid motion of a body, or of a chain of hinged bodies."""

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components
from skfem.mesh import Mesh3D

from fem.solid.geometry import Array, Indices
from fem.solid.supports import Conditions

MOTIONS = ("x", "y", "z", "about x", "about y", "about z")
FREE = 1e-9  # singular value, relative: a motion that strains no support


def check_rigid_motions(mesh: Mesh3D, conditions: Conditions) -> None:
    """Raise ValueError if the conditions permit a rigid motion of a body.

    A body is a set of cells connected by faces. Bodies that are connected by nodes only have
    equal displacements at these nodes.
    """
    nodes = np.asarray(mesh.dofs.element_dofs)
    count, body = _bodies(mesh)
    of_node = np.zeros(mesh.doflocs.shape[1], int)
    of_node[nodes] = body
    motion = np.array([_motion(mesh, nodes[:, body == k]) for k in range(count)])

    def rows(dofs: Indices, k: Indices) -> Array:
        """Matrix (dofs, bodies x 6) of the unknowns `dofs` in unit rigid motions of the bodies.

        `k` is the index of the body of each unknown.
        """
        out = np.zeros((dofs.size, count, 6))
        out[np.arange(dofs.size), k] = motion[k, dofs // 3, dofs % 3]
        return out.reshape(dofs.size, 6 * count)

    held = [rows(conditions.dofs, of_node[conditions.dofs // 3])]
    for group in conditions.ties:
        moved = rows(group, of_node[group // 3])
        held.append(moved[1:] - moved[0])
    for k in range(count):  # nodes of this body that are assigned to another body
        own = np.unique(nodes[:, body == k])
        own = own[of_node[own] != k]
        dofs = (3 * own[:, None] + np.arange(3)).ravel()
        held.append(rows(dofs, of_node[dofs // 3]) - rows(dofs, np.full(dofs.size, k)))
    joint = np.linalg.qr(np.vstack([*held, np.zeros((6 * count, 6 * count))]))[1]
    _, s, v = np.linalg.svd(joint)
    if s[-1] > FREE * max(1.0, s[0]):
        return
    amplitudes = v[-1].reshape(count, 6)
    worst = int(np.argmax(abs(amplitudes).max(axis=1)))
    how = ", ".join(
        f"{c:+.2g} {name}"
        for c, name in zip(amplitudes[worst], MOTIONS, strict=True)
        if abs(c) > FREE
    )
    raise ValueError(f"body {worst + 1} of {count} can move rigidly ({how}): support this body")


def _motion(mesh: Mesh3D, own: Indices) -> Array:
    """Displacements (nodes, 3, 6) of unit rigid motions about the mean of the nodes `own`."""
    at = mesh.doflocs[:, np.unique(own)]
    x = (mesh.doflocs - at.mean(axis=1)[:, None]) / np.ptp(at, axis=1).max()
    turns = [np.cross(axis, x.T) for axis in np.eye(3)]
    shifts = [np.broadcast_to(axis, x.T.shape) for axis in np.eye(3)]
    return np.stack([*shifts, *turns], axis=2)


def _bodies(mesh: Mesh3D) -> tuple[int, Indices]:
    """Number of bodies, and the index (cells,) of the body of each cell."""
    inner = mesh.f2t[:, mesh.f2t[1] >= 0]
    links = csr_array((np.ones(inner.shape[1]), tuple(inner)), (mesh.nelements, mesh.nelements))
    count, body = connected_components(links, directed=False)
    return int(count), np.asarray(body)
