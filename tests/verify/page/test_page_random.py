"""Random edits in a browser: every answer is the command line's, and nothing is an error."""

import contextlib
import io
import json
import random
from pathlib import Path
from typing import Any

import pytest

from tests.verify.page.conftest import Server, missing

if reason := missing():
    pytest.skip(reason, allow_module_level=True)

from tests.verify.page.answered import TEXTS, places
from tests.verify.page.browsing import Browser
from verify.app.check_command import Options, run_check
from verify.app.page.described import Described, Field, describe
from verify.app.page.session import State, edited_raw, text_at
from verify.app.page.toml_text import parameter_file
from verify.core.inputs import InputError

QUICK = ("ring-lame", "freewheel-cup", "contact-flat", "spring-accordion")
LONG = ("freewheel-clutch", "rotor-system")  # a form of words, and one of tables
CASES = [*QUICK, *(pytest.param(name, marks=pytest.mark.soak) for name in LONG)]
EDITS = 15  # of each case
TABLE = """return [...document.querySelectorAll("#answer details")]
    .filter(one => one.textContent.startsWith("Values"))
    .flatMap(one => [...one.querySelectorAll("tr")])
    .map(row => [...row.children].map(cell => cell.textContent.replaceAll("\\u200b", "")))"""
pytestmark = pytest.mark.slow("a browser opens the page")


def text_of(made: random.Random, before: str) -> str:
    """A text from the list, or the number that was there, changed a little."""
    number, _, unit = before.partition(" ")
    if not unit or made.random() < 0.3:
        return made.choice(TEXTS)
    return f"{float(number) * made.uniform(0.95, 1.05):.5g}{made.choice((f' {unit}', unit, ''))}"


def printed_answer(state: State, folder: Path) -> tuple[str, dict[str, str]]:
    """Verdict and values of `freewheel check --json`; "" where the inputs are refused."""
    path, output = folder / "my.toml", io.StringIO()
    path.write_text(parameter_file(state), "utf-8")
    try:
        with contextlib.redirect_stdout(output):
            run_check(path, Options(json=True, notes=False))
    except InputError:
        return "", {}
    found = json.loads(output.getvalue())
    values = {v["symbol"].replace("_", ""): f"{v['value']:.6g}" for v in found["values"]}
    return found["answer"]["verdict"], values


def put(page: Browser, field: Field, place: str, text: str) -> None:
    """Type or choose a text."""
    if field.words:  # by keys, as a driver's click is no `input`
        page.input(place).send_keys(text or "left out")
    else:
        page.type(place, text)


def edited(case: Described, state: State, made: random.Random) -> tuple[Field, str, str, State]:
    """An input with another text, and the state that this is to give."""
    while True:
        place, field = made.choice(places(case, state.raw))
        before = text_at(state.raw, place)
        text = made.choice(["", *field.words]) if field.words else text_of(made, before)
        raw = edited_raw(state.raw, place, case.entered(place, text))
        if raw != state.raw:
            return field, place, text, State(state.case, state.name, raw)


def displayed(page: Browser) -> tuple[Any, str, dict[str, str]]:
    """The inputs of the answer that the page shows, its verdict and its values."""
    rows = page.driver.execute_script(TABLE)
    verdict = page.verdict
    assert page.state is not None
    return (
        page.state.raw, "" if "No answer" in verdict else verdict[2:].lower(),
        {row[0]: row[1] for row in rows[1:]},
    )  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_answers_after_random_edits_are_those_of_the_command_line(
    name: str, driver: Any, server: Server, tmp_path: Path
) -> None:
    page, made, answered = Browser(driver, server.address), random.Random(5), 0
    driver.get_log("browser")
    page.open(name)
    case = describe(name)
    for _ in range(EDITS):
        before = page.state
        assert before is not None
        field, place, text, state = edited(case, before, made)
        put(page, field, place, text)
        expected = (state.raw, *printed_answer(state, tmp_path))
        with contextlib.suppress(AssertionError):  # the next line tells what differs
            page.until(lambda: displayed(page) == expected, 20)  # noqa: B023
        assert displayed(page) == expected
        answered += bool(expected[1])
        if not expected[1]:  # the next edit is one of a part with an answer
            put(page, field, place, text_at(before.raw, place))
            page.until(lambda: displayed(page)[0] == before.raw, 20)  # noqa: B023
    assert answered
    severe = [e["message"] for e in driver.get_log("browser") if e["level"] == "SEVERE"]
    assert severe == []
    assert "Traceback" not in server.text
    assert "ERROR" not in server.text.upper()
