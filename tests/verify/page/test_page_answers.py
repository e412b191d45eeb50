"""The page gives the answers of the command line, and draws inputs with their names."""

import contextlib
import io
import json
import random
import re
from pathlib import Path
from typing import Any

import pytest
from markupsafe import Markup

from tests.verify.page.answered import RING, TEXTS, answered, places
from verify.answers.console import margin
from verify.answers.parameter_file import read
from verify.app.check_command import Options, check_part, run_check
from verify.app.page.described import describe, model_of
from verify.app.page.session import State, edited_raw
from verify.app.page.sketches import named_sketch
from verify.app.page.toml_text import parameter_file
from verify.cases.registry import CASES, find
from verify.core.inputs import InputError, meta
from verify.jobs.executor import ThisProcess

EDITS = 1000


@pytest.mark.parametrize("case", CASES.ids)
def test_every_case_has_a_form_whose_template_has_an_answer(case: str) -> None:
    made = describe(case)
    assert {f.name for f in made.fields} >= set(made.raw)
    assert answered(case, dict(made.raw)).verdict


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
            printed = json.loads(output.getvalue())
            checked = check_part(read(path), "my", Options(json=True), ThisProcess())
            assert found.verdict == printed["answer"]["verdict"] == str(checked.answer.verdict)
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
            raw = edited_raw(raw, made.choice(places(described, raw))[0], made.choice(TEXTS))
        found = answered(described.id, raw)
        assert found.verdict or found.fault or found.faults
