"""Tasks of a crown: what is read, and the one line that says what is wrong with the others."""

import numpy as np
import pytest

from tests.verify.template_text import inputs_of, whole
from verify.answers.template import template as case_template
from verify.app.cli import run
from verify.cases.registry import find
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.inputs import InputError
from verify.studies.design_sprag.corners import corners, reach
from verify.studies.design_sprag.inputs import default, load, task, unable
from verify.studies.design_sprag.template import template

GOOD = inputs_of(template())


def read(**changes):
    raw = {k: v for k, v in (GOOD | changes).items() if v is not None}
    return task(raw, "clutch", "clutch.toml")


def test_the_template_reads_as_the_default_task(tmp_path):
    path = tmp_path / "task.toml"
    path.write_text(whole(template()), encoding="utf-8")
    found, meant = load(path), default()
    assert (found.low, found.high, found.torques) == (meant.low, meant.high, meant.torques)
    assert found.clutch == meant.clutch == EngagementInputs()
    assert found.wishes == meant.wishes


def test_a_file_of_the_case_is_a_task_at_its_own_torque_without_tolerance(tmp_path):
    path = tmp_path / "clutch.toml"
    text = whole(case_template(find("sprag-clutch"))).replace('T = "25 N m"', 'T = "31 N m"')
    path.write_text(text, encoding="utf-8")
    found = load(path)
    assert found.torques == (31.0,)
    assert (found.wishes.t_z, found.wishes.t_y) == (0.0, 0.0)
    assert (found.wishes.aim, found.wishes.contacts) == ("excess", "strips")
    path.write_text(f"{text}\nt_z = '1 µm'\n", encoding="utf-8")
    with pytest.raises(InputError, match=r'inputs\.t_z: belongs to case = "design-sprag"'):
        load(path)


def test_torques_are_a_list_a_range_or_that_of_the_clutch():
    assert read(torques=["40 N m", "10 N m"]).torques == (10.0, 40.0)
    assert read(torques="10 N m : 40 N m : 4").torques == pytest.approx((10, 20, 30, 40))
    assert read(torques=None, T="33 N m").torques == (33.0,)


WRONG = [
    ({"K_1_range": "5 : 1"}, "inputs.K_1_range: a range rises, got 5 to 1"),
    ({"K_1_range": "0 : 2"}, "inputs.K_1_range = 0 to 2: must be greater than 0 and at most 100"),
    ({"z_m_range": "5 : 25"}, 'inputs.z_m_range: "5" has no unit: needs a length'),
    ({"z_m_range": "5 µm"}, 'inputs.z_m_range: a range is "low : high"'),
    ({"torques": []}, "inputs.torques: the list is empty"),
    ({"torques": "1 N m : 13 N m : 13"}, "inputs.torques: 13 torques, at most 12 are taken"),
    ({"t_z": "3 µm"}, "inputs.t_z = 0.003 mm: is more than half of the smallest drop"),
    ({"t_y": "1.9 mm"}, "inputs.t_y = 1.9 mm: is K_2 ± 0.422, more than the smallest"),
    ({"t_y": "5 mm"}, "a crown begins on the sprag: t_y < l/2, got t_y = 5 mm, l = 9 mm"),
    ({"aim": "best"}, "inputs.aim: needs one of excess, pressure, got 'best'"),
    ({"seed": -1}, "inputs.seed = -1: must be at least 0"),
    ({"R_i": None}, "inputs: missing R_i"),
]


@pytest.mark.parametrize(("changes", "said"), WRONG, ids=[said for _, said in WRONG])
def test_wrong_input_is_refused_in_one_line(changes, said):
    with pytest.raises(InputError) as caught:
        read(**changes)
    message = str(caught.value)
    assert said in message
    assert message.startswith("clutch.toml: inputs")
    assert "\n" not in message


def test_a_crown_has_no_front_to_choose_from(tmp_path, capsys):
    path = tmp_path / "task.toml"
    path.write_text(whole(template()), encoding="utf-8")
    assert run(["design", "--choose", "2", str(path)]) == 2
    assert "--choose: a crown has one best" in capsys.readouterr().err


def test_a_clutch_that_slips_or_rolls_over_is_named_with_its_torque():
    assert "under T = 25 N m it slips: " in unable(read(mu_s=0.05, mu_c=0.05))
    assert "under T = 120 N m it rolls over: " in unable(read(torques=["25 N m", "120 N m"]))
    assert unable(read()) == ""


# Tolerances


def test_corners_of_a_tolerance_grow_the_profile_and_move_its_beginning():
    found = corners(read(t_z="1 µm", t_y="0.09 mm"), np.array([[2.0, 0.5, 10e-6]]))
    assert found.shape == (1, 5, 3)
    assert found[0, 0].tolist() == [2.0, 0.5, 10e-6]
    # 0.09 mm of half of 9 mm are 0.02 of K_2; 1 of 10 µm is a tenth of K_1 and z_m
    rest = sorted(map(tuple, found[0, 1:].round(9).tolist()))
    assert rest == [(1.8, 0.48, 9e-6), (1.8, 0.52, 9e-6), (2.2, 0.48, 11e-6), (2.2, 0.52, 11e-6)]


def test_without_tolerance_a_crown_stands_for_itself_and_one_alone_has_two_corners():
    one = np.array([[2.0, 0.5, 10e-6]])
    assert corners(read(t_z=None, t_y=None), one).shape == (1, 1, 3)
    assert corners(read(t_y=None), one).shape == (1, 3, 3)
    assert corners(read(t_z=None), one).shape == (1, 3, 3)


def test_kriging_spans_every_corner_of_every_crown_of_the_ranges():
    one = read(t_z="1 µm", t_y="0.1 mm")
    low, high = reach(one)
    ends = np.array(np.meshgrid(*zip(one.low, one.high, strict=True))).reshape(3, -1).T
    every = corners(one, ends).reshape(-1, 3)
    assert np.all(every >= low * (1 - 1e-12))
    assert np.all(every <= high * (1 + 1e-12))
    assert low == pytest.approx(every.min(axis=0))
    # at z_m's lowest the profile grows most, K_1's largest included
    assert high == pytest.approx(every.max(axis=0))
