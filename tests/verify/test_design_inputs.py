"""Design tasks: what is read, and the one line that says what is wrong with the others."""

import math

import pytest

from tests.verify.template_text import inputs_of, whole
from verify.app.cli import run
from verify.core.inputs import InputError
from verify.studies.design.inputs import default, load, task
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


def test_ranges_lists_and_single_values_are_read():
    found = read(L1="1 cm : 14 mm : 5", r=["0.5 mm", "0.4 mm", "0.5 mm"], n=6, alpha="80°").ranges
    assert found["L1"] == pytest.approx([0.010, 0.011, 0.012, 0.013, 0.014])
    assert found["r"] == pytest.approx([0.4e-3, 0.5e-3])
    assert found["n"] == (6,)
    assert found["alpha"] == pytest.approx([math.radians(80)])


WRONG = [
    ({"L_w": None}, "needs either L_w or U_w, neither is given"),
    ({"L_w": "30 mm"}, "needs L_w < wedge, got L_w = 30 mm, wedge = 27 mm"),
    ({"ratio_min": 0.7}, "needs ratio_min < ratio_max, got 0.7 and 0.6"),
    ({"k_band": None}, "b_tolerance and k_band belong together, k_band is missing"),
    ({"width_factor": 1.2}, "width_factor = 1.2 is more than 1/(1 - ν²) = 1.0989"),
    ({"L1": "10 mm : 14 mm"}, 'inputs.L1: a range is "first : last : number"'),
    ({"L1": "10 mm : 14 mm : 1"}, "inputs.L1: a range ends with how many values it has, 2 to"),
    ({"b": []}, "inputs.b: the list is empty"),
    ({"n": 10**5000}, "inputs.n: the number is out of range"),
    ({"n": 3}, "inputs.n = 3: must be at least 4"),
    ({"n": "4 : 9 : 3"}, "needs whole numbers"),
    ({"alpha": "95 deg"}, "inputs.alpha = 95 deg: must be at least 20 deg and at most 90 deg"),
    ({"L1": "10 mm : 14 mm : 900", "r": "0.3 mm:0.6 mm:90"}, "candidates, at most 300,000"),
]


@pytest.mark.parametrize(("changes", "said"), WRONG, ids=[said for _, said in WRONG])
def test_wrong_input_is_refused_in_one_line(changes, said):
    with pytest.raises(InputError) as caught:
        read(**changes)
    message = str(caught.value)
    assert said in message
    assert message.startswith("spring.toml: inputs")
    assert "\n" not in message


@pytest.mark.parametrize("text", ["case = 1\n[inputs]\n", "[inp"])
def test_another_file_is_refused_with_status_2(tmp_path, capsys, text):
    path = tmp_path / "other.toml"
    path.write_text(text)
    assert run(["design", str(path)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "other.toml" in said


def test_a_file_of_another_case_names_all_that_design_takes(tmp_path, capsys):
    path = tmp_path / "ring.toml"
    path.write_text('case = "ring-lame"\n[inputs]\n', encoding="utf-8")
    assert run(["design", str(path)]) == 2
    said = capsys.readouterr().err
    assert "design takes design-spring, design-sprag or sprag-clutch, got 'ring-lame'" in said
