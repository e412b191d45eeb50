"""Bounds of freewheel formulas: a second implementation of the wedge, limits, times of slip."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.bounds.freewheel import cup_bracket, intervals
from analytic.bounds.freewheel.cup import Approaches, Course, CupBounds
from analytic.bounds.freewheel.friction import FrictionBounds, at_limit, limit_load
from analytic.bounds.freewheel.parts import FreewheelParts, Loaded
from analytic.bounds.freewheel.slip_times import Rig
from analytic.bounds.freewheel.star import StarBounds
from analytic.bounds.freewheel.turn import Moved, of_turn, turned
from analytic.freewheel import criterion, rolling, state
from analytic.freewheel.compliance import compliance
from analytic.freewheel.geometry import InnerCam


def parts(clutch):
    cam = clutch.cam
    return FreewheelParts(
        sense=int(cam.sense), race=float(cam.race), flat=float(cam.flat), r=cam.r, z=cam.z,
        L=clutch.L, r_b=clutch.r_b, R_a=clutch.R_a, E=clutch.roller.E, nu=clutch.roller.nu,
    )  # fmt: skip


def sizes(now):
    names = ("N", "T", "alpha", "d_i", "d_o", "a_i", "a_o")
    return Loaded(**{name: float(getattr(now, name)) for name in names})


def bounds(star, T=26.0):
    return StarBounds(parts(star), sizes(state.loaded(star, T)))


def test_a_second_writing_of_the_wedge_meets_the_formulas(clutch):
    d, again = {"d_i": 6e-6, "d_o": 14e-6}, parts(clutch)
    for name in ("alpha", "arc", "centre", "distance"):
        found, formula = (np.array(getattr(one, name)(**d)) for one in (again, clutch.cam))
        assert found == pytest.approx(formula, rel=1e-14)
    assert again.corner == float(clutch.cam.corner)
    path = {name: value * np.linspace(0, 1, 50) for name, value in d.items()}
    assert again.rolled(**path) == pytest.approx(rolling.torsion(clutch.cam, **path), rel=1e-12)
    wide = clutch.half_widths(2e5)[0 if again.sense > 0 else 1]
    assert float(again.width_on_flat(2e5)) == pytest.approx(float(wide), rel=1e-14)


def test_intervals_of_a_star_hold_the_formulas_themselves(star):
    found = bounds(star)
    for low, high in (found.angle(), found.travel(), found.slope(), found.force(), found.contact(),
                      found.force_at_angle(), found.approach("d_o")):  # fmt: skip
        assert low < 0 < high
    formula = float(state.loaded(star, 26.0).d_i)
    assert found.d_i[0] < formula < found.d_i[1]


def course(cup, factors=(1.0, 1.0, 1.0), top=13e3):
    def approaches(N):
        d = compliance(cup).approaches(N / cup.L)
        return d.d_i, d.d_o

    return Course(parts(cup), Approaches(approaches, top), factors)


def test_a_hollow_shaft_winds_up_by_its_shear(star):
    """dphi/dr = T/(2 pi r³ G L): the difference over a thin tube."""
    one, T, r, wall = parts(star), 10.0, 1e-2, 1e-7
    G = one.E / (2 * (1 + one.nu))
    thin = T * wall / (2 * math.pi * r**3 * G * one.L)
    assert intervals.winding(one, T, r, r + wall) == pytest.approx(thin, rel=1e-4)


def test_the_limit_s_interval_is_that_of_the_criterion_at_other_angles():
    own, mu = 0.06, 0.08
    low, high = at_limit(lambda tan: math.sqrt((mu / tan) ** 2 - 1), own, (-0.01, 0.02), mu)
    at = {"T": 26.0, "R": 16.5e-3, "mu": mu}
    loads = [float(criterion.largest_axial_load(alpha=math.atan(tan), **at))
             for tan in (own, own / 0.99, own / 1.02)]  # fmt: skip
    assert (low, high) == pytest.approx(sorted(loads[0] / other - 1 for other in loads[1:]))


def test_the_interval_of_the_limit_load_is_that_of_the_criterion_at_the_ends_of_the_slope(star):
    """F_ax = T/R sqrt((mu/tan alpha)^2 - 1) with the error of tan(alpha) of one contact."""
    found = bounds(star)
    tan, slope = math.tan(found.at.alpha), found.slope(tilted=True)
    at = {"T": 26.0, "R": 16.5e-3, "mu": 0.2}
    own, *others = (float(criterion.largest_axial_load(alpha=math.atan(t), **at))
                    for t in (tan, *(tan / (1 + m) for m in slope)))  # fmt: skip
    expected = sorted(own / other - 1 for other in others)
    assert limit_load(found, mu=0.2) == pytest.approx(expected, rel=1e-9)


def test_bounds_of_contacts_grow_with_the_square_of_the_width_from_a_least_value_on(star):
    """Hertz replaces arcs by parabolas: 4 (a/r)^2, and no less than is required."""
    one, at = parts(star), bounds(star).at
    found = {share: intervals.of_contact(one, replace(at, a_i=share * one.r, a_o=0.0))
             for share in (0.01, 0.1, 0.2)}  # fmt: skip
    assert found[0.01] == (-intervals.LEAST, intervals.LEAST)
    assert found[0.1] == pytest.approx((-0.04, 0.04))
    assert found[0.2] == pytest.approx((-0.16, 0.16))
    certain = intervals.of_approach(1.0, (1.0, 1.0))
    assert certain == (-intervals.ASKED, intervals.ASKED)


def test_there_is_no_interval_where_the_torque_alone_may_slip(star):
    found = bounds(star)
    assert limit_load(found, mu=math.tan(found.at.alpha) * 1.0001) is None
    low, high = limit_load(found, mu=0.2)
    assert low < 0 < high
    close = FrictionBounds(found, mu=math.tan(found.at.alpha) * 1.01, lever=0.4)
    assert close.limit_load() is None
    assert close.limit_creep() is None


def test_the_turn_by_the_flats_is_the_formulas(star):
    off, T, cam = 5e-6, 26.0, star.cam

    def end(dX):
        clutch = replace(star, cam=InnerCam(R=cam.R, r=cam.r, X=cam.X + dX, z=cam.z))

        def approaches(N):
            d = compliance(clutch).approaches(N / clutch.L)
            return float(d.d_i), float(d.d_o)

        return Moved(parts(clutch), approaches), float(state.loaded(clutch, T).alpha)

    (low, alpha_low), (high, alpha_high) = end(-off), end(off)
    more = {"off": off, "F_t": T / (8 * 16.5e-3)}
    found = turned([low, high], bounds(star), f_i=1.0, f_o=1.0, **more)
    assert found == pytest.approx((alpha_high - alpha_low) / (2 * off), rel=1e-7)
    least, most = of_turn([low, high], bounds(star), **more)
    assert least < 0 < most


RIG = Rig(R=16.5e-3, T=26.0, T_m=0.0, T_critical=26.0, F_ax=3000.0, f=30.0, rise=0.1, duration=0.5)


def alike(_):
    """tan(alpha) that no torque changes."""
    return 0.06


@pytest.mark.parametrize("at", [0.35, 0.8])
def test_a_path_reaches_a_load_no_sooner_than_it_grows_to_it(at):
    """A ramp at F = at F_ax; a sine not before, and within half a swing, at its definition."""
    ramp, sine = (RIG.time_of_slip(path, at * RIG.F_ax, alike) for path in (1, 2))
    assert ramp == pytest.approx(RIG.rise + at * (RIG.duration - RIG.rise), rel=1e-12)
    assert ramp <= sine <= ramp + 0.5 / RIG.f
    turn = 2 * math.pi * 30 * (sine - 0.1)
    assert 3000 * (sine - 0.1) / 0.4 * abs(math.sin(turn)) == pytest.approx(3000 * at, rel=1e-9)


@pytest.mark.parametrize(
    ("F", "t"),
    [(1050.0, 0.175), (1150.0, 0.2)],  # grown after 5.25 cycles, and after 5.75: it overruns
)
def test_of_one_angle_the_path_in_phase_slips_as_its_amplitude_has_grown_and_it_locks(F, t):
    assert RIG.time_of_slip(3, F, alike) == pytest.approx(t, abs=1e-9)
    # a load that no path reaches has no time
    assert all(RIG.time_of_slip(path, 1.1 * RIG.F_ax, alike) == math.inf for path in (1, 2, 3))


def test_the_line_through_two_frictions_has_their_angles():
    lever = RIG.R * RIG.F_ax / RIG.T
    tan = RIG.tangent((1.0, 0.5), (0.07 * math.hypot(1, lever), 0.06 * math.hypot(1, lever)))
    assert [tan(T) for T in (26.0, 13.0, 19.5)] == pytest.approx([0.07, 0.06, 0.065], rel=1e-12)


def test_the_course_of_a_cup_is_the_formulas_and_a_softer_one_has_a_lower_summit(cup):
    now, found = state.loaded(cup, 10.0), course(cup).at(10.0)
    for name in ("N", "alpha", "s", "phi"):
        assert found[name] == pytest.approx(float(getattr(now, name)), rel=2e-4)
    assert course(cup).force(float(now.psi)) == pytest.approx(float(now.N), rel=1e-4)
    assert course(cup, (1.0, 1.1, 1.0)).summit < course(cup).summit
    at = sizes(state.loaded(cup, 10.0))
    low, high = CupBounds(parts(cup), at, course(cup).approaches).summit()
    assert low < 0 < high


def test_a_cup_is_stiffer_than_the_ring_outside_its_corners_and_the_more_flats_the_less(cup):
    P = 2e5
    found = [cup_bracket.expected_approach(replace(parts(cup), z=z), P) for z in (8, 16)]
    for low, middle, high in found:
        assert low < middle < high
    assert found[0][1] / found[0][0] > found[1][1] / found[1][0]


def test_tangential_forces_turn_the_ring_further(star):
    found = bounds(star)
    (low, high), (least, most) = found.torsion(), found.travel()
    tan = math.tan(found.at.alpha)
    assert (1 + least) / (1 + low) - 1 == pytest.approx(tan**2, rel=1e-9)
    assert (1 + most) / (1 + high) - 1 == pytest.approx(tan**2 / 2, rel=1e-9)


def test_along_its_axis_a_contact_is_less_sure_than_both_together(star):
    found = FrictionBounds(bounds(star), mu=0.08, lever=0.4)
    (low, high), (least, most) = found.both_contacts(), found.one_contact()
    assert least < low < 0 < high < most


def test_the_thinner_wall_tilts_the_surface(star):
    """2 P (1 - nu²)/(pi E h) at the depth h: 3.9 mm of the star, or what is left of the ring."""
    found = bounds(star)
    for R_a, wall in ((21e-3, 11.39565e-3 - 7.5e-3), (18e-3, 1.5e-3)):
        one = StarBounds(replace(found.star, R_a=R_a), found.at)
        tilt = 2 * found.at.N / 10e-3 * (1 - 0.3**2) / (math.pi * 206e9 * wall)
        assert one.tilt * math.tan(found.at.alpha) == pytest.approx(tilt, rel=1e-12)
