"""Units of an answer follow the file: lengths, forces, torques and pressures are converted."""

import json
import re
from pathlib import Path

import pytest

from verify.answers.answer_units import in_units
from verify.app.cli import run
from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.inputs import entry_model, is_table, meta
from verify.core.unit_systems import DISPLAYED, converted, system_of, text_in

PARTS = Path(__file__).parent / "parts"


def test_every_unit_of_the_tools_is_converted_once_into_the_same_quantity():
    """A length, force, torque or pressure that no map names would stay in mm or N."""
    for system in DISPLAYED.values():
        for unit, target in system.items():
            assert units.dimensions(unit) == units.dimensions(target), unit
            assert target not in system
    used = {output.unit for case in CASES for output in case.outputs}
    for case in CASES:
        for field in case.inputs.model_fields.values():
            inner = entry_model(field).model_fields.values() if is_table(field) else (field,)
            used |= {meta(one)["unit"] for one in inner}
    neutral = {"1", "%", "deg", "rad", "s", "ms", "Hz", "r/min", "rad/s"}
    assert used - neutral - set(DISPLAYED["inch"]) == set()


def test_numbers_and_sentences_are_in_inch_and_pound():
    for value, unit, expected, target in (
        (25.4, "µm", 1.0, "mil"),
        (1.0, "N m", 1 / 0.1129848290276167, "lbf in"),  # NIST SP 811: 1 lbf in = 0.1129848 N m
        (6.894757293, "MPa", 1.0, "ksi"),
        (1.0, "N/mm", 1000 * 0.0254 / 4.4482216152605, "lbf/in"),
        (30.0, "deg", 30.0, "deg"),
    ):
        assert converted(value, unit, "inch") == (pytest.approx(expected, rel=1e-9), target)
    for text, expected in (
        ("first the contacts slip (764.4 N m, 4.25 T)",
         "first the contacts slip (6766 lbf in, 4.25 T)"),
        ("sprag-wedge turns by 12.1°, 41 slices", "sprag-wedge turns by 12.1°, 41 slices"),
        ("5 N m s/rad, 3 kg m^2", "44.3 lbf in s/rad, 10252 lb in^2"),
    ):  # fmt: skip
        assert text_in(text, "inch") == expected
        assert text_in(text, "mm") == text


def test_the_system_of_a_file_is_that_of_most_lengths():
    for raw, system in (
        ({"R": "25 mm", "r": "1 in"}, "mm"),
        ({"R": "25 mm", "r": "1 in", "l": "2 inch"}, "inch"),
        ({"T": "5 lbf in", "p": "3 ksi"}, "inch"),
        ({"segments": [{"shaft": "in", "length": "10 in"}]}, "inch"),
        ({"L1": "0.4 in : 0.6 in : 9", "b": ["4 mil", "5 mil"]}, "inch"),
        ({}, "mm"),
    ):
        assert system_of(raw) == system


def answered(capsys, *command):
    assert run([*command, "--json"]) in (0, 1)
    return json.loads(capsys.readouterr().out)


def test_json_has_the_same_quantities_in_each_system(capsys):
    found = {}
    for system in DISPLAYED:
        file = str(PARTS / "roller-clutch-31.toml")
        answer = answered(capsys, "check", file, "--units", system)
        found[system] = answer | answer["details"] | {"criteria": answer["answer"]["criteria"]}
    parts = {"values": "value", "limits": "at", "assumed": "value", "criteria": "limit"}
    for part, key in parts.items():
        for same in zip(*(of[part] for of in found.values()), strict=True):
            si = [one[key] * units.factor(one["unit"]) for one in same]
            assert si == pytest.approx(si[:1] * len(si), rel=1e-12)
    assert found["inch"]["inputs"]["T"]["unit"] == "lbf in"


def test_a_file_in_inches_is_answered_in_inches_unless_another_system_is_given(capsys):
    fan = str(PARTS / "fan-rotor-inch.toml")
    metric = answered(capsys, "check", fan, "--units", "mm")["values"]
    assert not {v["unit"] for v in metric} & {"mil", "lbf"}
    assert run(["check", fan]) == 0
    printed = capsys.readouterr().out
    assert "lbf" in printed
    assert " µm" not in printed
    assert "length 10 in, d_o 2.5 in" in printed


def test_rows_are_converted_and_their_relative_numbers_are_not(of_paper):
    result = of_paper(find("spring-accordion"))
    inch = in_units(result, "inch")
    assert any(row.unit == "lbf/in" for row in inch.rows)
    for was, now in zip(result.rows, inch.rows, strict=True):
        assert (now.status, now.detects, now.demand, now.interval) == (
            was.status, was.detects, was.demand, was.interval)  # fmt: skip
        ratio = units.factor(was.unit) / units.factor(now.unit)
        for name in ("analytic", "fem", "difference", "scale", "tolerance", "u_num"):
            if (value := getattr(was, name)) is not None:
                assert getattr(now, name) == pytest.approx(value * ratio, rel=1e-12)
    assert in_units(inch, "inch") == inch


@pytest.mark.slow("a design is searched in each system")
def test_a_design_is_answered_in_the_units_of_its_file(capsys):
    task = ("design", str(PARTS / "design-spring-30.toml"), "--no-fem")
    mm, inch = (answered(capsys, *task, "--units", system) for system in ("mm", "inch"))
    stiffness = [found["answer"]["design"] for found in (mm, inch)]
    assert [one["unit"] for one in stiffness] == ["N/mm", "lbf/in"]
    si = [one["value"] * units.factor(one["unit"]) for one in stiffness]
    assert si[0] == pytest.approx(si[1])
    assert run([*task, "--units", "inch"]) == 0
    printed = capsys.readouterr().out
    lines = [x.partition("typical")[0] for x in printed.splitlines() if "for 6 N at 24 mm" not in x]
    assert not [x for x in lines if " mm" in x or " MPa" in x]
    (row,) = (line for line in printed.splitlines() if re.match(r"  \d+\*", line))
    assert f"{inch['members'][inch['chosen'] - 1]['L0']['value']:.4f}" in row
