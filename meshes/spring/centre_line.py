"""Line mesh along the centre line of an accordion spring."""

import gmsh

from meshes.line import LineMesh, line_mesh
from meshes.session import gmsh_session
from meshes.spring.path import Tail, accordion


def centre_line(
    *,
    n: int,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail = "arc",
    leaf: float | None = None,
    per_arc: int,
    per_leaf: int,
) -> LineMesh:
    """Quadratic elements, `per_arc` on each arc and `per_leaf` on each leaf.

    Nodes "head" (middle of the head) and "tail" (where it is held); bodies "arcs" and "leaves".
    """
    with gmsh_session():
        geo = gmsh.model.geo
        start = first = geo.addPoint(0, 0, 0)
        curves: dict[str, list[int]] = {"leaf": [], "arc": []}
        for piece in accordion(n=n, L1=L1, radius=radius, alpha=alpha, tail=tail, leaf=leaf):
            end = geo.addPoint(*piece.end, 0)
            if piece.kind == "arc":
                curve = geo.addCircleArc(start, geo.addPoint(*piece.centre, 0), end)
            else:
                curve = geo.addLine(start, end)
            geo.mesh.setTransfiniteCurve(curve, (per_arc if piece.turn else per_leaf) + 1)
            curves[piece.kind].append(curve)
            start = end
        geo.synchronize()
        gmsh.model.addPhysicalGroup(0, [first], name="head")
        gmsh.model.addPhysicalGroup(0, [start], name="tail")
        gmsh.model.addPhysicalGroup(1, curves["arc"], name="arcs")
        gmsh.model.addPhysicalGroup(1, curves["leaf"], name="leaves")
        gmsh.model.mesh.generate(1)
        gmsh.model.mesh.setOrder(2)
        return line_mesh()
