"""Optimal crown of a roller: the logarithmic profile with unloaded ends and the lowest pressure.

A straight roller has pressure peaks at its ends. With the optimal crown, the largest pressure is
within a few per cent of the pressure under a uniform line load.
"""

import matplotlib.pyplot as plt
import numpy as np

from analytic.contact import strips
from analytic.contact.best_crown import best_crown
from analytic.contact.crown import logarithmic, slice_centres

load = 3407.0  # N
roller = {"length": 9e-3, "R": 2.95e-3, "E_star": 113e9}  # m, m, Pa
best = best_crown(load=load, **roller)
uniform = np.sqrt(load * roller["E_star"] / (np.pi * roller["length"] * roller["R"]))
print(f"optimal crown K_1 = {best.K_1:g}, K_2 = {best.K_2:g}, z_m = {best.z_m * 1e6:.1f} µm")
print(f"largest pressure {best.peak / uniform:.3f} times that of a uniform line load")

y = slice_centres(length=roller["length"], slices=161)
shape = {"length": roller["length"], "E_star": roller["E_star"], "load": load}
profiles = {
    "straight": np.zeros_like(y),
    "optimal": logarithmic(y, K_1=best.K_1, K_2=best.K_2, z_m=best.z_m, **shape),
    "too deep": logarithmic(y, K_1=3 * best.K_1, K_2=best.K_2, z_m=best.z_m, **shape),
}
for name, profile in profiles.items():
    pressed = strips.press_strips(profile, load=load, **roller)
    plt.plot(y * 1e3, pressed.pressure / 1e6, label=name)
plt.axhline(uniform / 1e6, color="0.5", ls="--", label="uniform line load")
plt.xlabel("distance from mid-length [mm]")
plt.ylabel("contact pressure [MPa]")
plt.ylim(0, 2e-6 * uniform)
plt.legend()
plt.savefig("optimal_crown.png", dpi=110, bbox_inches="tight")
