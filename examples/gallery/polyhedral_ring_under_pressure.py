"""Polyhedral ring under pressure: radial growth by a series and by finite elements."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.polyhedral import Sector, rim_displacement, stiffness_factors
from fem.plane import solve_polygon_ring
from meshes.polyhedral import polygon_half_sector

z, d_e, d_i, rho = 6, 80.0, 72.0, 2.0  # flats; outer and corner diameter, fillet radius [mm]
E, nu, p = 210e3, 0.3, 10.0  # MPa, -, MPa

ring = Sector(z=z, d_e=d_e, d_i=d_i, rho=rho)
theta = np.linspace(0, np.pi / z, 31)
material = {"E": E, "nu": nu, "assumption": "plane stress"}
series = rim_displacement(theta, sector=ring, p=p, **material).real

solved = solve_polygon_ring(
    polygon_half_sector, z=z, d_e=d_e, d_i=d_i, fillet=rho, p=p, **material
)  # fmt: skip
elements = solved.growth(theta)
print(f"growth above a flat {elements[0] * 1e3:.3f} µm, series {series[0] * 1e3:.3f} µm")
K = stiffness_factors(sector=ring, nu=nu, assumption="plane stress")
print(f"factor K of the flats {K.mid:.3f}, of a round ring 1")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
inside = solved.solution.in_body("ring")
hoop = left.scatter(*inside.x, c=inside.polar()[2], s=6, cmap="viridis")
left.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
figure.colorbar(hoop, ax=left, label="hoop stress [MPa]")
right.plot(np.degrees(theta), series * 1e3, label="series")
right.plot(np.degrees(theta), elements * 1e3, "o", ms=4, label="finite elements")
right.set(xlabel="angle from the middle of a flat [deg]", ylabel="radial growth [µm]")
right.legend()
figure.savefig("polyhedral_ring_under_pressure.png", dpi=110)
