"""Templates of parameter files are complete and have the inputs of the paper."""

import re
import tomllib
from dataclasses import replace

import pytest

from tests.verify.template_text import joined, whole
from verify.answers.assumed.complete import complete
from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.template import template
from verify.answers.template_lines import aligned, remark
from verify.app.cli import run
from verify.cases.registry import CASES
from verify.core import inputs as kinds
from verify.core.inputs import Inputs, build, is_table, meta, quantity
from verify.studies.design.inputs import load as load_spring
from verify.studies.design_sprag.inputs import load as load_sprag

LINE = re.compile(r'^(# )?(\w+) = (".+"|[-+.e0-9]+) +# (.+)$')
TABLE = re.compile(r"\[\[inputs\.(\w+)\]\]\n")


def lines_in(text):
    """Commented out or not, name, value and comment of every line of an input."""
    return [found.groups() for line in text.splitlines() if (found := LINE.fullmatch(line))]


def inputs_in(case):
    """Fields and lines of the case, and of the first entry of each of its tables."""
    fields = case.inputs.model_fields
    body = joined(template(case)).partition("[inputs]\n")[2].partition("\n# Or ")[0]
    own, *parts = TABLE.split(body)
    own = own if case.id in ASSUMPTIONS else own.partition("\n\n")[0]
    yield {n: f for n, f in fields.items() if not is_table(f)}, lines_in(own)
    first = {}
    for name, text in zip(parts[::2], parts[1::2], strict=True):
        first.setdefault(name, text.partition("\n\n")[0])
    assert list(first) == [n for n, f in fields.items() if is_table(f)]
    for name, text in first.items():
        yield kinds.entry_model(fields[name]).model_fields, lines_in(text)


def test_a_template_builds_to_the_paper_s_inputs_and_a_tool_s_needs_eight_lines_at_most():
    for case in CASES:
        text = whole(template(case)) if case.id in ASSUMPTIONS else template(case)
        data = tomllib.loads(text)
        assert data["case"] == case.id
        assert build(case.inputs, data["inputs"], "template") == case.inputs()
    for case in (case for case in CASES if case.id in ASSUMPTIONS):
        begin = joined(template(case)).partition("[inputs]\n")[2].partition("\n\n")[0].splitlines()
        assert 1 <= len(begin) <= 8
        given = tomllib.loads(template(case))["inputs"]
        scalars = {name for name, value in given.items() if not isinstance(value, list)}
        assert scalars == {line.partition(" =")[0] for line in begin}
        complete(case.id, case.inputs, given, "template")


def test_a_template_of_a_task_begins_with_what_it_needs(tmp_path, capsys):
    for task, load in (("design-spring", load_spring), ("design-sprag", load_sprag)):
        assert run(["init", task]) == 0
        text = capsys.readouterr().out
        assert len(tomllib.loads(text)["inputs"]) == 4
        path = tmp_path / "task.toml"
        path.write_text(text, encoding="utf-8")
        found = load(path)
        assert found.assumed
        assert all(one.source in joined(text) for one in found.assumed)


def test_no_line_is_longer_than_a_hundred_columns(capsys):
    for task in (*CASES.ids, "design-spring", "design-sprag"):
        assert run(["init", task]) == 0
        assert max(map(len, capsys.readouterr().out.splitlines())) <= 100


@pytest.mark.parametrize("word", ["100 mm", "line-by-line"])
def test_numbers_stay_with_their_units_and_words_are_not_broken(word):
    for length in range(60, 100):
        text = f"{'x' * length} {word} end"
        for written in (remark(text), aligned([("a = 1", text), ("# b = 2", text)])):
            assert word in written
            assert max(map(len, written.splitlines())) <= 98


def test_optional_lines_can_be_uncommented_together(capsys):
    """As by the command of an editor, which takes a # and a space away from the lines."""
    for task in ("freewheel-clutch", "design-spring"):
        assert run(["init", task]) == 0
        text = capsys.readouterr().out.partition("\n# Optional: ")[2].partition("\n")[2]
        lines = text.partition("\n\n")[0].splitlines(keepends=True)
        assert any(line.startswith("#   ") for line in lines)
        shown = "".join(line.removeprefix("#").removeprefix(" ") for line in lines)
        assert tomllib.loads(shown) == tomllib.loads(whole("".join(lines)))
        assert len(tomllib.loads(shown)) > 10


def test_every_line_has_a_unit_a_description_a_range_and_a_source():
    for case in CASES:
        assumed = {one.name: one.source for one in ASSUMPTIONS.get(case.id, ())}
        for fields, lines in inputs_in(case):
            assert sorted(name for _, name, _, _ in lines) == sorted(fields)
            for line in lines:
                own = fields[line[1]] is case.inputs.model_fields.get(line[1])
                check_line(fields[line[1]], assumed.get(line[1], "") if own else "", *line)


def check_line(field, source, hidden, _name, value, comment):
    about = meta(field)
    assert about["what"] in comment
    assert source in comment
    if words := kinds.choices(field):
        assert f"one of {', '.join(words)}" in comment
    elif about["unit"] == "1":
        assert ("text" if field.annotation is str else "number") in comment
    else:
        assert value.strip('"').endswith(about["unit"])
    if field.metadata:
        assert re.search(r"at (least|most)|(greater|less) than", comment)
    optional = bool(source) or about["omitted"] != kinds.REQUIRED
    assert ("optional" in comment) == optional
    assert not hidden or optional
    if about["claims"]:
        assert about["claims"].partition(":")[0] in comment


def test_wrong_words_are_one_line_and_two(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "my.toml"
    path.write_text("mine")
    for arguments, message in (
        ("ring-lam", "unknown case 'ring-lam', did you mean ring-lame?"),
        ("design-spragg", "tasks of freewheel design are design-spring, design-sprag"),
        ("ring-lame --out no/my.toml", "No such file or directory"),
        ("ring-lame --out my.toml", "my.toml: exists already and is not overwritten"),
    ):
        assert run(["init", *arguments.split()]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert message in line
    assert path.read_text() == "mine"


def test_numbers_that_do_not_end_are_written_to_their_last_digit():
    class Awkward(Inputs):
        L: float = quantity(f"{100 / 3} mm", "mm", "L", "a third of a decimetre")
        alpha: float = quantity("1 rad", "deg", "α", "one radian")

    raw = tomllib.loads(template(replace(CASES[0], inputs=Awkward)))["inputs"]
    read = build(Awkward, raw, "template").model_dump()
    assert read == pytest.approx(Awkward().model_dump(), rel=3e-16)
