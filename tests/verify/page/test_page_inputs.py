"""What is typed is read in its unit, and every wrong input is marked."""

from typing import Any

import pytest

from tests.verify.page.answered import RING, answered
from verify.app.page.answer_view import answer
from verify.app.page.described import describe
from verify.core.inputs import InputError


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
    assert found.faults == {"supports[1].node": "supports[1].node = 99: the nodes are 1 to 14"}


def test_inputs_that_are_missing_and_wrong_are_both_marked() -> None:
    raw = {k: v for k, v in RING.items() if k != "r_o"} | {"E": "2 mm"}
    assert set(answered("ring-lame", raw).faults) == {"r_o", "E"}
    assert answered("ring-lame", raw).faults["r_o"] == "missing"
