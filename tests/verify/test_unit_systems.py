"""Units of an answer follow the file: lengths, forces, torques and pressures converted alike."""

import json
import re
from pathlib import Path

import pytest

from verify.answers.answer_units import in_units
from verify.app.cli import run
from verify.app.commands import load
from verify.cases.registry import CASES
from verify.core import units
from verify.core.inputs import entry_model, is_table, meta
from verify.core.unit_systems import DISPLAYED, converted, system_of, text_in
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve

PARTS = Path(__file__).parent / "parts"
ROLLER = PARTS / "roller-clutch-31.toml"
FAN = PARTS / "fan-rotor-inch.toml"


@pytest.mark.parametrize("system", DISPLAYED)
def test_no_unit_is_converted_into_another_quantity_or_twice(system):
    for unit, target in DISPLAYED[system].items():
        assert units.dimensions(unit) == units.dimensions(target), unit
        assert target not in DISPLAYED[system]


@pytest.mark.parametrize(
    ("value", "unit", "expected", "target"),
    [
        (25.4, "mm", 1.0, "in"),
        (25.4, "µm", 1.0, "mil"),
        (1.0, "N m", 1 / 0.1129848290276167, "lbf in"),  # NIST SP 811: 1 lbf in = 0.1129848 N m
        (6.894757293, "MPa", 1.0, "ksi"),
        (4.4482216152605, "N", 1.0, "lbf"),
        (1.0, "kN", 224.8089431, "lbf"),
        (1.0, "N/mm", 1000 * 0.0254 / 4.4482216152605, "lbf/in"),
        (0.45359237, "kg", 1.0, "lb"),
        (1.0, "N m/rad", 1 / 0.1129848290276167, "lbf in/rad"),
        (30.0, "deg", 30.0, "deg"),
        (0.12, "1", 0.12, "1"),
    ],
)
def test_inch_and_pound(value, unit, expected, target):
    number, shown = converted(value, unit, "inch")
    assert shown == target
    assert number == pytest.approx(expected, rel=1e-9)


def test_every_unit_of_the_tools_is_known_to_both_systems():
    """A length, force, torque or pressure that no map names would stay in mm or N."""
    used = {output.unit for case in CASES for output in case.outputs}
    for case in CASES:
        for field in case.inputs.model_fields.values():
            inner = entry_model(field).model_fields.values() if is_table(field) else (field,)
            used |= {meta(one)["unit"] for one in inner}
    neutral = {"1", "%", "deg", "rad", "s", "ms", "Hz", "r/min", "rad/s"}
    assert used - neutral - set(DISPLAYED["inch"]) == set()


@pytest.mark.parametrize(
    ("raw", "system"),
    [
        ({"R": "1 in", "T": "5 N m"}, "inch"),
        ({"R": "25 mm", "r": "1 in"}, "mm"),
        ({"R": "25 mm", "r": "1 in", "l": "2 inch"}, "inch"),
        ({"R": "25 mm", "T": "5 lbf in", "p": "3 ksi"}, "mm"),
        ({"T": "5 lbf in", "p": "3 ksi"}, "inch"),
        ({"segments": [{"shaft": "in", "length": "10 in"}]}, "inch"),
        ({"L1": "0.4 in : 0.6 in : 9", "b": ["4 mil", "5 mil"]}, "inch"),
        ({"mu": 0.1, "kind": "inner cam", "n": "100 furlong"}, "mm"),
        ({}, "mm"),
    ],
)
def test_the_system_of_a_file_is_that_of_most_lengths(raw, system):
    assert system_of(raw) == system


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("X smaller by 25.4 µm", "X smaller by 1 mil"),
        ("first the contacts slip (764.4 N m, 4.25 T)", "first the contacts slip (6766 lbf in, "
         "4.25 T)"),
        ("4656 N m/rad at this torque", "41209 lbf in/rad at this torque"),
        ("up to 3094 MPa at one, 2670 MPa at another", "up to 448.7 ksi at one, 387.3 ksi at "
         "another"),
        ("d_i = 80 mm, D = 100 mm", "d_i = 3.15 in, D = 3.94 in"),
        ("between 10 and 20 kN", "between 2248 and 4496 lbf"),
        ("sprag-wedge turns by 12.1°, 41 slices", "sprag-wedge turns by 12.1°, 41 slices"),
        ("5 N m s/rad, 3 kg m^2", "44.3 lbf in s/rad, 10252 lb in^2"),
    ],
)  # fmt: skip
def test_sentences_are_converted_number_by_number(text, expected):
    assert text_in(text, "inch") == expected
    assert text_in(text, "mm") == text
    assert text_in(expected, "inch") == expected


def check(path, capsys, *more):
    assert run(["check", str(path), "--json", *more]) in (0, 1)
    found = json.loads(capsys.readouterr().out)
    return found | found["details"] | {"criteria": found["answer"]["criteria"]}


def test_json_has_the_same_quantities_in_each_system(capsys):
    found = {system: check(ROLLER, capsys, "--units", system) for system in DISPLAYED}
    parts = {"values": "value", "limits": "at", "assumed": "value", "criteria": "limit"}
    for part, key in parts.items():
        for k, metric in enumerate(found["mm"][part]):
            for system in ("si", "inch"):
                other = found[system][part][k]
                si = [one[key] * units.factor(one["unit"]) for one in (metric, other)]
                assert si[1] == pytest.approx(si[0], rel=1e-12)
    torque = next(v for v in found["inch"]["values"] if v["key"] == "T_slip")
    metric = next(v for v in found["mm"]["values"] if v["key"] == "T_slip")
    assert torque["unit"] == "lbf in"
    assert torque["value"] == pytest.approx(metric["value"] / 0.1129848290276167, rel=1e-12)
    assert found["inch"]["inputs"]["T"]["unit"] == "lbf in"


def test_a_file_in_inches_is_answered_in_inches_unless_told_otherwise(capsys):
    values = {v["key"]: v for v in check(FAN, capsys)["values"]}
    metric = {v["key"]: v for v in check(FAN, capsys, "--units", "mm")["values"]}
    assert {v["unit"] for v in values.values()} & {"mil", "lbf"}
    assert not {v["unit"] for v in metric.values()} & {"mil", "lbf"}
    assert run(["check", str(FAN)]) == 0
    printed = capsys.readouterr().out
    assert "lbf" in printed
    assert " µm" not in printed
    assert "length 10 in, d_o 2.5 in" in printed


def test_rows_are_converted_and_their_relative_numbers_are_not():
    _, case, inputs, values = load(PARTS / "accordion-spring-20.toml")
    (result,) = solve([Job(case, inputs, values=values)], Where(1), use_cache=False, quiet=True)
    inch = in_units(result, "inch")
    assert len(inch.rows) == len(result.rows) > 0
    assert any(row.unit == "lbf/in" for row in inch.rows)
    for was, now in zip(result.rows, inch.rows, strict=True):
        assert (now.status, now.detects, now.demand, now.interval) == (
            was.status, was.detects, was.demand, was.interval)  # fmt: skip
        ratio = units.factor(was.unit) / units.factor(now.unit)
        for name in ("analytic", "fem", "difference", "scale", "tolerance", "u_num"):
            if (value := getattr(was, name)) is not None:
                assert getattr(now, name) == pytest.approx(value * ratio, rel=1e-12)
        if was.scale and was.difference is not None and was.difference != 0:
            assert now.difference / now.scale == pytest.approx(was.difference / was.scale)
    assert in_units(inch, "inch") == inch
    assert in_units(result, "mm") is result


def test_a_wrong_system_is_refused_in_one_line(capsys):
    assert run(["check", str(FAN), "--units", "imperial"]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_inputs_that_are_whole_numbers_or_words_stay(capsys):
    found = check(PARTS / "drawn-cup-20.toml", capsys, "--units", "inch")["inputs"]
    assert found["kind"]["value"] == "outer cam"
    assert found["z"] == {"value": 11, "unit": "1"}


def test_large_numbers_of_a_sentence_have_a_power_of_ten():
    assert text_in("2020 MPa and 20 mm", "si") == "2.02e+09 Pa and 0.02 m"


def test_a_design_is_answered_in_the_units_of_its_file(tmp_path, capsys):
    metric = PARTS / "design-spring-30.toml"
    assert run(["design", str(metric), "--no-fem", "--json"]) == 0
    was = json.loads(capsys.readouterr().out)
    assert run(["design", str(metric), "--no-fem", "--units", "inch"]) == 0
    printed = capsys.readouterr().out
    lines = [x.partition("typical")[0] for x in printed.splitlines() if "for 6 N at 24 mm" not in x]
    assert not [x for x in lines if " mm" in x or " MPa" in x]
    assert run(["design", str(metric), "--no-fem", "--units", "inch", "--json"]) == 0
    now = json.loads(capsys.readouterr().out)
    assert was["answer"]["design"]["unit"] == "N/mm"
    assert now["answer"]["design"]["unit"] == "lbf/in"
    ratio = units.factor("N/mm") / units.factor("lbf/in")
    assert now["answer"]["design"]["value"] == pytest.approx(
        was["answer"]["design"]["value"] * ratio
    )
    (row,) = (line for line in printed.splitlines() if re.match(r"  \d+\*", line))
    assert f"{now['members'][now['chosen'] - 1]['L0']['value']:.4f}" in row


def test_the_head_of_a_report_is_in_the_units_of_the_answer(tmp_path, capsys):
    assert run(["check", str(FAN), "--out", str(tmp_path)]) == 0
    found = json.loads((tmp_path / "results.json").read_text("utf-8"))["cases"][0]
    assert any("in mm, N and MPa" in line for line in found["findings"])
    assert {one["unit"] for one in found["values"]} & {"lbf", "mil"}
