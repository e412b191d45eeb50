"""Four-sided blocks of mapped quadrilaterals, and their mesh by gmsh."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import gmsh
import numpy as np
from skfem.mesh import Mesh2D

from meshes.plane import nodes_and_cells, plane_mesh
from meshes.session import gmsh_session
from meshes.topology import Topologies, Topology

Point = tuple[float, float]
Place = Callable[[Point], Point]
Cells = Literal["quad", "tri"]
TOPOLOGIES = Topologies()


@dataclass(frozen=True)
class Edge:
    """Side of a block: a line, or an arc about `centre` of less than half a turn.

    `beta` grades the cells from fine at the start to coarse at the end, see meshes.contact.grading;
    0 gives equal cells. All edges with the same `name` are one boundary of the mesh.
    """

    start: Point
    end: Point
    cells: int
    centre: Point | None = None
    beta: float = 0.0
    name: str = ""

    @property
    def length(self) -> float:
        """Length of the edge, in the unit of the points."""
        chord = math.dist(self.start, self.end)
        if self.centre is None:
            return chord
        radius = math.dist(self.centre, self.start)
        return 2 * radius * math.asin(min(1.0, chord / (2 * radius)))

    def placed(self, place: Place) -> "Edge":
        """Edge mapped by `place`, a rigid motion or a reflection of points."""
        centre = None if self.centre is None else place(self.centre)
        return replace(self, start=place(self.start), end=place(self.end), centre=centre)


@dataclass(frozen=True)
class Block:
    """Four edges around a part of a body.

    Each edge connects two consecutive corners, in either direction. Opposite edges must have the
    same number of cells. Blocks share the edge between the same two points.
    """

    edges: tuple[Edge, Edge, Edge, Edge]
    body: str

    @property
    def corners(self) -> list[Point]:
        """Common point of each edge and the previous edge."""
        ends = [{edge.start, edge.end} for edge in self.edges]
        return [(ends[k - 1] & ends[k]).pop() for k in range(4)]

    @property
    def anticlockwise(self) -> "Block":
        """Block with its edges in anticlockwise order."""
        (x_0, y_0), (x_1, y_1), (x_2, y_2), (x_3, y_3) = self.corners
        area = (x_2 - x_0) * (y_3 - y_1) - (x_3 - x_1) * (y_2 - y_0)
        a, b, c, d = self.edges
        return self if area > 0 else replace(self, edges=(d, c, b, a))

    def mirrored(self, x: int, y: int) -> "Block":
        """Block with its coordinates multiplied by `x` and `y`, each 1 or -1."""
        return self.placed(lambda point: (x * point[0], y * point[1]))

    def placed(self, place: Place) -> "Block":
        """Block mapped by `place`, a rigid motion or a reflection of points."""
        a, b, c, d = (edge.placed(place) for edge in self.edges)
        return replace(self, edges=(a, b, c, d))


def mesh_blocks(
    blocks: Sequence[Block],
    *,
    cells: Cells = "quad",
    order: int = 2,
    straight: bool = False,
    whole: Mapping[str, tuple[str, ...]] | None = None,
) -> Mesh2D:
    """Mesh of `blocks`, with the names of their edges and bodies.

    Cells are quadrilaterals, or triangles that halve them. `order` is 1 or 2; `straight` cells have
    straight edges. Each boundary named in `whole` combines those of its parts that exist.
    """
    whole = whole or {}
    with gmsh_session():
        drawing = _Drawing(cells)
        for block in blocks:
            drawing.add(block.anticlockwise)
        gmsh.model.geo.synchronize()
        for name, curves in drawing.boundaries.items():
            gmsh.model.addPhysicalGroup(1, curves, name=name)
        for name, surfaces in drawing.bodies.items():
            gmsh.model.addPhysicalGroup(2, surfaces, name=name)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        if cells == "tri":  # scikit-fem renumbers the nodes of triangles
            return _named(plane_mesh(straight=straight), whole)
        read = nodes_and_cells(straight=straight)
        # equal drawings have equal names of curves and surfaces
        key = (drawing.structure, tuple(whole.items()), read.t.shape, read.t.tobytes())
        topology = TOPOLOGIES.get(
            key, lambda: Topology.of(_named(plane_mesh(straight=straight), whole), read.t)
        )
    return topology.at(read.p)


def _named(mesh: Mesh2D, whole: Mapping[str, tuple[str, ...]]) -> Mesh2D:
    """The `mesh`, to which the combined boundaries of `whole` are added."""
    own = mesh.boundaries
    found = {
        name: np.concatenate([own[part] for part in parts if part in own])
        for name, parts in whole.items()
    }
    return replace(mesh, _boundaries=own | found)


@dataclass
class _Drawing:
    """Entities of the current gmsh model, by their position."""

    cells: Cells
    points: dict[Point, int] = field(default_factory=dict)
    curves: dict[frozenset[Point], tuple[int, Point]] = field(default_factory=dict)
    boundaries: dict[str, list[int]] = field(default_factory=dict)
    bodies: dict[str, list[int]] = field(default_factory=dict)
    drawn: list[tuple[object, ...]] = field(default_factory=list)

    @property
    def structure(self) -> tuple[object, ...]:
        """All data except positions of points; equal structures have meshes of equal topology."""
        names = tuple((name, tuple(curves)) for name, curves in self.boundaries.items())
        return self.cells, names, tuple(self.drawn)

    def add(self, block: Block) -> None:
        """Add the mapped surface of `block` to the gmsh model."""
        geo = gmsh.model.geo
        loop = []
        for edge, corner in zip(block.edges, block.corners, strict=True):
            curve, start = self.curve(edge)
            loop.append(curve if start == corner else -curve)
        surface = geo.addPlaneSurface([geo.addCurveLoop(loop)])
        geo.mesh.setTransfiniteSurface(surface)
        if self.cells == "quad":
            geo.mesh.setRecombine(2, surface)
        self.bodies.setdefault(block.body, []).append(surface)
        self.drawn.append((block.body, *loop))

    def curve(self, edge: Edge) -> tuple[int, Point]:
        """Curve of `edge` and its start; the curve is added to the gmsh model at its first use."""
        ends = frozenset((edge.start, edge.end))
        if ends not in self.curves:
            geo = gmsh.model.geo
            a, b = self.point(edge.start), self.point(edge.end)
            if edge.centre is None:
                curve = geo.addLine(a, b)
            else:
                curve = geo.addCircleArc(a, self.point(edge.centre), b)
            if edge.beta == 0:
                geo.mesh.setTransfiniteCurve(curve, edge.cells + 1)
            else:
                geo.mesh.setTransfiniteCurve(curve, edge.cells + 1, "Beta", edge.beta)
            self.curves[ends] = curve, edge.start
            self.drawn.append((curve, a, b, edge.cells))
            if edge.name:
                self.boundaries.setdefault(edge.name, []).append(curve)
        return self.curves[ends]

    def point(self, place: Point) -> int:
        """Point at `place`; it is added to the gmsh model at its first use."""
        if place not in self.points:
            self.points[place] = gmsh.model.geo.addPoint(*place, 0)
        return self.points[place]
