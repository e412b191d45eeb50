"""The record: few pages, one for each case, with the most important rows that fit on it."""

import re
from dataclasses import replace

import pytest

from reports import write as writing
from reports.pdf import pdf
from reports.pdf_data import document
from reports.pdf_one_page import by_weight
from reports.pdf_record import BYTES, PAGES, record
from tests.reports.conftest import first_of, sheets_of
from tests.reports.test_pdf import NEEDS_POPPLER, RIGHT, read
from verify.cases.registry import CASES
from verify.core.results import Kind, Status
from verify.jobs.cache import default_folder
from verify.verdicts.record import kept


@pytest.fixture(scope="module")
def paper(recorded) -> bytes:
    return pdf(recorded, {}, record)


@NEEDS_POPPLER
def test_each_case_has_one_page_with_its_verdict_rows_and_where_the_rest_is(
    paper, recorded, tmp_path
):
    pages = re.sub(r"[^\S\f]+", " ", read(paper, tmp_path, "-layout").replace("\u200b", ""))
    for case in recorded.cases:
        (page,) = [
            text for text in pages.split("\f") if f"All of this case: report/{case.id}.html" in text
        ]
        assert page.count(f" {case.id} · ") == 1  # its head
        assert "Formula and reference" in page
        marks = len(re.findall("|".join(f"[✓×!≈◇–] {s}" for s in Status), page))
        shown = marks - len({row.status for row in case.rows})  # less the counts of the head
        more = re.search(r"(\d+) more rows in", page)
        assert shown + int(more[1] if more else 0) == len(by_weight(case, ()))
        assert shown >= 4


def test_the_suite_fits_its_limits(paper, recorded):
    """The pages before the cases, with the verdicts of all papers, and one for each case."""
    before = sheets_of(paper) - len(recorded.cases)
    index = len(CASES) // 40 + 1
    assert before + index + len(CASES) <= PAGES
    assert len(paper) / sheets_of(paper) * PAGES < BYTES


def test_a_page_that_is_full_leaves_out_rows_and_then_drawings(wordy, report):
    """One page for any case: 200 rows with long reasons, a lead of half a page."""
    (case,) = wordy.cases
    rows = tuple(
        replace(case.rows[0], quantity=f"{i}", reason="why " * 120, status=Status.NOTE)
        for i in range(200)
    )
    full = replace(case, rows=rows, lead="word " * 700, figures=report.cases[0].figures)
    long = replace(wordy, name="", cases=(full,))
    short = replace(long, cases=(replace(full, rows=rows[:1], lead=""),))
    assert sheets_of(pdf(long, {}, record)) == sheets_of(pdf(short, {}, record))


@NEEDS_POPPLER
def test_no_word_stands_beyond_the_margins(paper, wordy, tmp_path):
    for data in (paper, pdf(replace(wordy, name=""), {}, record)):
        ends = re.findall(r'<word .*xMax="([\d.]+)"', read(data, tmp_path, "-bbox"))
        assert len(ends) > 100
        assert max(map(float, ends)) <= RIGHT + 0.5


@pytest.mark.parametrize("name", ["spring-map", "freewheel-torque"])
def test_rows_of_most_weight_come_first(report, name):
    case = next(c for c in report.cases if c.id == name)
    verdicts = [v for v in kept() if case.id in v.cases]
    evidence = {row for v in verdicts for row in (*v.rows, *v.model_rows)}

    def weight(row):
        is_settled = row.status is Status.PASS and row.kind in (Kind.EXACT, Kind.FACT)
        return row.id not in evidence, not row.published, is_settled

    failed, *others = case.rows
    others.sort(key=weight, reverse=True)
    rows = (*others, replace(failed, status=Status.FAIL))
    first, *ordered = [line.row for line in by_weight(replace(case, rows=rows), verdicts)]
    assert first.quantity == failed.quantity
    found = [weight(row) for row in ordered]
    assert found == sorted(found)
    assert len(set(found)) >= 3


def test_the_first_page_names_what_is_not_to_be_used_and_varied_inputs_come_first(recorded):
    data = record(recorded, {})
    wang = next(p for p in data["papers"] if p["cited"] == "Wang 2023")
    assert "Eq. 6" in wang["unusable"]
    assert "Eq. 9 corrected" not in wang["unusable"]
    (table,) = wang["tables"]
    assert table["rows"]
    assert all(row["claims"] and not row["inputs"] for row in table["rows"])
    ids = {e["id"] for e in wang["errata"]}
    assert ids == {e for v in kept() if v.paper == "wang2023" for e in v.errata}
    case = next(c for c in data["cases"] if c["id"] == "polyhedral-ring")
    varied = [i["is_varied"] for i in (*case["inputs"], *case["more_inputs"])]
    assert varied[0] > varied[-1]
    assert varied == sorted(varied, reverse=True)
    assert len(varied) == len(next(c for c in recorded.cases if c.id == case["id"]).inputs)


def test_a_run_without_verdicts_or_on_one_page_states_this(report):
    data = record(report, {}, single_file=True)
    assert data["counted"] is None
    assert {c["page"] for c in data["cases"]} == {"report.html"}


def test_the_record_is_the_default_of_several_cases(report, tmp_path, monkeypatch):
    """The PDF is not typeset here, only requested."""
    asked = []
    monkeypatch.setattr(writing, "content", lambda _report, _drawn, make: asked.append(make))
    monkeypatch.setattr(writing, "printed", lambda *_: b"%PDF")
    two = first_of(report, 2)
    for full in (False, True):
        writing.write(two, tmp_path, cache=default_folder(), full_pdf=full)
    default, full = asked
    assert (default.func, default.keywords, full) == (record, {"single_file": False}, document)
