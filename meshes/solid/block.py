"""Block of equal hexahedra."""

import math

import gmsh
from skfem.mesh import Mesh3D

from meshes.session import gmsh_session
from meshes.solid.hexahedra import solid_mesh

Span = tuple[float, float]
SIDES = ("z=0", "z=1", "y=0", "x=1", "y=1", "x=0")  # in gmsh's order; 0 the lower end, 1 the upper


def solid_block(
    *, x: Span, y: Span, z: Span, cells: tuple[int, int, int], order: int = 2
) -> Mesh3D:
    """Mesh of the block between two values of `x`, `y` and `z`, with `cells` per direction.

    The reference axes of the cells are x, y, z. Boundaries: "x=0" (the lower end), "x=1" (the upper
    end), and so on. Body: "block". `order` is 1 or 2. Raises ValueError unless the second value of
    each pair is above the first and every number of cells is at least 1.
    """
    if min(cells) < 1 or not all(-math.inf < low < high < math.inf for low, high in (x, y, z)):
        raise ValueError(
            "a block requires rising x, y, z and at least one cell per direction, got "
            f"x={x}, y={y}, z={z}, "
            f"cells={cells}"
        )
    with gmsh_session():
        geo = gmsh.model.geo
        corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
        points = [geo.addPoint(*corner, z[0]) for corner in corners]
        sides = [geo.addLine(points[k], points[(k + 1) % 4]) for k in range(4)]
        for k, side in enumerate(sides):
            geo.mesh.setTransfiniteCurve(side, cells[k % 2] + 1)
        base = geo.addPlaneSurface([geo.addCurveLoop(sides)])
        geo.mesh.setTransfiniteSurface(base, cornerTags=points)
        geo.mesh.setRecombine(2, base)
        swept = geo.extrude([(2, base)], 0, 0, z[1] - z[0], numElements=[cells[2]], recombine=True)
        top, volume, *walls = (tag for _, tag in swept)
        geo.synchronize()
        for name, surface in zip(SIDES, [base, top, *walls], strict=True):
            gmsh.model.addPhysicalGroup(2, [surface], name=name)
        gmsh.model.addPhysicalGroup(3, [volume], name="block")
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        return solid_mesh()
