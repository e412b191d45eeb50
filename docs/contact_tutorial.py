"""How to set up a contact problem: a steel pin in the hole of an aluminium lug.

Run it with `.venv/bin/python docs/contact_tutorial.py`. The example contains no freewheel: the
solver accepts any bodies, named boundaries and loads. Lengths are in mm, stresses in MPa, forces in
N per mm of thickness; any other consistent set of units can be used.
"""

import gmsh
import numpy as np

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.plane.material import Elastic
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

# The mesh. Draw each body separately with gmsh. Assign names to the surfaces (bodies) and curves
# (boundaries) to which the problem refers. Second-order edges follow the circles. The pin has a
# radial clearance of 0.02 mm and touches the hole at the lowest point.

R, PLAY, LOAD = 10.0, 0.02, 400.0

with gmsh_session():
    occ = gmsh.model.occ
    block, hole = occ.addRectangle(-25, -40, 0, 50, 65), occ.addDisk(0, 0, 0, R, R)
    occ.cut([(2, block)], [(2, hole)])
    pin = occ.addDisk(0, -PLAY, 0, R - PLAY, R - PLAY)
    occ.synchronize()
    gmsh.model.addPhysicalGroup(2, [block], name="lug")
    gmsh.model.addPhysicalGroup(2, [pin], name="pin")
    edges = [tag for _, tag in gmsh.model.getBoundary([(2, block)], oriented=False)]
    for name, y in {"foot": -40, "hole": 0}.items():
        own = [e for e in edges if abs(gmsh.model.occ.getCenterOfMass(1, e)[1] - y) < 1e-6]
        gmsh.model.addPhysicalGroup(1, own, name=name)
    rim = [tag for _, tag in gmsh.model.getBoundary([(2, pin)], oriented=False)]
    gmsh.model.addPhysicalGroup(1, rim, name="rim")
    gmsh.option.setNumber("Mesh.MeshSizeMax", 1.5)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    mesh = plane_mesh()

# The problem: materials, supports and pairs that may touch, by name. Only the hole supports the
# pin. The bodies are factorised once; every further `solve` takes about a millisecond. The friction
# state continues from the step `after`.

problem = ContactProblem(
    mesh,
    materials={"lug": Elastic(E=70e3, nu=0.33), "pin": Elastic(E=210e3, nu=0.3)},
    assumption="plane stress",
    supports={"foot": "xy"},
    contacts=[Pair(slave="rim", master="hole", friction=0.15)],
)
step = None
for load in np.linspace(LOAD / 4, LOAD, 4):
    step = problem.solve(body_forces={"pin": (0, -load / (np.pi * (R - PLAY) ** 2))}, after=step)
    touch = step.touches[0]
    angle = np.degrees(np.arctan2(touch.x[0], -touch.x[1]))[touch.closed]
    print(
        f"{load:4.0f} N/mm: peak pressure {touch.peak:5.1f} MPa, contact from {angle.min():4.0f} "
        f"to {angle.max():3.0f} deg, the hole carries {-touch.force[1]:6.2f} N/mm"
    )

# A problem may also have:
# - exact circles, so that facets do not affect the gap:
#   `Pair(..., slave_shape=Circle((0, -PLAY), R - PLAY))`;
# - a fit, `interference=0.01`, or bodies drawn with overlap, `press_fit=True`;
# - a rigid surface without a mesh, driven by a force or a displacement:
#   `obstacles={"punch": Obstacle(Circle((0, 20), 5), free="y")}` as the master of a pair, then
#   `solve(forces={"punch": (0, -100)})` or, if y is not free,
#   `solve(displacements={"punch": {"y": -0.1}})`;
# - a body of `Rigid()`;
# - `steps=20` if friction depends on the load path.
# A torque is a traction or body force that depends on the position:
# `body_forces={"pin": lambda x: 2.0 * np.array([-x[1], x[0]])}`.

# The results are tractions and slips along the surface (touch.x, touch.pressure,
# touch.traction, touch.slip, touch.sticks), and the fields in the bodies, as for any plane problem.

stress = step.plane.at(np.array([[0.0], [-R - 1.0]])).stress
print(f"1 mm below the hole sigma_y = {stress[1, 0]:.1f} MPa")
