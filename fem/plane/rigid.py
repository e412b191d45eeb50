"""Test whether supports permit a rigid motion of a body, or of a chain of hinged bodies."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lu
from scipy.sparse import csr_array, diags_array, vstack
from scipy.sparse.csgraph import connected_components
from skfem import Basis
from skfem.mesh import Mesh2D

from fem.plane.discretisation import Array, Indices
from fem.plane.supports import Conditions, node_dofs
from fem.plane.ties import Tied

MOTIONS = ("x", "y", "rotation")


@dataclass(frozen=True)
class Motions:
    """Rigid motions of bodies that the conditions of a problem do not prevent.

    `fields` (unknowns, k) are the displacements of the motions; `words` describe the body that
    moves most, and its motion.
    """

    fields: Array
    words: tuple[str, ...]


def check_rigid_motions(
    basis: Basis, conditions: Conditions, tied: Tied, means: csr_array, *, turn: bool = False
) -> None:
    """Raise ValueError if the conditions permit a rigid motion of a body."""
    if words := free_motions(basis, conditions, tied, means, turn=turn).words:
        raise ValueError(f"{words[-1]}: support this body against this motion")


def free_motions(
    basis: Basis, conditions: Conditions, tied: Tied, means: csr_array, *, turn: bool = False
) -> Motions:
    """Rigid motions that the conditions permit to a body, or to a chain of hinged bodies.

    A body is a set of cells connected by edges; bodies with only a common vertex are hinged there.
    Ties and the rows `means` (k, unknowns) are also conditions. With `turn`, the bodies are bodies
    of revolution, and the only rigid motion is along the axis y.
    """
    kinds = [1] if turn else [0, 1, 2]
    n = len(kinds)
    count, body, hinges = _bodies(basis)
    centre = np.zeros((2, count))
    size = np.zeros(count)
    for k in range(count):
        at = basis.mesh.p[:, np.unique(basis.mesh.t[:, body == k])]
        centre[:, k], size[k] = at.mean(axis=1), np.ptp(at, axis=1).max()

    def motion(x: Array, k: Indices) -> Array:
        """Displacements (m, 2, n) at `x` (2, m) for unit motions of the bodies `k` (m,)."""
        u, v = (x - centre[:, k]) / size[k]
        one, zero = np.ones_like(u), np.zeros_like(u)
        return np.array([[one, zero, -v], [zero, one, u]]).transpose(2, 0, 1)[..., kinds]

    of_dof = np.zeros(basis.N, int)
    of_dof[np.asarray(basis.element_dofs)] = body
    k = of_dof[conditions.dofs[0]]
    held = np.einsum(
        "im,mij->mj", conditions.direction, motion(basis.doflocs[:, conditions.dofs[0]], k)
    )
    blocks = []
    for j in range(count):  # n rows are equivalent to all rows of one body
        rows = np.zeros((n, n * count))
        rows[:, n * j : n * j + n] = np.linalg.qr(np.vstack([held[k == j], np.zeros((n, n))]))[1]
        blocks.append(rows)
    for vertex, first, second in hinges:
        rows = np.zeros((2, n * count))
        at = basis.mesh.p[:, [vertex]]
        rows[:, n * first : n * first + n] = motion(at, np.array([first]))[0]
        rows[:, n * second : n * second + n] = -motion(at, np.array([second]))[0]
        blocks.append(rows)
    nodes = node_dofs(basis)
    of_node = of_dof[nodes[0]]
    # a row's size must not depend on the unit of length
    size_of = np.abs(means).sum(axis=1)
    also = vstack([tied.rows, diags_array(1 / size_of) @ means]).tocsr()
    if also.shape[0]:
        shapes = motion(tied.x[:, nodes[0]], of_node)
        blocks.append(_compressed(also, nodes, of_node, shapes, count))
    _, s, v = np.linalg.svd(np.vstack(blocks), full_matrices=False)
    # a basis with as many zeros as possible: single motions of single bodies, if they exist
    free = lu(v[s < 1e-9].T, permute_l=True)[0].T.reshape(-1, count, n)
    if not len(free):
        return Motions(np.zeros((basis.N, 0)), ())
    shapes = motion(tied.x[:, nodes[0]], of_node)
    fields = np.zeros((basis.N, len(free)))
    for i, amplitudes in enumerate(free):
        fields[nodes, i] = np.einsum("mij,mj->im", shapes, amplitudes[of_node])
    names = [_name(basis.mesh, body == k) for k in range(count)]
    return Motions(fields, tuple(_words(amplitudes, kinds, names) for amplitudes in free))


def _compressed(
    rows: csr_array, nodes: Indices, of_node: Indices, shapes: Array, count: int
) -> Array:
    """Conditions `rows` (k, unknowns) as a matrix (n count, n count) for n motions of each body."""
    n = shapes.shape[2]
    all_motions = np.zeros((rows.shape[1], count, n))
    for i in (0, 1):
        all_motions[nodes[i], of_node] = shapes[:, i]
    constrained = rows @ all_motions.reshape(rows.shape[1], -1)
    return np.linalg.qr(np.vstack([constrained, np.zeros((n * count, n * count))]))[1]


def _name(mesh: Mesh2D, own: NDArray[np.bool_]) -> str:
    """First name, in brackets, whose cells are all in one body (mask `own`); empty if none."""
    for name, cells in (mesh.subdomains or {}).items():
        if np.all(own[cells]):
            return f" ({name!r})"
    return ""


def _words(amplitudes: Array, kinds: list[int], names: list[str]) -> str:
    """Description of the body that moves most, and of its motion.

    `amplitudes` (bodies, kinds) are the amplitudes of the `kinds` of motion.
    """
    worst = int(np.argmax(np.abs(amplitudes).max(axis=1)))
    how = ", ".join(
        f"{c:+.2g} {MOTIONS[kind]}"
        for c, kind in zip(amplitudes[worst], kinds, strict=True)
        if abs(c) > 1e-9
    )
    return f"body {worst + 1} of {len(amplitudes)}{names[worst]} can move rigidly ({how})"


def _bodies(basis: Basis) -> tuple[int, Indices, list[tuple[int, int, int]]]:
    """Number of bodies, body of every cell, and hinges (vertex, body, body)."""
    mesh = basis.mesh
    inner = mesh.f2t[:, mesh.f2t[1] >= 0]
    links = csr_array((np.ones(inner.shape[1]), tuple(inner)), (mesh.nelements, mesh.nelements))
    count, body = connected_components(links, directed=False)
    hinges = []
    if count > 1:
        pairs = np.unique(np.vstack([mesh.t.ravel(), np.tile(body, mesh.t.shape[0])]), axis=1)
        for vertex in np.flatnonzero(np.bincount(pairs[0]) > 1):
            first, *others = pairs[1, pairs[0] == vertex].tolist()
            hinges += [(int(vertex), first, other) for other in others]
    return count, body, hinges
