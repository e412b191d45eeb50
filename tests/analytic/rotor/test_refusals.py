"""Invalid clutches, shafts and rotors are refused in words."""

import math

import numpy as np
import pytest

from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import SpragCoupling, even_angles, with_axial
from analytic.rotor.clutch_state import preload_twist, under_loads
from analytic.rotor.cylinder import Cylinder
from analytic.rotor.shafts import UniformShaft, hutchinson
from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_modes import (
    natural_frequencies,
    transfer_critical_speeds,
    whirl_frequencies,
)
from analytic.rotor.transfer_response import transfer_unbalance_response
from analytic.rotor.transfer_supported import check_supported

SPRAG = {"R_i": 11.11e-3, "nu": math.radians(3.15), "L": 9e-3, "k_n": 5.7e8}
SHAFT = {"L": 0.5, "d_o": 0.06, "d_i": 0.0, "E": 210e9, "nu": 0.3, "rho": 7850.0, "kappa": 0.9}
CYLINDER = {"r_o": 0.03, "r_i": 0.0, "E": 210e9, "nu": 0.3, "rho": 7850.0}


SEGMENT = Segment(length=0.2, d_o=0.05)
THREE = SegmentedShaft(segments=(SEGMENT,) * 3)
HELD = (StationSupport(node=0, kxx=1e8), StationSupport(node=3, kxx=1e8))
UNLIKE = (HELD[0], StationSupport(node=3, kxx=1e8, kyy=5e7))


def rotor(*supports, shafts=(THREE,), **parts):
    return TransferMatrixRotor(shafts=shafts, supports=supports, **parts)


def clutch(**change):
    return SpragCoupling(**{"psi": even_angles(Z=12), "n_s": 11} | SPRAG | change)


REFUSED = [
    *[(lambda change=change: clutch(**change), message) for change, message in (
        ({"nu": 1.6}, "nu must lie between 0 and pi/2"),
        ({"n": 0.5}, "n must be at least 1"),
        ({"n_s": 0}, "n_s must be at least 1, got 0"),
        ({"psi": np.array([0.0, 1.0, 1.0 + 2 * math.pi])}, "three different angles"),
        ({"crown": lambda x: np.zeros(7)}, "a finite drop"),
        ({"interference": np.zeros(5)}, "for each of 12 sprags"),
    )],
    (lambda: even_angles(Z=2), "Z must be at least 3, got 2: two sprags cannot transmit"),
    (lambda: even_angles(Z=5, missing=(5,)), "between 0 and 4, got 5"),
    (lambda: clutch().loads([0.0] * 6), "q must have 5 displacements"),
    (lambda: with_axial(np.eye(6)), "5, 5"),
    (lambda: uniform.radial_stiffness(Z=2, k=1.0), "Z must be at least 3, got 2"),
    (lambda: uniform.tilting_stiffness(Z=3, k=1.0, L=1.0, n_s=0.5), "n_s must be"),
    (lambda: preload_twist(clutch(), T=[1.0, -2.0]), "T must be positive and finite, got -2 N m"),
    (lambda: preload_twist(clutch(), T=1.0, offset=(0, 0, 0)), "four finite numbers"),
    (lambda: under_loads(clutch(), [0, 0, 0, 0, -1.0]), "a positive torque"),
    (lambda: under_loads(clutch(n_s=1), [0, 0, 1.0, 0, 1.0]), "cannot transmit a bending moment"),
    (lambda: UniformShaft(**SHAFT | {"d_i": 0.06}), "r_i/r_o < 1|0 <= d_i < d_o"),
    (lambda: UniformShaft(**SHAFT).whirl(0, theory="euler"), "at least 1, got j=0"),
    (lambda: Cylinder(**CYLINDER | {"r_i": 0.03}), "0 <= r_i < r_o"),
    (lambda: Cylinder(**CYLINDER, powers=1), "number of powers"),
    (lambda: hutchinson(nu=0.6), "nu=0.6"),
    (lambda: Segment(length=0.0, d_o=0.05), "length of a segment must be positive, got 0 m"),
    (lambda: Segment(length=0.1, d_o=0.05, d_i=0.05), "0 <= d_i < d_o, got d_i = 0.05 m"),
    (lambda: Segment(length=0.1, d_o=0.05, nu=0.6), "Poisson's ratio must be above -1"),
    (lambda: SegmentedShaft(segments=()), "at least one segment"),
    (lambda: SegmentedShaft(segments=(SEGMENT,), ratio=math.inf), "must be finite, got inf"),
    (lambda: StationDisc(node=0, mass=-1.0, polar=0, diametral=0),
     "mass of a disc must not be neg"),
    (lambda: StationSupport(node=0, kxx=-1.0), "stiffness must not be negative, got kxx = -1"),
    (lambda: StationSupport(node=0, kxx=1e8, kxy=2e8), "kxy must not exceed the square root"),
    (lambda: StationLink(a=1, b=1, kxx=1e8), "two different stations, got 1 twice"),
    (lambda: TransferMatrixRotor(shafts=()), "at least one shaft"),
    (lambda: rotor(StationSupport(node=4, kxx=1e8)), "existing station, got 4, the last"),
    (lambda: rotor(links=(StationLink(a=0, b=9, kxx=1e8),)), "existing station, got 9"),
    (lambda: rotor(theory="saint-venant"), "theory must be one of timoshenko, rayleigh, euler"),
    (lambda: natural_frequencies(rotor(*HELD), 0.0, count=0), "count must be at least 1"),
    (lambda: transfer_critical_speeds(rotor(*HELD), excitation=0.0),
     "must be finite and not 0"),
    (lambda: transfer_unbalance_response(rotor(*HELD), -1.0, {0: 1e-5}),
     "speeds must be finite and not"),
    (lambda: transfer_unbalance_response(rotor(*HELD), 100.0, {}), "at least one unbalance"),
    (lambda: transfer_unbalance_response(rotor(*HELD), 100.0, {7: 1e-5}),
     "an unbalance must be at an existing station, got 7"),
    (lambda: whirl_frequencies(rotor(*UNLIKE), 0.0), "equal in x and y"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_what_makes_no_sense_is_refused_in_words(call, message):
    with pytest.raises(ValueError, match=message):
        call()


@pytest.mark.parametrize(
    ("free", "message"),
    [
        (rotor(), "no bearing supports it"),
        (rotor(StationSupport(node=0, kxx=1e8)), "shaft 1 .*tilts freely in x and y"),
        (rotor(HELD[0], StationSupport(node=3, kxx=1e8, kyy=0.0)), "freely in y"),
        (rotor(HELD[0], StationSupport(node=3, kxx=0.0, kyy=1e8)), "freely in x"),
        (rotor(StationSupport(node=0, kxx=0.0, k_tilt=1e5)), "shaft 1 shifts freely"),
        (rotor(*HELD, shafts=(THREE, THREE), links=(StationLink(a=1, b=5, kxx=1e8),)),
         "shaft 2 .*tilts freely"),
    ],
)  # fmt: skip
def test_a_rotor_that_can_move_as_a_rigid_body_is_refused_with_its_motion(free, message):
    with pytest.raises(ValueError, match=message):
        check_supported(free)
    with pytest.raises(ValueError, match="rotor must be supported"):
        natural_frequencies(free, 0.0)
    with pytest.raises(ValueError, match="rotor must be supported"):
        transfer_unbalance_response(free, 100.0, {0: 1e-5})


def test_one_bearing_that_resists_tilting_is_enough():
    check_supported(rotor(StationSupport(node=0, kxx=1e8, k_tilt=1e5)))
    with pytest.raises(ValueError, match="shaft inner"):
        check_supported(rotor(*HELD, shafts=(THREE, THREE)), ("outer", "inner"))
