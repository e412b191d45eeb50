"""Hertz's line contact against hand values, the definition of its constants and its integral."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line

ROLLER = {"P": 3.0, "R": 0.7, "E_star": 400.0}


def test_the_pressure_carries_the_load():
    a, p_0 = float(hertz_line.half_width(**ROLLER)), float(hertz_line.peak_pressure(**ROLLER))
    total, _ = quad(lambda x: float(hertz_line.pressure(x, a=a, p_0=p_0)), -a, a)
    assert total == pytest.approx(ROLLER["P"], rel=1e-9)


def test_the_pressure_bends_a_half_plane_to_the_parabola():
    """Slope of the surface -2/(pi E*) times the principal value of p/(x - t), here x/R.

    The singularity is taken out by hand: the principal value of 1/(x - t) over (-a, a) is
    ln((a + x)/(a - x)).
    """
    a, p_0 = float(hertz_line.half_width(**ROLLER)), float(hertz_line.peak_pressure(**ROLLER))

    def p(t):
        return float(hertz_line.pressure(t, a=a, p_0=p_0))

    x = 0.4 * a
    regular, _ = quad(lambda t: (p(t) - p(x)) / (x - t), -a, a, points=[x], epsabs=1e-10)
    principal = regular + p(x) * np.log((a + x) / (a - x))
    assert 2 / (np.pi * ROLLER["E_star"]) * principal == pytest.approx(x / 0.7, rel=1e-8)


def test_pressure_vanishes_beyond_the_contact():
    np.testing.assert_array_equal(
        hertz_line.pressure([-2.0, -1.0, 0.0, 3.0], a=1.0, p_0=5.0), [0, 0, 5, 0]
    )


@pytest.mark.parametrize(
    ("assumption", "expected"),
    [
        ("plane stress", 1.2),  # 1/2 + 1/3 = 5/6
        ("plane strain", 1 / (0.75 / 2 + 0.96 / 3)),  # (1 - 0.25)/2 + (1 - 0.04)/3
    ],
)
def test_contact_modulus_adds_the_compliances(assumption, expected):
    pair = {"E_1": 2.0, "nu_1": -0.5, "E_2": 3.0, "nu_2": 0.2}
    modulus = hertz_line.contact_modulus(**pair, assumption=assumption)
    assert float(modulus) == pytest.approx(expected, rel=1e-14)


def test_equal_bodies_are_twice_as_soft_as_one_on_a_rigid_flat():
    one = {"E_1": 2e11, "nu_1": 0.3, "assumption": "plane strain"}
    rigid = hertz_line.contact_modulus(**one, E_2=np.inf, nu_2=0.1)
    assert float(hertz_line.contact_modulus(**one, E_2=2e11, nu_2=0.3)) == pytest.approx(rigid / 2)


def test_a_bore_touches_more_softly_than_a_flat_and_a_flat_more_than_a_shaft():
    bore, flat, shaft = hertz_line.relative_radius(R_1=1.0, R_2=[-1.5, np.inf, 1.5])
    assert float(bore) == pytest.approx(3.0)  # 1/(1 - 2/3)
    assert float(flat) == 1.0
    assert float(shaft) == pytest.approx(0.6)  # 1/(1 + 2/3)


@pytest.mark.parametrize(
    ("R_2", "R_1"), [(-1.0, 1.0), (-0.5, 1.0), (0.0, 1.0), (np.nan, 1.0), (2.0, -1.0), (2.0, 0.0)]
)
def test_radii_that_cannot_touch_are_refused(R_1, R_2):
    with pytest.raises(ValueError, match=r"R_2 must be positive or, for a bore|roller's radius"):
        hertz_line.relative_radius(R_1=R_1, R_2=R_2)


@pytest.mark.parametrize("name", ["P", "R", "E_star"])
@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf])
@pytest.mark.parametrize("formula", [hertz_line.half_width, hertz_line.peak_pressure])
def test_loads_and_bodies_that_make_no_sense_are_refused(formula, name, value):
    with pytest.raises(ValueError, match=r"must be positive and finite, got .* (N/m|m|Pa)$"):
        formula(**ROLLER | {name: value})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"nu_1": 0.5}, "Poisson's ratio"),
        ({"nu_2": -1.0}, "Poisson's ratio"),
        ({"nu_1": np.nan}, "Poisson's ratio"),
        ({"E_1": 0.0}, "Young's modulus"),
        ({"E_1": np.inf, "E_2": np.inf}, "one body must be elastic"),
        ({"assumption": "closed ends"}, "assumption is one of plane stress, plane strain"),
    ],
)
def test_materials_that_make_no_sense_are_refused(change, message):
    sound = {"E_1": 1.0, "nu_1": 0.3, "E_2": 1.0, "nu_2": 0.3, "assumption": "plane strain"}
    with pytest.raises(ValueError, match=message):
        hertz_line.contact_modulus(**sound | change)
