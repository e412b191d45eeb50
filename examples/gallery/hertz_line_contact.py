"""Hertz line contact of a roller on a race: pressure, and shear stress below the surface."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.contact import hertz_line
from analytic.contact.hertz_line_stress import largest_shear_stress, stresses
from analytic.contact.two_bodies import contact_modulus, relative_radius

P = 400e3  # N/m
R = relative_radius(R_1=4e-3, R_2=25e-3)
E_star = contact_modulus(E_1=206e9, nu_1=0.3, E_2=206e9, nu_2=0.3, assumption="plane strain")
a = hertz_line.half_width(P=P, R=R, E_star=E_star)
p_0 = hertz_line.peak_pressure(P=P, R=R, E_star=E_star)
tau, depth = largest_shear_stress(a=a, p_0=p_0)
print(f"half-width {a * 1e6:.1f} µm, peak pressure {p_0 / 1e6:.0f} MPa")
print(f"largest shear stress {tau / p_0:.4f} p_0 at {depth / a:.4f} a, handbook 0.30 and 0.78")

x, z = np.meshgrid(np.linspace(-2, 2, 161) * a, np.linspace(0.005, 2.5, 101) * a)
s_x, s_z, t_xz = stresses(x, z, a=a, p_0=p_0)
shear = np.hypot((s_x - s_z) / 2, t_xz) / p_0
plt.figure(figsize=(6, 4))
plt.contourf(x / a, z / a, shear, levels=np.linspace(0, 0.31, 32), cmap="viridis")
plt.colorbar(label="largest shear stress / peak pressure")
plt.plot(0, depth / a, "w+", ms=12)
plt.gca().invert_yaxis()
plt.xlabel("x / a")
plt.ylabel("depth / a")
plt.savefig("hertz_line_contact.png", dpi=110, bbox_inches="tight")
