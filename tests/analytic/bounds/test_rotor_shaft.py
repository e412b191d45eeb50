"""Expected errors of beam theories: Timoshenko's equation anew, beside the formulas' own."""

import math

import pytest

from analytic.bounds.rotor import shaft
from analytic.rotor.shafts import UniformShaft, hutchinson

STEEL = {"E": 206e9, "nu": 0.3, "rho": 7850.0}


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("m", [0.0, 0.5, 0.9])
def test_shear_coefficients_are_hutchinson_s(nu, m):
    assert shaft.shear_coefficient(nu, m) == pytest.approx(hutchinson(nu=nu, m=m), rel=1e-14)


@pytest.mark.parametrize("j", [1, 2, 3])
@pytest.mark.parametrize("size", [(0.6, 0.06, 0.03), (0.6, 0.06, 0.0), (0.2, 0.06, 0.05)])
def test_frequencies_are_timoshenko_s(j, size):
    shape = dict(zip(("L", "d_o", "d_i"), size, strict=True)) | STEEL
    kappa = hutchinson(nu=0.3, m=shape["d_i"] / shape["d_o"])
    exact = UniformShaft(**shape, kappa=kappa).whirl(j, theory="timoshenko")[0]
    assert shaft.frequency(j, **shape) == pytest.approx(exact, rel=1e-11)


@pytest.mark.parametrize("theory", ["euler", "rayleigh"])
def test_the_interval_has_what_timoshenko_s_equation_adds_to_a_slender_shaft(theory):
    shape = {"L": 0.6, "d_o": 0.06, "d_i": 0.03} | STEEL
    own = UniformShaft(**shape, kappa=hutchinson(nu=0.3, m=0.5))
    e = (math.pi / 0.6) ** 2 * own.I / own.A
    low, high = shaft.neglected(theory, e, own.E * own.A / own.S)
    exact = own.whirl(1, theory=theory)[0] / shaft.frequency(1, **shape) - 1
    assert low < exact < high


def test_the_interval_is_silent_where_a_series_says_nothing():
    e, s = 0.0116, 2.9
    assert shaft.neglected("euler", 10 * e, s) is None
    low, high = shaft.neglected("euler", e, s)
    assert 0.015 < low < high < 0.023
