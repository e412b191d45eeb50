"""Partial slip (Cattaneo, Mindlin): the traction of a line contact under a tangential force."""

import matplotlib.pyplot as plt
import numpy as np

from analytic.contact import hertz_line
from analytic.contact.partial_slip import stick_half_width, traction

P, R, E_star, mu = 400e3, 4e-3, 113e9, 0.1  # N/m, m, Pa
a = hertz_line.half_width(P=P, R=R, E_star=E_star)
p_0 = hertz_line.peak_pressure(P=P, R=R, E_star=E_star)
share = 0.75  # of the largest tangential force mu P
c = stick_half_width(Q=share * mu * P, P=P, mu=mu, a=a)
print(f"stick zone {c / a:.3f} of the contact, closed form {np.sqrt(1 - share):.3f}")

x = np.linspace(-1.1 * a, 1.1 * a, 801)
plt.plot(x / a, mu * hertz_line.pressure(x, a=a, p_0=p_0) / 1e6, "k--", label="friction limit µ p")
for part in (0.25, 0.5, 0.75):
    q = traction(x, Q=part * mu * P, P=P, mu=mu, a=a)
    plt.plot(x / a, q / 1e6, label=f"Q = {part:g} µ P")
plt.xlabel("x / a")
plt.ylabel("tangential traction [MPa]")
plt.legend()
plt.savefig("partial_slip.png", dpi=110, bbox_inches="tight")
