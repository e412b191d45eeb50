"""The approach in line contact against the strain below it, summed up by quadrature."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line_approach as approach
from analytic.contact import hertz_line_stress

BODY = {"P": 2.0, "a": 0.3, "E": 5.0, "nu": 0.3}


@pytest.mark.parametrize("d", [0.01, 0.3, 4.0])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_approach_is_the_strain_summed_up_to_the_depth(d, assumption):
    """Hooke's law in space, sigma_y included, on the stresses of the other module."""
    contact = {"a": 0.3, "p_0": 2 * 2.0 / (np.pi * 0.3)}  # P = pi a p_0/2

    def strain(z):
        sx, sz, _ = hertz_line_stress.stresses(0.0, z, **contact)
        sy = hertz_line_stress.transverse_stress(0.0, z, **contact, nu=0.3, assumption=assumption)
        return float(sz - 0.3 * (sx + sy)) / 5.0

    shortened, _ = quad(strain, 0, d, epsabs=1e-12)
    value = approach.approach_to_depth(d, **BODY, assumption=assumption)
    assert float(value) == pytest.approx(-shortened, rel=1e-9)


def test_at_the_contact_itself_there_is_no_approach():
    assert float(approach.approach_to_depth(0.0, **BODY, assumption="plane strain")) == 0


@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_far_below_the_logarithm_takes_over_at_the_second_order(assumption):
    d = np.array([30.0, 60.0])
    exact = approach.approach_to_depth(d, **BODY, assumption=assumption)
    left = exact - approach.approach_to_far_depth(d, **BODY, assumption=assumption)
    assert left[0] / left[1] == pytest.approx(4.0, rel=1e-3)


def test_the_middle_of_a_disc_is_nearer_than_that_depth_of_a_half_plane_in_johnson_s_ratio():
    """Difference (P/pi E')(2 ln 2 - 1 + nu'), here with P = pi, E' = 1, nu' = 1/4, by hand."""
    plane = approach.approach_to_far_depth(
        1.0, P=np.pi, a=1e-3, E=1.0, nu=0.25, assumption="plane stress"
    )
    disc = approach.approach_to_centre(P=np.pi, a=1e-3, R=1.0, E_plane=1.0)
    assert float(disc - plane) == pytest.approx(2 * np.log(2) - 1 + 0.25, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"d": -1.0}, "depth"),
        ({"P": 0.0}, "load per length"),
        ({"a": np.nan}, "half-width"),
        ({"E": np.inf}, "Young's modulus"),
        ({"nu": 0.5}, "Poisson's ratio"),
        ({"assumption": "free"}, "assumption"),
    ],
)
def test_input_that_makes_no_sense_is_refused(change, message):
    sound = {"d": 1.0, **BODY, "assumption": "plane strain"} | change
    with pytest.raises(ValueError, match=message):
        approach.approach_to_depth(sound.pop("d"), **sound)


def test_a_contact_wider_than_its_disc_is_refused():
    with pytest.raises(ValueError, match=r"below the radius, got a=1\.0 m, R=1\.0 m"):
        approach.approach_to_centre(P=1.0, a=1.0, R=1.0, E_plane=1.0)
