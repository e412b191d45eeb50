"""An engagement must not notice whether it is told in m, kg, s or in mm, t, s (forces in N)."""

import numpy as np
import pytest

from analytic.sprag.balance import balance
from analytic.sprag.clutch import Clutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import Parts
from analytic.sprag.table import tabulated
from analytic.sprag.transient import engage

MM, MPA, TONNE = 1e3, 1e-6, 1e-3


def engaged(k, s, t):
    sprag = LogSprag(R_i=11.11e-3 * k, R_e=19.44e-3 * k, m=0.09, r_i=4.02e-3 * k)
    parts = Parts(
        sprag=sprag, n_s=12, l=9e-3 * k, b=4e-3 * k, R_id=7.21e-3 * k, R_ed=26.23e-3 * k,
        E=206e9 * s, nu=0.3, rho=7850.0 * s / k**2, omega=500.0,
    )  # fmt: skip
    clutch = Clutch(sprag=sprag, n_s=12, compliance=parts.plane())
    inertia = t * k**2
    motion = Motion(
        m_g=1.8e-3 * t, I_g=1.18e-8 * inertia, I_bi=1.41e-3 * inertia, I_be=1.41e-3 * inertia,
        K_r=0.01 * k, alpha_max=0.02, C_rl=0.1 * k, k_out=1e5 * k, mu_s=0.06, mu_c=0.05,
        gamma_b=1.0 / k,
    )  # fmt: skip
    return engage(
        tabulated(clutch, N_end=20e3), motion, Torque.step(25.0 * k), duration=0.01, D_V=0.5 * k
    )


def test_forces_and_angles_keep_their_numbers_and_speeds_and_works_scale():
    si, mm = engaged(1.0, 1.0, 1.0), engaged(MM, MPA, TONNE)
    np.testing.assert_allclose(mm.N, si.N, rtol=1e-8, atol=1e-6)
    np.testing.assert_allclose(mm.alpha, si.alpha, rtol=1e-8)
    np.testing.assert_allclose(mm.v_i / MM, si.v_i, atol=1e-9)
    assert float(balance(mm).friction[-1]) == pytest.approx(
        float(balance(si).friction[-1]) * MM, rel=1e-6
    )
    assert mm.N_static == pytest.approx(si.N_static, rel=1e-10)
