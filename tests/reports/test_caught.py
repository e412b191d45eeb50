"""Fault detection on the page, in the PDF and in results.json."""

from dataclasses import replace

from scipy.stats import binomtest

from reports.caught import in_words, interval, moved, share
from reports.pdf_data import document
from reports.records import report_record
from tests.reports.conftest import section
from verify.core.results import Caught, MutantGroup, Survivor

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
        "listed": {"because": {"a fact: an order": [["a", None], ["b", 0.1]]}, "rows": 2,
                   "share": 0.0125, "share without convergence": 0.02},
        "rows": 160, "convergence": 58,
        "by formula": {"rows": 60, "reached": 50, "agree": 50, "hidden": [], "not reached": ["x"]},
        "apart": {"exact balances": 40, "deviations from zero": 3, "others": 7},
        "the rest": {"rows": 50, "red": {"+1 %": 49, "-1 %": 50}},
    },
)  # fmt: skip


def test_page_pdf_and_records_have_shares_counts_survivors_and_rows_without_a_requirement(wordy):
    one = replace(wordy, name="", caught=CAUGHT, validity=(), tables=(), errata=())
    text = section(one, "caught")
    for words in (
        "200 of 13000", '>97.0\u202f% <span class="unit">94 to 99\u202f%<',  # 150 and 44 of 200
        '150 <span class="unit">75.0\u202f%', '6 <span class="unit">3.0\u202f%', "2026-11-23",
        "a &lt; &lt;b&gt;", "all rows that must fail at ±1 %",
        "ring-lame/radius: passes with the reference changed by +1",
        '>a fact: an order</th><td class="n">2</td>',
        "and 10 do not; of those that depend on one, 0 pass in spite",
    ):  # fmt: skip
        assert words in text
    data = document(one, {})["caught"]
    assert data["groups"][0][1:4] == [
        "200 of 13000", "97.0\u202f% (94 to 99\u202f%)", "150 (75.0\u202f%)",
    ]  # fmt: skip
    assert [row["line"] for row in data["survivors"][0]["rows"]] == [46, 46]
    assert in_words(CAUGHT)[1] in str(data["moved"]["listed"])
    record = report_record(one)["caught"]
    assert record["groups"][0]["tried"] == 200
    assert record["references"]["gate"]["rows"] == 100
    without = replace(one, caught=None)
    assert document(without, {})["caught"] is report_record(without)["caught"] is None


def test_references_that_were_moved_have_a_line_for_each_kind_and_words():
    names, lines = moved(CAUGHT)
    assert names == ["+1 %", "-1 %"]
    assert [(line.kind, line.rows) for line in lines] == [
        ("identity", 60), ("all rows that must fail at ±1 %", 100),
        ("all rows that must fail at ±1 % and depend on a value of a formula", 50),
    ]  # fmt: skip
    assert lines[2].red == [49, 50]
    assert in_words(CAUGHT) == [
        "2 of 160 rows are not required to fail if their reference is changed by ±1 %. This is "
        "1.2 % of all rows, or 2.0 % of the rows that remain without the 58 convergence rows.",
        "If values of formulas are changed instead of references, 50 of the 60 rows with a formula "
        "depend on a changed value, and 10 do not; of those that depend on one, 0 pass in spite "
        "of the change.",
        "Rows that must fail if their reference is changed, but do not depend on any value of a "
        "formula: 40 exact "
        "balances, 3 deviations from zero, 7 others.",
    ]
    assert moved(Caught(date="2026-11-23")) == ([], [])
    assert in_words(Caught()) == []


def test_the_interval_of_a_share_is_wilson_s():
    found = binomtest(30, 37).proportion_ci(0.95, method="wilson")
    assert interval(30, 37) == f"{100 * found.low:.0f} to {100 * found.high:.0f}\u202f%"
    assert share(1, 0) == interval(1, 0) == ""
