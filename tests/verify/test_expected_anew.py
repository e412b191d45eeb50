"""What rows are held to is written anew: it meets the formulas, but for what it leaves out."""

import math

import pytest

from analytic.rotor import shafts
from verify.cases.rotor.clutch import bounds as rotor_clutch_expected
from verify.cases.rotor.clutch import tilted
from verify.cases.rotor.clutch.case import ClutchLink
from verify.cases.rotor.shaft import bounds as rotor_shaft_expected
from verify.cases.rotor.shaft.case import UniformShaft


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("m", [0.0, 0.5, 0.9])
def test_shear_coefficients_are_hutchinson_s(nu, m):
    assert rotor_shaft_expected.shear_coefficient(nu, m) == pytest.approx(
        shafts.hutchinson(nu=nu, m=m), rel=1e-14
    )


@pytest.mark.parametrize("j", [1, 2, 3])
@pytest.mark.parametrize("change", [{}, {"d_i": 0.0}, {"L": 0.2, "d_i": 0.05}])
def test_frequencies_are_timoshenko_s(j, change):
    q = UniformShaft(**change)
    anew = rotor_shaft_expected.frequency(q, j)
    assert anew == pytest.approx(q.shaft().whirl(j, theory="timoshenko")[0], rel=1e-11)


@pytest.mark.parametrize(
    "change", [{}, {"Z": 5}, {"e": 5e-6}, {"n_s": 2}, {"nu": math.radians(10)}, {"T": 1000.0}]
)
def test_couplings_are_those_of_eqs_3_to_11(change):
    q = ClutchLink(**change)
    by_formula = tilted.couplings(q)
    at = tilted.aside(q, q.delta_0)
    for entry, value in rotor_clutch_expected.summed(q, *at).items():
        assert value == pytest.approx(by_formula[entry], rel=1e-7), entry
