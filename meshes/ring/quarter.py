"""Quarter ring in the first quadrant, mapped quadrilaterals."""

import math

import gmsh
from skfem.mesh import Mesh2D

from meshes.plane import plane_mesh
from meshes.session import gmsh_session


def quarter_ring(
    *, r_i: float, r_o: float, through: int, around: int, order: int = 2, straight: bool = False
) -> Mesh2D:
    """`2 through` cells across the wall and `around` cells along a quarter.

    Boundaries "bore", "rim", "x=0", "y=0" and the internal circle "middle"; bodies "inner half"
    and "outer half" meet there. `order` 1 or 2; `straight` cells keep straight edges.
    """
    r_m = (r_i + r_o) / 2
    with gmsh_session():
        geo = gmsh.model.geo
        o = geo.addPoint(0, 0, 0)
        foot = [geo.addPoint(r, 0, 0) for r in (r_i, r_m, r_o)]
        top = [geo.addPoint(0, r, 0) for r in (r_i, r_m, r_o)]
        circles = [geo.addCircleArc(a, o, b) for a, b in zip(foot, top, strict=True)]
        feet = [geo.addLine(foot[k], foot[k + 1]) for k in (0, 1)]
        tops = [geo.addLine(top[k], top[k + 1]) for k in (0, 1)]
        for curve in circles:
            geo.mesh.setTransfiniteCurve(curve, around + 1)
        for curve in feet + tops:
            geo.mesh.setTransfiniteCurve(curve, through + 1)
        for k, body in enumerate(("inner half", "outer half")):
            loop = geo.addCurveLoop([feet[k], circles[k + 1], -tops[k], -circles[k]])
            surface = geo.addPlaneSurface([loop])
            geo.mesh.setTransfiniteSurface(surface)
            geo.mesh.setRecombine(2, surface)
            geo.addPhysicalGroup(2, [surface], name=body)
        named = {"bore": circles[:1], "middle": circles[1:2], "rim": circles[2:]}
        for name, curves in (named | {"y=0": feet, "x=0": tops}).items():
            geo.addPhysicalGroup(1, curves, name=name)
        geo.synchronize()
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        return plane_mesh(straight=straight)


def cells_around(*, r_i: float, r_o: float, through: int) -> int:
    """Cells along a quarter that are about as long at the mean radius as they are thick."""
    return max(4, round(math.pi / 2 * (r_i + r_o) / (r_o - r_i) * through))
