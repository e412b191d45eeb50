"""Expected errors of wedged sprags and of engagements: limits in which they vanish."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.bounds.sprag import engagement
from analytic.bounds.sprag.wedge import ELASTIC, SHARP, Bounds, times
from analytic.bounds.sprag.wedge_sizes import Race, Sizes
from analytic.sprag.closure import wedged
from analytic.sprag.elastic import ElasticSpragClutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import SpragClutchParts

RADII = {"R_i": 11.11e-3, "R_e": 19.44e-3, "r_i": 4.02e-3}
WALLS = {"R_id": 7.21e-3, "R_ed": 26.23e-3, "b": 4e-3, "l": 9e-3}


def bounds(N=3000.0, nu=0.3):
    sprag = LogSprag.from_wedge_angle(nu_0=0.055, **RADII)
    one = ElasticSpragClutch(SpragClutchParts(sprag=sprag, n_s=12, E=206e9, nu=nu, **WALLS))
    a = tuple(float(x) for x in one.half_widths(np.asarray(N)))
    races = tuple(
        Race(race.mean, float(race.at(x)), float(race.under(x)))
        for race, x in zip(one.races, a, strict=True)
    )
    sizes = Sizes(r_e=float(sprag.r_e), nu_0=0.055, z=12, E=206e9, nu=nu, E_plane=one.E_plane,
                  **RADII, **WALLS)  # fmt: skip
    return Bounds(sizes=sizes, N=N, at=wedged(one.clutch, N), a=a, races=races, column=one.column)


def test_a_light_load_leaves_the_squares_of_the_wedge_angle_and_what_polynomials_miss():
    light = bounds(N=1e-3)
    left = ELASTIC + math.tan(0.055) ** 2 / 2 + light.askew
    assert light.elastic()[1] == pytest.approx(left, rel=1e-6)
    assert light.elastic()[1] < bounds().elastic()[1]
    low, high = light.angle()
    assert low < 0 < high
    assert high - low < (lambda i: i[1] - i[0])(bounds().angle())


def test_without_poisson_s_effect_thin_rings_are_long_ones():
    for which in ("i", "e"):
        one = bounds(nu=0.0)
        assert one.thin_mean(which) == pytest.approx(one.long_mean(which), rel=4e-3)  # N for N_e
    assert bounds(nu=0.0).thin("i") == pytest.approx((-SHARP, SHARP), rel=1e-9)
    assert bounds(nu=0.3).thin("i")[0] > 0.02  # thin rings yield more


def test_a_force_is_as_wrong_as_the_torque_that_it_has_at_an_angle():
    one = bounds()
    (low, high), (less, more) = one.torque(), one.force()
    assert (1 + low) * (1 + more) == pytest.approx(1.0, rel=1e-12)
    assert (1 + high) * (1 + less) == pytest.approx(1.0, rel=1e-12)


def test_a_ratio_of_formulas_moves_the_interval_along():
    assert times((-0.01, 0.02), 1.5, spread=0.1) == pytest.approx((0.3365, 0.683), abs=1e-12)


def bounds_engagement(**changes):
    sizes = {"unequal": 1e-3, "passed_on": 1.2, "inertia": 5e-4, "left_out": 2e-4, "turns": False}
    return engagement.Bounds(**(sizes | changes))


def test_equal_forces_and_massless_sprags_leave_nothing_and_mass_widens_both_sides():
    one = bounds_engagement(unequal=0.0, inertia=0.0, left_out=0.0)
    for interval in (one.statics(), one.energy(), one.spring(), one.both(), one.either_way(2)):
        assert interval == (0.0, 0.0)
    assert one.radially() == (-engagement.BOOKED, engagement.BOOKED)
    low, high = bounds_engagement().spring()
    assert (low, high) == pytest.approx((-1.2e-3 - 5e-4, 5e-4))
    assert bounds_engagement().both() == pytest.approx((low - high, high - low))


@pytest.mark.parametrize(("r_i", "R_i"), [(4e-3, 11e-3), (11e-3, 4e-3)])
def test_the_wider_contact_is_that_over_its_smaller_radius(r_i, R_i):
    one = bounds()
    q = replace(one.sizes, r_i=r_i, R_i=R_i, r_e=5e-3)
    inner, outer = (replace(one, sizes=q, a=a) for a in ((4e-5, 1e-5), (1e-5, 1e-4)))
    assert inner.wide == pytest.approx(1e-4)
    assert outer.wide == pytest.approx(4e-4)


def test_the_thinner_of_wall_and_sprag_limits_the_half_space():
    """Walls of 3.9 and 6.79 mm, sprag 4 mm wide."""
    one = replace(bounds(), a=(1e-5, 2e-5))
    assert one.thin_body("i") == pytest.approx((1e-5 / 3.9e-3) ** 2, rel=1e-12)
    assert one.thin_body("e") == pytest.approx((2e-5 / 4e-3) ** 2, rel=1e-12)


def test_contacts_roll_by_the_tilt_of_walls_as_beams_over_a_pitch():
    """Simply supported, M at the middle: tilt M L/(12 E' I), which is s (1/r +- 1/R) of rolling."""
    one = bounds()
    q, tilts = one.sizes, []
    T = 3000.0 * math.tan(float(one.at.nu)) / 9e-3
    for R, h in ((11.11e-3, 3.9e-3), (19.44e-3, 6.79e-3)):
        M, pitch, bending = T * h / 2, 2 * math.pi * R / 12, q.E_plane * h**3 / 12
        tilts.append(M * pitch / (12 * bending))
    inner = tilts[0] / (1 / 4.02e-3 + 1 / 11.11e-3) / 11.11e-3
    outer = tilts[1] / (1 / q.r_e - 1 / 19.44e-3) / 19.44e-3
    assert one.tilted() * float(one.at.beta) == pytest.approx(inner + outer, rel=1e-12)
