"""Accordion spring: the two stages of its curve, and its stiffness by finite elements."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.spring.stages import stages
from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from meshes.spring.centre_line import centre_line

b, h, E = 0.1, 56.0, 206e3  # thickness and width of the strip [mm], Young's modulus [MPa]
path = {"n": 10, "L1": 11.6, "radius": 0.5, "alpha": np.radians(80)}
spring = stages(**path, b=b, h=h, E=E, head="free", tail="arc", theory="thin")

line = centre_line(**path, tail="arc", per_arc=8, per_leaf=8)
strip = Section(EA=E * b * h, EI=E * h * b**3 / 12, GA=1e3 * E * b * h)  # nearly rigid in shear
frame = solve_curved_frame(
    line.points, line.elements, sections=strip, supports={line.nodes["tail"]: "xyr"},
    loads={line.nodes["head"]: (1.0, 0.0, 0.0)},
)  # fmt: skip
k = 1 / abs(frame.u[line.nodes["head"], 0])
print(f"stiffness of the free stage {float(spring.k1):.4f} N/mm, finite elements {k:.4f} N/mm")
print(f"beyond {float(spring.U_A):.2f} mm the leaves touch: {float(spring.k2):.3f} N/mm")

U = np.linspace(0, 1.6 * float(spring.U_A), 100)
F = np.where(U < spring.U_A, spring.k1 * U, spring.F_A + spring.k2 * (U - spring.U_A))
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
left.plot(*line.chords[0].T, ".", ms=2)
left.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", title="centre line")
right.plot(U, F)
right.plot(U, spring.k1 * U, "--", color="0.5", label="stiffness of the free stage")
right.plot(spring.U_A, spring.F_A, "o", label="the leaves touch")
right.legend()
right.set(xlabel="displacement [mm]", ylabel="force [N]", title="curve")
figure.savefig("spring_curve.png", dpi=110)
