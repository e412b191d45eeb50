"""Sections of cyclic sectors and periodic cells: nodes of a boundary follow another boundary.

    Tie(leader="ring.left", follower="ring.right", angle=-2 * pi / 8)

The condition is u(follower) = R u(leader). The same rotation R, about a point, and a shift move the
nodes of the leader to the nodes of the follower. Displacements are u = P w, where w are the
displacements of the nodes that do not follow. A node that follows itself with a rotation is fixed.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.spatial import cKDTree
from skfem import Basis

from fem.plane.discretisation import Array, Indices, named_facets
from fem.plane.guides import turned
from fem.plane.moves import Move
from fem.plane.supports import Conditions, free_directions, node_dofs, nodes_on

MATCH = 1e-6  # relative to the mesh's extent: largest distance of nodes from their partners
SAME = 1e-9  # rotations [rad] that differ by less are one
Follows = dict[int, tuple[int, Move]]  # by the unknowns x of nodes: whom, and the move from there


@dataclass(frozen=True, kw_only=True)
class Tie:
    """The boundary `follower` is `leader`, rotated by `angle` [rad] about a point and then shifted.

    By default, rotation and shift [length] are zero: two boundaries at the same place are bonded.
    """

    leader: str
    follower: str
    angle: float = 0.0
    about: tuple[float, float] = (0.0, 0.0)
    shift: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        if not np.all(np.isfinite([self.angle, *self.about, *self.shift])):
            raise ValueError(f"tie {self}: angle, about and shift must be finite")
        if self.leader == self.follower and not self.angle and not any(self.shift):
            raise ValueError(f"tie {self}: leader and follower must be different boundaries")

    def __str__(self) -> str:
        return f"{self.follower!r} to {self.leader!r}"

    @property
    def move(self) -> Move:
        """Rigid motion that moves the leader nodes to their follower nodes."""
        return Move.about(complex(*self.about), self.angle, complex(*self.shift))


@dataclass(frozen=True)
class Tied:
    """Nodes that follow other nodes: unknowns u_x, u_y of followers (2, m) and leaders (2, m).

    `angle` (m,) [rad] is the rotation from a leader to its follower. No leader follows another
    node; `still` (2, k) are fixed nodes. `x` (2, unknowns) are the positions of nodes; positions of
    followers are computed exactly from their leaders.
    """

    follower: Indices
    leader: Indices
    angle: Array
    still: Indices
    x: Array

    @property
    def count(self) -> int:
        """Number of unknowns of the mesh."""
        return self.x.shape[1]

    @cached_property
    def P(self) -> csr_array:
        """Matrix (unknowns, unknowns) that gives displacements of all nodes from the leaders."""
        leads = np.ones(self.count)
        leads[self.follower] = 0.0
        c, s = np.cos(self.angle), np.sin(self.angle)
        (x, y), (u, v) = self.follower, self.leader
        turned = csr_array(
            (
                np.concatenate([c, -s, s, c]),
                (np.concatenate([x, x, y, y]), np.concatenate([u, v, u, v])),
            ),
            (self.count, self.count),
        )
        turned.eliminate_zeros()
        return (diags_array(leads) + turned).tocsr()

    @cached_property
    def rows(self) -> csr_array:
        """Rows (k, unknowns) whose product with u is zero if followers follow their leaders."""
        if not self.angle.size:
            return csr_array((0, self.count))
        apart = (diags_array(np.ones(self.count)) - self.P).tocsr()
        return apart[self.follower.ravel()]

    def led_by(self, nodes: Indices) -> tuple[Indices, Array]:
        """Leaders (2, m) of `nodes` (2, m), and the angles (m,) by which the nodes are rotated.

        If a node follows no other node, its leader is the node itself.
        """
        place = np.full(self.count, -1)
        place[self.follower[0]] = np.arange(self.angle.size)
        of = place[nodes[0]]
        own = np.flatnonzero(of >= 0)
        leader, angle = nodes.copy(), np.zeros(nodes.shape[1])
        leader[:, own], angle[own] = self.leader[:, of[own]], self.angle[of[own]]
        return leader, angle

    def led(self, conditions: Conditions) -> Conditions:
        """Conditions with unknowns of followers replaced by unknowns of their leaders."""
        dofs, angle = self.led_by(conditions.dofs)
        return replace(conditions, dofs=dofs, direction=turned(conditions.direction, -angle))

    def free_directions(
        self, basis: Basis, conditions: Conditions, place: Indices
    ) -> tuple[csr_array, Array]:
        """T and u0 of `fem.plane.supports.free_directions`; followers move with their leaders."""
        if not self.angle.size:
            return free_directions(basis, conditions, place)
        T, u0 = free_directions(basis, self.led(conditions), place, self.follower.ravel())
        T = (self.P @ T).tocsr()
        size = np.sqrt(np.asarray((T * T).sum(axis=0)).ravel())
        return (T @ diags_array(1 / size)).tocsr(), self.P @ u0

    def forces(self, conditions: Conditions, reaction: Array) -> Array:
        """Forces (m,) in the directions of the conditions; their sum is `reaction` (unknowns,).

        The force of a support of a follower also appears at its leader.
        """
        return self.led(conditions).forces(self.P.T @ reaction)

    def ordered(self, place: Indices) -> Indices:
        """Position (unknowns,) of every unknown in the order of elimination; leaders are last."""
        place = place.copy()
        np.maximum.at(place, self.leader, place[self.follower])
        place[self.leader] += self.count
        return place


def tied(basis: Basis, ties: Sequence[Tie], *, turn: bool = False) -> Tied:
    """Followers and leaders of all ties. Raises ValueError if the nodes of a tie do not match.

    With `turn`, x is a radius, and ties can only shift along the axis.
    """
    y_of = np.zeros(basis.N, int)
    nodes = node_dofs(basis)
    y_of[nodes[0]] = nodes[1]
    follows: Follows = {}
    at_rest: set[int] = set()
    for tie in ties:
        if turn and (math.remainder(tie.angle, 2 * math.pi) or tie.shift[0]):
            raise ValueError(
                f"tie {tie}: in a body of revolution, followers can only be shifted along y"
            )
        for a, b in zip(*_partners(basis, tie), strict=True):
            (a_root, to_a), (b_root, to_b) = _root(follows, a), _root(follows, b)
            between = to_b.back.after(tie.move.after(to_a))
            if a_root != b_root:
                follows[b_root] = a_root, between
            elif abs(math.remainder(between.angle, 2 * math.pi)) > SAME:
                at_rest.add(a_root)
    follower = np.array(sorted(follows), dtype=int)
    ends = [_root(follows, f) for f in follower.tolist()]
    leader = np.array([root for root, _ in ends], dtype=int)
    still = np.array(sorted({_root(follows, n)[0] for n in at_rest}), dtype=int)
    x = basis.doflocs.copy()
    at = np.array([move.of(complex(*x[:, root])) for root, move in ends], dtype=complex)
    x[:, follower] = x[:, y_of[follower]] = np.array([at.real, at.imag])
    return Tied(
        np.array([follower, y_of[follower]]), np.array([leader, y_of[leader]]),
        np.array([move.angle for _, move in ends], dtype=float), np.array([still, y_of[still]]), x,
    )  # fmt: skip


def _root(follows: Follows, node: int) -> tuple[int, Move]:
    """Last leader in the chain of leaders of `node`, and the motion from this leader to `node`."""
    move = Move()
    while node in follows:
        node, last = follows[node]
        move = move.after(last)
    return node, move


def _partners(basis: Basis, tie: Tie) -> tuple[list[int], list[int]]:
    """Unknowns u_x of leaders and followers, in pairs."""
    leader, follower = (
        np.unique(nodes_on(basis, named_facets(basis.mesh, name))[0])
        for name in (tie.leader, tie.follower)
    )
    if leader.size != follower.size:
        raise ValueError(
            f"tie {tie}: the follower must have as many nodes as the leader, "
            f"got {follower.size} for {leader.size}: use equal meshes"
        )
    moved = tie.move.of(basis.doflocs[0, leader] + 1j * basis.doflocs[1, leader])
    wanted = np.array([moved.real, moved.imag])
    distance, nearest = cKDTree(basis.doflocs[:, follower].T).query(wanted.T)
    extent = float(np.ptp(basis.mesh.p, axis=1).max())
    worst = int(np.argmax(distance))
    if distance[worst] > MATCH * extent or np.unique(nearest).size < leader.size:
        x, y = wanted[:, worst]
        raise ValueError(
            f"tie {tie}: no follower matches the leader's node at ({x:.5g}, {y:.5g}), the nearest "
            f"is {distance[worst]:.3g} away: use equal meshes, or change angle=, about= and shift="
        )
    return leader.tolist(), follower[nearest].tolist()
