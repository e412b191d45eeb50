"""Roller freewheel under torque: clamping angle, contact pressure and wind-up.

The clutch has an inner cam (star) with ten rollers. It is computed by formulas and, at one torque,
by finite elements. Without load, the clamping angle follows from the radii alone:
cos 2α = (X + r)/(R - r).
"""

import matplotlib.pyplot as plt
import numpy as np

from analytic.freewheel import ContactMaterial, InnerCam, RollerClutch, loaded, roller_torque_limits
from fem.wedge import solve_freewheel
from meshes.freewheel import inner_cam_sector

R, X, r = 21.0e-3, 14.9e-3, 3.0e-3  # bore of the ring, flat of the star, roller [m]
steel = ContactMaterial(E=206e9, nu=0.3)
clutch = RollerClutch(
    cam=InnerCam(R=R, X=X, r=r, z=10), L=12e-3, r_b=8e-3, R_a=28e-3,
    roller=steel, inner=steel, outer=steel,
)  # fmt: skip
T = np.linspace(0, 200, 201)  # N m
state = loaded(clutch, T)
rigid = np.degrees(np.arccos((X + r) / (R - r)) / 2)
unloaded, angle = np.degrees(state.alpha[[0, 100]])
print(f"clamping angle without load {unloaded:.4f} deg, rigid clutch {rigid:.4f} deg")
print(f"at 100 N m: clamping angle {angle:.3f} deg, wind-up {np.degrees(state.phi[100]):.3f} deg")
print(f"pressure on the star {state.p_i[100] / 1e6:.0f} MPa")
first = roller_torque_limits(clutch, mu=0.08, p_lim=4e9)
print(f"torque at the first limit {float(first.torque):.0f} N m: {first.first}")
solved = solve_freewheel(
    inner_cam_sector, R=R, X=X, r=r, z=10, L=12e-3, r_b=8e-3, R_a=28e-3, E=206e9, nu=0.3, mu=0.1,
    T=100.0,
)  # fmt: skip
elements = np.degrees(solved.alpha)
print(f"finite elements at 100 N m: {elements:.3f} deg, {solved.pressures[0] / 1e6:.0f} MPa")

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
left.plot(T, np.degrees(state.phi))
left.set(xlabel="torque [N m]", ylabel="wind-up [deg]")
right.plot(T, state.p_i / 1e6, label="on the star")
right.plot(T, state.p_o / 1e6, label="on the ring")
right.plot(100, solved.pressures[0] / 1e6, "o", color="C0", label="on the star, finite elements")
right.set(xlabel="torque [N m]", ylabel="contact pressure [MPa]")
right.legend()
figure.savefig("roller_freewheel_under_torque.png", dpi=110)
