"""The record: few pages, one for each case, with the rows of most weight that fit on it."""

import re
import subprocess
from dataclasses import replace

import pytest

from reports.pdf import pdf
from reports.pdf_one_page import by_weight
from reports.pdf_record import BYTES, PAGES, record
from reports.write import PAPER, write
from tests.reports.conftest import sheets_of
from tests.reports.test_pdf import NEEDS_POPPLER, RIGHT
from verify.app.report import make_report
from verify.cases.registry import CASES, find
from verify.core.results import Kind, Status
from verify.jobs.cache import default_folder
from verify.verdicts.record import kept

LAST = (Kind.EXACT, Kind.FACT)


def pages(paper: bytes, folder) -> list[str]:
    """What pdftotext reads of each page."""
    (folder / "r.pdf").write_bytes(paper)
    run = ["pdftotext", "-layout", str(folder / "r.pdf"), "-"]
    text = subprocess.run(run, capture_output=True, text=True, check=True).stdout
    return [re.sub(r"\s+", " ", page.replace("\u200b", "")) for page in text.split("\f")[:-1]]


@pytest.fixture(scope="module")
def with_verdicts(report):
    return replace(report, verdicts=kept())


@pytest.fixture(scope="module")
def paper(with_verdicts) -> bytes:
    return pdf(with_verdicts, {}, record)


@NEEDS_POPPLER
def test_each_case_has_one_page_with_its_verdict_rows_and_where_the_rest_is(
    paper, with_verdicts, tmp_path
):
    read = pages(paper, tmp_path)
    for case in with_verdicts.cases:
        (page,) = [text for text in read if f"All of this case: report/{case.id}.html" in text]
        assert page.count(f" {case.id} · ") == 1  # its head
        assert "Formula and reference" in page
        marks = len(re.findall("|".join(f"[✓×!≈◇–] {s}" for s in Status), page))
        shown = marks - len({row.status for row in case.rows})  # less the counts of the head
        more = re.search(r"(\d+) more rows in", page)
        assert shown + int(more[1] if more else 0) == len(by_weight(case, ()))
        assert shown >= 4


def test_the_suite_fits_its_limits(paper, with_verdicts):
    """The pages before the cases, with the verdicts of all papers, and one for each case."""
    before = sheets_of(paper) - len(with_verdicts.cases)
    index = len(CASES) // 40 + 1
    assert before + index + len(CASES) <= PAGES
    assert len(paper) / sheets_of(paper) * PAGES < BYTES


def test_a_page_that_is_full_leaves_out_rows_and_then_drawings(wordy, report):
    """One page, whatever the case has: 200 rows with long reasons, a lead of half a page."""
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
    long = pdf(replace(wordy, name=""), {}, record)
    for name, data in {"some": paper, "long": long}.items():
        (tmp_path / name).write_bytes(data)
        run = ["pdftotext", "-bbox", str(tmp_path / name), "-"]
        text = subprocess.run(run, capture_output=True, text=True, check=True).stdout
        ends = [float(x) for x in re.findall(r'<word .*xMax="([\d.]+)"', text)]
        assert len(ends) > 100
        assert max(ends) <= RIGHT + 0.5


@pytest.mark.parametrize(
    ("name", "groups"),
    [("spring-map", ["evidence", "printed", "other", "settled"]),
     ("freewheel-torque", ["evidence", "other", "settled"])],
)  # fmt: skip
def test_rows_of_most_weight_come_first(report, name, groups):
    case = next(c for c in report.cases if c.id == name)
    verdicts = [v for v in kept() if case.id in v.cases]
    evidence = {row for v in verdicts for row in (*v.rows, *v.model_rows)}
    failed, *others = case.rows
    against = sorted(
        others, key=lambda r: (r.id in evidence, bool(r.published), r.kind not in LAST)
    )
    rows = (*against, replace(failed, status=Status.FAIL))
    ordered = [line.row for line in by_weight(replace(case, rows=rows), verdicts)]
    assert ordered[0].quantity == failed.quantity
    found = [
        "evidence" if r.id in evidence else "printed" if r.published
        else "settled" if r.status is Status.PASS and r.kind in LAST
        else "other" for r in ordered[1:]
    ]  # fmt: skip
    assert list(dict.fromkeys(found)) == groups
    assert found == sorted(found, key=groups.index)


def test_the_first_page_names_what_is_not_to_be_used_and_papers_have_their_tables(with_verdicts):
    data = record(with_verdicts, {})
    unusable = {p["cited"]: p["unusable"] for p in data["papers"]}
    assert "Eq. 6" in unusable["Wang 2023"]
    assert "Eq. 9 corrected" not in unusable["Wang 2023"]
    wang = next(p for p in data["papers"] if p["cited"] == "Wang 2023")
    (table,) = wang["tables"]
    assert table["rows"]
    assert all(row["claims"] and not row["inputs"] for row in table["rows"])
    ids = {e["id"] for e in wang["errata"]}
    assert ids == {e for v in kept() if v.paper == "wang2023" for e in v.errata}


def test_inputs_that_were_varied_come_first(with_verdicts):
    case = next(c for c in record(with_verdicts, {})["cases"] if c["id"] == "polyhedral-ring")
    varied = [i["is_varied"] for i in (*case["inputs"], *case["more_inputs"])]
    assert varied[0] > varied[-1]
    assert varied == sorted(varied, reverse=True)
    assert len(varied) == len(next(c for c in with_verdicts.cases if c.id == case["id"]).inputs)


def test_a_run_without_verdicts_states_why(report, hostile):
    assert record(report, {})["counted"] is None
    assert pdf(hostile, {}, record).startswith(b"%PDF")


@pytest.mark.slow("a report is written twice")
def test_the_record_is_the_default_of_several_cases(of_paper, tmp_path):
    cases = [find("ring-lame"), find("contact-roller-flat")]
    two = make_report([of_paper(case) for case in cases], cases, 1.0)
    write(two, tmp_path, cache=default_folder())
    small = (tmp_path / PAPER).read_bytes()
    assert b"report/ring-lame.html" in small
    write(two, tmp_path, cache=default_folder(), full_pdf=True)
    assert sheets_of((tmp_path / PAPER).read_bytes()) > 2 * sheets_of(small)


def test_with_one_page_for_all_cases_the_record_leads_there(report):
    assert {c["page"] for c in record(report, {}, single_file=True)["cases"]} == {"report.html"}
