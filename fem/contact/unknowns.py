"""Free unknowns of elastic bodies, rigid bodies and rigid obstacles, in order of elimination.

Displacements are u = T q + u_0. Rigid bodies keep up to three unknowns, obstacles those that are
free. Unknowns of the contact surfaces come last.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csr_array, hstack, vstack
from skfem import Basis

from fem.contact.shapes import Circle, Flat
from fem.plane.discretisation import Array, Indices
from fem.plane.ordering import nested_dissection
from fem.plane.supports import Conditions, free_directions

MOTIONS = "xyr"


@dataclass(frozen=True)
class Rigid:
    """The material of a body that does not deform."""


@dataclass(frozen=True)
class Obstacle:
    """A rigid surface without a mesh.

    `free` names the motions that loads decide, of x, y and r (rotation about the shape's point or
    centre, in radians); the others are prescribed.
    """

    shape: Flat | Circle
    free: str = ""

    def __post_init__(self) -> None:
        if set(self.free) - set(MOTIONS):
            raise ValueError(f"an obstacle's free motions are of x, y and r, got {self.free!r}")

    @property
    def centre(self) -> tuple[float, float]:
        """The point that it turns about."""
        return self.shape.centre if isinstance(self.shape, Circle) else self.shape.point


@dataclass(frozen=True)
class Unknowns:
    """Columns of `T` (all, n) are orthonormal, but for those of obstacles.

    All are the unknowns of the mesh, then three for each obstacle. The last `surface` of the n
    free ones are those of contact surfaces, rigid bodies and obstacles.
    """

    T: csr_array
    surface: int


def unknowns(
    basis: Basis,
    conditions: Conditions,
    *,
    surface: Indices,
    rigid: Sequence[Indices],
    obstacles: Sequence[Obstacle],
    turn: bool,
) -> Unknowns:
    """Unknowns of `basis` where `surface` are those on contact surfaces.

    `rigid` lists the unknowns of each rigid body, in pairs x, y.
    """
    stiff = np.concatenate([np.zeros(0, int), *rigid])
    place = nested_dissection(basis)
    place[surface] += basis.N
    elastic = without(conditions, stiff)
    fixed = csr_array(([1.0] * stiff.size, (stiff, stiff)), (basis.N, basis.N))
    T, _ = free_directions(basis, elastic, place)
    keep = np.setdiff1d(np.arange(T.shape[1]), (fixed @ T).tocoo().coords[1])
    T = T[:, keep]
    chosen = np.zeros(basis.N)
    chosen[surface] = 1
    count = int(np.count_nonzero(abs(T.T) @ chosen))
    blocks, columns = [T], []
    for dofs in rigid:
        shapes, _ = rigid_motion(basis, conditions, dofs, turn)
        columns.append(shapes)
        at = np.repeat(dofs, shapes.shape[1]), np.tile(np.arange(shapes.shape[1]), dofs.size)
        blocks.append(csr_array((shapes.ravel(), at), (basis.N, shapes.shape[1])))
    T = hstack(blocks).tocsr()
    extent = float(np.ptp(basis.mesh.p, axis=1).max())
    free = [(3 * i + MOTIONS.index(c)) for i, o in enumerate(obstacles) for c in o.free]
    scale = [1 / extent if k % 3 == 2 else 1.0 for k in free]
    moving = csr_array((scale, (free, np.arange(len(free)))), (3 * len(obstacles), len(free)))
    width = T.shape[1]
    T = vstack([
        hstack([T, csr_array((basis.N, len(free)))]),
        hstack([csr_array((3 * len(obstacles), width)), moving]),
    ]).tocsr()  # fmt: skip
    count += sum(c.shape[1] for c in columns) + len(free)
    return Unknowns(T, count)


def prescribed(
    basis: Basis,
    conditions: Conditions,
    rigid: Sequence[Indices],
    obstacles: Mapping[str, Obstacle],
    motions: Mapping[str, Mapping[str, float]],
    turn: bool,
) -> Array:
    """The prescribed part u_0 (all,) of the displacements; `motions` are those of obstacles."""
    stiff = np.concatenate([np.zeros(0, int), *rigid])
    place = np.arange(basis.N)
    _, u_0 = free_directions(basis, without(conditions, stiff), place)
    for dofs in rigid:
        u_0[dofs] = rigid_motion(basis, conditions, dofs, turn)[1]
    moved = np.zeros((len(obstacles), 3))
    for i, (name, obstacle) in enumerate(obstacles.items()):
        for c, value in motions.get(name, {}).items():
            if c in obstacle.free or c not in MOTIONS:
                fixed = [m for m in MOTIONS if m not in obstacle.free]
                raise ValueError(
                    f"obstacle {name!r}: motions that can be prescribed are {fixed}, got {c!r}"
                )
            moved[i, MOTIONS.index(c)] = value
    return np.concatenate([u_0, moved.ravel()])


def rigid_motion(
    basis: Basis, conditions: Conditions, dofs: Indices, turn: bool
) -> tuple[Array, Array]:
    """Orthonormal motions (unknowns, k) that supports leave a rigid body, and those prescribed."""
    x, y = basis.doflocs[:, dofs[::2]]
    x, y = x - x.mean(), y - y.mean()
    size = max(float(np.ptp(x)), float(np.ptp(y)))
    shapes = np.zeros((dofs.size, 3))
    shapes[::2, 0] = shapes[1::2, 1] = 1
    shapes[::2, 2], shapes[1::2, 2] = -y / size, x / size
    if turn:
        shapes = shapes[:, 1:2]  # around the axis a body can only move along it
    own = np.isin(conditions.dofs[0], dofs)
    row = np.full(basis.N, -1)
    row[dofs] = np.arange(dofs.size)
    d, value = conditions.direction[:, own], conditions.value[own]
    at = row[conditions.dofs[:, own]]
    held = d[0, :, None] * shapes[at[0]] + d[1, :, None] * shapes[at[1]]
    amplitudes = (
        np.linalg.lstsq(held, value, rcond=1e-9)[0] if value.size else np.zeros(shapes.shape[1])
    )
    if value.size and not np.allclose(held @ amplitudes, value, atol=1e-9 * np.abs(value).max()):
        raise ValueError("the supports of a rigid body prescribe a deformation of it")
    _, s, v = np.linalg.svd(np.vstack([held, np.zeros((3, shapes.shape[1]))]))
    free = shapes @ v[s < 1e-9 * max(s[0], 1.0)].T
    return np.linalg.qr(free)[0], shapes @ amplitudes


def without(conditions: Conditions, dofs: Indices) -> Conditions:
    """The conditions that do not belong to `dofs`."""
    keep = ~np.isin(conditions.dofs[0], dofs)
    return replace(
        conditions, dofs=conditions.dofs[:, keep], direction=conditions.direction[:, keep],
        value=conditions.value[keep], owner=conditions.owner[keep],
    )  # fmt: skip
