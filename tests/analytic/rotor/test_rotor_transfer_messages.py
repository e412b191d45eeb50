"""What the transfer-matrix model refuses, and why."""

import pytest

from analytic.rotor.transfer_model import Disc, Link, Rotor, Segment, Shaft, Support
from analytic.rotor.transfer_modes import critical_speeds, natural_frequencies, whirl_frequencies
from analytic.rotor.transfer_response import unbalance_response
from analytic.rotor.transfer_supported import check_supported
from analytic.rotor.transfer_torsion import torsional_frequencies

SEGMENT = Segment(length=0.2, d_o=0.05)
SHAFT = Shaft(segments=(SEGMENT,) * 3)
HELD = (Support(node=0, kxx=1e8), Support(node=3, kxx=1e8))


def rotor(*supports, links=(), shafts=(SHAFT,)):
    return Rotor(shafts=shafts, supports=supports, links=links)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Segment(length=0.0, d_o=0.05), "length of a segment must be positive, got 0 m"),
        (lambda: Segment(length=float("nan"), d_o=0.05), "length of a segment must be positive"),
        (lambda: Segment(length=0.1, d_o=0.05, d_i=0.05), "0 <= d_i < d_o, got d_i = 0.05 m"),
        (lambda: Segment(length=0.1, d_o=0.05, d_i=-0.01), "0 <= d_i < d_o"),
        (lambda: Segment(length=0.1, d_o=0.05, E=-1.0), "Young's modulus must be positive"),
        (lambda: Segment(length=0.1, d_o=0.05, rho=0.0), "density must be positive"),
        (lambda: Segment(length=0.1, d_o=0.05, nu=0.6), "Poisson's ratio must be above -1"),
        (lambda: Segment(length=0.1, d_o=0.05, kappa=0.0), "shear coefficient must be positive"),
        (lambda: Shaft(segments=()), "a shaft needs a segment"),
        (lambda: Shaft(segments=(SEGMENT,), ratio=float("inf")), "ratio of speed must be finite"),
        (lambda: Disc(node=0, mass=-1.0, polar=0, diametral=0), "mass of a disc must not be neg"),
        (lambda: Support(node=0, kxx=-1.0), "stiffness must not be negative, got kxx = -1"),
        (lambda: Support(node=0, kxx=1.0, cyy=-1.0), "damping must not be negative, got cyy = -1"),
        (lambda: Support(node=0, kxx=1e8, kxy=2e8), "kxy must not exceed the root of kxx kyy"),
        (lambda: Link(a=1, b=1, kxx=1e8), "a link joins two stations, got 1 twice"),
        (lambda: Rotor(shafts=()), "a rotor needs a shaft"),
        (lambda: rotor(Support(node=4, kxx=1e8)), "support is at station 4, there are 0 to 3"),
        (lambda: rotor(links=(Link(a=0, b=9, kxx=1e8),)), "link is at station 9"),
        (lambda: Rotor(shafts=(SHAFT,), discs=(Disc(node=-1, mass=1, polar=0, diametral=0),)),
         "disc is at station -1"),
        (lambda: Rotor(shafts=(SHAFT,), theory="saint-venant"),
         "theory is one of timoshenko, rayleigh, euler"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    ("free", "message"),
    [
        (rotor(), "no bearing holds it"),
        (rotor(Support(node=0, kxx=1e8)), "shaft 1 .*tilts freely in x and y"),
        (rotor(Support(node=0, kxx=1e8), Support(node=3, kxx=1e8, kyy=0.0)), "freely in y"),
        (rotor(Support(node=0, kxx=0.0, k_tilt=1e5)), "shaft 1 shifts freely"),
        (rotor(*HELD, shafts=(SHAFT, SHAFT)), "shaft 2 .*freely"),
        (rotor(*HELD, shafts=(SHAFT, SHAFT), links=(Link(a=1, b=5, kxx=1e8),)),
         "shaft 2 .*tilts freely"),
    ],
)  # fmt: skip
def test_a_rotor_that_can_move_as_a_rigid_body_is_refused_with_its_motion(free, message):
    with pytest.raises(ValueError, match=message):
        check_supported(free)
    with pytest.raises(ValueError, match="unsupported rotor"):
        natural_frequencies(free, 0.0)
    with pytest.raises(ValueError, match="unsupported rotor"):
        unbalance_response(free, 100.0, {0: 1e-5})


def test_one_bearing_that_resists_tilting_is_enough():
    check_supported(rotor(Support(node=0, kxx=1e8, k_tilt=1e5)))
    check_supported(rotor(*HELD, shafts=(SHAFT, SHAFT), links=(Link(a=1, b=5, kxx=1e8, k_tilt=1),)))


def test_shafts_are_named_where_they_have_names():
    with pytest.raises(ValueError, match="shaft inner"):
        check_supported(rotor(*HELD, shafts=(SHAFT, SHAFT)), ("outer", "inner"))


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda r: natural_frequencies(r, 0.0, count=0), "count must be at least 1"),
        (lambda r: torsional_frequencies(r, count=0), "count must be at least 1"),
        (lambda r: critical_speeds(r, excitation=0.0), "excitation must be a number other than 0"),
        (lambda r: unbalance_response(r, -1.0, {0: 1e-5}), "speeds must be finite and not neg"),
        (lambda r: unbalance_response(r, 100.0, {}), "needs an unbalance"),
        (lambda r: unbalance_response(r, 100.0, {7: 1e-5}), "unbalance is at station 7"),
    ],
)
def test_questions_without_an_answer_are_refused(ask, message):
    with pytest.raises(ValueError, match=message):
        ask(rotor(*HELD))


def test_circles_are_asked_of_like_bearings_alone():
    unlike = rotor(HELD[0], Support(node=3, kxx=1e8, kyy=5e7))
    with pytest.raises(ValueError, match="no forward and backward circles"):
        whirl_frequencies(unlike, 0.0)
