"""Inputs missing in a file: each has a source, is listed, and never changes a given input.

The files of `parts` have at most ten lines, as a designer has them from a drawing or a catalogue.
"""

import json
import math
import tomllib
from pathlib import Path

import pytest

from verify.answers.assumed.complete import assumed_inputs, build_completed, complete
from verify.answers.assumed.influence import UNCHANGED, influence
from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.parameter_file import read
from verify.app.cli import run
from verify.cases.registry import find
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.inputs import REQUIRED, InputError, meta
from verify.studies.design.inputs import Demands
from verify.studies.design_sprag.inputs import Wishes

FOLDER = Path(__file__).parent / "parts"
PARTS = sorted(FOLDER.glob("*.toml"))
TASKS = {"design-spring": Demands, "design-sprag": Wishes}
PAPER = {"R_i": "11.11 mm", "R_e": "19.44 mm", "l": "9 mm", "T": "25 N m"}


def raw_of(path):
    data = tomllib.loads(path.read_text("utf-8"))
    case_id = data["case"]
    return case_id, TASKS.get(case_id) or find(case_id).inputs, data["inputs"]


def clutch(**changes):
    """The paper's clutch from its main sizes with changes; None leaves one out."""
    raw = {k: v for k, v in (PAPER | changes).items() if v is not None}
    return build_completed("sprag-clutch", EngagementInputs, raw, "file")


@pytest.mark.parametrize("path", PARTS, ids=lambda path: path.stem)
def test_a_given_value_is_not_replaced(path):
    case_id, model, raw = raw_of(path)
    assert len([x for x in path.read_text("utf-8").splitlines() if x.strip()]) <= 10
    whole, assumed = complete(case_id, model, raw, "file")
    assert {k: whole[k] for k in raw} == raw
    for one in assumed:
        again, others = complete(case_id, model, raw | {one.name: whole[one.name]}, "file")
        assert one.name not in [other.name for other in others]
        assert again[one.name] == whole[one.name]


def test_check_and_design_answer_and_list_every_assumed_input(tmp_path, capsys):
    path = FOLDER / "accordion-spring-20.toml"
    _, model, raw = raw_of(path)
    assert run(["check", str(path), "--json"]) in (0, 1, 3)
    found = json.loads(capsys.readouterr().out)
    assert found["values"]
    listed = {one["name"]: one for one in found["assumed"]}
    fields = model.model_fields
    left_out = {n for n, f in fields.items() if n not in raw and meta(f)["omitted"] == REQUIRED}
    assert left_out
    assert left_out <= set(listed)
    assert run(["check", str(path), "--out", str(tmp_path)]) in (0, 1, 3)
    text = capsys.readouterr().out
    assert all(one["source"].split("^")[0] in text for one in listed.values())
    assert "assumed, typical: steel" in (tmp_path / "report.html").read_text("utf-8")
    path = FOLDER / "design-spring-30.toml"
    assert run(["design", "--no-fem", str(path)]) in (0, 1)
    text = capsys.readouterr().out
    assert all(one.source.split("^")[0] in text for one in assumed_inputs(*raw_of(path)))


def test_the_paper_s_clutch_is_assumed_from_its_main_sizes():
    q, assumed = clutch()
    paper = EngagementInputs()
    same = ("R_id", "R_ed", "r_i", "nu_0", "z", "E", "nu", "mu_s", "mu_c", "I_bi", "I_be", "K_r")
    for name in same:
        assert getattr(q, name) == pytest.approx(getattr(paper, name), rel=1e-5), name
    for name, rel in (("b", 1e-3), ("alpha_max", 6e-3), ("m_g", 5e-3), ("I_g", 5e-3)):
        assert getattr(q, name) == pytest.approx(getattr(paper, name), rel=rel), name
    assert len(assumed) == len(ASSUMPTIONS["sprag-clutch"])
    # what is derived follows what is given
    q, _ = clutch(b="5 mm", density="8000 kg/m^3", z=10)
    assert q.m_g == pytest.approx(8000 * 9e-3 * 0.7625 * 5e-3 * 8.33e-3, rel=1e-5)
    assert q.alpha_max == pytest.approx(5 / 8.04, rel=1e-5)


def test_flats_of_both_cams_have_the_wedge_angle():
    case = find("freewheel-clutch")
    for kind in ("inner cam", "outer cam"):
        raw = {"kind": kind, "R": "20 mm", "r": "3 mm", "L": "10 mm", "T": "20 N m"}
        q, _ = build_completed(case.id, case.inputs, raw, "file")
        assert 2 * math.degrees(case.analytic(q)["alpha_0"]) == pytest.approx(7, rel=2e-3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"R_i": None, "T": None}, "inputs: missing R_i, T"),
        ({"R_i": "20 mm"}, "inputs: R_e > R_i > 0 is required, got R_e = 19.44 mm, R_i = 20 mm"),
        ({"z": 60}, "b = 3.9984 mm; assumed: b = 3.9984 mm (typical: 0.48 (R_e - R_i))"),
        ({"R_ed": "19 mm"}, "the bore of the outer race must be smaller"),
    ],
)
def test_wrong_input_gets_one_line(change, message):
    with pytest.raises(InputError, match=r"^file: inputs[^\n]*$") as caught:
        clutch(**change)
    assert message in str(caught.value)


@pytest.mark.parametrize("path", PARTS, ids=lambda path: path.stem)
def test_whatever_is_wrong_in_a_short_file_ends_with_one_line_or_an_answer(path, recwarn):
    case_id, model, raw = raw_of(path)
    for wrong in ("0 mm", "-3 mm", "1e300 mm", 10**400, [{}], True):
        messages = []
        for name in {*raw, *(one.name for one in ASSUMPTIONS[case_id])}:
            try:
                build_completed(case_id, model, raw | {name: wrong}, "file")
            except InputError as error:
                messages.append(str(error))
        assert messages
        assert all(message.startswith("file: inputs") for message in messages)
        assert not any("\n" in message for message in messages)
    assert not recwarn.list


# Which of them change a value, and by how much


def studied(name, key):
    file = read(FOLDER / f"{name}.toml")
    found = influence(file.case, file.inputs, file.assumed, key)
    return {one.assumed.name: one for one in found}, found


def test_the_stiffness_of_a_spring_follows_its_modulus_and_what_follows_from_an_input():
    named, found = studied("accordion-spring-20", "k1")
    assert found[0] is named["E"]
    assert (named["E"].low, named["E"].high) == pytest.approx((200, 212))
    off = (named["E"].at_low, named["E"].at_high)
    assert off == pytest.approx((200 / 206 - 1, 212 / 206 - 1))
    assert not named["nu"].matters
    assert [one.largest for one in found] == sorted((one.largest for one in found), reverse=True)
    # the width factor of a plate follows from nu
    named, _ = studied("accordion-curve-20", "k1")
    assert (named["nu"].note, named["nu"].at_low < 0) == ("", True)


def test_a_variation_without_a_solution_is_reported_first():
    named, found = studied("drawn-cup-20", "alpha")
    assert found[0] is named["X"]
    assert (named["X"].at_high, named["X"].note) == (None, "no solution")
    assert math.isinf(found[0].largest)


def test_what_is_left_to_the_motion_in_time_changes_no_formula():
    file = read(FOLDER / "sprag-clutch-55.toml")
    given = {n: getattr(file.inputs, n) for n in type(file.inputs).model_fields}
    names = [one.name for one in ASSUMPTIONS["sprag-clutch"] if one.dynamic]
    other = type(file.inputs)(**given | {name: given[name] * 0.9 for name in names})
    found = find("sprag-clutch").analytic(other)
    assert {key: found[key] for key in file.values} == pytest.approx(
        dict(file.values), rel=UNCHANGED, abs=0
    )
