"""Rings and their sectors with identical cells."""

from dataclasses import replace
from math import cos, pi, sin

import numpy as np
from skfem import Basis, ElementQuad2, ElementTriP2, MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

R_I, R_O = 1.0, 1.6
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}


def sector(kind, z, *, start=0.3, around=6, through=3, **radii):
    """The first of `z` sectors from `start` [rad]: "bore", "rim", "first cut", "last cut"."""
    return arc(kind, 2 * pi / z, start=start, around=around, through=through, **radii)


def arc(kind, angle, *, start, around, through, r_i=R_I, r_o=R_O):
    """Triangles are cut along one diagonal only, so that no mirror maps the mesh onto itself."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(r_i, r_o, through + 1), angle * np.linspace(0, 1, around + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == r_i,
        "rim": lambda x: x[0] == r_o,
        "first cut": lambda x: x[1] == 0,
        "last cut": lambda x: x[1] == angle,
    })  # fmt: skip
    r, phi = mesh.doflocs[0], mesh.doflocs[1] + start
    return replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)]))


def ring(kind, z, *, start=0.3, around=6, through=3, r_i=R_I, r_o=R_O):
    """The closed ring of `z` such sectors: "bore", "rim"."""
    straight, _ = KINDS[kind]
    cut = arc(kind, 2 * pi, start=start, around=z * around, through=through, r_i=r_i, r_o=r_o)
    own = np.arange(cut.nvertices)
    p = cut.p[:, : cut.nvertices]
    for last in np.unique(cut.facets[:, cut.boundaries["last cut"]]):
        own[last] = np.argmin(np.hypot(*(p - p[:, [last]])) + 10 * (own == last))
    kept = np.unique(own)
    number = np.zeros(own.size, int)
    number[kept] = np.arange(kept.size)
    closed = straight(p[:, kept], number[own][cut.t], sort_t=False, validate=False)
    closed = curved(kind, closed, cut)
    radius = np.hypot(*closed.p[:, : closed.nvertices])[closed.facets].mean(axis=0)
    outer = closed.f2t[1] < 0
    middle = (r_i + r_o) / 2
    return closed.with_boundaries({
        "bore": np.flatnonzero(outer & (radius < middle)),
        "rim": np.flatnonzero(outer & (radius > middle)),
    })  # fmt: skip


def curved(kind, mesh, *parts):
    """Straight `mesh` with the curved edges of its `parts`, whose cells are one after the other."""
    straight, shape = KINDS[kind]
    if shape is straight:
        return mesh
    element = ElementTriP2() if straight is MeshTri1 else ElementQuad2()
    quadratic = shape.from_mesh(mesh)
    dofs, *own = (Basis(m, element).element_dofs for m in (quadratic, *parts))
    places = quadratic.doflocs.copy()
    places[:, dofs] = np.concatenate(
        [m.doflocs[:, d] for m, d in zip(parts, own, strict=True)], axis=2
    )
    return replace(quadratic, doflocs=places)


def beside(kind, *parts):
    """Meshes as one whose nodes are not joined; boundaries are numbered: "bore 0", "bore 1"."""
    starts = np.cumsum([0, *(m.nvertices for m in parts)])
    p = np.hstack([m.doflocs[:, : m.nvertices] for m in parts])
    t = np.hstack([m.t + start for m, start in zip(parts, starts, strict=False)])
    whole = curved(kind, KINDS[kind][0](p, t, sort_t=False, validate=False), *parts)
    number = {tuple(sorted(f)): i for i, f in enumerate(whole.facets.T.tolist())}
    return whole.with_boundaries({
        f"{name} {k}": np.array(
            [number[tuple(sorted(f))] for f in (m.facets[:, own] + starts[k]).T.tolist()]
        )
        for k, m in enumerate(parts)
        for name, own in m.boundaries.items()
    })  # fmt: skip


def turned(x, angle):
    """Points or vectors (2, m), turned by `angle` [rad]."""
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s], [s, c]]) @ np.asarray(x)


def places(solution):
    """Places (2, nodes) and displacements (2, nodes) of all nodes."""
    x = solution.basis.doflocs[:, ::2]
    return x, np.array([solution.u[::2], solution.u[1::2]])


def apart(part, whole):
    """Largest difference of the displacements of two solutions where they have nodes in common.

    Relative to the largest displacement; every node of the part must be one of the whole.
    """
    x, u = places(part)
    X, U = places(whole)
    distance = np.hypot(*(x[:, :, None] - X[:, None, :]))
    nearest = distance.argmin(axis=1)
    assert distance.min(axis=1).max() < 1e-9
    return np.abs(u - U[:, nearest]).max() / np.abs(U).max()
