"""Design tasks: accepted files, and one line with the error for all other files."""

import math

import numpy as np
import pytest

from tests.verify.template_text import inputs_of, whole
from verify.answers.template import template as case_template
from verify.app.cli import run
from verify.cases.registry import find
from verify.core.inputs import InputError
from verify.studies.design import inputs as springs
from verify.studies.design.template import template as spring_template
from verify.studies.design_sprag import inputs as crowns
from verify.studies.design_sprag.corners import corners, reach
from verify.studies.design_sprag.template import template as crown_template

SPRING, CROWN = (inputs_of(text) for text in (spring_template(), crown_template()))


def spring(**changes):
    raw = {k: v for k, v in (SPRING | changes).items() if v is not None}
    return springs.task(raw, "mine", "mine.toml")


def crown(**changes):
    raw = {k: v for k, v in (CROWN | changes).items() if v is not None}
    return crowns.task(raw, "mine", "mine.toml")


def test_a_template_reads_as_the_default_task(tmp_path):
    path = tmp_path / "task.toml"
    for template, module, names in (
        (spring_template, springs, ("demands", "ranges")),
        (crown_template, crowns, ("low", "high", "torques", "clutch", "wishes")),
    ):
        path.write_text(whole(template()), encoding="utf-8")
        found, meant = module.load(path), module.default()
        for name in names:
            assert getattr(found, name) == getattr(meant, name)


def test_ranges_lists_and_single_values_are_read():
    found = spring(L1="1 cm : 14 mm : 5", r=["0.5 mm", "0.4 mm", "0.5 mm"], n=6, alpha="80°").ranges
    assert found["L1"] == pytest.approx([0.010, 0.011, 0.012, 0.013, 0.014])
    assert found["r"] == pytest.approx([0.4e-3, 0.5e-3])
    assert found["n"] == (6,)
    assert found["alpha"] == pytest.approx([math.radians(80)])
    assert crown(torques=["40 N m", "10 N m"]).torques == (10.0, 40.0)
    assert crown(torques="10 N m : 40 N m : 4").torques == pytest.approx((10, 20, 30, 40))
    assert crown(torques=None, T="33 N m").torques == (33.0,)


WRONG = [
    (spring, {"L_w": None}, "exactly one of L_w and U_w must be given: neither is given"),
    (spring, {"L_w": "30 mm"}, "L_w must be less than wedge, got L_w = 30 mm, wedge = 27 mm"),
    (spring, {"k_band": None}, "b_tolerance and k_band must be given together: k_band is missing"),
    (spring, {"width_factor": 1.2}, "width_factor = 1.2 must not exceed 1/(1 - ν²) = 1.0989"),
    (spring, {"L1": "10 mm : 14 mm"}, 'L1: a range must be "first : last : number of values"'),
    (spring, {"b": []}, "inputs.b: the list must contain at least one value"),
    (spring, {"n": "4 : 9 : 3"}, "includes fractions, but this input takes whole numbers only"),
    (
        spring,
        {"L1": "10 mm : 14 mm : 900", "r": "0.3 mm:0.6 mm:90"},
        "candidates, the maximum is 300",
    ),
    (crown, {"K_1_range": "5 : 1"}, "K_1_range: low must be less than high, got 5 to 1"),
    (crown, {"K_1_range": "0 : 2"}, "inputs.K_1_range = 0 to 2: must be greater than 0 and at"),
    (crown, {"z_m_range": "5 µm"}, 'inputs.z_m_range: a range must be "low : high"'),
    (crown, {"torques": "1 N m : 13 N m : 13"}, "inputs.torques: 13 torques, the maximum is 12"),
    (crown, {"t_z": "3 µm"}, "inputs.t_z = 0.003 mm: must not exceed half of the smallest drop"),
    (crown, {"t_y": "1.9 mm"}, "1.9 mm: the corresponding tolerance of K_2, 0.422, must be"),
    (crown, {"t_y": "5 mm"}, "t_y must be less than l/2, got t_y = 5 mm"),
]


@pytest.mark.parametrize(("read", "changes", "words"), WRONG, ids=[words for *_, words in WRONG])
def test_wrong_input_is_refused_in_one_line(read, changes, words):
    with pytest.raises(InputError, match=r"^mine.toml: inputs[^\n]*$") as caught:
        read(**changes)
    assert words in str(caught.value)


def test_what_design_cannot_do_ends_with_2_and_one_line(tmp_path, capsys):
    path = tmp_path / "mine.toml"
    for text, words in (
        ('case = "ring-lame"\n[inputs]\n', "case must be design-spring, design-sprag or sprag-"),
        (whole(crown_template()), "--choose is only for springs: a crown has one optimum"),
    ):
        path.write_text(text, encoding="utf-8")
        assert run(["design", "--choose", "2", str(path)]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert words in line


def test_a_file_of_the_case_is_a_task_at_its_torque_without_tolerance(tmp_path):
    path = tmp_path / "clutch.toml"
    text = whole(case_template(find("sprag-clutch"))).replace('T = "25 N m"', 'T = "31 N m"')
    path.write_text(text, encoding="utf-8")
    found = crowns.load(path)
    assert found.torques == (31.0,)
    assert (found.wishes.t_z, found.wishes.t_y) == (0.0, 0.0)
    path.write_text(f"{text}\nt_z = '1 µm'\n", encoding="utf-8")
    with pytest.raises(InputError, match=r'inputs\.t_z: only valid with case = "design-sprag"'):
        crowns.load(path)


def test_a_clutch_that_slips_or_rolls_over_is_named_with_its_torque():
    assert "under T = 25 N m the clutch slips: " in crowns.unable(crown(mu_s=0.05, mu_c=0.05))
    assert "under T = 120 N m the clutch rolls over: " in crowns.unable(crown(torques=["120 N m"]))
    assert crowns.unable(crown()) == ""


def test_corners_of_a_tolerance_grow_the_profile_and_move_its_beginning():
    one = np.array([[2.0, 0.5, 10e-6]])
    found = corners(crown(t_z="1 µm", t_y="0.09 mm"), one)
    assert found[0, 0].tolist() == [2.0, 0.5, 10e-6]
    # 0.09 mm of half of 9 mm are 0.02 of K_2; 1 of 10 µm is a tenth of K_1 and z_m
    rest = sorted(map(tuple, found[0, 1:].round(9).tolist()))
    assert rest == [(1.8, 0.48, 9e-6), (1.8, 0.52, 9e-6), (2.2, 0.48, 11e-6), (2.2, 0.52, 11e-6)]
    assert corners(crown(t_z=None, t_y=None), one).shape == (1, 1, 3)
    assert corners(crown(t_y=None), one).shape == corners(crown(t_z=None), one).shape == (1, 3, 3)
    assert corners(crown(t_z=None, t_y="0.1 mm"), one * [[1, 2, 1]])[0, :, 1].max() == 1.0
    # kriging spans every corner of every crown of the ranges
    one = crown(t_z="1 µm", t_y="0.1 mm")
    low, high = reach(one)
    ends = np.array(np.meshgrid(*zip(one.low, one.high, strict=True))).reshape(3, -1).T
    every = corners(one, ends).reshape(-1, 3)
    assert low == pytest.approx(every.min(axis=0))
    # at z_m's lowest the profile grows most, K_1's largest included
    assert high == pytest.approx(every.max(axis=0))
