"""Shells swept along z from a plane path: strips, cylinder panels, plates, accordion springs."""

from collections.abc import Iterable
from typing import NamedTuple

import gmsh
import numpy as np

from meshes.contact.grading import beta
from meshes.session import gmsh_session
from meshes.shell.surface import ShellMesh, shell_mesh
from meshes.spring.path import Piece


class _Path(NamedTuple):
    """Points from the head to the tail, curves between them, and whether each curve is an arc."""

    points: list[int]
    curves: list[int]
    arcs: list[bool]


def swept_path(
    path: Iterable[Piece],
    *,
    width: float,
    per_arc: int,
    per_leaf: int,
    across: int,
    finest: float | None = None,
    leaf_ends: float = 1.0,
) -> ShellMesh:
    """Mesh of the leaves and arcs of a plane path, swept from z = 0 to z = `width`.

    `per_arc` cells lie along each arc, and `per_leaf` cells along each leaf. `across` cells lie
    over the width; they are equal, or grow from about `finest` (in the unit of the path) at the
    edge z = `width`. Cells at the ends of a leaf are about `leaf_ends` times as long as in its
    middle. To halve every cell, double the numbers of cells and halve `finest`.

    Boundaries: "head" and "tail" (first and last line across), "middle" (z = 0) and "edge". Nodes:
    "head" and "tail", both at z = 0. Bodies: "leaves" and "arcs", if they exist. Normals point to
    the right of the path, seen from positive z.
    """
    pieces = list(path)
    _check(pieces, width, min(per_arc, per_leaf, across), finest, leaf_ends)
    heights = _heights(width, across, finest)
    with gmsh_session():
        line = _path(pieces, per_arc, per_leaf, leaf_ends)
        swept = gmsh.model.geo.extrude(
            [(1, curve) for curve in line.curves], 0, 0, width,
            numElements=[1] * across, heights=heights, recombine=True,
        )  # fmt: skip
        gmsh.model.geo.synchronize()
        _name(line, swept)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(2)
        return shell_mesh()


def _check(
    pieces: list[Piece], width: float, fewest: int, finest: float | None, leaf_ends: float
) -> None:
    if not pieces:
        raise ValueError("a path must have at least one leaf or arc")
    if not width > 0:
        raise ValueError(f"width must be positive, got {width:g}")
    if fewest < 1:
        raise ValueError(f"per_arc, per_leaf and across must be at least 1, got {fewest}")
    if finest is not None and not finest > 0:
        raise ValueError(f"the finest cell size must be positive, got finest={finest:g}")
    if not 0 < leaf_ends <= 1:
        raise ValueError(f"leaf_ends must lie in (0, 1], got {leaf_ends:g}")


def _heights(width: float, across: int, finest: float | None) -> list[float]:
    """Positions of the lines between cells, relative to the width."""
    even = np.arange(1, across + 1) / across
    if finest is None or finest * across >= width:
        return [float(x) for x in even]
    b = beta(length=width, first=finest, cells=across)
    e = ((b + 1) / (b - 1)) ** even
    return [float(x) for x in b * (e - 1) / (e + 1)]


def _path(pieces: list[Piece], per_arc: int, per_leaf: int, leaf_ends: float) -> _Path:
    geo = gmsh.model.geo
    line = _Path([geo.addPoint(pieces[0].x, pieces[0].y, 0)], [], [bool(p.turn) for p in pieces])
    for piece, arc in zip(pieces, line.arcs, strict=True):
        start, end = line.points[-1], geo.addPoint(*piece.end, 0)
        if arc:
            curve = geo.addCircleArc(start, geo.addPoint(*piece.centre, 0), end)
            geo.mesh.setTransfiniteCurve(curve, per_arc + 1)
        else:
            curve = geo.addLine(start, end)
            how = ("Bump", leaf_ends) if leaf_ends < 1 else ()
            geo.mesh.setTransfiniteCurve(curve, per_leaf + 1, *how)
        line.points.append(end)
        line.curves.append(curve)
    return line


def _name(line: _Path, swept: list[tuple[int, int]]) -> None:
    """Define physical groups; in `swept`, each surface follows its curve at the edge."""
    surfaces = [i for i, (dim, _) in enumerate(swept) if dim == 2]
    head, tail = (
        [c for c in gmsh.model.getAdjacencies(0, point)[0] if c not in line.curves]
        for point in (line.points[0], line.points[-1])
    )
    edge = [swept[i - 1][1] for i in surfaces]
    for name, curves in (("head", head), ("tail", tail), ("middle", line.curves), ("edge", edge)):
        gmsh.model.addPhysicalGroup(1, curves, name=name)
    for name, arc in (("leaves", False), ("arcs", True)):
        own = [swept[i][1] for i, is_arc in zip(surfaces, line.arcs, strict=True) if is_arc == arc]
        if own:
            gmsh.model.addPhysicalGroup(2, own, name=name)
    for name, point in (("head", line.points[0]), ("tail", line.points[-1])):
        gmsh.model.addPhysicalGroup(0, [point], name=name)
