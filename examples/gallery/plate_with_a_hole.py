"""Plate with a hole in tension: the stress concentration of Kirsch's solution.

A quarter of a square plate is meshed with gmsh. The outer edges carry the tractions of Kirsch's
solution, so that the finite plate has the stresses of the infinite plate. The stress at the
hole is 3 times the nominal stress.
"""

import gmsh
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.tri import Triangulation

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

a, side, nominal = 1.0, 5.0, 100.0  # mm, mm, MPa


def kirsch(x):
    """Stresses (xx, yy, xy) of an infinite plate under tension along x."""
    r, t = np.hypot(*x), np.arctan2(x[1], x[0])
    c2, c4, s2, s4 = np.cos(2 * t), np.cos(4 * t), np.sin(2 * t), np.sin(4 * t)
    k, q = (a / r) ** 2, 1.5 * (a / r) ** 4
    return nominal * np.array([1 - k * (1.5 * c2 + c4) + q * c4, -k * (c2 / 2 - c4) - q * c4,
                               -k * (s2 / 2 + s4) + q * s4])  # fmt: skip


with gmsh_session():
    occ = gmsh.model.occ
    square, disc = occ.addRectangle(0, 0, 0, side, side), occ.addDisk(0, 0, 0, a, a)
    plate, _ = occ.cut([(2, square)], [(2, disc)])
    occ.synchronize()
    gmsh.model.addPhysicalGroup(2, [plate[0][1]], name="plate")
    places = {"right": (0, side), "top": (1, side), "x=0": (0, 0.0), "y=0": (1, 0.0)}
    for _, edge in gmsh.model.getBoundary(plate, oriented=False):
        centre = gmsh.model.occ.getCenterOfMass(1, edge)
        names = [n for n, (axis, at) in places.items() if abs(centre[axis] - at) < 1e-6]
        gmsh.model.addPhysicalGroup(1, [edge], name=names[0] if names else "hole")
        if not names:
            gmsh.model.mesh.setTransfiniteCurve(edge, 65)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.2)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    mesh = plane_mesh()

solution = solve_plane(
    mesh, materials=Elastic(E=210e3, nu=0.3), assumption="plane stress",
    supports={"x=0": "x", "y=0": "y"},
    tractions={"right": lambda x: kirsch(x)[[0, 2]], "top": lambda x: kirsch(x)[[2, 1]]},
)  # fmt: skip
hole = solution.on_boundary("hole")
angle, hoop = np.arctan2(hole.x[1], hole.x[0]), hole.polar()[2] / nominal
slope, mean = np.polyfit(np.cos(2 * angle), hoop, 1)  # Kirsch: 1 - 2 cos 2θ
print(f"stress concentration factor {mean - slope:.3f}, Kirsch 3")

inside = solution.in_body("plate")
plt.figure(figsize=(6, 4.5))
triangles = Triangulation(*inside.x)
triangles.set_mask(np.hypot(*inside.x[:, triangles.triangles].mean(axis=2)) < a)
plt.tricontourf(triangles, inside.stress[0] / nominal, levels=24)
plt.colorbar(label="axial stress / nominal stress")
plt.axis("equal")
plt.xlabel("x [mm]")
plt.ylabel("y [mm]")
plt.savefig("plate_with_a_hole.png", dpi=110, bbox_inches="tight")
