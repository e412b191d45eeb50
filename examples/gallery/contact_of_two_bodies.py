"""Contact of two bodies: a disc pressed on a block, compared with Hertz's line contact."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.contact import hertz_line
from analytic.contact.two_bodies import contact_modulus
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import half_block
from meshes.contact.disc import quarter_disc
from meshes.join import join

R, P = 10.0, 800.0  # radius [mm], load per length [N/mm]
steel, aluminium = Elastic(E=210e3, nu=0.3), Elastic(E=70e3, nu=0.33)
E_star = contact_modulus(E_1=210e3, nu_1=0.3, E_2=70e3, nu_2=0.33, assumption="plane strain")
a = hertz_line.half_width(P=P, R=R, E_star=E_star)
p_0 = hertz_line.peak_pressure(P=P, R=R, E_star=E_star)

zone = float(1.5 * a)
problem = ContactProblem(
    join({
        "roller": quarter_disc(R=R, zone=zone, refine=2),
        "flat": half_block(width=8 * R, depth=8 * R, zone=zone, refine=2),
    }),
    materials={"roller": steel, "flat": aluminium}, assumption="plane strain",
    supports={"roller.axis": "x", "flat.axis": "x", "flat.bottom": "y"},
    contacts=[Pair(
        slave="roller.surface", master="flat.surface",
        slave_shape=Circle((0.0, R), R), master_shape=Flat(),
    )],
)  # fmt: skip
step = problem.solve(forces={"roller.middle": (0.0, -P / 2)})  # half the load on half a disc
touch = step.touches[0]
print(f"peak pressure {touch.peak:.0f} MPa, Hertz {p_0:.0f} MPa")
print(f"half-width {touch.half_width((0.0, 0.0)):.4f} mm, Hertz {a:.4f} mm")

x = np.linspace(0, 1.3 * float(a), 200)
plt.plot(x, hertz_line.pressure(x, a=a, p_0=p_0), label="Hertz")
near = touch.x[0] < x[-1]
plt.plot(touch.x[0][near], touch.pressure[near], "o", ms=4, label="finite elements")
plt.xlabel("distance from the middle [mm]")
plt.ylabel("contact pressure [MPa]")
plt.legend()
plt.savefig("contact_of_two_bodies.png", dpi=110, bbox_inches="tight")
