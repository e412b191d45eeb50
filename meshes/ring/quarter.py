"""Quarter ring in the first quadrant, with mapped quadrilaterals."""

import math

import gmsh
from skfem.mesh import Mesh2D

from meshes.counts import at_least, nearest
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

AROUND = 12  # cells along a quarter on the coarsest mesh
ACROSS = 0.4  # increase of ln r over one of these cells


def quarter_ring(
    *, r_i: float, r_o: float, refine: int, order: int = 2, straight: bool = False
) -> Mesh2D:
    """Mesh of a quarter of a ring, with cells that grow with the radius.

    `refine` 1 is the coarsest mesh: twelve cells along the quarter (more in thin walls) and at
    least one across each half of the wall; 2 halves all cells, and so on. Boundaries: "bore",
    "rim", "x=0", "y=0" and the internal circle "middle" between the bodies "inner half" and "outer
    half". `order` is 1 or 2; `straight` cells have straight edges.
    """
    if not 0 < r_i < r_o:
        raise ValueError(f"a ring must have 0 < r_i < r_o, got r_i={r_i:g} m, r_o={r_o:g} m")
    radii = (r_i, (r_i + r_o) / 2, r_o)
    # the rise of an arc over its chord stays below a quarter of the thinnest cell
    thin = math.log(r_o / radii[1])
    around = refine * max(AROUND, at_least(math.pi / 2 / math.sqrt(2 * thin)))
    with gmsh_session():
        geo = gmsh.model.geo
        o = geo.addPoint(0, 0, 0)
        foot = [geo.addPoint(r, 0, 0) for r in radii]
        top = [geo.addPoint(0, r, 0) for r in radii]
        circles = [geo.addCircleArc(a, o, b) for a, b in zip(foot, top, strict=True)]
        feet = [geo.addLine(foot[k], foot[k + 1]) for k in (0, 1)]
        tops = [geo.addLine(top[k], top[k + 1]) for k in (0, 1)]
        for curve in circles:
            geo.mesh.setTransfiniteCurve(curve, around + 1)
        for k, body in enumerate(("inner half", "outer half")):
            stretch = radii[k + 1] / radii[k]
            cells = refine * max(1, nearest(math.log(stretch) / ACROSS))
            for curve in (feet[k], tops[k]):
                geo.mesh.setTransfiniteCurve(
                    curve, cells + 1, "Progression", stretch ** (1 / cells)
                )
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
