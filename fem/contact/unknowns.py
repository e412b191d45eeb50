"""Free unknowns of elastic bodies, rigid bodies and obstacles, in order of elimination.

Displacements are u = T q + L b with free unknowns q and prescribed values b. A rigid body has up to
three unknowns; an obstacle has one for each free motion. Unknowns of contact surfaces are last.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import block_diag, csr_array, hstack, vstack
from skfem import Basis

from fem.contact.pairs import MOTIONS, Obstacle
from fem.plane.discretisation import Array, Indices
from fem.plane.means import held_means
from fem.plane.ordering import nested_dissection
from fem.plane.supports import Conditions
from fem.plane.ties import Tied

INDEPENDENT = 1e-9
CONTRADICTION = 1e-9


@dataclass(frozen=True)
class Unknowns:
    """Maps from free unknowns and prescribed values to displacements.

    Columns of `T` (all, n) are orthonormal, except those of obstacles. "all" are the unknowns of
    the mesh, then three for each obstacle. The last `surface` of the n free unknowns belong to
    contact surfaces, rigid bodies and obstacles. `L` (all, m) maps m prescribed values to
    displacements: values of conditions, motions of obstacles, mean motions. `rows` (conditions,
    all) evaluate the conditions.
    """

    T: csr_array
    surface: int
    L: csr_array
    rows: csr_array

    def displaced(self, values: Array) -> Array:
        """Displacements L b for the prescribed `values` b.

        Raises ValueError if the supports of a node or of a rigid body contradict each other.
        """
        u = np.asarray(self.L @ values)
        given = values[: self.rows.shape[0]]
        missed = np.abs(self.rows @ u - given)
        if np.any(missed > CONTRADICTION * np.abs(given).max(initial=0)):
            raise ValueError(
                "the supports contradict each other at a node or on a rigid body: "
                f"a prescribed value of {given[np.argmax(missed)]:g} is missed by "
                f"{missed.max():.3g}"
            )
        return u


def unknowns(
    basis: Basis,
    conditions: Conditions,
    *,
    surface: Indices,
    rigid: Sequence[Indices],
    obstacles: Sequence[Obstacle],
    tied: Tied,
    means: csr_array,
    turn: bool,
) -> Unknowns:
    """Unknowns of `basis`; `surface` are the unknowns on contact surfaces.

    `rigid` lists the unknowns of each rigid body, in pairs x, y. The rows `means` (k, mesh
    unknowns) define the prescribed mean motions. With `turn`, bodies can only move along the axis
    y.
    """
    place = nested_dissection(basis)
    place[surface] += 2 * basis.N
    place = tied.ordered(place)
    stiff = np.zeros(basis.N, bool)
    stiff[np.concatenate([np.zeros(0, int), *rigid])] = True
    elastic = ~stiff[conditions.dofs[0]]
    still = replace(
        conditions, dofs=conditions.dofs[:, elastic], direction=conditions.direction[:, elastic],
        value=np.zeros(int(elastic.sum())), owner=conditions.owner[elastic],
    )  # fmt: skip
    if np.any(stiff[tied.follower]) or np.any(stiff[tied.leader]):
        raise ValueError("ties need elastic bodies, but a rigid body is tied: make it elastic")
    T, _ = tied.free_directions(basis, still, place)
    T = T[:, abs(T.T) @ stiff.astype(float) == 0]
    on_surface = np.zeros(basis.N)
    on_surface[surface] = 1
    count = int(np.count_nonzero(abs(T.T) @ on_surface))
    led = tied.led(still) if tied.angle.size else still
    L = _least_norm(led, np.flatnonzero(elastic), conditions.owner.size, basis.N)
    L, lift = tied.P @ L, np.zeros((basis.N, 0))
    if means.shape[0]:
        T, lift = held_means(T, means, count)
        L = L - csr_array(lift @ (means @ L))
    columns = [T]
    for dofs in rigid:
        own = np.flatnonzero(np.isin(conditions.dofs[0], dofs))
        shapes, driven = _rigid(basis, conditions, dofs, own, turn)
        columns.append(_scattered(shapes, dofs, np.arange(shapes.shape[1]), basis.N))
        L = L + _scattered(driven, dofs, own, basis.N, conditions.owner.size)
        count += shapes.shape[1]
    free, fixed = _moving(obstacles, float(np.ptp(basis.mesh.p, axis=1).max()))
    n = conditions.owner.size
    at = np.tile(np.arange(n), 2), conditions.dofs.ravel()
    rows = csr_array((conditions.direction.ravel(), at), (n, basis.N + 3 * len(obstacles)))
    none = csr_array((fixed.shape[0], lift.shape[1]))
    moved = hstack([block_diag([L, fixed]), vstack([csr_array(lift), none])])
    return Unknowns(
        block_diag([hstack(columns), free]).tocsr(), count + free.shape[1], moved.tocsr(), rows
    )


def _least_norm(conditions: Conditions, index: Indices, of: int, count: int) -> csr_array:
    """Displacements (count, of) of least norm for unit values of `conditions`.

    `index` (m,) gives the numbers of these conditions among all `of` conditions.
    """
    number, dofs, direction = conditions.by_node()
    inverse = np.linalg.pinv(direction, rcond=INDEPENDENT).swapaxes(1, 2)
    node, rank = np.nonzero(number >= 0)
    at = dofs[:, node].T.ravel(), np.repeat(index[number[node, rank]], 2)
    return csr_array((inverse[node, rank].ravel(), at), (count, of))


def _rigid(
    basis: Basis, conditions: Conditions, dofs: Indices, own: Indices, turn: bool
) -> tuple[Array, Array]:
    """Orthonormal free motions (dofs, k) of a rigid body, and the motions prescribed by supports.

    The columns of the second result (dofs, conditions) belong to the values of the conditions.
    """
    x, y = basis.doflocs[:, dofs[::2]]
    x, y = x - x.mean(), y - y.mean()
    size = max(float(np.ptp(x)), float(np.ptp(y)))
    shapes = np.zeros((dofs.size, 3))
    shapes[::2, 0] = shapes[1::2, 1] = 1
    shapes[::2, 2], shapes[1::2, 2] = -y / size, x / size
    if turn:
        shapes = shapes[:, 1:2]
    row = np.full(basis.N, -1)
    row[dofs] = np.arange(dofs.size)
    d, at = conditions.direction[:, own], row[conditions.dofs[:, own]]
    held = d[0, :, None] * shapes[at[0]] + d[1, :, None] * shapes[at[1]]
    _, s, v = np.linalg.svd(np.vstack([held, np.zeros((shapes.shape[1], shapes.shape[1]))]))
    free, _ = np.linalg.qr(shapes @ v[s < INDEPENDENT * max(s[0], 1.0)].T)
    return free, shapes @ np.linalg.pinv(held, rcond=INDEPENDENT)


def _moving(obstacles: Sequence[Obstacle], extent: float) -> tuple[csr_array, csr_array]:
    """Free motions (3 obstacles, k) and prescribed motions of obstacles.

    Free rotations are scaled to a unit displacement at the distance `extent`.
    """
    free = [3 * i + MOTIONS.index(c) for i, o in enumerate(obstacles) for c in o.free]
    count = 3 * len(obstacles)
    scale = [1 / extent if k % 3 == 2 else 1.0 for k in free]
    fixed = np.setdiff1d(np.arange(count), free)
    return (
        csr_array((scale, (free, np.arange(len(free)))), (count, len(free))),
        csr_array((np.ones(fixed.size), (fixed, fixed)), (count, count)),
    )


def _scattered(
    block: Array, rows: Indices, columns: Indices, count: int, width: int | None = None
) -> csr_array:
    at = np.repeat(rows, columns.size), np.tile(columns, rows.size)
    return csr_array((block.ravel(), at), (count, columns.size if width is None else width))
