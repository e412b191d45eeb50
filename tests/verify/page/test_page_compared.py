"""Two variants: what differs is listed first, what is identical is folded away."""

import re
from typing import Any

from markupsafe import Markup

from verify.app.page.answers import Shown, shown
from verify.app.page.compared import compared
from verify.app.page.described import describe
from verify.app.page.toml_text import as_values


def side_by_side(case: str, a: dict[str, Any], b: dict[str, Any]) -> str:
    made = describe(case)
    found = [_shown(case, as_values(raw, made.whole)) for raw in (a, b)]
    return str(compared(made, (a, b), (found[0], found[1])))


def _shown(case: str, raw: dict[str, Any]) -> Shown:
    return shown(case, "my part", raw, False, lambda _state: None)


def rows(html: str) -> list[list[str]]:
    found = [re.findall("<td>(.*?)</td>", line) for line in re.findall(r"<tr>(.*?)</tr>", html)]
    return [[Markup(cell).striptags().strip("\u200b") for cell in line] for line in found if line]


def test_what_differs_has_symbol_and_meaning_and_comes_first() -> None:
    raw = dict(describe("freewheel-clutch").raw)
    html = side_by_side("freewheel-clutch", raw, raw | {"T": "30 N m", "mu": "0.1"})
    first, _, folded = html.partition("<details>")
    listed = rows(first)
    what = {f.name: f.what for f in describe("freewheel-clutch").fields}
    assert ["T", what["T"], "26 N m", "30 N m"] in listed
    mu = next(line for line in listed if line[0] == "μ")
    assert mu[1:] == [what["mu"], "0.08, assumed", "0.1"]
    assert next(line for line in listed if line[0] == "α")[1].startswith("clamping angle")
    assert all(line[-1] != line[-2] for line in listed if len(line) == 4)
    assert ["R", what["R"], "16.5 mm"] in rows(folded)
    assert "R" not in {line[0] for line in listed}


def test_an_input_that_is_left_out_shows_what_is_assumed() -> None:
    raw = dict(describe("freewheel-clutch").raw)
    assert "mu" not in raw
    html = side_by_side("freewheel-clutch", raw, raw | {"mu": "0.1", "p_lim": "3000 MPa"})
    listed = {line[0]: line for line in rows(html) if len(line) == 4}
    assert listed["μ"][2:] == ["0.08, assumed", "0.1"]
    assert listed["plim"][2:] == ["4000 MPa, assumed", "3000 MPa"]


def test_entries_of_tables_are_compared_by_entry() -> None:
    raw = dict(describe("rotor-system").raw)
    supports = [*raw["supports"][:1], {**raw["supports"][1], "k": "50 N/µm"}]
    html = side_by_side("rotor-system", raw, raw | {"supports": supports})
    listed = {line[0]: line for line in rows(html.partition("<details>")[0])}
    assert listed["supports[2] k"][1:] == ["radial stiffness", "40 N/µm", "50 N/µm"]
    assert listed["supports[3] k"][2:] == ["40 N/µm", "left out"]
    assert "supports[1] k" not in listed


def test_variants_that_are_equal_and_a_wrong_variant() -> None:
    raw = dict(describe("ring-lame").raw)
    html = side_by_side("ring-lame", raw, raw)
    assert "Inputs do not differ." in html
    assert "Values do not differ." in html
    wrong = side_by_side("ring-lame", raw, raw | {"r_i": "x"})
    assert ["verdict", "holds", "wrong input"] in rows(wrong)
    assert "Values" not in wrong
