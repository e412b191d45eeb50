"""Shells swept along z from a plane path: strips, cylinder panels, plates, accordion springs."""

from collections.abc import Iterable

import gmsh
import numpy as np

from meshes.contact.grading import beta
from meshes.session import gmsh_session
from meshes.shell.surface import ShellMesh, shell_mesh
from meshes.spring.path import Piece


def swept_path(
    path: Iterable[Piece],
    *,
    width: float,
    per_arc: int,
    per_leaf: int,
    across: int,
    finest: float | None = None,
) -> ShellMesh:
    """Leaves and arcs of a plane path, swept from z = 0 to z = `width`.

    `per_arc` and `per_leaf` cells along each piece, `across` over the width: even ones, or growing
    from `finest` (same unit as the path) at the edge z = `width` on. Boundaries "head" and "tail"
    (first and last line across), "middle" (z = 0) and "edge"; nodes "head" and "tail" in the
    middle; bodies "leaves" and "arcs". Normals point to the right of the path seen against z.
    """
    pieces = list(path)
    if not pieces:
        raise ValueError("a path needs a leaf or an arc")
    if not width > 0:
        raise ValueError(f"width must be positive, got {width:g}")
    if min(per_arc, per_leaf, across) < 1:
        raise ValueError(
            f"needs a cell at least along each piece and across, got per_arc={per_arc}, "
            f"per_leaf={per_leaf}, across={across}"
        )
    heights = _heights(width, across, finest)
    with gmsh_session():
        geo = gmsh.model.geo
        start = geo.addPoint(pieces[0].x, pieces[0].y, 0)
        lines = [start]
        curves: dict[str, list[int]] = {"leaf": [], "arc": []}
        for piece in pieces:
            end = geo.addPoint(*piece.end, 0)
            if piece.kind == "arc":
                curve = geo.addCircleArc(lines[-1], geo.addPoint(*piece.centre, 0), end)
            else:
                curve = geo.addLine(lines[-1], end)
            geo.mesh.setTransfiniteCurve(curve, (per_arc if piece.turn else per_leaf) + 1)
            curves[piece.kind].append(curve)
            lines.append(end)
        every = [(1, curve) for curve in curves["leaf"] + curves["arc"]]
        swept = geo.extrude(
            every, 0, 0, width, numElements=[1] * across, heights=heights, recombine=True
        )
        geo.synchronize()
        surfaces = [tag for dim, tag in swept if dim == 2]
        tops = [swept[i - 1][1] for i, (dim, _) in enumerate(swept) if dim == 2]
        path_curves = {tag for _, tag in every}
        head, tail = (
            [c for c in gmsh.model.getAdjacencies(0, point)[0] if c not in path_curves]
            for point in (lines[0], lines[-1])
        )
        count = len(curves["leaf"])
        for name, tags in (
            ("head", head), ("tail", tail), ("middle", [c for _, c in every]), ("edge", tops)
        ):  # fmt: skip
            gmsh.model.addPhysicalGroup(1, tags, name=name)
        for name, tags in (("leaves", surfaces[:count]), ("arcs", surfaces[count:])):
            if tags:
                gmsh.model.addPhysicalGroup(2, tags, name=name)
        for name, tag in (("head", lines[0]), ("tail", lines[-1])):
            gmsh.model.addPhysicalGroup(0, [tag], name=name)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(2)
        return shell_mesh()


def _heights(width: float, across: int, finest: float | None) -> list[float]:
    """Where the lines between cells lie, as shares of the width."""
    even = np.arange(1, across + 1) / across
    if finest is None:
        return [float(x) for x in even]
    if not finest > 0:
        raise ValueError(f"finest must be positive, got {finest:g}")
    if finest * across >= width:
        return [float(x) for x in even]
    b = beta(length=width, first=finest, cells=across)
    e = ((b + 1) / (b - 1)) ** even
    return [float(x) for x in b * (e - 1) / (e + 1)]
