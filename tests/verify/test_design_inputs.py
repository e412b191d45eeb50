"""Design tasks: what is read, and the one line that says what is wrong with the others."""

import math

import pytest

from tests.verify.template_text import inputs_of, whole
from verify.answers.assumed.registry import DESIGN_SPRING_TASK as CASE
from verify.app.cli import run
from verify.core.inputs import InputError
from verify.studies.design.inputs import SWEEPS, default, load, task
from verify.studies.design.template import template

GOOD = inputs_of(template())


def read(**changes):
    raw = {k: v for k, v in (GOOD | changes).items() if v is not None}
    return task(raw, "spring", "spring.toml")


def test_the_template_reads_as_the_default_task(tmp_path):
    path = tmp_path / "task.toml"
    path.write_text(whole(template()), encoding="utf-8")
    found = load(path)
    assert found.demands == default().demands
    assert found.ranges == default().ranges


def test_every_value_of_the_template_has_its_unit():
    for line in whole(template()).splitlines():
        if "=" in line and not line.startswith(("case", "name", "#")):
            text, comment = line.split("  # ", 1)
            bare = "a number" in comment or "one of" in comment or text.startswith("n =")
            assert bare or '"' in text, line


def test_units_of_inch_and_pound_mean_the_same():
    metric = read(F_w="4.4482216152605 N", L_w="25.4 mm", wedge="50.8 mm", L1="10 mm")
    inches = read(F_w="1 lbf", L_w="1 in", wedge="2 in", L1="10 mm")
    assert inches.demands == metric.demands
    mils = read(b=["4 mil"]).ranges["b"]
    assert mils == pytest.approx([0.1016e-3], rel=1e-12)


def test_ranges_lists_and_single_values_are_read():
    found = read(L1="1 cm : 14 mm : 5", r=["0.5 mm", "0.4 mm", "0.5 mm"], n=6, alpha="80°").ranges
    assert found["L1"] == pytest.approx([0.010, 0.011, 0.012, 0.013, 0.014])
    assert found["r"] == pytest.approx([0.4e-3, 0.5e-3])
    assert found["n"] == (6,)
    assert found["alpha"] == pytest.approx([math.radians(80)])


def test_a_right_angle_in_radians_is_taken():
    assert read(alpha="1.5707963267948966 rad").ranges["alpha"] == pytest.approx([math.pi / 2])


def test_a_range_of_whole_numbers_is_taken():
    assert read(n="8 : 12 : 3").ranges["n"] == (8, 10, 12)


WRONG = [
    ({"F_w": 5}, "inputs.F_w: 5 has no unit: needs a force"),
    ({"F_w": "5 mm"}, 'inputs.F_w: "5 mm" is not a force'),
    ({"F_w": "-5 N"}, "inputs.F_w = -5 N: must be greater than 0 N"),
    ({"L_w": None}, "needs either L_w or U_w, neither is given"),
    ({"U_w": "8 mm"}, "needs either L_w or U_w, both are given"),
    ({"L_w": "30 mm"}, "needs L_w < wedge, got L_w = 30 mm, wedge = 27 mm"),
    ({"ratio_min": 0.7}, "needs ratio_min < ratio_max, got 0.7 and 0.6"),
    ({"k_band": None}, "b_tolerance and k_band belong together, k_band is missing"),
    ({"width_factor": 1.2}, "width_factor = 1.2 is more than 1/(1 - ν²) = 1.0989"),
    ({"tail": "wall"}, "inputs.tail: needs one of mid-leaf, arc, got 'wall'"),
    ({"wedge": None}, "inputs: missing wedge"),
    ({"alpha": None}, "inputs: missing alpha"),
    ({"beta": "1 deg"}, "inputs.beta: unknown key; known are F_w"),
    ({"L1": 11.6}, "inputs.L1: 11.6 has no unit: needs a length"),
    ({"L1": "10 mm : 14 mm"}, 'inputs.L1: a range is "first : last : number"'),
    ({"L1": "14 mm : 10 mm : 5"}, "inputs.L1: a range rises, got 14 mm to 10 mm"),
    ({"L1": "10 mm : 14 mm : 1"}, "inputs.L1: a range ends with how many values it has, 2 to"),
    ({"L1": "10 mm : 14 deg : 5"}, 'inputs.L1: "14 deg" is not a length'),
    ({"b": []}, "inputs.b: the list is empty"),
    ({"b": ["0.1 mm", "0 mm"]}, "inputs.b = 0 mm: must be greater than 0 mm"),
    ({"b": ["0.1 mm", True]}, "inputs.b[1]: needs a length, got True"),
    ({"b": [["0.1 mm"]]}, "inputs.b[0]: needs a length, got a table or list"),
    ({"n": 10**5000}, "inputs.n: the number is out of range"),
    ({"n": float("nan")}, "inputs.n: the number is out of range"),
    ({"n": 3}, "inputs.n = 3: must be at least 4"),
    ({"n": 8.5}, "inputs.n: needs a whole number, got 8.5"),
    ({"n": "4 : 9 : 3"}, "needs whole numbers"),
    ({"alpha": "95 deg"}, "inputs.alpha = 95 deg: must be at least 20 deg and at most 90 deg"),
    ({"alpha": "nan deg"}, 'inputs.alpha: "nan deg" is not finite'),
    ({"L1": "10 mm : 14 mm : 900", "r": "0.3 mm:0.6 mm:90"}, "candidates, at most 300,000"),
]


@pytest.mark.parametrize(("changes", "said"), WRONG, ids=[said for _, said in WRONG])
def test_wrong_input_is_told_in_one_line(changes, said):
    with pytest.raises(InputError) as caught:
        read(**changes)
    message = str(caught.value)
    assert said in message
    assert message.startswith("spring.toml: inputs")
    assert "\n" not in message


@pytest.mark.parametrize("text", ['case = "ring-lame"\n[inputs]\n', "case = 1\n[inputs]\n", "[inp"])
def test_another_file_is_refused_with_status_2(tmp_path, capsys, text):
    path = tmp_path / "other.toml"
    path.write_text(text)
    assert run(["design", str(path)]) == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "other.toml" in told


def test_init_prints_the_template(capsys):
    assert run(["init", CASE]) == 0
    assert capsys.readouterr().out == template()


def test_every_swept_default_lies_in_its_own_range():
    for name, sweep in SWEEPS.items():
        assert sweep.read(sweep.default, name)


def test_a_file_of_another_case_names_all_that_design_takes(tmp_path, capsys):
    path = tmp_path / "ring.toml"
    path.write_text('case = "ring-lame"\n[inputs]\n', encoding="utf-8")
    assert run(["design", str(path)]) == 2
    told = capsys.readouterr().err
    assert "design takes design-spring, design-sprag or sprag-clutch, got 'ring-lame'" in told
