"""Rotating shafts in closed form and in three dimensions: roots, limits, mutual comparison."""

import numpy as np
import pytest

from analytic.rotor.cylinder import Cylinder
from analytic.rotor.pochhammer import bending_frequency
from analytic.rotor.shafts import UniformShaft, cowper, hutchinson

E, NU, RHO, R = 210e9, 0.3, 7850.0, 0.03
THEORIES = ("euler", "rayleigh", "timoshenko")


def shaft(L=0.5, m=0.0, kappa=None, unit=1.0):
    """All lengths in `unit` of a metre: stress goes with 1/unit, density with 1/unit^4 (t, s)."""
    return UniformShaft(
        L=L / unit, d_o=2 * R / unit, d_i=2 * R * m / unit, E=E * unit, nu=NU,
        rho=RHO * unit**3, kappa=hutchinson(nu=NU, m=m) if kappa is None else kappa,
    )  # fmt: skip


def cylinder(m=0.0, **more):
    return Cylinder(r_o=R, r_i=m * R, E=E, nu=NU, rho=RHO, **more)


@pytest.mark.parametrize("theory", THEORIES)
@pytest.mark.parametrize("backward", [False, True])
@pytest.mark.parametrize("L", [0.2, 1.0])
def test_at_a_critical_speed_the_shaft_whirls_at_that_speed(theory, backward, L):
    s = shaft(L=L)
    speed = s.critical_speed(1, theory=theory, backward=backward)
    pair = s.whirl(1, Omega=speed, theory=theory)
    assert pair[backward] == pytest.approx(speed, rel=1e-12)


@pytest.mark.parametrize(
    ("coefficient", "power"), [(hutchinson, 4), (cowper, 2)], ids=["Hutchinson", "Cowper"]
)
@pytest.mark.parametrize("m", [0.0, 0.5, 0.9])
def test_hutchinson_s_coefficient_leaves_an_error_of_order_four(coefficient, power, m):
    """Against exact elasticity, at waves four times as long."""
    errors = []
    for k in (0.08 / R, 0.02 / R):
        s = shaft(L=np.pi / k, m=m, kappa=coefficient(nu=NU, m=m))
        exact = cylinder(m).whirl(k)[0][0]
        errors.append(s.whirl(1, theory="timoshenko")[0] / exact - 1)
    assert np.log(errors[0] / errors[1]) / np.log(4) == pytest.approx(power, abs=0.1)


@pytest.mark.parametrize("m", [0.0, 0.1, 0.5, 0.95])
@pytest.mark.parametrize("kr", [0.3, 1.0, 3.0])
def test_the_cylinder_s_polynomials_meet_pochhammer_s_and_gazis_s_determinant(m, kr):
    found = cylinder(m).whirl(kr / R)[0][0]
    exact = bending_frequency(k=kr / R, r_o=R, r_i=m * R, E=E, nu=NU, rho=RHO)
    assert found == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("m", [0.0, 0.5, 0.95])
def test_a_turning_cylinder_s_whirl_is_a_slender_shaft_s(m):
    k, Omega = 0.05 / R, 2e3
    exact = cylinder(m).whirl(k, Omega=Omega)
    s = shaft(L=np.pi / k, m=m)
    beam = s.whirl(1, Omega=Omega, theory="timoshenko")
    assert [float(w[0]) for w in exact] == pytest.approx(beam, rel=1e-5)
    split = exact[0][0] - exact[1][0]
    assert split == pytest.approx(beam[0] - beam[1], rel=(k * R) ** 2)
    for backward in (False, True):
        speed = s.critical_speed(1, theory="timoshenko", backward=backward)
        assert cylinder(m).critical_speeds(k, backward=backward)[0] == pytest.approx(
            speed, rel=1e-5
        )
