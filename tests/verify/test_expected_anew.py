"""What rows are held to is written anew: it meets the formulas, but for what it leaves out."""

import math

import pytest

from verify.cases.rotor.clutch import bounds as rotor_clutch_expected
from verify.cases.rotor.clutch import tilted
from verify.cases.rotor.clutch.case import ClutchLink


@pytest.mark.parametrize(
    "change", [{}, {"Z": 5}, {"e": 5e-6}, {"n_s": 2}, {"nu": math.radians(10)}, {"T": 1000.0}]
)
def test_couplings_are_those_of_eqs_3_to_11(change):
    q = ClutchLink(**change)
    by_formula = tilted.couplings(q)
    at = tilted.aside(q, q.delta_0)
    for entry, value in rotor_clutch_expected.summed(q, *at).items():
        assert value == pytest.approx(by_formula[entry], rel=1e-7), entry
