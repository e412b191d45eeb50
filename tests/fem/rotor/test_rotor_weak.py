"""Turning shafts as weak forms: closed forms, no locking, stepped shafts, refusals."""

import numpy as np
import pytest
from skfem import MeshLine

from analytic.rotor.shafts import UniformShaft, hutchinson
from fem.rotor.weak import weak_shaft

E, NU, RHO, L = 210e9, 0.3, 7850.0, 0.6
SPEED = 2000.0


def uniform(d):
    return UniformShaft(L=L, d_o=d, E=E, nu=NU, rho=RHO, kappa=hutchinson(nu=NU))


def weak(s, cells, theory="timoshenko"):
    mesh = MeshLine(np.linspace(0, s.L, cells + 1))
    return weak_shaft(
        mesh, bending=E * s.I, shear=s.S, mass=RHO * s.A, rotary=RHO * s.I, theory=theory
    )  # fmt: skip


@pytest.mark.parametrize(
    ("theory", "d"), [("euler", 0.018), ("rayleigh", 0.2), ("timoshenko", 0.2)]
)
def test_whirl_converges_to_the_closed_form_at_order_four(theory, d):
    s = uniform(d)
    exact = np.array([s.whirl(j, Omega=SPEED, theory=theory) for j in (1, 2, 3)]).T
    errors = np.array([
        np.array(weak(s, cells, theory).whirl(SPEED, held=[0, L])) / exact - 1
        for cells in (8, 16, 32)
    ])  # fmt: skip
    assert np.all(errors > 0)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(np.full((2, 3), 4), abs=0.1)
    assert errors[2, :, 0] == pytest.approx(0, abs=3e-7)


def test_splitting_has_as_many_digits_at_a_low_speed_where_a_difference_has_four():
    own = weak(uniform(0.06), 16)
    slow, fast = 1e-4, 1.0
    expected = own.splitting(fast, held=[0, L]) * slow / fast
    assert own.splitting(slow, held=[0, L]) == pytest.approx(expected, rel=1e-9)
    forward, backward = own.whirl(slow, held=[0, L])
    assert abs((forward - backward) / expected - 1).max() > 1e-7


def test_a_stout_shaft_on_springs_bounces_and_rocks_as_if_rigid():
    """Two springs k at the ends: w^2 = 2 k/m, and k L^2/2 over m L^2/12 + rho I L."""
    s, k = uniform(0.2), 1e3
    found = weak(s, 8).on_springs({0.0: k, L: k}).whirl(0.0, count=2)[0]
    m = RHO * s.A * L
    rocking = np.sqrt(k * L**2 / 2 / (m * L**2 / 12 + RHO * s.I * L))
    assert found == pytest.approx([np.sqrt(2 * k / m), rocking], rel=1e-5)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"theory": "bernoulli"}, "a theory is one of"),
        ({"shear": 0.0}, "shear must be positive"),
        ({"mass": np.nan}, "mass must be positive"),
    ],
)
def test_what_makes_no_sense_is_refused(wrong, said):
    right = {"bending": 1.0, "shear": 1.0, "mass": 1.0, "rotary": 1.0}
    with pytest.raises(ValueError, match=said):
        weak_shaft(MeshLine(np.linspace(0, 1, 3)), **(right | wrong))
    with pytest.raises(ValueError, match=r"no node at z=0\.31"):
        weak(uniform(0.05), 4).whirl(0.0, held=[0.31])
