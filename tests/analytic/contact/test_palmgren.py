"""Palmgren's law: its units and what it refuses."""

import pytest

from analytic.contact import palmgren


def test_palmgrens_constant_in_si_is_his_in_millimetres():
    """By hand for 9 mm and 3400 N: 3.84e-5 x 1507.8 / 5.7995 = 9.983e-3 mm."""
    in_mm = 3.84e-5 * 3400**0.9 / 9**0.8
    assert in_mm == pytest.approx(9.983e-3, rel=1e-4)
    assert float(palmgren.approach(load=3400, length=9e-3)) == pytest.approx(
        1e-3 * in_mm, rel=1e-14
    )
    s_in_mm = 50 * (3.84e-5 / 9**0.8) ** (1 / 0.9)  # mm^(10/9)/N
    s = palmgren.compliance(length=9e-3, slices=50)
    assert float(s) == pytest.approx(s_in_mm * 1e-3 ** (10 / 9), rel=1e-14)


@pytest.mark.parametrize("name", ["load", "length"])
def test_palmgrens_law_refuses_what_makes_no_sense(name):
    with pytest.raises(ValueError, match=f"{name} must be positive and finite, got -1.0"):
        palmgren.approach(**{"load": 1.0, "length": 1.0, name: -1.0})
    with pytest.raises(ValueError, match="slices must be at least 1, got 0"):
        palmgren.compliance(length=1.0, slices=0)
