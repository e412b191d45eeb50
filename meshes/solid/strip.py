"""Hexahedra of a strip: a plane path of leaves and arcs with a thickness, swept over its width."""

import math
from collections.abc import Sequence

import gmsh
from skfem.mesh import Mesh3D

from meshes.session import gmsh_session
from meshes.solid.grading import levels
from meshes.solid.hexahedra import solid_mesh
from meshes.spring.path import Piece

NAMES = ("right", "tail", "left", "head")  # the sides of a piece, in the order of its outline


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
    """The strip of thickness `b` about a path in z = 0, from there to z = `width` [one unit].

    `through` cells over b, `per_arc` and `per_leaf` along each piece, `across` over the width: the
    ones at z = width are finer than those at 0 by about `grading`. The first reference direction
    of every cell runs along the path. Boundaries "head" and "tail" (the cut faces), "left" and
    "right" seen from the head, "middle" (z = 0) and "edge"; bodies "arcs" and "leaves". `order` 1
    or 2; `straight` cells keep straight edges. ValueError for lengths and counts that aren't
    positive, and for an arc thinner than half the strip inside.
    """
    _check(pieces, b, width, (through, per_arc, per_leaf, across))
    with gmsh_session():
        geo = gmsh.model.geo
        before = _face(pieces[0].x, pieces[0].y, pieces[0].heading, b, through)
        drawn = []
        for piece in pieces:
            after = _face(*piece.end, piece.heading + piece.turn, b, through)
            sides = [_side(piece, before[k], after[k]) for k in (0, 1)]
            for side in sides:
                geo.mesh.setTransfiniteCurve(side, (per_arc if piece.turn else per_leaf) + 1)
            loop = geo.addCurveLoop([sides[1], -after[2], -sides[0], before[2]])
            surface = geo.addPlaneSurface([loop])
            geo.mesh.setTransfiniteSurface(
                surface, cornerTags=[before[1], after[1], after[0], before[0]]
            )
            geo.mesh.setRecombine(2, surface)
            drawn.append(surface)
            before = after
        swept = geo.extrude(
            [(2, surface) for surface in drawn], 0, 0, width,
            numElements=[1] * across, heights=levels(across, grading), recombine=True,
        )  # fmt: skip
        geo.synchronize()
        _name(pieces, drawn, [tag for _, tag in swept])
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        return solid_mesh(straight=straight)


def _name(pieces: Sequence[Piece], drawn: list[int], swept: list[int]) -> None:
    """Physical groups of what gmsh made: of each piece its far face, its volume and four sides."""
    parts = [swept[k : k + 6] for k in range(0, len(swept), 6)]
    faces = {name: [part[2 + k] for part in parts] for k, name in enumerate(NAMES)}
    faces["head"], faces["tail"] = faces["head"][:1], faces["tail"][-1:]
    faces["middle"], faces["edge"] = drawn, [part[0] for part in parts]
    for name, surfaces in faces.items():
        gmsh.model.addPhysicalGroup(2, surfaces, name=name)
    for name, kind in (("arcs", "arc"), ("leaves", "leaf")):
        own = [part[1] for part, piece in zip(parts, pieces, strict=True) if piece.kind == kind]
        if own:
            gmsh.model.addPhysicalGroup(3, own, name=name)


def _face(x: float, y: float, heading: float, b: float, through: int) -> tuple[int, int, int]:
    """Left point, right point and the curve from left to right through the strip."""
    geo = gmsh.model.geo
    n_x, n_y = -math.sin(heading) * b / 2, math.cos(heading) * b / 2
    left, right = geo.addPoint(x + n_x, y + n_y, 0), geo.addPoint(x - n_x, y - n_y, 0)
    line = geo.addLine(left, right)
    geo.mesh.setTransfiniteCurve(line, through + 1)
    return left, right, line


def _side(piece: Piece, start: int, end: int) -> int:
    geo = gmsh.model.geo
    if piece.kind == "leaf":
        return int(geo.addLine(start, end))
    return int(geo.addCircleArc(start, geo.addPoint(*piece.centre, 0), end))


def _check(pieces: Sequence[Piece], b: float, width: float, counts: tuple[int, ...]) -> None:
    if not pieces:
        raise ValueError("a strip needs a path of at least one leaf or arc")
    if not (0 < b < math.inf and 0 < width < math.inf):
        raise ValueError(f"a strip needs b > 0 and width > 0, got b={b:g} m, width={width:g} m")
    if min(counts) < 1:
        raise ValueError(
            "a strip needs a cell each way, got through, per_arc, per_leaf, across = "
            + ", ".join(map(str, counts))
        )
    for piece in pieces:
        if piece.turn and abs(piece.length / piece.turn) <= b / 2:
            raise ValueError(
                f"an arc needs a radius above b/2, got {abs(piece.length / piece.turn):g} m "
                f"with b={b:g} m"
            )
