"""report.pdf: complete, literal text within the margins; without typst, all other files exist."""

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
from reports.pdf_record import record
from reports.pdf_tables import LONGEST, SHOWN
from reports.standalone import HERE
from reports.write import PAPER, write
from tests.reports.conftest import first_of
from verify.core.figures import Table
from verify.core.results import Status
from verify.jobs.cache import default_folder

NASTY = '#panic("x") <script> $x$ @y *b* _i_ // \\ [z] `r` "q"'
NEEDS_POPPLER = pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs poppler-utils")
MM = 72 / 25.4
RIGHT = (210 - 17) * MM  # edge of the text


def query(data, selector):
    """What typst finds on the pages."""
    inputs = {"document": json.dumps(_cleaned(data))}
    found = typst.query(HERE / "report.typ", selector, root=HERE, sys_inputs=inputs)
    return json.loads(found)


def text_of(content):
    """The letters of the tree of typst."""
    if isinstance(content, dict):
        own = content.get("text", "") if isinstance(content.get("text"), str) else ""
        inner = [content.get("body"), content.get("child"), *content.get("children", [])]
        space = " " if content.get("func") == "space" else ""
        return own + "".join(text_of(part) for part in inner if part) + space
    return content if isinstance(content, str) else ""


@pytest.fixture
def own(report):
    """A user's report: one case with a name, no ledgers."""
    one = first_of(report, 1)
    case = replace(one.cases[0], name=NASTY, title=NASTY, lead=NASTY, warnings=(NASTY,))
    return replace(one, cases=(case,), name=NASTY)


def read(paper: bytes, folder, option: str) -> str:
    """What pdftotext reads of a PDF."""
    (folder / "r.pdf").write_bytes(paper)
    run = ["pdftotext", option, str(folder / "r.pdf"), "-"]
    return subprocess.run(run, capture_output=True, text=True, check=True).stdout


def test_every_row_erratum_case_and_ledger_can_be_found(report):
    some = replace(first_of(report, 3), tables=report.tables)
    found = query(document(some, {}), "selector(metadata).or(heading)")
    labels = [m["label"].strip("<>") for m in found if m["func"] == "metadata"]
    assert len(labels) == len(set(labels))
    rows = [label for label in labels if label.startswith("row-")]
    assert sorted(rows) == sorted(anchors(some.rows).values())
    assert len(labels) - len(rows) == len(some.errata)
    names = {"Summary", "Tables of the papers", "Errata ledger", "Provenance"}
    headings = {text_of(m).replace("\u200b", "") for m in found if m["func"] == "heading"}
    assert {case.title for case in some.cases} | names <= headings


@NEEDS_POPPLER
def test_hostile_texts_stand_as_they_are_and_the_same_report_gives_the_same_bytes(own, tmp_path):
    own = replace(own, provenance={**own.provenance, "made": "2001-02-03 04:05 UTC"})
    first = pdf(own, {})
    assert first == pdf(own, {})
    assert b"(D:20010203040500Z)" in first
    squeezed = re.sub(r"\s+", "", read(first, tmp_path, "-layout")).replace("\u200b", "")
    assert squeezed.count(re.sub(r"\s+", "", NASTY)) >= 3
    assert "Summary" in squeezed
    assert (
        "Errataledger" not in squeezed
    )  # the ledger of the papers is not in the report on a user's part


def test_every_status_and_control_characters_make_a_pdf_of_either_form(hostile):
    few = replace(first_of(hostile, 1), errata=())
    data = document(few, {})
    assert {line["status"] for line in data["cases"][0]["lines"]} == {s.value for s in Status}
    assert [b["status"] for b in data["banners"]] == ["FAIL", "SKIP"]
    for form in (document, record):
        assert pdf(few, {}, form).startswith(b"%PDF")


def test_a_long_table_is_shortened_and_a_wide_one_keeps_all_its_columns(own):
    rows = tuple((f"r{i}", float(i)) for i in range(LONGEST + 1))
    table = Table(title="many: rows", header=("name", "value"), rows=rows)
    header = tuple(f"c{i}" for i in range(30))
    other = Table(title="wide", header=header, rows=(tuple(map(float, range(30))),))
    case = replace(own.cases[0], tables=(table, replace(table, rows=rows[:LONGEST]), other))
    long, short, wide = document(replace(own, cases=(case,)), {})["cases"][0]["tables"]
    assert len(long["parts"][0]["rows"]) == SHOWN
    assert long["shortened"].endswith(f"of {LONGEST + 1} rows; all are in tables.xlsx, "
                                      "sheet many rows.")  # fmt: skip
    assert len(short["parts"][0]["rows"]) == LONGEST
    assert not short["shortened"]
    assert {cell[0] for part in wide["parts"] for cell in part["header"]} == set(header)
    assert all(part["header"][0] == ["c0"] for part in wide["parts"])
    assert max(len(part["header"]) for part in wide["parts"]) <= 12


class PanicException(BaseException):
    pass


@pytest.mark.parametrize("fault", [typst.TypstError("no\nfont", ""), PanicException("broken")])
def test_a_fault_of_typst_is_one_line_and_the_rest_is_written(own, tmp_path, monkeypatch, fault):
    (tmp_path / PAPER).write_bytes(b"of an earlier run")
    monkeypatch.setattr(typst, "compile", lambda *_, **__: (_ for _ in ()).throw(fault))
    written = write(own, tmp_path, cache=default_folder())
    assert [r for r in written.remarks if r.startswith("report.pdf is not written: ")]
    assert not any("\n" in remark for remark in written.remarks)
    assert written.page.is_file()
    assert not (tmp_path / PAPER).exists()
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(NotSet, match="typst cannot be imported"):
        pdf(own, {})


@NEEDS_POPPLER
@pytest.mark.parametrize(("printed", "reason", "room"), [(1, "", 35), (10, "why " * 80, 33)])
def test_names_have_room_and_no_word_stands_beyond_the_margin(
    printed, reason, room, wordy, tmp_path
):
    """Beside one printed value and beside many with long reasons; a word is 5 mm wide."""
    (case,) = wordy.cases
    rows = tuple(
        replace(r, published=r.published * printed, reason=reason or r.reason) for r in case.rows
    )
    paper = pdf(replace(wordy, cases=(replace(case, rows=rows),)), {})
    found = re.findall(
        r'xMin="([\d.]+)" yMin="[\d.]+" xMax="([\d.]+)" yMax="[\d.]+">([^<]*)<',
        read(paper, tmp_path, "-bbox"),
    )
    texts = [text for *_, text in found]
    summary = found[texts.index("Quantity") : texts.index("tolerances")]
    at = [(float(left), float(right)) for left, right, text in summary if text == "word"]
    assert len(at) >= 18 * 3
    assert max(right for _, right in at) - min(left for left, _ in at) > room * MM
    assert "CALIBRATED" in texts
    assert max(float(right) for _, right, _ in found) <= RIGHT + 0.5
    assert not any("^" in text for text in texts)  # powers are raised
