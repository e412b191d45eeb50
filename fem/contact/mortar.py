"""Mortar operators of a pair of surfaces: weighted gaps, slips and the conjugate forces.

The contact traction is piecewise linear between the vertices i of the slave, with hat functions
phi_i along its facets. The weighted gaps, the weighted slips and the work of the traction use the
same integrals. Each integration segment lies within one facet of the slave and one facet of the
master:

    g_i = int phi_i (gap + n . (u_m - u_s)),    s_i = int phi_i t . (u_m - u_s),

where n is directed from slave to master and t is n rotated by +90 deg. The pressure p = sum p_i
phi_i pushes the slave along -n and the master along +n. The traction q = sum q_i phi_i pulls the
master along +t and the slave along -t.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from fem.contact.pairing import Points
from fem.contact.trace import Trace
from fem.plane.discretisation import Array, Indices

BARE = 1e-9  # over the integral of a hat: less than that over the segments carries no traction


@dataclass(frozen=True)
class Mortar:
    """Operators of a contact pair; m vertices of the slave carry the contact traction.

    `x` (2, m) are the positions of the vertices, `arc` (m,) their arc lengths along the surface,
    `hats` (points, m) the hat functions phi_i. `normal` and `tangential` (points, unknowns) give n
    . (u_m - u_s) and t . (u_m - u_s) from displacements. `weight` (points,) [area] are the
    integration weights, `size` (m,) the integrals of the hat functions.
    """

    points: Points
    x: Array
    arc: Array
    hats: csr_array
    normal: csr_array
    tangential: csr_array
    weight: Array

    @property
    def size(self) -> Array:
        return self.hats.T @ self.weight

    def weighted(self, values: csr_array | Array) -> csr_array | Array:
        """Integrals (m, ...) of `values` at the points, weighted with each hat function."""
        if isinstance(values, np.ndarray):
            return self.hats.T @ (self.weight * values)
        scaled = self.hats.copy()
        scaled.data = scaled.data * np.repeat(self.weight, np.diff(scaled.indptr))
        return (scaled.T @ values).tocsr()


def mortar(
    slave: Trace,
    master: Trace | None,
    points: Points,
    *,
    unknowns: int,
    depth: Array,
    obstacle: tuple[int, tuple[float, float]] = (0, (0.0, 0.0)),
) -> Mortar:
    """Operators of a pair at `points`; `depth` (points,) is the thickness or the circumference.

    Without a master mesh, `obstacle` gives the first of the three unknowns of the rigid shape
    (shift x, y, rotation) and its centre of rotation.
    """
    count = points.s.size
    rows = np.arange(count)
    t = np.array([-points.n[1], points.n[0]])

    def relative(direction: Array) -> csr_array:
        own = _trace_rows(slave, points.slave, points.s, -direction)
        if master is not None:
            other = _trace_rows(master, points.master, points.t, direction)
        else:
            first, centre = obstacle
            arm = points.y - np.reshape(centre, (2, 1))
            turn = direction[1] * arm[0] - direction[0] * arm[1]
            other = (
                np.array([*direction, turn]),
                np.repeat([[first], [first + 1], [first + 2]], count, axis=1),
            )
        entries = np.concatenate([own[0].ravel(), other[0].ravel()])
        columns = np.concatenate([own[1].ravel(), other[1].ravel()])
        at = np.concatenate([np.tile(rows, len(own[0])), np.tile(rows, len(other[0]))])
        return csr_array((entries, (at, columns)), (count, unknowns))

    weight = points.weight * depth
    carriers = slave.carriers()
    order = np.array([0.0, 1.0, 0.5])[: len(carriers), None] + np.arange(slave.count)
    _, first, place = np.unique(carriers, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(order.ravel()[first]))  # nodes follow each other as facets do
    place = rank[place].reshape(carriers.shape)
    local = slave.hats(points.s)
    hats = csr_array(
        (local.ravel(), (np.tile(rows, len(local)), place[:, points.slave].ravel())),
        (count, rank.size),
    )
    whole = np.bincount(place.ravel(), np.tile(slave.lengths() / len(local), len(local)))
    covered = hats.T @ points.weight > BARE * whole
    places, arc = np.zeros((2, rank.size)), np.zeros(rank.size)
    places[:, place] = slave.nodes[:, : len(local)]
    ends = np.array([0.0, 1.0, 0.5])[: len(local), None] + np.zeros(slave.count)
    along = slave.arc(np.arange(slave.count), ends)
    arc[place[::-1].ravel()] = along[::-1].ravel()  # the last counts: a closed curve's start
    return Mortar(
        points,
        places[:, covered],
        arc[covered],
        hats[:, covered].tocsr(),
        relative(points.n),
        relative(t),
        weight,
    )


def _trace_rows(trace: Trace, k: Indices, s: Array, direction: Array) -> tuple[Array, Indices]:
    """Entries and unknowns (2 nodes, points) of the rows direction . u at `s` on the facets `k`."""
    shape = trace.displacement_shapes(s)
    entries = direction[:, None] * shape[None]
    return entries.reshape(-1, s.size), trace.dofs[:, :, k].reshape(-1, s.size)
