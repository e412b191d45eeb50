"""Line mesh along the centre line of an accordion spring."""

from dataclasses import replace

import gmsh
import numpy as np

from meshes.line import LineMesh, line_mesh
from meshes.session import gmsh_session
from meshes.spring.path import Tail, accordion

BODIES = {"arc": "arcs", "leaf": "leaves", "tip": "tips"}


def centre_line(
    *,
    n: int,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail = "arc",
    leaf: float | None = None,
    tips: bool = False,
    per_arc: int,
    per_leaf: int,
) -> LineMesh:
    """Line mesh of quadratic elements along the centre line of an accordion spring.

    There are `per_arc` elements on each arc and `per_leaf` on each leaf or half leaf. Nodes: "head"
    (middle of the head) and "tail" (its support). Bodies: "arcs" and "leaves". With `tips`, the
    leaves of head and tail extend to their free ends. Additional nodes are then "head tip" and
    "tail tip"; additional bodies are "tips" (the free parts, not included in "leaves") and "unit 1"
    to "unit n".
    """
    path = accordion(n=n, L1=L1, radius=radius, alpha=alpha, tail=tail, leaf=leaf, tips=tips)
    with gmsh_session():
        geo = gmsh.model.geo
        pieces = list(path)
        first = pieces[0]
        ends = [geo.addPoint(first.x, first.y, 0)]
        parts: dict[tuple[str, int], list[int]] = {}
        for piece in pieces:
            ends.append(geo.addPoint(*piece.end, 0))
            if piece.turn:
                curve = geo.addCircleArc(ends[-2], geo.addPoint(*piece.centre, 0), ends[-1])
            else:
                curve = geo.addLine(*ends[-2:])
            geo.mesh.setTransfiniteCurve(curve, (per_arc if piece.turn else per_leaf) + 1)
            parts.setdefault((piece.kind, piece.unit if tips else 0), []).append(curve)
        geo.synchronize()
        head, tail_end = (ends[1], ends[-2]) if tips else (ends[0], ends[-1])
        named = {"head": head, "tail": tail_end}
        if tips:
            named |= {"head tip": ends[0], "tail tip": ends[-1]}
        for name, point in named.items():
            gmsh.model.addPhysicalGroup(0, [point], name=name)
        for kind, unit in sorted(parts):  # disjoint groups: they number the elements
            gmsh.model.addPhysicalGroup(1, parts[kind, unit], name=f"{kind} {unit}")
        gmsh.model.mesh.generate(1)
        gmsh.model.mesh.setOrder(2)
        return _merged(line_mesh())


def _merged(mesh: LineMesh) -> LineMesh:
    """Mesh whose bodies, named "kind unit", are joined into one body per kind and one per unit."""
    bodies: dict[str, list[int]] = {}
    for name, elements in mesh.bodies.items():
        kind, unit = name.split()
        bodies.setdefault(BODIES[kind], []).extend(elements)
        if int(unit):
            bodies.setdefault(f"unit {unit}", []).extend(elements)
    return replace(mesh, bodies={name: np.array(own) for name, own in bodies.items()})
