"""Plane mesh of the strip of an accordion spring, seen along its width."""

import math

import gmsh
from skfem.mesh import Mesh2D

from meshes.plane import plane_mesh
from meshes.session import gmsh_session
from meshes.spring.path import Piece, Tail, accordion


def strip(
    *,
    n: int,
    b: float,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail = "arc",
    leaf: float | None = None,
    through: int,
    per_arc: int,
    per_leaf: int,
    order: int = 2,
) -> Mesh2D:
    """Mesh with `through` cells over the thickness b, `per_arc` along an arc, `per_leaf` per leaf.

    Boundaries: "head" and "tail" (the end faces, along x), "left" and "right" seen from the head.
    Bodies: "arcs" and "leaves".
    """
    with gmsh_session():
        geo = gmsh.model.geo
        pieces = list(accordion(n=n, L1=L1, radius=radius, alpha=alpha, tail=tail, leaf=leaf))
        first = before = _face(pieces[0].x, pieces[0].y, pieces[0].heading, b, through)
        sides: tuple[list[int], list[int]] = ([], [])
        surfaces: dict[str, list[int]] = {"leaf": [], "arc": []}
        for piece in pieces:
            after = _face(*piece.end, piece.heading + piece.turn, b, through)
            edges = [_side(piece, before[k], after[k]) for k in (0, 1)]
            for k, edge in enumerate(edges):
                geo.mesh.setTransfiniteCurve(edge, (per_arc if piece.turn else per_leaf) + 1)
                sides[k].append(edge)
            loop = geo.addCurveLoop([edges[1], -after[2], -edges[0], before[2]])
            surface = geo.addPlaneSurface([loop])
            geo.mesh.setTransfiniteSurface(surface)
            geo.mesh.setRecombine(2, surface)
            surfaces[piece.kind].append(surface)
            before = after
        geo.synchronize()
        named = {"head": [first[2]], "tail": [before[2]], "left": sides[0], "right": sides[1]}
        for name, curves in named.items():
            gmsh.model.addPhysicalGroup(1, curves, name=name)
        gmsh.model.addPhysicalGroup(2, surfaces["arc"], name="arcs")
        gmsh.model.addPhysicalGroup(2, surfaces["leaf"], name="leaves")
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        return plane_mesh()


def _face(x: float, y: float, heading: float, b: float, through: int) -> tuple[int, int, int]:
    """Left point, right point, and the curve from left to right across the strip."""
    geo = gmsh.model.geo
    n_x, n_y = -math.sin(heading) * b / 2, math.cos(heading) * b / 2
    left, right = geo.addPoint(x + n_x, y + n_y, 0), geo.addPoint(x - n_x, y - n_y, 0)
    across = geo.addLine(left, right)
    geo.mesh.setTransfiniteCurve(across, through + 1)
    return left, right, across


def _side(piece: Piece, start: int, end: int) -> int:
    geo = gmsh.model.geo
    if piece.kind == "leaf":
        return int(geo.addLine(start, end))
    return int(geo.addCircleArc(start, geo.addPoint(*piece.centre, 0), end))
