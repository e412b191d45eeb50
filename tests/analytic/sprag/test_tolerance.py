"""Derivatives of the wedge angle against differences of a given sprag's angles."""

import numpy as np
import pytest

from analytic.sprag.geometry import LogSprag, strut, triangle
from analytic.sprag.tolerance import sensitivities

STEP = 1e-5


@pytest.mark.parametrize("m", [0.03, 0.0892, 0.3])
@pytest.mark.parametrize("name", ["R_i", "R_e", "r_e", "m"])
def test_derivatives_are_those_of_the_angle(m, name):
    sprag = LogSprag(R_i=11.11, R_e=19.44, m=m, r_i=4.02)
    nominal = {"R_i": 11.11, "R_e": 19.44, "r_e": float(sprag.r_e), "m": m}

    def nu(change):
        x = nominal | {name: nominal[name] + change}
        found = triangle(OA=x["R_i"], OC_e=x["R_e"] - x["r_e"], m=x["m"])
        return strut(OA=x["R_i"], OB=x["R_e"], beta=found.beta)[0]

    expected = (nu(STEP) - nu(-STEP)) / (2 * STEP)
    assert float(getattr(sensitivities(sprag), name)) == pytest.approx(float(expected), rel=1e-7)


def test_all_sizes_together_do_not_change_the_angle():
    sprag = LogSprag(R_i=11.11, R_e=19.44, m=[0.05, 0.1], r_i=4.02)
    by = sensitivities(sprag)
    whole = by.R_i * 11.11 + by.R_e * 19.44 + by.r_e * sprag.r_e
    assert whole == pytest.approx(np.zeros(2), abs=1e-13)
