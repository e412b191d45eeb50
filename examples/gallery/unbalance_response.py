"""Unbalance response of a Jeffcott rotor: a disc in the middle of a light shaft.

At the critical speed, only damping limits the amplitude. For an unbalance force m e ω² and a damper
c at the disc, the amplitude is m e ω/c.
"""

import matplotlib.pyplot as plt
import numpy as np

from fem.rotor.model import Disc, Element, Rotor, Shaft, Support
from fem.rotor.parts import Material
from fem.rotor.response import unbalance_response

LIGHT = Material(E=210e9, nu=0.3, rho=1e-3)
length, d, mass, c, unbalance = 1.0, 0.04, 20.0, 200.0, 1e-4  # m, m, kg, N s/m, kg m
shaft = Shaft([Element(length=length / 8, d_o=d, material=LIGHT)] * 8)
bearings = [Support(0, kxx=1e12), Support(8, kxx=1e12), Support(4, kxx=0.0, cxx=c)]
rotor = Rotor([shaft], [Disc(4, mass=mass)], bearings)

k = 48 * 210e9 * np.pi / 64 * d**4 / length**3  # Euler's beam; shear reduces the stiffness slightly
critical = np.sqrt(k / mass)
speeds = np.linspace(0.3 * critical, 2 * critical, 1500)
swing = unbalance_response(rotor, speeds, {4: unbalance})
amplitude = np.abs(swing.major(4))
peak = amplitude.argmax()
rpm = 30 / np.pi
print(f"critical speed {speeds[peak] * rpm:.0f} r/min, Euler's beam {critical * rpm:.0f} r/min")
expected = unbalance * speeds[peak] / c
print(f"largest amplitude {amplitude[peak] * 1e6:.1f} µm, m e ω/c = {expected * 1e6:.1f} µm")

plt.semilogy(speeds * rpm, amplitude * 1e6)
plt.axhline(unbalance / mass * 1e6, color="0.5", ls="--", label="eccentricity of the disc")
plt.xlabel("speed [r/min]")
plt.ylabel("amplitude of the disc [µm]")
plt.legend()
plt.savefig("unbalance_response.png", dpi=110, bbox_inches="tight")
