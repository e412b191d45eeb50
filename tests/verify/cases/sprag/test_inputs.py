"""What sprag clutches refuse, warn of, and leave to their formulas: one input for each rule."""

import re

import pytest

from verify.cases.sprag.clutch.case import CLUTCH
from verify.cases.sprag.crown.case import CROWN
from verify.cases.sprag.engagement.case import ENGAGEMENT
from verify.cases.sprag.friction.case import FRICTION
from verify.cases.sprag.optimum.case import OPTIMUM_25
from verify.cases.sprag.wedge.case import WEDGE


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (WEDGE, {"r_i": 20e-3}, "no room for the sprag: its pole C_e must lie inside the bore"),
        (WEDGE, {"T": 1e7}, "T = 1e+07 N m"),
        (CLUTCH, {"R_i": 20e-3}, "the sprags need room between the races"),
        (CLUTCH, {"R_id": 12e-3}, "the inner race needs a wall: R_id < R_i, got R_id = 12 mm"),
        (CLUTCH, {"R_ed": 19e-3}, "the outer race needs a wall"),
        (CLUTCH, {"b": 7e-3}, "sprags stand side by side on the inner race"),
        (CLUTCH, {"r_i": 0.5e-3, "nu_0": 0.192}, "no spiral has this wedge angle"),
        (CLUTCH, {"mu_c": 0.2}, "friction falls with the speed"),
        (CLUTCH, {"dt": 1e-8, "t_end": 1.0}, "between 10 and 2,000,000 steps"),
        (CLUTCH, {"t_ramp": 0.1}, "the torque has risen before the end: t_ramp <= t_end, got"),
        (OPTIMUM_25, {"K_1_low": 6.0}, "K_1_low < K_1_high, got K_1_low = 6, K_1_high = 5"),
        (OPTIMUM_25, {"z_m_low": 3e-5}, "got z_m_low = 0.03 mm, z_m_high = 0.025 mm"),
        (OPTIMUM_25, {"population": 11}, "a population is in pairs"),
    ],
)
def test_no_such_clutch(case, changes, words):
    with pytest.raises(ValueError, match=re.escape(words)):
        case.analytic(case.inputs(**changes))


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (WEDGE, {"nu_0": 0.11}, "that oiled steel hardly exceeds: the clutch slips"),
        (WEDGE, {"T": 110.0}, "exceeds the 4000 MPa"),
        (WEDGE, {"r_i": 6e-3, "b": 5e-3}, "wider than they are round"),
        (WEDGE, {"T": 200.0}, "the sprags roll over"),
        (ENGAGEMENT, {"mu_s": 0.05, "mu_c": 0.05}, "the sprags slip"),
        (ENGAGEMENT, {"K_r": 4e-4}, "slide at the start"),
        (FRICTION, {"T": 120.0}, "the sprags roll over"),
        (FRICTION, {"mu_s": 0.056, "mu_c": 0.05, "K_r": 4e-4},
         "it locks only where it does not slip first"),
        (CLUTCH, {"z": 3}, "the inner race deflects 3.8"),
        (CLUTCH, {"R_id": 10.9e-3, "R_ed": 19.65e-3, "T": 1.0}, "the outer race deflects"),
        (CLUTCH, {"n": 2094.0}, "at n each sprag feels m_g ω² r = 120.6 N of centrifugal force"),
        (CLUTCH, {"K_r": 10.0}, "the springs alone press with"),
        (CLUTCH, {"E": 3e9}, "slices follow Palmgren's law, which is steel's"),
        (CLUTCH, {"l": 3e-3}, "sprags are shorter than wide"),
        (CROWN, {}, "z_m = 10 µm is reached at the very ends alone"),
    ],
)  # fmt: skip
def test_near_an_end_of_the_range_a_clutch_is_warned_of(case, changes, words):
    q = case.inputs(**changes)
    assert words in " ".join(case.warnings(q, case.analytic(q)))
    assert case is CROWN or not case.warnings(case.inputs(), case.analytic(case.inputs()))


@pytest.mark.parametrize(
    ("case", "changes", "words"),
    [
        (WEDGE, {"T": 60.0}, "their contacts come to the flanks"),
        (WEDGE, {"r_i": 6e-3, "b": 5e-3}, "wider than they are round"),
        (WEDGE, {"nu_0": 0.2, "T": 600.0}, "r wide under"),
        (WEDGE, {"R_id": 10.8e-3, "T": 20.0, "nu_0": 0.2}, "displacements are not small"),
        (ENGAGEMENT, {"dt": 1e-7}, "steps"),
        (ENGAGEMENT, {"K_r": 4e-4}, "slide at the start"),
        (FRICTION, {"T": 120.0}, "roll over"),
        (CLUTCH, {"T": 500.0}, "no state within the profile bears this torque"),
        (CLUTCH, {"T": 0.01}, "below the least load that slices are solved for"),
        (CLUTCH, {"slices": 81}, "81 slices are solved anew"),
        (CROWN, {"z_m": 0.0}, "without a crown"),
        (CROWN, {"T": 80.0}, "roll over"),
        (CROWN, {"slices": 81}, "81 slices"),
        (OPTIMUM_25, {"mu_s": 0.05, "mu_c": 0.04}, "the sprags slip: no crown mends that"),
        (OPTIMUM_25, {"T": 5000.0}, "no state within the profile bears this torque"),
        (OPTIMUM_25, {"slices": 101}, "101 slices are solved anew at each load"),
        (OPTIMUM_25, {"t_end": 1.0}, "t_end/dt = 1e+05 is above 50000 steps"),
    ],
)
def test_what_the_reference_cannot_solve_is_left_to_the_formulas(case, changes, words):
    assert words in case.too_large(case.inputs(**changes))
    assert not case.too_large(case.inputs())
