"""Accordion spring: two-stage force curve by formulas and by beam elements with self-contact."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.spring import two_stages
from fem.beam import compress_spring
from meshes.spring import spring_centre_line

b, h, E = 0.1e-3, 56e-3, 206e9  # thickness and width of the strip [m], Young's modulus [Pa]
path = {"n": 4, "L1": 11.6e-3, "radius": 0.5e-3, "alpha": np.radians(80), "tail": "arc"}
spring = two_stages(**path, b=b, h=h, E=E, head="free", theory="thin")
U_A, F_A = float(spring.U_A), float(spring.F_A)

line = spring_centre_line(**path, tips=True, per_arc=4, per_leaf=4)
share = np.array([0.01, 0.3, 0.6, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4])
curve = compress_spring(line, share * U_A, b=b, h=h, E=E, nu=0.3)
k = curve.F[0] / curve.U[0]
print(f"stiffness of the free stage {spring.k1 / 1e3:.4f} N/mm, finite elements {k / 1e3:.4f} N/mm")
first = curve.U[curve.press.sum(axis=1) > 0][0]
print(f"the leaves touch at {U_A * 1e3:.2f} mm, finite elements: before {first * 1e3:.2f} mm")

U = np.linspace(0, 1.4 * U_A, 100)
F = np.where(U < U_A, spring.k1 * U, F_A + spring.k2 * (U - U_A))
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
for shape, label in (
    (line.points[curve.nodes], "free"),
    (curve.shapes[-1][curve.nodes], "pressed"),
):
    left.plot(*shape.T * 1e3, label=label)
left.legend()
left.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", title="centre line")
right.plot(U * 1e3, F, label="two straight lines")
right.plot(curve.U * 1e3, curve.F, "o", label="finite elements")
right.legend()
right.set(xlabel="displacement [mm]", ylabel="force [N]", title="curve")
figure.savefig("spring_curve.png", dpi=110)
