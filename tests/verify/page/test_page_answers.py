"""The page gives the answers of the command line, and marks wrong inputs."""

import contextlib
import io
import json
import random
import re
from pathlib import Path
from typing import Any

import pytest
from markupsafe import Markup

from verify.answers.console import margin
from verify.answers.parameter_file import read
from verify.app.check_command import Options, check_part, run_check
from verify.app.page.answer_view import answer
from verify.app.page.answers import shown
from verify.app.page.described import describe, model_of
from verify.app.page.session import State, edited_raw
from verify.app.page.sketches import named_sketch
from verify.app.page.sweep_figure import options
from verify.app.page.tasks import DESIGN, MARGIN, sweep
from verify.app.page.toml_text import as_values, parameter_file
from verify.cases.registry import CASES, find
from verify.core.inputs import InputError, meta
from verify.jobs.executor import ThisProcess

TEXTS = ("", " ", "0", "-1", "1e30", "3,5", "nan", "5 furlongs", "12", "0.3", "40 mm", "-2 mm",
         "1e-9 mm", "210 GPa", "50 N m", "2000 r/min", "2 kg", "left", "<b>", "\u2603", '"',
         "10 %")  # fmt: skip
RING = {"r_i": "60 mm", "r_o": "80 mm", "p_i": "100 MPa", "E": "210 GPa", "nu": "0.3"}
EDITS = 1000


def quietly(_told: Any) -> None:
    """Progress that no one sees."""


def answered(case: str, raw: dict[str, Any], *, notes: bool = False) -> Any:
    return shown(case, "my part", as_values(raw, describe(case).whole), notes, quietly)


@pytest.mark.parametrize("case", CASES.ids)
def test_every_case_has_a_form_whose_template_has_an_answer(case: str) -> None:
    made = describe(case)
    assert {f.name for f in made.fields} >= set(made.raw)
    assert answered(case, dict(made.raw)).verdict


def test_every_input_that_is_wrong_is_marked_with_the_words_of_the_command_line() -> None:
    found = answered("ring-lame", RING | {"r_i": "60", "r_o": "4 kg", "nu": "0.9"})
    assert found.verdict == ""
    assert found.faults == {
        "r_i": '"60" has no unit: needs a length, such as "60 mm"',
        "r_o": '"4 kg" is not a length, such as "1.5 mm"',
        "nu": "nu = 0.9: must be at most 0.45",
    }


@pytest.mark.parametrize(("case", "place", "text", "taken"), [
    ("freewheel-clutch", "T", "300", "300 N m"), ("freewheel-clutch", "T", " -3e2 ", "-3e2 N m"),
    ("freewheel-clutch", "T", "300 Nm", "300 Nm"), ("freewheel-clutch", "T", "3,5", "3,5"),
    ("freewheel-clutch", "z", "12", "12"), ("freewheel-clutch", "nu", "0.3", "0.3"),
    ("freewheel-clutch", "T", "", ""), ("rotor-system", "supports[2].k", "5", "5 N/µm"),
    ("rotor-system", "supports[2].node", "5", "5"), ("rotor-system", "shafts[1].name", "5", "5"),
    ("rotor-system", "k", "5", "5"),
])  # fmt: skip
def test_a_number_alone_is_in_the_unit_of_its_field(
    case: str, place: str, text: str, taken: str
) -> None:
    assert describe(case).entered(place, text) == taken


def test_a_number_alone_of_a_file_is_refused_with_the_unit_to_add() -> None:
    found = answered("freewheel-clutch", describe("freewheel-clutch").raw | {"T": "300"})
    assert found.faults == {"T": '"300" has no unit: needs a torque, such as "300 N m"'}


@pytest.mark.parametrize("supports", ["abc", ["a", "b"], [{"k": "1"}, "b"]])
def test_a_file_that_has_no_entries_for_a_table_is_refused(supports: Any) -> None:
    with pytest.raises(InputError, match=r"needs tables \[\[inputs\.supports\]\]"):
        describe("rotor-system").refuse_shapes({"supports": supports})


def test_every_wrong_entry_of_a_table_is_marked_and_listed() -> None:
    raw = dict(describe("rotor-system").raw)
    supports = [dict(one) for one in raw["supports"]]
    supports[0]["k"], supports[1]["k"], supports[2]["k"] = "3", "-4 N/m", "4 kg"
    del supports[1]["node"]
    found = answered("rotor-system", raw | {"supports": supports, "margin": "3"})
    assert found.faults == {
        "margin": "margin = 3: must be less than 1",
        "supports[1].k": '"3" has no unit: needs a stiffness, such as "3 N/µm"',
        "supports[2].node": "missing",
        "supports[2].k": "supports[2].k = -4e-06 N/µm: must be at least 0 N/µm",
        "supports[3].k": '"4 kg" is not a stiffness, such as "1.5 N/µm"',
    }
    text = str(answer(found))
    assert "5 inputs are wrong" in text
    assert all(place in text for place in found.faults)


def test_a_rule_between_inputs_is_stated_where_every_value_is_right() -> None:
    assert answered("ring-lame", RING | {"r_i": "90 mm"}).fault == (
        "a ring needs r_i < r_o, got r_i = 90 mm, r_o = 80 mm"
    )
    raw = dict(describe("rotor-system").raw)
    supports = [{**raw["supports"][0], "node": "99"}, *raw["supports"][1:]]
    found = answered("rotor-system", raw | {"supports": supports})
    assert found.faults == {"supports[1].node": "supports[1].node = 99: there are nodes 1 to 14"}


def test_inputs_that_are_missing_and_wrong_are_both_marked() -> None:
    raw = {k: v for k, v in RING.items() if k != "r_o"} | {"E": "2 mm"}
    assert set(answered("ring-lame", raw).faults) == {"r_o", "E"}
    assert answered("ring-lame", raw).faults["r_o"] == "missing"


def test_a_warning_stands_beside_the_input_that_causes_it() -> None:
    found = answered("ring-lame", RING | {"E": "500 GPa"})
    (text,) = found.beside["E"]
    assert "outside the usual range" in text


def test_a_warning_that_has_a_word_like_an_input_is_not_placed_there() -> None:
    found = answered("contact-roller", dict(describe("contact-roller").raw) | {"E_1": "500 GPa"})
    assert set(found.beside) == {"E_1"}
    assert any("Palmgren" in text for text in found.warnings)


def test_dimensions_of_the_sketch_carry_the_names_of_their_inputs() -> None:
    marked = 0
    for case in map(find, CASES.ids):
        q = case.inputs()
        drawn = named_sketch(case.sketch(q) if case.sketch else None, model_of(case))
        fields = case.inputs.model_fields
        for name, label in re.findall(r'<g data-input="(\w+)">.*?<text[^>]*>(.*?)</text>', drawn):
            words = re.split(r"\s*[=/,]\s*", Markup(label).striptags())[0]
            symbol = str(meta(fields[name])["symbol"] or name)
            assert words.replace("\u200b", "") == symbol.replace("_", ""), (case.id, label)
            marked += 1
    assert marked > 60


def test_answers_are_those_of_the_command_line_for_random_inputs(tmp_path: Path) -> None:
    made = random.Random(7)
    for case in ("ring-lame", "freewheel-cup", "contact-flat", "rotor-shaft", "spring-accordion"):
        described = describe(case)
        for _ in range(4):
            raw = {k: _scaled(v, made) for k, v in described.raw.items()}
            path = tmp_path / "my.toml"
            path.write_text(parameter_file(State(case, "my part", raw)), "utf-8")
            found = answered(case, raw, notes=True)
            output = io.StringIO()
            try:
                with contextlib.redirect_stdout(output):
                    run_check(path, Options(json=True))
            except InputError:
                assert found.verdict == ""
                continue
            told = json.loads(output.getvalue())
            checked = check_part(read(path), "my", Options(json=True), ThisProcess())
            assert found.verdict == told["answer"]["verdict"] == str(checked.answer.verdict)
            assert {v[0]: v[1] for v in found.values} == {
                v.symbol: f"{v.value:.6g}" for v in checked.result.values
            }
            worst = checked.answer.limiting
            if found.margin and worst:
                assert found.margin == margin(worst)


def _scaled(value: Any, made: random.Random) -> Any:
    """A text with its number changed by up to a tenth."""
    number, _, unit = str(value).partition(" ")
    if not unit:
        return value
    return f"{float(number) * made.uniform(0.9, 1.1):.6g} {unit}"


@pytest.mark.soak
def test_a_thousand_random_edits_of_all_forms_end_no_answer() -> None:
    made = random.Random(3)
    for number in range(EDITS):
        described = describe(CASES.ids[number % len(CASES.ids)])
        raw = dict(described.raw)
        for _ in range(made.randrange(1, 4)):
            raw = edited_raw(raw, made.choice(_places(described, raw)), made.choice(TEXTS))
        found = answered(described.id, raw)
        assert found.verdict or found.fault or found.faults


def _places(described: Any, raw: dict[str, Any]) -> list[str]:
    places = [f.name for f in described.fields if not f.is_table]
    for table in (f for f in described.fields if f.is_table):
        for k in range(1, len(raw.get(table.name, ())) + 1):
            places += [f"{table.name}[{k}].{f.name}" for f in table.fields]
    return places


def test_a_sweep_has_results_and_gaps_where_inputs_are_refused() -> None:
    found = sweep("ring-lame", "my", RING, ["r_i=70mm:90mm:3"], MARGIN, quietly)
    assert found.axes == (("r_i [mm]", (70.0, 80.0, 90.0)),)
    first, *rest = found.values[0]
    assert first == float(f"{float(first or 0):.6g}")
    assert rest == [None, None]
    assert found.problem


def test_a_sweep_over_two_inputs_is_a_grid() -> None:
    found = sweep(
        "ring-lame", "my", RING, ["r_i=50mm:60mm:3", "p_i=10MPa:20MPa:2"], DESIGN, quietly
    )
    assert [len(row) for row in found.values] == [3, 3]
    ratio = float(found.values[1][0] or 0) / float(found.values[0][0] or 1)
    assert ratio == pytest.approx(2, rel=1e-5)  # linear in the pressure


def test_the_figure_of_a_sweep_has_every_point() -> None:
    line = sweep("ring-lame", "my", RING, ["p_i=10MPa:30MPa:3"], "hoop_bore", quietly)
    drawn = options(line, dark=False)["series"][0]["data"]
    assert [x for x, _ in drawn] == pytest.approx([10, 20, 30])
    assert tuple(y for _, y in drawn) == line.values[0]
    last = answered("ring-lame", RING | {"p_i": "30 MPa"})
    assert f"{line.values[0][-1]:.6g}" in {v[1] for v in last.values if v[0] == "σ_θ(r_i)"}
    grid = sweep("ring-lame", "my", RING, ["p_i=10MPa:30MPa:3", "r_o=75mm:80mm:2"], MARGIN, quietly)
    cells = options(grid, dark=True)["series"][0]["data"]
    assert {(i, j): value for i, j, value in cells} == {
        (i, j): grid.values[j][i] for i in range(3) for j in range(2)
    }


def test_a_sweep_that_is_too_large_or_of_a_word_is_refused() -> None:
    with pytest.raises(InputError, match="at most 1000 points"):
        sweep("ring-lame", "my", RING, ["r_i=1mm:2mm:500", "p_i=1MPa:2MPa:3"], MARGIN, quietly)
    with pytest.raises(InputError, match="unknown input"):
        sweep("ring-lame", "my", RING, ["x=1:2:3"], MARGIN, quietly)
