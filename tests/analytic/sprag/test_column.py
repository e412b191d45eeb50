"""The elastic column: discs, convergence, what a flank takes away."""

import numpy as np
import pytest

from analytic.contact.hertz_line_approach import approach_to_centre
from analytic.sprag.column import Column, Outline, approach
from analytic.sprag.geometry import LogSprag

SPRAG = LogSprag.from_wedge_angle(R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3, nu_0=np.radians(3.15))
PATCHES = (112e-6, 154e-6)


def column(b=4e-3):
    return Column(sprag=SPRAG, b=b)


def at_first_contact(b=4e-3):
    outline = column(b).outline(turned=0.0, alpha_b=0.0)
    assert outline is not None
    return outline


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
def test_a_disc_of_any_size_and_place_yields_as_in_closed_form(nu):
    R, turn = 4e-3, np.linspace(-1.5, 1.5, 101)
    right = 0.02 + R * np.exp(1j * (turn + 0.3))
    left = 0.02 - R * np.exp(1j * (0.3 - turn))
    A, B = 0.02 - 1j * R * np.exp(0.3j), 0.02 + 1j * R * np.exp(0.3j)
    disc = Outline(A=A, B=B, left=left, right=right)
    exact = sum(float(approach_to_centre(P=1.0, a=a, R=R, E_plane=1.0)) for a in PATCHES)
    assert approach(disc, a=PATCHES, nu=nu) == pytest.approx(exact, rel=1e-9)


def test_the_sprag_s_approach_settles_with_the_degree():
    found = [approach(at_first_contact(), a=PATCHES, nu=0.3, degree=n) for n in (16, 24, 40)]
    assert abs(found[1] / found[2] - 1) < 1e-3
    assert abs(found[0] / found[2] - 1) < 2e-3


def test_a_sprag_yields_more_than_the_disc_about_and_a_narrow_one_more_than_a_wide_one():
    disc = sum(float(approach_to_centre(P=1.0, a=a, R=8.33e-3 / 2, E_plane=1.0)) for a in PATCHES)
    wide, middle, narrow = (
        approach(at_first_contact(b), a=PATCHES, nu=0.3) for b in (5.9e-3, 4e-3, 2e-3)
    )
    assert disc * 0.99 < wide < middle < narrow


def test_a_narrow_column_yields_as_a_bar_between_its_ends():
    b, h = 1e-3, 8.33e-3
    thin, thinner = (approach(at_first_contact(x), a=PATCHES, nu=0.3) for x in (b, 0.8e-3))
    bar = h / 0.8e-3 - h / b
    assert thinner - thin == pytest.approx(bar, rel=0.15)  # the ends' cones go with ln b


def test_contacts_beside_the_middle_yield_more():
    turned = column().outline(turned=0.25, alpha_b=0.25)
    assert turned is not None
    straight = approach(at_first_contact(), a=PATCHES, nu=0.3)
    assert straight * 1.01 < approach(turned, a=PATCHES, nu=0.3) < straight * 1.03


def test_half_widths_enter_by_their_logarithms():
    one, other = (approach(at_first_contact(), a=(a, 1e-4), nu=0.3) for a in (1e-4, 2e-4))
    assert one - other == pytest.approx(2 / np.pi * np.log(2), rel=1e-9)


def test_beyond_a_flank_there_is_no_outline():
    whole = column()
    assert 0.4 < whole.turned < 0.6
    assert 0.4 < whole.alpha_b < 0.6
    assert whole.stands(turned=0.999 * whole.turned, alpha_b=0.0)
    assert whole.outline(turned=1.001 * whole.turned, alpha_b=0.0) is None
    assert whole.outline(turned=0.0, alpha_b=1.001 * whole.alpha_b) is None


def test_flanks_are_b_apart():
    outline = at_first_contact()
    along = (outline.B - outline.A) / abs(outline.B - outline.A)
    for side, sign in ((outline.left, 1), (outline.right, -1)):
        assert np.abs(((side - outline.A) / along).imag).max() == pytest.approx(2e-3, rel=1e-9)
        assert np.all(sign * ((side - outline.A) / along).imag > 0)


def test_a_sprag_wider_than_it_is_round_is_refused():
    with pytest.raises(ValueError, match=r"wider than spiral or arc reach"):
        column(9e-3)


@pytest.mark.parametrize("a", [(0.0, 1e-4), (1e-4, -1e-4), (np.nan, 1e-4)])
def test_half_widths_must_be_positive(a):
    with pytest.raises(ValueError, match="half-width"):
        approach(at_first_contact(), a=a, nu=0.3)
