"""Sweep in Python: the error of Barlow's formula over the wall thickness of a cylinder.

Barlow's hoop stress p d/(2 s), with the inside diameter d, is compared with finite elements. The
expected error of the largest stress follows from Lamé: -s r_o/(r_o² + r_i²).
"""

import matplotlib.pyplot as plt
import numpy as np

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.ring.quarter import quarter_ring

r_i, p = 50.0, 10.0  # mm, MPa
walls = np.geomspace(1.0, 50.0, 9)


def hoop_stress(wall):
    """Largest hoop stress [MPa] of the cylinder by finite elements."""
    cylinder = solve_plane(
        quarter_ring(r_i=r_i, r_o=r_i + wall, refine=3),
        materials=Elastic(E=210e3, nu=0.3), assumption="plane strain",
        supports={"x=0": "x", "y=0": "y"}, pressures={"bore": p},
    )  # fmt: skip
    bore = cylinder.on_boundary("bore")
    return bore.mean(bore.polar()[2])


error = np.array([p * r_i / wall / hoop_stress(wall) - 1 for wall in walls])
r_o = r_i + walls
expected = -walls * r_o / (r_o**2 + r_i**2)
print(f"error at the thickest wall {error[-1]:+.2%}, by Lamé {expected[-1]:+.2%}")
print(f"within 5 % up to a wall of {np.interp(0.05, -error, walls):.1f} mm")

plt.semilogx(walls / r_i, 100 * expected, label="Barlow over Lamé")
plt.semilogx(walls / r_i, 100 * error, "o", label="Barlow over finite elements")
plt.axhspan(-5, 0, color="C2", alpha=0.15, label="within 5 %")
plt.xlabel("wall / inside radius")
plt.ylabel("error of the formula [%]")
plt.legend()
plt.savefig("sweep_of_a_formula.png", dpi=110, bbox_inches="tight")
