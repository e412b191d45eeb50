"""report.pdf: everything is on it, literally; without typst the rest is written."""

import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace

import pytest
import typst

from reports.html import anchors
from reports.pdf import NotSet, _cleaned, pdf
from reports.pdf_data import document
from reports.pdf_tables import LONGEST, SHOWN
from reports.standalone import HERE
from reports.write import PAPER, write
from verify.core.figures import Table
from verify.core.results import Status
from verify.jobs.cache import default_folder

NASTY = '#panic("x") <script> $x$ @y *b* _i_ // \\ [z] `r` "q"'


def query(data, selector):
    """What typst finds on the pages."""
    inputs = {"document": json.dumps(_cleaned(data))}
    found = typst.query(HERE / "report.typ", selector, root=HERE, sys_inputs=inputs)
    return json.loads(found)


def text_of(content):
    """The letters of typst's own tree."""
    if isinstance(content, dict):
        own = content.get("text", "") if isinstance(content.get("text"), str) else ""
        inner = [content.get("body"), content.get("child"), *content.get("children", [])]
        return (
            own
            + "".join(text_of(part) for part in inner if part)
            + (" " if content.get("func") == "space" else "")
        )
    return content if isinstance(content, str) else ""


def words(data):
    return [text_of(h).replace("\u200b", "") for h in query(data, "heading")]


@pytest.fixture
def own(report):
    """A user's report: one case with a name, no ledgers."""
    case = replace(report.cases[0], name=NASTY, title=NASTY, lead=NASTY, warnings=(NASTY,))
    cards = tuple(one for one in report.validity if one.case == case.id)
    return replace(report, cases=(case,), name=NASTY, validity=cards)


@pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs poppler-utils")
def test_the_pages_hold_the_hostile_text(own, tmp_path):
    (tmp_path / "own.pdf").write_bytes(pdf(own, {}))
    run = ["pdftotext", "-layout", str(tmp_path / "own.pdf"), "-"]
    printed = subprocess.run(run, capture_output=True, text=True, check=True).stdout
    squeezed = re.sub(r"\s+", "", printed).replace("\u200b", "")
    assert squeezed.count(re.sub(r"\s+", "", NASTY)) >= 3


def test_every_row_and_erratum_can_be_linked_to(report):
    found = query(document(report, {}), "metadata")
    labels = [m["label"].strip("<>") for m in found]
    assert len(labels) == len(set(labels))
    rows = [label for label in labels if label.startswith("row-")]
    assert sorted(rows) == sorted(anchors(report.rows).values())
    assert len(labels) - len(rows) == len(report.errata)


def test_every_case_and_ledger_has_a_heading(report):
    headings = words(document(report, {}))
    for case in report.cases:
        assert case.title in headings
    for name in ("Summary", "Tables of the papers", "Errata ledger", "Provenance"):
        assert name in headings


def test_a_report_of_ones_own_has_no_ledgers(own):
    headings = words(document(own, {}))
    assert "Errata ledger" not in headings
    assert "Summary" in headings


def test_every_status_and_control_characters_make_a_pdf(hostile):
    data = document(hostile, {})
    assert {line["status"] for line in data["cases"][0]["lines"]} == {s.value for s in Status}
    assert [b["status"] for b in data["banners"]] == ["FAIL", "SKIP"]
    assert pdf(hostile, {}).startswith(b"%PDF")


def test_the_same_report_gives_the_same_bytes(own):
    own = replace(own, provenance={**own.provenance, "made": "2001-02-03 04:05 UTC"})
    first = pdf(own, {})
    assert first == pdf(own, {})
    assert b"(D:20010203040500Z)" in first


def test_a_long_table_is_shortened_and_says_where_the_rest_is(own):
    rows = tuple((f"r{i}", float(i)) for i in range(LONGEST + 1))
    table = Table(title="many: rows", header=("name", "value"), rows=rows)
    case = replace(own.cases[0], tables=(table, replace(table, rows=rows[:LONGEST])))
    long, short = document(replace(own, cases=(case,)), {})["cases"][0]["tables"]
    assert len(long["parts"][0]["rows"]) == SHOWN
    assert long["shortened"].endswith(f"of {LONGEST + 1} rows; all stand in tables.xlsx, "
                                      "sheet many rows.")  # fmt: skip
    assert len(short["parts"][0]["rows"]) == LONGEST
    assert not short["shortened"]


def test_a_wide_table_keeps_all_its_columns(own):
    header = tuple(f"c{i}" for i in range(30))
    table = Table(title="wide", header=header, rows=(tuple(map(float, range(30))),))
    case = replace(own.cases[0], tables=(table,))
    (wide,) = document(replace(own, cases=(case,)), {})["cases"][0]["tables"]
    shown = [cell[0] for part in wide["parts"] for cell in part["header"]]
    assert set(shown) == set(header)
    assert all(part["header"][0] == ["c0"] for part in wide["parts"])
    assert max(len(part["header"]) for part in wide["parts"]) <= 12


class PanicException(BaseException):
    pass


@pytest.mark.parametrize("fault", [typst.TypstError("no\nfont", ""), PanicException("broken")])
def test_a_fault_of_typst_is_one_line_and_the_rest_is_written(own, tmp_path, monkeypatch, fault):
    def broken(*_, **__):
        raise fault

    (tmp_path / PAPER).write_bytes(b"of an earlier run")
    monkeypatch.setattr(typst, "compile", broken)
    written = write(own, tmp_path, cache=default_folder())
    assert [r for r in written.remarks if r.startswith("report.pdf is not written: ")]
    assert not any("\n" in remark for remark in written.remarks)
    assert written.page.is_file()
    assert not (tmp_path / PAPER).exists()


def test_without_typst_the_rest_is_written(own, monkeypatch):
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(NotSet, match="typst cannot be imported"):
        pdf(own, {})
