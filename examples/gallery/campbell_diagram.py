"""Campbell diagram: a rotor with two discs and its critical speeds by two independent models.

The diagram is computed with beam elements. The critical speeds are also computed with exact
transfer matrices.
"""

import matplotlib.pyplot as plt
import numpy as np

from analytic.rotor import transfer_model as exact
from analytic.rotor.transfer_modes import transfer_critical_speeds
from fem.rotor.campbell import campbell
from fem.rotor.model import Disc, Element, Rotor, Shaft, Support
from fem.rotor.parts import Material

STEEL = Material(E=210e9, nu=0.3, rho=7850.0)
discs = [Disc.cylinder(node, d_o=0.3, d_i=0.05, width=0.05, rho=7850.0) for node in (4, 9)]
elements = [Element(length=0.1, d_o=0.05, material=STEEL)] * 13
rotor = Rotor([Shaft(elements)], discs, [Support(node, kxx=5e7) for node in (0, 13)])

same = exact.TransferMatrixRotor(
    shafts=(exact.SegmentedShaft(segments=(exact.Segment(length=0.1, d_o=0.05),) * 13),),
    discs=tuple(
        exact.StationDisc(node=d.node, mass=d.mass, polar=d.polar, diametral=d.diametral)
        for d in discs
    ),
    supports=tuple(exact.StationSupport(node=node, kxx=5e7) for node in (0, 13)),
)  # fmt: skip
reference = transfer_critical_speeds(same, count=2, whirl="forward").w * 30 / np.pi

speeds = np.linspace(0, 1000, 51)
diagram = campbell(rotor, speeds, count=4)
r_min = 30 / np.pi
print("forward critical speeds by transfer matrices", *(f"{n:.0f}" for n in reference), "r/min")
crossings = diagram.crossings() * r_min
nearest = [crossings[np.abs(crossings - n).argmin()] for n in reference]
print("critical speeds from the diagram of beam elements", *(f"{n:.0f}" for n in nearest), "r/min")

for branch, whirl in zip(diagram.frequencies.T, diagram.whirl[-1], strict=True):
    plt.plot(speeds * r_min, branch / (2 * np.pi), "-" if whirl > 0 else "--", color="C0")
plt.plot(speeds * r_min, speeds / (2 * np.pi), color="0.5", label="excitation by unbalance")
plt.plot(reference, reference / 60, "o", color="C3", label="critical speeds, transfer matrices")
plt.xlabel("speed [r/min]")
plt.ylabel("frequency [Hz] (dashed: backward whirl)")
plt.ylim(0, 1.5 * speeds[-1] / (2 * np.pi))
plt.legend()
plt.savefig("campbell_diagram.png", dpi=110, bbox_inches="tight")
