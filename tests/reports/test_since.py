"""What moved since a release, and what numbers may mean, on the page and on paper."""

from dataclasses import replace

import pytest

from reports import readings, since
from reports.equations import Glyphs
from reports.html import page as with_equations_drawn
from reports.pdf import pdf
from reports.records import report_record
from verify.cases.registry import CASES
from verify.core.results import Change, Drift, ReadingsTried
from verify.jobs.cache import default_folder
from verify.studies.readings.tried import searches


def page(report, frames):
    """The page, with the equations that earlier runs drew."""
    return with_equations_drawn(report, frames, Glyphs(default_folder()))


STILL = Drift(release="0.1.0", date="2026-01-01", commit="abc", compared=89, tightened=0)
LOOSE = Change(row="ring-lame/bore displacement, plane stress", aspect="demand", was="1 %",
               now="2 %", loosened=True)  # fmt: skip
MOVED = Change(row="ring-lame/<b>x", aspect="formula", was="1 mm", now="2 mm",
               size="+1 of the scale")  # fmt: skip
EXPLAINED = replace(LOOSE, aspect="interval", reason="thin rings are of it now")
TIGHT = replace(MOVED, aspect="bound", was="2 %", now="1 %", size="")
DRIFT = replace(
    STILL,
    tightened=1,
    tighter=(TIGHT,),
    changes=(MOVED, EXPLAINED, LOOSE),
    unused=("c/q: demand: w",),
)

FOUND = ReadingsTried(
    reference="wang2023:k1-theory", place="Table 1", printed="0.601", unit="N/mm", what="Eqs. 1-9",
    as_it_stands=0.0168, tried=255, hits=2, readings=("b for h", "one side"), value=0.60096,
    chance=0.032, is_evidence=True, errata=("eq-3-leaf-length",),
)  # fmt: skip
MISSING = ReadingsTried(reference="wang2023:b", place="Sec. 1", printed="0.1", unit="mm",
                        missing="a thickness <b>")  # fmt: skip


@pytest.fixture
def shown(wordy):
    """One case with everything there is to tell."""
    return replace(wordy, name="", drift=DRIFT, searches=(FOUND, MISSING))


def test_nothing_moved_is_one_line_and_no_table(wordy):
    html = page(replace(wordy, name="", drift=STILL), {})
    section = html.partition('<section id="since">')[2].partition("</section>")[0]
    assert "89 rows compared, nothing moved" in section
    assert "<table" not in section
    assert "loosened without a reason" not in html


def test_a_first_version_and_own_parameters_have_no_such_section(wordy):
    html = page(replace(wordy, name="", drift=None), {})
    assert 'id="since"' not in html
    assert 'id="readings"' not in html


def test_what_was_loosened_without_a_reason_stands_first_and_in_a_banner(shown):
    html = page(shown, {})
    assert "1 tolerance loosened without a reason" in html
    section = html.partition('<section id="since">')[2].partition("</section>")[0]
    places = [section.index(text) for text in ("without a reason</b>", "thin rings", "+1 of the")]
    assert places == sorted(places)
    assert "<b>x" not in section
    assert "Reasons that nothing asks for" in section


def test_what_was_tightened_is_counted_and_listed(shown):
    section = page(shown, {}).partition('<section id="since">')[2].partition("</section>")[0]
    folded = section.partition("<details><summary>Tightened")[2].partition("</details>")[0]
    assert "1 row<" in folded
    assert "<td>bound</td><td>2\u202f%</td><td>1\u202f%</td>".replace("\u202f", " ") in folded
    assert since.since_data(DRIFT)["tighter"][0][1:4] == [["bound"], ["2 %"], ["1 %"]]
    assert "Tightened" not in page(replace(shown, drift=replace(DRIFT, tighter=())), {})


def test_a_number_without_a_unit_has_none_on_paper():
    (said,) = readings.readings_data((replace(MISSING, unit="1"),))["missing"]
    assert "".join(map(str, said)).startswith("wang2023:b (0.1): ")


def test_many_changes_are_cut_and_said_to_be():
    many = replace(STILL, changes=(*(MOVED,) * 500, LOOSE))
    assert len(since.shown(many)) == since.MOST
    assert since.shown(many)[0] == LOOSE
    assert since.left_out(many) == f"{501 - since.MOST} more stand in results.json, drift."
    assert since.left_out(STILL) == ""


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({}, "b for h and one side (0.60096); 1 other combination too"),
        ({"hits": 3, "is_evidence": False},
         "b for h and one side (0.60096); 2 other combinations too; no evidence"),
        ({"readings": (), "hits": 0}, "none"),
        ({"met": True}, "met as it stands, within the rounding of what it is computed from; "
                        "no other reading is needed"),
    ],
)  # fmt: skip
def test_what_a_search_found_in_words(change, words):
    assert readings.found(replace(FOUND, **change)) == words


def test_readings_stand_on_the_page_with_their_chance_and_what_has_no_formula(shown):
    section = page(shown, {}).partition('<section id="readings">')[2].partition("</section>")[0]
    for text in ("b for h and one side (0.60096)", "0.032", "eq-3-leaf-length", "255"):
        assert text in section
    assert "a thickness &lt;b&gt;" in section
    assert len(section) < 40_000


def test_paper_and_records_have_both(shown):
    assert pdf(shown, {}).startswith(b"%PDF")
    record = report_record(shown)
    assert record["drift"]["unexplained"] == 1
    assert [c["aspect"] for c in record["drift"]["changes"]] == ["formula", "interval", "demand"]
    assert record["readings_tried"][0]["readings"] == ["b for h", "one side"]
    assert report_record(replace(shown, drift=None))["drift"] is None


def test_all_of_it_takes_little_room_in_a_whole_report(wordy):
    every = searches([case.id for case in CASES])
    html = page(replace(wordy, name="", drift=STILL, searches=every), {})
    for name in ("since", "readings"):
        section = html.partition(f'<section id="{name}">')[2].partition("</section>")[0]
        assert 0 < len(section.encode()) < 40_000
