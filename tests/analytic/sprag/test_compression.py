"""Eq. 7 and what the parts' compliance makes of Eqs. 6 to 8."""

import numpy as np
import pytest

from analytic.ring import rotating
from analytic.sprag.compression import sprag_compression
from analytic.sprag.parts import Parts


def test_eq_7_by_hand():
    """A bar of 8.33 mm and 4 x 9 mm² under 3407 N: 3407 x 8.33/(36 x 206 000) mm."""
    d = sprag_compression(N=3407.0, R_i=11.11e-3, R_e=19.44e-3, b=4e-3, l=9e-3, E=206e9)
    assert float(d) == pytest.approx(3.8269026e-6, rel=1e-7)


def test_the_compliance_has_eqs_6_and_7(parts):
    found = parts.palmgren().yields(np.array([0.0, 3407.0]))
    assert found.sprag.tolist() == pytest.approx([0.0, 3.8269026e-6], rel=1e-7)
    scale = 3407 * 12 / (2 * np.pi * 9e-3 * 206e9)
    i, e = (
        (11.11**2 + 7.21**2) / (11.11**2 - 7.21**2),
        (26.23**2 + 19.44**2) / (26.23**2 - 19.44**2),
    )
    assert found.race_i[1] == pytest.approx(scale * (i - 0.3), rel=1e-12)
    assert found.race_e[1] == pytest.approx(scale * (e + 0.3), rel=1e-12)
    assert found.contact_i[1] == pytest.approx(3.84e-8 * 3407**0.9 / 9**0.8, rel=1e-12)
    five = found.contact_i + found.contact_e + found.race_i + found.race_e + found.sprag
    assert pytest.approx(five, rel=1e-14) == found.H


def test_two_bodies_of_one_steel_have_half_its_plane_strain_modulus(parts):
    assert float(parts.E_star) == pytest.approx(206e9 / 0.91 / 2, rel=1e-14)


def test_speed_makes_the_outer_race_grow_by_eq_8(parts):
    fast = Parts(**(vars_of(parts) | {"omega": 1000.0}))
    bore = rotating.radial_displacement(
        19.44e-3, r_i=19.44e-3, r_o=26.23e-3, rho=7850.0, omega=1000.0, E=206e9, nu=0.3,
        assumption="plane stress",
    )  # fmt: skip
    assert float(fast.palmgren().yields(1.0).d_ce) == float(bore)
    assert float(parts.palmgren().yields(1.0).d_ce) == 0.0


def test_long_bodies_yield_in_plane_strain_and_their_dents_hold_the_bar(parts):
    """Rings by Lamé in plane strain: Eq. 6 with E/(1 - nu²) and nu/(1 - nu); no Eq. 7."""
    found, scale = parts.plane().yields(3407.0), 3407 * 12 / (2 * np.pi * 9e-3 * 206e9 / 0.91)
    i = (11.11**2 + 7.21**2) / (11.11**2 - 7.21**2)
    e = (26.23**2 + 19.44**2) / (26.23**2 - 19.44**2)
    assert float(found.race_i) == pytest.approx(scale * (i - 3 / 7), rel=1e-12)
    assert float(found.race_e) == pytest.approx(scale * (e + 3 / 7), rel=1e-12)
    assert float(found.sprag) == 0.0


def test_rigid_races_are_liu_s_model(parts):
    stiff, free = (c.yields(100.0) for c in (parts.palmgren().rigid_races(), parts.palmgren()))
    assert float(stiff.race_i + stiff.race_e) == 0.0
    assert float(stiff.contact_i) == float(free.contact_i)
    assert float(stiff.sprag) == float(free.sprag)


def vars_of(parts):
    names = ("sprag", "n_s", "l", "b", "R_id", "R_ed", "E", "nu", "rho", "omega")
    return {name: getattr(parts, name) for name in names}


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"b": 6e-3}, "sprags touch each other"),
        ({"R_id": 12e-3}, "R_id below R_i"),
        ({"R_ed": 19e-3}, "R_ed above R_e"),
        ({"n_s": 2.5}, "must be whole"),
        ({"omega": -1.0}, "speed omega"),
        ({"nu": 0.6}, "Poisson"),
        ({"l": 0.0}, "length l"),
    ],
)
def test_parts_that_do_not_fit_are_refused(parts, change, told):
    with pytest.raises(ValueError, match=told):
        Parts(**(vars_of(parts) | change))
