"""Inputs that finite elements cannot solve or compare, of every subject: one for each reason."""

import pytest

from tests.verify.cases.own import own
from tests.verify.cases.test_refused import CUP
from tests.verify.cases.test_warned import cup_flats
from verify.cases.registry import find

NANOMETRE = {"delta": "1 nm", "E_o": "2 GPa", "p_i": "0 MPa", "p_o": "0 MPa"}
LEFT = [
    ("ring-loads-outer", {"r_o": "300 mm"}, "r_o/r_i"),
    ("ring-loads-outer", {"n": 250, "F": "1 kN", "R": "1 mm"}, "n = 250"),
    ("ring-loads-outer", {"F": "0.05 N"}, "because of round-off"),
    ("polyhedral-locking", {"p_t": "20.5 MPa"}, "the ring reaches them at 20.26 MPa"),
    ("polyhedral-locking", {"p_t": "22.2 MPa"}, "finite elements need more than 22.27"),
    ("polyhedral-clutch", {"mu": 0.6}, "pressure does not limit the torque"),
    ("polyhedral-clutch", {"p_t": "15 MPa"}, "p_t = 15 MPa hardly presses the ring"),
    ("polyhedral-wedge", {"alpha": "12 deg"}, "no equilibrium exists; run `check` without --fem"),
    ("freewheel-torque", {"T": "500 N m"}, "the half-width of a contact is"),
    (
        "freewheel-torque",
        {"R_a": "17 mm", "T": "10 N m"},
        "more than 0.1 of its wall thickness of 0.5 mm",
    ),
    ("freewheel-torque", {"z": 17, "T": "52 N m"}, "mm of the ends of the flats"),
    ("freewheel-cup", {"T": "29 N m"}, "of the largest torque 30.04 N m"),
    ("freewheel-cup", {"X_o": cup_flats(9), "T": "90 N m"}, "the half-width of a contact is"),
    ("freewheel-paths", {"T_m": "10 N m"}, "axial load acts while the torque is nearly zero"),
    ("freewheel-paths", {"mu": 0.05}, "tan α = 0.0674 is not below μ = 0.05"),
    ("freewheel-paths", {"F_ax": "100 kN"}, "requires the friction coefficient"),
    ("freewheel-clutch", CUP, "cover only inner cams"),
    ("freewheel-clutch", {"E_r": "310 GPa"}, "one material"),
    ("freewheel-clutch", {"T": "9000 N m"}, "beyond the ends of their flats"),
    ("freewheel-clutch", {"X": "9 mm", "z": 3, "mu": 1.0}, "is too large: friction"),
    ("sprag-wedge", {"T": "60 N m"}, "their contacts reach the flanks"),
    ("sprag-wedge", {"nu_0": "0.2 rad", "T": "600 N m"}, "the half-width of a contact is"),
    ("sprag-wedge", {"R_id": "10.8 mm", "T": "20 N m", "nu_0": "0.2 rad"}, "are not small"),
    ("sprag-engagement", {"dt": "1e-7 s"}, "steps"),
    ("sprag-clutch", {"T": "500 N m"}, "at this torque no equilibrium exists within the profile"),
    ("sprag-clutch", {"T": "0.01 N m"}, "below the smallest load of the contact laws"),
    ("sprag-clutch", {"slices": 81}, "81 slices at each load"),
    ("sprag-crown", {"z_m": "0 mm"}, "without a crown"),
    ("sprag-optimum", {"mu_s": 0.05, "mu_c": 0.04}, "the sprags slip: no crown prevents this"),
    ("sprag-optimum", {"t_end": "1 s"}, "t_end/dt = 1e+05 exceeds the limit of 50000"),
    ("spring-buckling", {"n": 30}, "n = 30 segments are more than 24"),
    ("spring-buckling", {"n": 4}, "too short to buckle sideways"),
    ("spring-width", {"n": 31}, "check it with n = 30"),
    ("spring-width", {"b": "0.001 mm"}, "is 11938 times the thickness"),
    ("spring-curve", {"head": "free"}, "head = free: the whole curve"),
    ("contact-ring", {"r_o": "20 mm"}, "a wall of 0.56 mm"),
    ("contact-press-fit", {"r_i": "25.8 mm", "r_f": "26 mm", "delta": "1 µm"}, "without --fem"),
    ("contact-press-fit", NANOMETRE | {"delta": "0.001 nm"}, "round-off changes the pressure"),
    ("contact-slip", {"share": 0.49}, "run `check` without --fem"),
    ("contact-sphere", {"P": "4e-8 N"}, "round-off"),
    ("contact-roller", {"d": "0.1 mm"}, "d = 0.1 mm is shorter than l/64 = 0.141 mm"),
    ("rotor-clutch", {"T": "600 N m"}, "for rolling sprags"),
]


def left_out(case, q):
    """Why finite elements do not take these inputs; empty if they do."""
    return case.too_large(q) or getattr(q, "refusal", str)()


@pytest.mark.parametrize(("case_id", "changes", "words"), LEFT)
def test_what_finite_elements_cannot_compare_is_left_to_the_formulas(case_id, changes, words):
    case = find(case_id)
    q = own(case, **changes)
    message = left_out(case, q)
    assert words in message
    assert "\n" not in message
    assert case.equations(q, case.analytic(q))
    assert not left_out(case, own(case))
