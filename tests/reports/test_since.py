"""Changes since a release, and the meaning of numbers, on the page and on paper."""

from dataclasses import replace

import pytest

from reports import readings
from reports.html import page
from reports.records import report_record
from tests.reports.conftest import section
from verify.core.results import Change, Drift, ReadingsTried

STILL = Drift(release="0.1.0", date="2026-01-01", commit="abc", compared=89, tightened=0)
LOOSE = Change(row="ring-lame/bore displacement, plane stress", aspect="demand", was="1 %",
               now="2 %", loosened=True)  # fmt: skip
MOVED = Change(row="ring-lame/<b>x", aspect="formula", was="1 mm", now="2 mm",
               size="+1 of the scale")  # fmt: skip
EXPLAINED = replace(LOOSE, aspect="interval", reason="thin rings are of it now")
TIGHT = replace(MOVED, aspect="bound", was="2 %", now="1 %", size="")
DRIFT = replace(STILL, tightened=1, tighter=(TIGHT,), changes=(MOVED, EXPLAINED, LOOSE),
                unused=("c/q: demand: w",))  # fmt: skip
FOUND = ReadingsTried(
    reference="wang2023:k1-theory", place="Table 1", printed="0.601", unit="N/mm", what="Eqs. 1-9",
    as_it_stands=0.0168, tried=255, hits=2, readings=("b for h", "one side"), value=0.60096,
    chance=0.032, is_evidence=True, errata=("eq-3-leaf-length",),
)  # fmt: skip
MISSING = ReadingsTried(reference="wang2023:b", place="Sec. 1", printed="0.1", unit="mm",
                        missing="a thickness <b>")  # fmt: skip


@pytest.fixture
def shown(wordy):
    """One case with all contents of a report."""
    return replace(wordy, name="", drift=DRIFT, searches=(FOUND, MISSING))


def test_nothing_moved_is_one_line_and_a_loosened_tolerance_stands_first_and_in_a_banner(shown):
    still = section(replace(shown, drift=STILL), "since")
    assert "89 rows compared, no changes" in still
    assert "<table" not in still
    assert "1 tolerance loosened without a reason" in page(shown, {})
    text = section(shown, "since")
    places = [text.index(words) for words in ("without a reason</b>", "thin rings", "+1 of the")]
    assert places == sorted(places)
    assert "<b>x" not in text
    assert "Reasons without a matching change" in text


def test_what_a_search_found_in_words():
    words = "b for h; one side (0.60096)"
    met = ("the formula gives the number, within the rounding of its inputs; "
           "no other reading is needed")  # fmt: skip
    for change, expected in (
        ({}, f"{words}; the printed number also follows from 1 other combination"),
        (
            {"hits": 3, "is_evidence": False},
            f"{words}; the printed number also follows from 2 other combinations; "
            "the agreement may be accidental",
        ),
        ({"readings": (), "hits": 0}, "no reading"),
        ({"met": True}, met),
    ):
        assert readings.found(replace(FOUND, **change)) == expected


def test_page_and_records_have_readings_with_their_chance(shown):
    text = section(shown, "readings")
    for words in ("b for h; one side (0.60096)", "0.032", "eq-3-leaf-length", "255",
                  "a thickness &lt;b&gt;"):  # fmt: skip
        assert words in text
    record = report_record(shown)
    assert record["drift"]["unexplained"] == 1
    assert [c["aspect"] for c in record["drift"]["changes"]] == ["formula", "interval", "demand"]
    assert record["readings_tried"][0]["readings"] == ["b for h", "one side"]
    assert report_record(replace(shown, drift=None))["drift"] is None
