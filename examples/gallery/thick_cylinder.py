"""Thick cylinder under internal pressure: Lamé's stresses compared with plane finite elements."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.ring.lame import stresses
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.ring.quarter import quarter_ring

r_i, r_o, p = 30.0, 45.0, 100.0  # mm, mm, MPa

cylinder = solve_plane(
    quarter_ring(r_i=r_i, r_o=r_o, refine=4),
    materials=Elastic(E=210e3, nu=0.3), assumption="plane strain",
    supports={"x=0": "x", "y=0": "y"}, pressures={"bore": p},
)  # fmt: skip
bore = cylinder.on_boundary("bore")
hoop = bore.mean(bore.polar()[2])
lame = stresses(r_i, r_i=r_i, r_o=r_o, p_i=p)[1]
print(f"hoop stress at the bore {hoop:.2f} MPa, Lamé {lame:.2f} MPa")

r = np.linspace(r_i, r_o, 100)
wall = cylinder.in_body("inner half"), cylinder.in_body("outer half")
radial_stress, hoop_stress = stresses(r, r_i=r_i, r_o=r_o, p_i=p)
plt.plot(r, radial_stress, label="radial stress, Lamé")
plt.plot(r, hoop_stress, label="hoop stress, Lamé")
for part in wall:
    _, radial, around, *_ = part.polar()
    plt.plot(np.hypot(*part.x), radial, "k.", ms=1)
    plt.plot(np.hypot(*part.x), around, "k.", ms=1)
plt.xlabel("radius [mm]")
plt.ylabel("stress [MPa], points: finite elements")
plt.legend()
plt.savefig("thick_cylinder.png", dpi=110, bbox_inches="tight")
