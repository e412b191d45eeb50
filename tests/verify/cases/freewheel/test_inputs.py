"""What freewheels refuse, warn of, and leave to their formulas: one input for each rule."""

import math

import pytest
from pydantic import ValidationError

from verify.cases.freewheel.clutch.case import CLUTCH
from verify.cases.freewheel.cup.case import CUP
from verify.cases.freewheel.friction.case import FRICTION
from verify.cases.freewheel.paths.case import PATHS
from verify.cases.freewheel.torque.case import TORQUE

OUTER = {"kind": "outer cam", "R": 10e-3, "r": 2e-3, "X": 13.8832168e-3, "R_a": 17.5e-3, "r_b": 0}


def flats(angle):
    """Distance [m] of a star's flats that makes the clamping angle [deg]."""
    return 14e-3 * math.cos(2 * math.radians(angle)) - 2.5e-3


def cup_flats(angle):
    """The same of a cup's."""
    return 12e-3 * math.cos(2 * math.radians(angle)) + 2e-3


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (TORQUE, {"R": 22e-3}, "the ring needs a wall: R < R_a, got R = 22 mm, R_a = 21 mm"),
        (TORQUE, {"r_b": 12e-3}, "the star needs a wall"),
        (TORQUE, {"X": 11.6e-3}, "got X = 11.6 mm, r = 2.5 mm, R = 16.5 mm"),
        (TORQUE, {"X": 9.3e-3, "z": 3}, "is beyond friction"),
        (TORQUE, {"T": 1e6}, "wider than half the rollers"),
        (TORQUE, {"T": 4000.0}, "past the corners of their flats: 5.2"),
        (CUP, {"R_s": 9e-3}, "no wedge"),
        (CUP, {"X_o": 12.2e-3, "z": 4}, "is beyond friction"),
        (CUP, {"R_a": 15e-3}, "the cup needs a wall at its corners"),
        (CUP, {"r_b": 10e-3}, "the shaft needs a wall"),
        (CUP, {"T": 31.0}, "more than the largest torque, 30.041 N m"),
        (FRICTION, {"mu": 0.0}, "greater than or equal to 0.01"),
        (PATHS, {"rise": 0.6}, "rise < duration, got rise = 0.6 s, duration = 0.5 s"),
        (PATHS, {"f": 1e4}, "at most 1000 cycles, got f duration = 5000"),
        (CLUTCH, {"X": 11.6e-3}, "no wedge: the roller cannot touch flat and ring unless X + 2 r"),
        (CLUTCH, {"r_b": 12e-3}, "needs r_b below its flats X, got r_b = 12 mm"),
        (CLUTCH, {"R_a": 16.5001e-3}, "R_a - R = 0.1 µm, tolerance ±5 µm"),
        (CLUTCH, OUTER | {"R_a": 15.03e-3, "X_tol": 1e-5}, "R_a - X/cos(π/z) = 2.9"),
        (CLUTCH, {"X_tol": 3e-4}, "X_tol must be below r/10, got X_tol = 300 µm, r = 2.5 mm"),
        (CLUTCH, {"s_mu": 0.05}, "s_mu must be below μ/2"),
        (CLUTCH, {"kind": "outer cam"}, "flat cuts the shaft: X must be above R"),
    ],
)
def test_no_such_clutch(case, changes, words):
    with pytest.raises((ValueError, ValidationError)) as refused:
        case.analytic(case.inputs(**changes))
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (TORQUE, {"X": flats(6.0)}, "that oiled steel hardly exceeds: the clutch slips"),
        (TORQUE, {"T": 400.0}, "exceeds the 4000 MPa"),
        (CUP, {"R_a": 17e-3, "T": 5.0}, "bends: rings that enclose it"),
        (CUP, {"X_o": cup_flats(6)}, "do not grip"),
        (FRICTION, {"F_ax": 1.1e3}, "yellow: the clutch slips along its axis; it bears F_ax = 100"),
        (FRICTION, {"F_ax": 2.5e3}, "red: the clutch slips"),
        (FRICTION, {"F_ax": 16e3, "mu": 1}, "one end lifts off"),
        (FRICTION, {"X": flats(5.0)}, "the torque alone lets the rollers out"),
        (PATHS, {"f": 500.0}, "inertia adds some"),
        (CLUTCH, {"E_r": 310e9}, "E_r is given without ν_r: ν = 0.3 is used for it"),
        (CLUTCH, {"X": 11.499e-3, "F_ax": 0.0}, "tolerances reach R - 2 r - X = 1 µm: X_tol"),
        (CLUTCH, OUTER | {"X": 13.998e-3, "T": 0.1, "F_ax": 0.0}, "R + 2 r - X = 2 µm"),
        (CLUTCH, {"T": 4000.0, "mu": 1.0}, "15.3 GPa at the rollers' ends"),
        (CLUTCH, {"e_lim": 0.005}, "the rollers tilt"),
    ],
)
def test_near_an_end_of_the_range_a_clutch_is_warned_of(case, changes, words):
    q = case.inputs(**changes)
    assert words in " ".join(case.warnings(q, case.analytic(q)))
    assert not case.warnings(case.inputs(), case.analytic(case.inputs()))


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (TORQUE, {"T": 500.0}, "wide under"),
        (TORQUE, {"R_a": 17e-3, "T": 10.0}, "more than 0.1 of its wall of 0.5 mm"),
        (TORQUE, {"z": 17, "T": 52.0}, "mm of the flats' corners"),
        (CUP, {"T": 29.0}, "of the largest torque 30.04 N m"),
        (CUP, {"T": 0.1}, "of the largest torque 30.04 N m"),
        (CUP, {"X_o": cup_flats(9), "T": 90.0}, "r wide at the largest"),
        (FRICTION, {"X": flats(5.0)}, "check it without --fem"),
        (PATHS, {"T_m": 10.0}, "axial load while its torque is next to zero"),
        (PATHS, {"mu": 0.05}, "tan α = 0.0674 is not below μ = 0.05"),
        (PATHS, {"F_ax": 1e5}, "asks for friction of"),
        (CLUTCH, OUTER, "inner cams only"),
        (CLUTCH, {"T": -1.0}, "a torque that locks"),
        (CLUTCH, {"E_r": 310e9}, "one material"),
        (CLUTCH, {"T": 9e3}, "past the corners of their flats"),
        (CLUTCH, {"X": 9e-3, "z": 3, "mu": 1.0}, "beyond friction"),
    ],
)
def test_what_finite_elements_cannot_solve_is_left_to_the_formulas(case, changes, words):
    q = case.inputs(**changes)
    assert words in case.too_large(q)
    assert not case.too_large(case.inputs())
    assert case.equations(q, case.analytic(q))
