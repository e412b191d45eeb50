"""Hexahedra of a strip: a plane path of leaves and arcs with a thickness, swept over its width."""

import math
from collections.abc import Sequence
from itertools import chain, pairwise

import gmsh
from skfem.mesh import Mesh3D

from meshes.session import gmsh_session
from meshes.solid.grading import levels
from meshes.solid.hexahedra import solid_mesh
from meshes.spring.path import Piece

Face = tuple[list[int], list[int]]


def solid_strip(
    pieces: Sequence[Piece],
    *,
    b: float,
    width: float,
    through: int,
    per_arc: int,
    per_leaf: int,
    across: int,
    grading: float = 1.0,
    order: int = 2,
    straight: bool = False,
) -> Mesh3D:
    """Mesh of a strip of thickness `b` about a path in z = 0, swept to z = `width` [same unit].

    There are `through` cells over b, `per_arc` along each arc, `per_leaf` along each leaf, and
    `across` over the width. Cells at z = width are finer than cells at z = 0 by a factor of about
    `grading`. The first reference direction of every cell is along the path. Boundaries: "head" and
    "tail" (the end faces), "left" and "right" seen from the head, "middle" (z = 0) and "edge".
    Bodies: "arcs" and "leaves". `order` is 1 or 2; `straight` cells have straight edges. Raises
    ValueError for lengths and numbers that are not positive, and for an arc with a radius of at
    most half the thickness.
    """
    _check(pieces, b, width, (through, per_arc, per_leaf, across))
    with gmsh_session():
        geo = gmsh.model.geo
        before = _face(pieces[0].x, pieces[0].y, pieces[0].heading, b, through)
        layers: list[list[int]] = []
        for piece in pieces:
            after = _face(*piece.end, piece.heading + piece.turn, b, through)
            layers.append(_layers(piece, before, after, per_arc if piece.turn else per_leaf))
            before = after
        swept = geo.extrude(
            [(2, surface) for surface in chain(*layers)], 0, 0, width,
            numElements=[1] * across, heights=levels(across, grading), recombine=True,
        )  # fmt: skip
        geo.synchronize()
        _name(pieces, layers, [tag for _, tag in swept])
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        return solid_mesh(straight=straight)


def _name(pieces: Sequence[Piece], layers: list[list[int]], swept: list[int]) -> None:
    """Define physical groups from each layer's entities: far face, volume and four sides."""
    through = len(layers[0])
    parts = [swept[k : k + 6] for k in range(0, len(swept), 6)]
    faces = {
        "head": [part[5] for part in parts[:through]],
        "tail": [part[3] for part in parts[-through:]],
        "left": [part[4] for part in parts[::through]],
        "right": [part[2] for part in parts[through - 1 :: through]],
        "middle": list(chain(*layers)),
        "edge": [part[0] for part in parts],
    }
    for name, surfaces in faces.items():
        gmsh.model.addPhysicalGroup(2, surfaces, name=name)
    for name, arcs in (("arcs", True), ("leaves", False)):
        own = [part[1] for k, part in enumerate(parts) if bool(pieces[k // through].turn) == arcs]
        if own:
            gmsh.model.addPhysicalGroup(3, own, name=name)


def _face(x: float, y: float, heading: float, b: float, through: int) -> Face:
    """Points from left to right through the strip, and the lines between them."""
    geo = gmsh.model.geo
    n_x, n_y = -math.sin(heading) * b / 2, math.cos(heading) * b / 2
    places = [1 - 2 * k / through for k in range(through + 1)]
    points = [geo.addPoint(x + s * n_x, y + s * n_y, 0) for s in places]
    lines = [geo.addLine(left, right) for left, right in pairwise(points)]
    for line in lines:
        geo.mesh.setTransfiniteCurve(line, 2)
    return points, lines


def _layers(piece: Piece, before: Face, after: Face, cells: int) -> list[int]:
    """Surfaces of the leaf or arc, one for each cell through its thickness."""
    geo = gmsh.model.geo
    sides = []
    for start, end in zip(before[0], after[0], strict=True):
        if piece.turn:
            sides.append(geo.addCircleArc(start, geo.addPoint(*piece.centre, 0), end))
        else:
            sides.append(geo.addLine(start, end))
        geo.mesh.setTransfiniteCurve(sides[-1], cells + 1)
    surfaces = []
    for k, (left, right) in enumerate(pairwise(sides)):
        loop = geo.addCurveLoop([right, -after[1][k], -left, before[1][k]])
        surfaces.append(geo.addPlaneSurface([loop]))
        corners = [before[0][k + 1], after[0][k + 1], after[0][k], before[0][k]]
        geo.mesh.setTransfiniteSurface(surfaces[-1], cornerTags=corners)
        geo.mesh.setRecombine(2, surfaces[-1])
    return surfaces


def _check(pieces: Sequence[Piece], b: float, width: float, counts: tuple[int, ...]) -> None:
    if not pieces:
        raise ValueError("a strip must have a path of at least one leaf or arc")
    if not (0 < b < math.inf and 0 < width < math.inf):
        raise ValueError(f"a strip must have b > 0 and width > 0, got b={b:g} m, width={width:g} m")
    if min(counts) < 1:
        raise ValueError(
            "numbers of cells of a strip must be >= 1, got through, per_arc, per_leaf, across = "
            + ", ".join(map(str, counts))
        )
    for piece in pieces:
        if piece.turn and abs(piece.length / piece.turn) <= b / 2:
            raise ValueError(
                f"the radius of an arc must be above b/2, got {abs(piece.length / piece.turn):g} m "
                f"with b={b:g} m"
            )
