"""Outward normals at the nodes of named boundaries: directions in which guides fix the nodes."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from skfem import Basis

from fem.plane.axis import on_axis
from fem.plane.discretisation import Array, Indices, facet_basis, outer_facets

if TYPE_CHECKING:
    from fem.plane.ties import Tied

SMOOTH = 0.866  # cos 30 deg: facets that turn by less are one wall


def wall_normals(
    basis: Basis, names: Mapping[int, str], turn: bool, tied: "Tied | None" = None
) -> dict[int, tuple[Indices, Array]]:
    """Unknowns u_x, u_y (2, m) and outward normals (2, m) of the nodes of each named boundary.

    A vertex between facets of a smooth wall has their mean normal, also if the facets have
    different names. A vertex at a corner has the normals of both sides. With `turn`, a wall
    continues beyond the axis as its mirror image; at a `tied` node, the wall continues on the
    facets at the leader.
    """
    nodes, normals, owner = [], [], []
    for i, name in names.items():
        facets = outer_facets(basis.mesh, name)
        trace = facet_basis(basis, facets, points=np.array([0.0, 0.5, 1.0]))
        ends = basis.nodal_dofs[:, basis.mesh.facets[:, facets]]
        stations = [(ends[:, 0], 0), (ends[:, 1], 2)]
        if basis.facet_dofs is not None and np.size(basis.facet_dofs):
            stations.append((basis.facet_dofs[:2, facets], 1))
        for dofs, k in stations:
            nodes.append(dofs)
            normals.append(np.asarray(trace.normals[:, :, k]))
            owner.append(np.full(dofs.shape[1], i))
    if not nodes:
        return {}
    dofs, normal, of = np.hstack(nodes), np.hstack(normals), np.concatenate(owner)
    if turn:
        pole = on_axis(basis.mesh, basis.doflocs[:, dofs[0]])
        pole &= normal[1] ** 2 - normal[0] ** 2 > SMOOTH
        normal[0, pole] = 0.0
    if tied is None:
        smooth = _smoothed(dofs[0], normal)
    else:
        leader, angle = tied.led_by(dofs)
        smooth = turned(_smoothed(leader[0], turned(normal, -angle)), angle)
    found = {}
    for i in names:
        rows = np.vstack([dofs[:, of == i], smooth[:, of == i]])
        rows = np.unique(np.round(rows, 12), axis=1)
        found[i] = rows[:2].astype(int), rows[2:] / np.hypot(*rows[2:])
    return found


def turned(vectors: Array, angle: Array) -> Array:
    """Plane `vectors` (2, m), each rotated by its element of `angle` (m,) [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    x, y = vectors
    return np.array([c * x - s * y, s * x + c * y])


def _smoothed(node: Indices, normal: Array) -> Array:
    """Normals (2, m), each replaced by the mean of all normals at its node within 30 deg."""
    smooth = normal.copy()
    order = np.argsort(node, kind="stable")
    for group in np.split(order, np.flatnonzero(np.diff(node[order])) + 1):
        near = normal[:, group].T @ normal[:, group] > SMOOTH
        mean = normal[:, group] @ near
        smooth[:, group] = mean / np.hypot(*mean)
    return smooth
