"""The state of the page: edits, undo, parameter files, links."""

import random
from pathlib import Path

import pytest

from verify.app.page.link import BROKEN, from_link, to_link
from verify.app.page.session import Session, State, text_at, with_entry, without_entry
from verify.app.page.toml_text import as_values, parameter_file, read_state
from verify.core.inputs import InputError, read_parameter_file

RING = State("ring-lame", "my ring", {"r_i": "60 mm", "nu": "0.3"})
TABLE = State("rotor-system", "my shaft", {"shafts": [{"name": "a", "n": "3"}, {"name": "b"}]})


def test_letters_of_one_input_are_one_step_and_undo_takes_it_back() -> None:
    session = Session(RING)
    for text in ("6", "61", "61 mm"):
        session.edit("r_i", text)
    session.edit("nu", "0.29")
    assert session.undo()
    assert session.state.raw == {"r_i": "61 mm", "nu": "0.3"}
    assert session.undo()
    assert session.state == RING
    assert not session.undo()


def test_redo_takes_back_undo_until_something_is_typed() -> None:
    session = Session(RING)
    session.edit("nu", "0.2")
    session.undo()
    assert session.redo()
    assert session.state.raw["nu"] == "0.2"
    session.undo()
    session.edit("nu", "0.25")
    assert not session.redo()


def test_an_empty_text_leaves_the_input_out() -> None:
    session = Session(RING)
    session.edit("nu", " ")
    assert session.state.raw == {"r_i": "60 mm"}


def test_an_entry_of_a_table_is_edited_added_and_removed() -> None:
    session = Session(TABLE)
    session.edit("shafts[2].name", "c")
    assert text_at(session.state.raw, "shafts[2].name") == "c"
    assert TABLE.raw["shafts"][1] == {"name": "b"}  # earlier states stay
    raw = with_entry(TABLE.raw, "shafts", {"name": "d"})
    assert without_entry(raw, "shafts", 1)["shafts"] == [{"name": "b"}, {"name": "d"}]
    assert without_entry({"shafts": [{}]}, "shafts", 1) == {}


def test_a_text_that_is_too_long_and_an_entry_that_is_missing_are_refused() -> None:
    session = Session(TABLE)
    with pytest.raises(ValueError, match="at most 200 characters"):
        session.edit("x", "1" * 201)
    with pytest.raises(LookupError):
        session.edit("shafts[7].name", "c")
    assert session.state == TABLE


@pytest.mark.parametrize("state", [
    RING, TABLE, State("a", 'ü "quoted" \\ \x7f', {"x": "1e5", "y": ".5", "z": "-0"}),
    State("a", "b", {"w": "007", "v": '\x7f "\\', "k e y": "\u2603"}),
])  # fmt: skip
def test_a_file_and_a_link_reproduce_a_state(state: State, tmp_path: Path) -> None:
    path = tmp_path / "my.toml"
    path.write_text(parameter_file(state), "utf-8")
    assert from_link(to_link(state)) == state
    if state.name.isprintable():
        assert read_state(path) == state


def test_numbers_are_written_without_quotes_and_other_texts_with_them(tmp_path: Path) -> None:
    path = tmp_path / "my.toml"
    path.write_text(parameter_file(RING), "utf-8")
    assert read_parameter_file(path)[2] == {"r_i": "60 mm", "nu": 0.3}


def test_whole_numbers_are_values_and_others_stay_as_typed() -> None:
    raw = {"z": "12", "r": "12", "t": [{"z": "3.5"}]}
    assert as_values(raw, frozenset({"z"})) == {"z": 12, "r": "12", "t": [{"z": "3.5"}]}


def test_a_link_that_was_changed_is_an_error_of_one_line() -> None:
    link = to_link(TABLE)
    made = random.Random(1)
    messages = []
    for _ in range(300):
        letters = list(link)
        for _ in range(3):
            letters[made.randrange(len(letters))] = made.choice("aZ09-_é%")
        try:
            from_link("".join(letters[: made.randrange(1, len(letters) + 1)]))
        except InputError as error:
            messages.append(str(error))
    assert len(messages) > 250
    assert set(messages) == {BROKEN}


def test_a_link_does_not_unpack_to_more_than_its_limit() -> None:
    bomb = to_link(State("a", "b", {"x": "1" * 200} | {f"k{i}": "0" * 200 for i in range(2000)}))
    assert len(bomb) < 20_000
    with pytest.raises(InputError, match="no session"):
        from_link(bomb)
