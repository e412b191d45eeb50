"""Cuts of cyclic sectors and periodic cells: the nodes of one boundary follow those of another.

    Tie(leader="ring.left", follower="ring.right", angle=-2 * pi / 8)

u(follower) = R u(leader) with the rotation R that also brings the leader's nodes, turned about a
point and shifted, to the follower's. Displacements are u = P w, where w are those of the nodes that
lead; a node that follows itself turned by an angle stays where it is.
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
from fem.plane.supports import Conditions, free_directions, node_dofs, nodes_on

MATCH = 1e-6  # of the mesh's extent: how far nodes may lie beside their partners
SAME = 1e-9  # rotations [rad] that differ by less are one


@dataclass(frozen=True, kw_only=True)
class Tie:
    """`follower` is `leader` turned by `angle` [rad] about a point, then shifted [length].

    By default nothing is turned or shifted: two boundaries at one place are bonded.
    """

    leader: str
    follower: str
    angle: float = 0.0
    about: tuple[float, float] = (0.0, 0.0)
    shift: tuple[float, float] = (0.0, 0.0)

    def __str__(self) -> str:
        return f"{self.follower!r} to {self.leader!r}"

    def moved(self, x: Array) -> Array:
        """Places (2, m) of followers whose leaders are at `x` (2, m)."""
        about = np.reshape(self.about, (2, 1))
        return rotation(self.angle) @ (x - about) + about + np.reshape(self.shift, (2, 1))


@dataclass(frozen=True)
class Tied:
    """Followers (2, m) and leaders (2, m), unknowns x and y of nodes; `angle` (m,) [rad].

    No leader follows another node; `still` (2, k) are nodes that stay where they are.
    """

    follower: Indices
    leader: Indices
    angle: Array
    still: Indices
    count: int

    @cached_property
    def P(self) -> csr_array:
        """Displacements (unknowns, unknowns) of all nodes from those that lead."""
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
        """Rows (k, unknowns) that vanish where followers follow."""
        apart = (diags_array(np.ones(self.count)) - self.P).tocsr()
        return apart[self.follower.ravel()]

    def led_by(self, nodes: Indices) -> tuple[Indices, Array]:
        """Leaders (2, m) of `nodes` (2, m), and angles (m,) by which the nodes are turned.

        A node that does not follow leads itself.
        """
        place = np.full(self.count, -1)
        place[self.follower[0]] = np.arange(self.angle.size)
        of = place[nodes[0]]
        own = np.flatnonzero(of >= 0)
        leader, angle = nodes.copy(), np.zeros(nodes.shape[1])
        leader[:, own], angle[own] = self.leader[:, of[own]], self.angle[of[own]]
        return leader, angle

    def led(self, conditions: Conditions) -> Conditions:
        """The same conditions, those of followers written for their leaders."""
        dofs, angle = self.led_by(conditions.dofs)
        return replace(conditions, dofs=dofs, direction=turned(conditions.direction, -angle))

    def free_directions(
        self, basis: Basis, conditions: Conditions, place: Indices
    ) -> tuple[csr_array, Array]:
        """As `fem.plane.supports.free_directions`, every follower moving with its leader."""
        if not self.angle.size:
            return free_directions(basis, conditions, place)
        T, u0 = free_directions(basis, self.led(conditions), place, self.follower.ravel())
        T = (self.P @ T).tocsr()
        size = np.sqrt(np.asarray((T * T).sum(axis=0)).ravel())
        return (T @ diags_array(1 / size)).tocsr(), self.P @ u0

    def forces(self, conditions: Conditions, reaction: Array) -> Array:
        """Force (m,) along each condition that makes up `reaction` (unknowns,) of the supports.

        What a follower's support carries appears at its leader as well.
        """
        return self.led(conditions).forces(self.P.T @ reaction)

    def ordered(self, place: Indices) -> Indices:
        """Order of elimination (unknowns,): what belongs to two places of the mesh comes late."""
        place = place.copy()
        np.maximum.at(place, self.leader, place[self.follower])
        place[self.leader] += self.count
        return place


def rotation(angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]])


def tied(basis: Basis, ties: Sequence[Tie]) -> Tied:
    """Who follows whom; ValueError where nodes of a tie do not match."""
    root = np.arange(basis.N)  # by the unknowns x of nodes
    turn = np.zeros(basis.N)  # what each is turned against its root
    y_of = np.zeros(basis.N, int)
    nodes = node_dofs(basis)
    y_of[nodes[0]] = nodes[1]
    still: set[int] = set()
    for tie in ties:
        for a, b in zip(*_partners(basis, tie), strict=True):
            (a_root, a_turn), (b_root, b_turn) = _found(root, turn, a), _found(root, turn, b)
            angle = a_turn + tie.angle - b_turn  # of b's root against a's
            if a_root != b_root:
                root[b_root], turn[b_root] = a_root, angle
            elif abs(math.remainder(angle, 2 * math.pi)) > SAME:
                still.add(a_root)
    joined = np.flatnonzero(root != np.arange(basis.N))
    follower = joined[np.isin(joined, nodes[0])]
    ends = [_found(root, turn, f) for f in follower.tolist()]
    leader = np.array([r for r, _ in ends], dtype=int)
    at_rest = np.array(sorted({_found(root, turn, n)[0] for n in still}), dtype=int)
    return Tied(
        np.array([follower, y_of[follower]]), np.array([leader, y_of[leader]]),
        np.array([t for _, t in ends], dtype=float), np.array([at_rest, y_of[at_rest]]), basis.N,
    )  # fmt: skip


def _found(root: Indices, turn: Array, node: int) -> tuple[int, float]:
    """The root of a node and what the node is turned against it."""
    angle = 0.0
    while root[node] != node:
        angle += float(turn[node])
        node = int(root[node])
    return node, angle


def _partners(basis: Basis, tie: Tie) -> tuple[list[int], list[int]]:
    """Unknowns x of leaders and followers, in pairs."""
    leader, follower = (
        np.unique(nodes_on(basis, named_facets(basis.mesh, name))[0])
        for name in (tie.leader, tie.follower)
    )
    if leader.size != follower.size:
        raise ValueError(
            f"tie {tie}: {follower.size} nodes cannot follow {leader.size}: mesh both sides alike"
        )
    wanted = tie.moved(basis.doflocs[:, leader])
    distance, nearest = cKDTree(basis.doflocs[:, follower].T).query(wanted.T)
    extent = float(np.ptp(basis.mesh.p, axis=1).max())
    worst = int(np.argmax(distance))
    if distance[worst] > MATCH * extent or np.unique(nearest).size < leader.size:
        x, y = wanted[:, worst]
        raise ValueError(
            f"tie {tie}: no node follows that at ({x:.5g}, {y:.5g}), the nearest is "
            f"{distance[worst]:.3g} away: mesh both sides alike, or mend angle, about and shift"
        )
    return leader.tolist(), follower[nearest].tolist()
