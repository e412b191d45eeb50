"""Warnings of every subject: one input for each warning."""

import math

import pytest

from tests.verify.cases.own import state
from tests.verify.cases.test_refused import CUP
from verify.cases.registry import find


def flats(angle):
    """Distance of a star's flats that makes the clamping angle [deg]."""
    return f"{14 * math.cos(2 * math.radians(angle)) - 2.5!r} mm"


def cup_flats(angle):
    """The same of a cup's."""
    return f"{12 * math.cos(2 * math.radians(angle)) + 2!r} mm"


RIM = {"F": "1 N", "Q": "1 N", "z_m": "0.1 µm"}
SLIPPERY = {"mu_s": 0.05, "mu_c": 0.05}
THIN = {"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "2 mm"}
WARNED = [
    ("ring-loads-outer", {"R_p": "500 MPa"}, "yields below the contact"),
    ("ring-loads-outer", {"R_p": "100 MPa"}, "hoop stress"),
    ("ring-loads-outer", {"F": "60 kN"}, "no steel withstands this pressure"),
    ("ring-rotation", {"omega": "6685 r/min"}, "Eq. 8 is relevant from"),
    ("ring-rotation", {"omega": "114592 r/min"}, "most steels yield"),
    ("polyhedral-pressure", {"R_p": "1 MPa"}, "exceeds R_p = 1 MPa"),
    ("polyhedral-ring", {"z": 3}, "move inwards"),
    ("polyhedral-ring", {"rho": "0.1 mm", "R_p": "900 MPa"}, "exceeds R_p"),
    ("polyhedral-ring", THIN, ""),
    ("polyhedral-locking", {"p_t": "20 MPa"}, "pressure alone does not lock"),
    ("polyhedral-locking", {"p_t": "22 MPa"}, "p_2l is negative"),
    ("polyhedral-wedge", {"alpha": "9 deg"}, "lower by 10 %"),
    ("polyhedral-wedge", {"alpha": "12 deg"}, "expelled from the wedge"),
    ("polyhedral-wedge", {"p_lim": "500 MPa"}, "exceeds p_lim = 500 MPa"),
    ("freewheel-torque", {"X": flats(6)}, "that oiled steel hardly exceeds: the clutch slips"),
    ("freewheel-cup", {"R_a": "17 mm", "T": "5 N m"}, "at its corners and bends, so that"),
    ("freewheel-friction", {"F_ax": "1.1 kN"}, "slips along its axis; the limit is F_ax"),
    ("freewheel-friction", {"F_ax": "16 kN", "mu": 1}, "one end lifts off"),
    ("freewheel-friction", {"X": flats(5)}, "the torque alone releases the rollers"),
    ("freewheel-paths", {"f": "500 Hz"}, "inertia adds about"),
    ("freewheel-clutch", {"E_r": "310 GPa"}, "E_r is given without ν_r: ν = 0.3 is used"),
    ("freewheel-clutch", {"X": "11.499 mm", "F_ax": "0 N"}, "exceed R - 2 r - X = 1 µm: X_tol"),
    ("freewheel-clutch", CUP | {"X": "13.998 mm", "T": "0.1 N m", "F_ax": "0 N"},
     "R + 2 r - X = 2 µm"),
    ("freewheel-clutch", {"T": "4000 N m", "mu": 1.0}, "15.3 GPa at the rollers' ends"),
    ("freewheel-clutch", {"e_lim": 0.005}, "the rollers tilt"),
    ("sprag-wedge", {"r_i": "6 mm", "b": "5 mm"}, "exceeds the width of the rounded profile"),
    ("sprag-engagement", SLIPPERY, "the sprags slip"),
    ("sprag-friction", {"mu_s": 0.056, "mu_c": 0.05, "K_r": "4e-4 N m/rad"},
     "the clutch locks only if it does not slip first"),
    ("sprag-clutch", {"z": 3}, "the inner race deflects 3.8"),
    ("sprag-clutch", {"R_id": "10.9 mm", "R_ed": "19.65 mm", "T": "1 N m"}, "outer race deflects"),
    ("sprag-clutch", {"n": "2e4 r/min"}, "the centrifugal force on a sprag is m_g ω² r = 120."),
    ("sprag-clutch", {"K_r": "10 N m/rad"}, "the contact force by the springs alone is"),
    ("sprag-clutch", {"E": "3 GPa"}, "Palmgren's law, which applies to steel only"),
    ("sprag-clutch", {"l": "3 mm"}, "l < b: sprags shorter than their width"),
    ("sprag-crown", {}, "z_m = 10 µm is reached only at the ends"),
    ("spring-buckling", {"F": "2 N"}, "with a free head, it buckles at 1.46 mm"),
    ("spring-stages", {"width_factor": 1.09}, "U_A is 55% of the free length"),
    ("spring-stages", {"F": "10 N", "tail": "mid-leaf"}, "F = 10 N is beyond A"),
    ("spring-stages", {"F": "9.5 N", "tail": "arc"}, "a tip touches"),
    ("spring-stages", {"R_p": "500 MPa"}, "at A exceeds R_p = 500 MPa: the loops yield before"),
    ("spring-stages", {"alpha": "20 deg", "L1": "5 mm"}, ": the contact force has this angle"),
    ("spring-width", {"h": "0.2 mm"}, "a strip 2 times as wide as thick is not a plate"),
    ("spring-width", {"h": "3 mm"}, "the width is 0.25 times the length of a leaf: the arcs"),
    ("spring-width", {"r": "4 mm", "L1": "8.1 mm"}, "the factor of a leaf does not apply"),
    ("contact-flat", {"F": "60 kN"}, "of the roller's radius"),
    ("contact-flat", {"L": "0.3 mm", "F": "21.4 N"}, "times a"),
    ("contact-ring", {"r_o": "20 mm"}, "of the race's wall (0.56 mm)"),
    ("contact-press-fit", {"R_p": "20 MPa"}, "its pressure decreases"),
    ("contact-press-fit", {"delta": "120 µm"}, "most metals yield"),
    ("contact-slip", {"P": "1500 N/mm"}, "replace the rollers by half-planes"),
    ("contact-slip", {"hardness": "1000 MPa"}, "exceeds p_lim = 1000 MPa"),
    ("contact-slip", {"mu": 0.6}, "with this friction"),
    ("contact-sphere", {"P": "2 kN"}, "error of Hertz's approach about"),
    ("contact-roller", {"R_2": "-4.3 mm"}, "of the radius of the roller"),
    ("contact-roller", {"E_1": "70 GPa", "nu_1": 0.0, "nu_2": 0.49}, "steel on steel"),
    ("contact-roller", {"z_m": "1e-6 mm"}, "an end is loaded"),
    ("contact-roller-tilted", {"theta": "0.3 deg"}, "only 5.087 mm"),
    ("contact-roller-tilted", RIM, "are in contact"),
    ("contact-roller-crowns", {"L": "100 mm", "F": "30 kN"}, ""),
    ("rotor-clutch", {"T": "0.01 N m"}, "the preload is too small"),
    ("rotor-clutch", {"e": "30 µm"}, "with an offset, "),
    ("rotor-clutch", {"nu": "0.15 rad"}, "the clutch slips"),
    ("rotor-clutch", {"T": "600 N m"}, "larger than the sprags can follow by rolling"),
    ("rotor-clutch", {"Z": 18, "R_i": "30 mm", "R_e": "38.33 mm", "T": "150 N m"}, "too large"),
    ("rotor-shaft", {"L": "400 mm"}, "use Timoshenko's theory"),
    ("rotor-shaft", {"L": "200 mm", "d_i": "56 mm"}, "too short or thin-walled"),
    ("rotor-shaft", {"n": "238732 r/min"}, "rim speed is 750 m/s"),
    ("rotor-step", {}, "45° rule lowers the beam's frequencies by up to 3.5%"),
    ("rotor-step", {"d_2": "40.2 mm"}, ""),
]  # fmt: skip
ALWAYS = {
    "sprag-crown", "spring-stages", "spring-buckling", "rotor-step", "contact-roller-flat",
    "polyhedral-locking", "polyhedral-ring",
}  # fmt: skip


@pytest.mark.parametrize(("case_id", "changes", "words"), WARNED)
def test_a_part_at_an_end_of_its_range_is_warned_of(case_id, changes, words):
    *_, warned = state(find(case_id), **changes)
    assert any(words in line for line in warned) if words else not warned


@pytest.mark.parametrize("case_id", sorted({case_id for case_id, *_ in WARNED} - ALWAYS))
def test_the_paper_s_part_has_no_warning(case_id):
    *_, warned = state(find(case_id))
    assert not warned
