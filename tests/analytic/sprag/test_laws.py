"""Laws of one contact: power, logarithm, slices."""

import numpy as np
import pytest

from analytic.contact import crown, slices
from analytic.contact.hertz_line_approach import approach_to_depth
from analytic.sprag.closure import at_torque, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.laws import palmgren_law, plane_law, sliced_law

N = np.geomspace(1.0, 1e4, 60)


@pytest.fixture
def contact(parts):
    """A crowned inner contact, 41 slices."""
    length, E_star = 9e-3, float(parts.E_star)
    y = crown.slice_centres(length=length, slices=41)
    gap = crown.logarithmic(
        y, K_1=1.0, K_2=0.7, z_m=1e-5, load=3407.0, length=length, E_star=E_star
    )
    return gap, {"R": float(parts.R_contact_i), "E_star": E_star}


def test_slices_are_met_between_their_loads(contact):
    gap, body = contact
    law = sliced_law(gap, l=9e-3, N_max=1e4, **body)
    exact = slices.press(gap - gap.min(), length=9e-3, load=N, **body).approach
    assert law(N) == pytest.approx(exact, rel=2e-3)
    assert law(np.array(1e4)) == pytest.approx(exact[-1], rel=1e-12)


def test_a_crown_that_is_nowhere_leaves_palmgren_s_exponent(contact):
    _, body = contact
    law = sliced_law(np.zeros(21), l=9e-3, N_max=1e4, loads=9, **body)
    slope = np.diff(np.log(law(N))) / np.diff(np.log(N))
    assert slope == pytest.approx(0.9, abs=0.01)
    assert law(N) == pytest.approx(palmgren_law(l=9e-3)(N), rel=0.05)


def test_sliced_laws_grow_from_nothing_and_end_at_their_largest_load(contact):
    gap, body = contact
    law = sliced_law(gap, l=9e-3, N_max=1e4, **body)
    assert law(np.array([0.0, np.nan, 1.01e4])).tolist() == pytest.approx(
        [0.0, np.nan, np.nan], nan_ok=True
    )
    way = law(np.geomspace(1e-6, 1e4, 500))
    assert np.all(np.diff(way) > 0)


def test_a_clutch_is_solved_up_to_the_last_load_of_its_slices(contact, parts):
    gap, body = contact
    law = sliced_law(gap, l=9e-3, N_max=1e4, **body)
    clutch = Clutch(
        sprag=parts.sprag, n_s=12, compliance=parts.compliance(contact_i=law, contact_e=law)
    )
    last = float(wedged(clutch, 1e4).T)
    assert float(at_torque(clutch, 0.999 * last).N) == pytest.approx(9990, rel=1e-3)
    assert np.isnan(at_torque(clutch, 1.001 * last).N)


def test_the_plane_law_adds_the_approaches_of_both_bodies():
    body = {"E": 200e9, "nu": 0.3}
    law = plane_law(l=2.0, r=1.0, R=-2.0, depth_sprag=0.5, depth_race=0.7, **body)
    P, R = 1e4 / 2.0, 2.0
    a = np.sqrt(4 * P * R / (np.pi * 200e9 / 0.91 / 2))
    each = [approach_to_depth(d, P=P, a=a, assumption="plane strain", **body) for d in (0.5, 0.7)]
    assert float(law(np.array(1e4))) == pytest.approx(sum(map(float, each)), rel=1e-12)
    assert float(law(np.array(0.0))) == 0.0


def test_negative_loads_are_refused():
    with pytest.raises(ValueError, match="normal force"):
        palmgren_law(l=1.0)(np.array(-1.0))
