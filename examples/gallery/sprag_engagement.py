"""Engagement of a sprag clutch: normal force over time under a suddenly applied torque.

The largest normal force of a sprag is nearly twice the static force. For an undamped linear spring
under a suddenly applied load, the factor would be 2. The first call compiles the time integration.
"""

import matplotlib.pyplot as plt
import numpy as np

from analytic.sprag import LogSprag, Motion, SpragClutchParts, engage_suddenly

parts = SpragClutchParts(
    sprag=LogSprag.from_wedge_angle(
        R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3, nu_0=np.radians(3.15)
    ),
    n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3,
)  # fmt: skip
motion = Motion(
    m_g=1.8e-3, I_g=1.18e-8, I_bi=1.41e-3, I_be=1.41e-3, K_r=0.01, alpha_max=0.5, C_rl=0.1,
    k_out=1e5, mu_s=0.12, mu_c=0.08, gamma_b=1.0,
)  # fmt: skip
course = engage_suddenly(parts, motion, T=25.0, duration=0.03)
print(f"the clutch {course.verdict}")
print(f"largest normal force {course.N_max:.0f} N, {course.peak_factor:.3f} times that at rest")

plt.plot(course.t * 1e3, course.N, label="engagement")
plt.axhline(course.N_static, color="0.5", ls="--", label="at rest")
plt.xlabel("time [ms]")
plt.ylabel("normal force of a sprag [N]")
plt.legend()
plt.savefig("sprag_engagement.png", dpi=110, bbox_inches="tight")
