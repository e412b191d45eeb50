"""Torque and pressure as each other's inverse."""

from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from analytic.polyhedral import forces, torque, wedging

CHAIN = {"p_1r": 18e6, "mu": 0.08, "z": 6, "D_i": 0.10006, "d_i": 0.072, "b": 0.03}


@given(
    share=st.floats(-1, 0.99), over=st.floats(1e-3, 1e3), mu=st.floats(0.01, 0.9),
    z=st.integers(3, 48), p_1r=st.floats(0, 1e9),
)  # fmt: skip
def test_the_pressure_for_the_torque_of_a_pressure_is_that_pressure(share, over, mu, z, p_1r):
    chain = CHAIN | {"mu": mu, "z": z, "p_1r": p_1r, "share": share}
    p_t = p_1r + over * 1e6
    M_t = torque.torque(p_t=p_t, **chain)
    assert float(torque.required_pressure(M_t=M_t, **chain)) == pytest.approx(p_t, rel=1e-9)


def test_a_sweep_over_the_pressure_goes_from_nothing_to_no_limit():
    p_t = np.array([0.0, 18e6, 20e6, 22e6])
    none, touch, some, twice = torque.torque(p_t=p_t, share=0.4, **CHAIN)
    assert (none, touch) == (0, 0)
    assert twice == pytest.approx(2 * some)
    assert torque.torque(p_t=p_t, share=1.0, **CHAIN).tolist() == [0, 0, inf, inf]
    needed = torque.required_pressure(M_t=[0.0, 400.0], share=[0.4, 1.2], **CHAIN)
    assert needed.tolist() == [18e6, 18e6]


def test_the_hub_s_share_is_that_of_the_forces():
    hub = {"psi": np.radians([8.0, 16.0, 25.0]), "phi_1": 0.05}
    for gamma in (0.0, hub["psi"]):
        F_s = forces.radial_force(M_t=400.0, z=6, lever=0.03, **hub)
        by_hub = forces.normal_force(
            F=0.0, R=forces.contact_force(F_s=F_s, **hub), phi_1=0.05, gamma=gamma
        )
        N = wedging.least_normal_force(M_t=400.0, mu=0.08, z=6, D_i=0.1)
        share = torque.hub_share(mu=0.08, D_i=0.1, lever=0.03, gamma=gamma, **hub)
        np.testing.assert_allclose(share, by_hub / N, rtol=1e-12)
