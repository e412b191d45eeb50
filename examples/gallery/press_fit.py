"""Press fit of a hub on a hollow shaft: pressure by Lamé and by finite elements in contact."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.contact.press_fit import Wall, contact_pressures
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.plane.material import Elastic
from meshes.join import join
from meshes.ring.quarter import quarter_ring

bore, seat, rim, overlap = 10.0, 25.0, 45.0, 0.02  # radii and interference on the radius [mm]
shaft, hub = Wall(bore, seat, 210e3, 0.3), Wall(seat, rim, 70e3, 0.33)
p = float(contact_pressures([shaft, hub], [overlap], assumption="plane stress")[0])

problem = ContactProblem(
    join({
        "shaft": quarter_ring(r_i=bore, r_o=seat, refine=2),
        "hub": quarter_ring(r_i=seat, r_o=rim, refine=2),
    }),
    materials={"shaft": Elastic(E=210e3, nu=0.3), "hub": Elastic(E=70e3, nu=0.33)},
    assumption="plane stress",
    supports={f"{part}.{cut}": "n" for part in ("shaft", "hub") for cut in ("x=0", "y=0")},
    contacts=[Pair(
        slave="shaft.rim", master="hub.bore", interference=overlap,
        slave_shape=Circle((0.0, 0.0), seat), master_shape=Circle((0.0, 0.0), seat, hollow=True),
    )],
)  # fmt: skip
step = problem.solve()
touch = step.touches[0]
mean = touch.normal_force / touch.weight.sum()
print(f"contact pressure {mean:.3f} MPa, Lamé {p:.3f} MPa")

for wall, loads, name in ((shaft, (0.0, p), "shaft"), (hub, (p, 0.0), "hub")):
    r = np.linspace(wall.r_i, wall.r_o, 60)
    radial, hoop = wall.stresses(r, p_i=loads[0], p_o=loads[1])
    plt.plot(r, hoop, label=f"hoop stress, {name}")
    plt.plot(r, radial, "--", label=f"radial stress, {name}")
for body in ("shaft.inner half", "shaft.outer half", "hub.inner half", "hub.outer half"):
    inside = step.plane.in_body(body)
    plt.plot(np.hypot(*inside.x), inside.polar()[2], "k.", ms=1)
plt.xlabel("radius [mm]")
plt.ylabel("stress [MPa], points: finite elements")
plt.legend()
plt.savefig("press_fit.png", dpi=110, bbox_inches="tight")
