"""Turning shafts in closed form and in three dimensions: roots, limits, and one another."""

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


@pytest.mark.parametrize("m", [0.0, 0.8])
@pytest.mark.parametrize("Omega", [0.0, 4e3, -4e3, 3e4])
@pytest.mark.parametrize("j", [1, 3])
def test_timoshenko_s_whirl_solves_the_two_equations_of_motion(m, Omega, j):
    """Of deflection Y sin kz and slope P cos kz: forces S k (k Y - P) and moments S (P - k Y)."""
    s = shaft(m=m)
    k = j * np.pi / s.L
    ahead, behind = s.whirl(j, Omega=Omega, theory="timoshenko")
    for w in (ahead, -behind):
        P_Y = (s.S * k**2 - s.rho * s.A * w**2) / (s.S * k)
        turn = s.S + s.E * s.I * k**2 + s.rho * s.I * (2 * w * Omega - w**2)
        assert turn * P_Y == pytest.approx(s.S * k, rel=1e-9)
        assert P_Y > 0  # slope and deflection go together: the lower pair


@pytest.mark.parametrize("Omega", [0.0, 4e3])
def test_rayleigh_s_whirl_is_timoshenko_s_without_shear_and_euler_s_without_inertia(Omega):
    stiff = shaft(kappa=1e9)
    assert stiff.whirl(2, Omega=Omega, theory="timoshenko") == pytest.approx(
        stiff.whirl(2, Omega=Omega, theory="rayleigh"), rel=1e-8
    )
    long = shaft(L=500.0)
    for theory in THEORIES:
        assert long.whirl(1, theory=theory) == pytest.approx(
            [np.pi**2 / 500**2 * np.sqrt(E / RHO) * R / 2] * 2, rel=1e-7
        )


@pytest.mark.parametrize("theory", ["rayleigh", "timoshenko"])
def test_turning_raises_forward_whirl_and_lowers_backward_whirl(theory):
    """By Omega rho I k^2 over the mass each, in a slender shaft."""
    s = shaft(L=3.0)
    ahead, behind = s.whirl(1, Omega=1e3, theory=theory)
    split = 2 * 1e3 * s.I * (np.pi / s.L) ** 2 / s.A
    assert ahead - behind == pytest.approx(split, rel=2e-3)
    assert s.whirl(1, Omega=-1e3, theory=theory) == pytest.approx((behind, ahead), rel=1e-12)


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


def test_pochhammer_s_shortest_waves_run_as_rayleigh_s_on_a_half_space():
    """0.9274 times the speed of shear at nu = 0.3: (2 - c^2)^2 = 4 sqrt((1 - c^2)(1 - 2/7 c^2))."""
    k = 60 / R
    shear = np.sqrt(E / (2 * (1 + NU)) / RHO)
    found = bending_frequency(k=k, r_o=R, E=E, nu=NU, rho=RHO) / (k * shear)
    assert found == pytest.approx(0.9274, rel=2e-3)


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


@pytest.mark.parametrize("m", [0.0, 0.5])
def test_a_cylinder_at_its_critical_speed_whirls_at_that_speed(m):
    k = 0.5 / R
    for backward in (False, True):
        speed = float(cylinder(m).critical_speeds(k, backward=backward)[0])
        found = cylinder(m).whirl(k, Omega=speed)[backward]
        assert found[0] == pytest.approx(speed, rel=1e-9)


def test_the_unit_of_length_changes_no_frequency():
    """Metres against millimetres with kg, s: E in kg/(mm s^2), rho in kg/mm^3."""
    small = Cylinder(r_o=R * 1e3, E=E / 1e3, nu=NU, rho=RHO / 1e9)
    assert small.whirl(10 / 1e3, Omega=1e3)[0] == pytest.approx(
        cylinder().whirl(10.0, Omega=1e3)[0], rel=1e-9
    )
    for theory in THEORIES:
        assert shaft(unit=1e-3).whirl(2, Omega=1e3, theory=theory) == pytest.approx(
            shaft().whirl(2, Omega=1e3, theory=theory), rel=1e-12
        )


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: shaft(L=-1.0), "L must be positive"),
        (lambda: shaft(m=1.0), "r_i/r_o < 1"),
        (lambda: shaft().whirl(0, theory="euler"), "numbered from 1, got j=0"),
        (lambda: cylinder(m=1.0), "0 <= r_i < r_o"),
        (lambda: Cylinder(r_o=1.0, E=1.0, nu=0.5, rho=1.0), "nu < 0.5"),
        (lambda: cylinder(powers=1), "two powers"),
        (lambda: cylinder().whirl(0.0), "positive, got k=0"),
        (lambda: bending_frequency(k=-1.0, r_o=1.0, E=1.0, nu=0.3, rho=1.0), "k > 0"),
        (lambda: hutchinson(nu=0.6), "nu=0.6"),
    ],
)
def test_what_makes_no_sense_is_refused(call, said):
    with pytest.raises(ValueError, match=said):
        call()
