"""What the suite catches, on the page, in the PDF and in results.json."""

from dataclasses import replace

import pytest

from reports.caught import moved, share, survivors
from reports.html import page
from reports.pdf_data import document
from reports.records import report_record
from verify.results import Caught, MutantGroup, Report, Survivor

GROUP = MutantGroup(
    name="formulas", all=13000, tried=200, rows=150, tests=44, survived=6, apart=9
)  # fmt: skip
ARGUED = Survivor(
    group="formulas", where="analytic.ring.lame.stresses", line=46, operator="sign",
    before="-A", after="A", reason="only r_o**2 is used",
)  # fmt: skip
BARE = replace(ARGUED, where="analytic.b.f", before="a < <b>", reason="")
RED = {"+1 %": 99, "-1 %": 100}
CAUGHT = Caught(
    date="2026-11-23", groups=(GROUP,), survivors=(ARGUED, BARE),
    references={
        "kinds": {"identity": {"rows": 60, "red": {"+1 %": 59, "-1 %": 60}},
                  "trend": {"rows": 0, "red": {"+1 %": 0, "-1 %": 0}}},
        "gate": {"held": False, "failures": ["x"], "rows": 100, "red": RED},
        "survivors": [{"row": "ring-lame/radius", "green at": ["+1 %", "-0.5 %"]}],
        "listed": {"because": {"a fact: an order": [["a", None], ["b", 0.1]]}},
    },
)  # fmt: skip


@pytest.fixture(scope="module")
def one(wordy) -> Report:
    return replace(wordy, name="", caught=CAUGHT, validity=(), tables=(), errata=())


def section(report: Report) -> str:
    text = page(report, {})
    return text[text.index('<section id="caught">') : text.index('<section id="provenance">')]


def test_shares_stand_beside_their_counts(one):
    text = section(one)
    assert "200 of 13000" in text
    assert ">97.0\u202f%<" in text  # 150 and 44 of 200
    assert '150 <span class="unit">75.0\u202f%' in text
    assert '6 <span class="unit">3.0\u202f%' in text
    assert "2026-11-23" in text
    assert share(1, 0) == ""


def test_survivors_are_listed_with_their_reasons_those_without_first(one):
    text = section(one)
    assert text.index("no reason known") < text.index("only ")
    assert "a &lt; &lt;b&gt;" in text
    assert "Survivors among formulas: 2" in text
    (group,) = survivors(CAUGHT)
    assert [survivor.reason for survivor in group[1]] == ["", ARGUED.reason]


def test_references_that_were_moved_have_a_line_for_each_kind(one):
    text = section(one)
    assert "all that must turn red at ±1 %" in text
    assert "ring-lame/radius at +1" in text
    assert "2 (a fact: an order)" in text
    names, lines = moved(CAUGHT)
    assert names == ["+1 %", "-1 %"]
    assert [(line.kind, line.rows) for line in lines] == [
        ("identity", 60), ("all that must turn red at ±1 %", 100),
    ]  # fmt: skip
    assert moved(Caught(date="2026-11-23")) == ([], [])


def test_what_is_not_measured_says_so_and_nothing_else(one):
    text = section(replace(one, caught=Caught(missing="not measured for this code: do it")))
    assert "Not measured for this code: do it." in text
    assert "<table" not in text


def test_a_report_on_one_s_own_parameters_has_no_section(one):
    text = page(replace(one, caught=None), {})
    assert 'id="caught"' not in text
    assert 'href="#caught"' not in text


def test_the_pdf_and_the_records_have_the_same(one):
    data = document(one, {})["caught"]
    assert data["groups"][0][1:4] == ["200 of 13000", "97.0\u202f%", "150 (75.0\u202f%)"]
    assert [row["line"] for row in data["survivors"][0]["rows"]] == [46, 46]
    assert document(replace(one, caught=None), {})["caught"] is None
    record = report_record(one)["caught"]
    assert record["groups"][0]["tried"] == 200
    assert record["references"]["gate"]["rows"] == 100
    assert report_record(replace(one, caught=None))["caught"] is None
