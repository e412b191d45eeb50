"""Verdicts on the page, in Markdown, in the PDF and the workbook; formulas to use instead."""

import io
import json
import zipfile
from dataclasses import replace

from reports.advice import advised, of_case
from reports.erratum_names import SUBJECTS
from reports.html import page
from reports.pdf import content
from reports.verdicts import at_paper, counts_in_markdown, markdown, sides
from reports.xlsx import xlsx
from verify.core.verdicts import Form, Verdict
from verify.papers.ledger import papers
from verify.verdicts.record import kept

ONE = replace(
    next(v for v in kept() if v.verdict is Verdict.WRONG), id="p/Eq. 1, printed", name="Eq. 1",
    paper="p", form=Form.PRINTED, instead="",
)  # fmt: skip
RIGHT = replace(ONE, id="p/Eq. 1, corrected", form=Form.CORRECTED, verdict=Verdict.ACCURATE,
                within=0.02)  # fmt: skip


def test_the_page_begins_with_the_verdicts_and_links_their_rows(report, recorded):
    html = page(recorded, {})
    section = html.partition('<section id="verdicts">')[2].partition("</section>")[0]
    assert html.index('id="verdicts"') < html.index('id="answer"')
    assert section.count('<th scope="row">Eq. ') == sum(v.name.startswith("Eq.") for v in kept())
    assert "up to 439 % above the reference" in section
    known = {row.id for row in recorded.rows}
    linked = sum(row in known for v in kept() for row in (*v.rows, *v.model_rows, v.caution_row))
    assert section.count('href="#row-') == linked > 0
    assert 'id="verdicts"' not in page(report, {})


def test_markdown_pdf_and_workbook_have_them_all(recorded):
    *_, total = counts_in_markdown(recorded).splitlines()
    assert sum(int(cell) for cell in total.split("|")[2:-1] if cell.strip()) == len(kept())
    assert len(markdown(recorded).splitlines()) == len(kept()) + 2
    assert "no verdict" not in counts_in_markdown(recorded)
    without = replace(kept()[0], verdict=Verdict.NONE)
    assert "no verdict" in counts_in_markdown(replace(recorded, verdicts=(without,)))
    data = json.loads(content(recorded, {}))["verdicts"]
    assert sum(len(paper["lines"]) for paper in data["papers"]) == len(kept())
    with zipfile.ZipFile(io.BytesIO(xlsx(recorded))) as book:
        assert 'name="Verdicts"' in book.read("xl/workbook.xml").decode()


def test_errors_have_their_bars_and_sides():
    for shows, values, shown in (
        (at_paper, {"error": 0.24, "U": 3e-4}, "+24 ±\u00a00.03\u00a0%"),
        (at_paper, {"error": -0.344, "U": 1e-6}, "−34\u00a0%"),
        (at_paper, {"error": 1e-9, "U": 1e-9}, "<\u00a00.01\u00a0%"),
        (at_paper, {"error": None, "U": None}, "–"),
        (sides, {"above": 0.05, "below": 0.344}, "+5 / −34\u00a0%"),
        (sides, {"above": 0.0, "below": 0.1}, "0 / −10\u00a0%"),
    ):
        assert shows(replace(kept()[0], **values)) == shown


def test_a_printed_form_refers_to_its_corrected_form_unless_another_advice_is_declared():
    for changes, words in (
        ({}, "the corrected form, accurate within 2 %"),
        ({"verdict": Verdict.PART}, "the corrected form, accurate within 2 % in part of the range"),
        ({"verdict": Verdict.DEFINITION}, "the corrected form"),
        ({"verdict": Verdict.CONSERVATIVE, "instead": "x"},
         "the corrected form, conservative; or x"),
        ({"verdict": Verdict.UNSAFE, "instead": "x"}, "x"),
        ({"verdict": Verdict.UNVERIFIABLE}, ""),
        ({"paper": "q"}, ""),
    ):  # fmt: skip
        printed, _ = advised([ONE, replace(RIGHT, **changes)])
        assert printed.instead == words, changes
    own, usable = replace(ONE, instead="a table"), replace(ONE, verdict=Verdict.ACCURATE)
    assert [v.instead for v in advised([own, RIGHT])] == ["a table", ""]
    assert advised([usable, RIGHT])[0].instead == ""


def test_a_case_has_the_largest_error_of_its_rows(report):
    case = next(c for c in report.cases if c.id == "polyhedral-ring")
    others = next(c for c in report.cases if c.id == "ring-lame")
    first, second, *_ = [r for r in case.rows if r.tolerance and r.scale and r.difference]
    foreign = next(r for r in others.rows if r.tolerance and r.scale)
    verdict = replace(
        RIGHT, error=9.0, U=0.1, is_of_part=True, rows=(first.id, foreign.id),
        model_rows=(second.id,), worst_row=foreign.id,
        words="+900 % ± 10 % at the default inputs",
    )  # fmt: skip
    (found,) = of_case([verdict], case.id, case.rows)
    assert found.error == first.difference / first.scale
    assert first.tolerance / first.scale == found.U
    assert found.is_of_part
    assert found.words == "+900 % ± 10 % at the default inputs of ring-lame"
    named = replace(verdict, words="+900 % at the default inputs of ring-lame")
    assert of_case([named], case.id, case.rows)[0].words == named.words
    (model,) = of_case([replace(verdict, rows=(foreign.id,))], case.id, case.rows)
    assert (model.error, model.is_of_part) == (second.difference / second.scale, False)
    assert of_case([replace(verdict, rows=(), model_rows=())], case.id, case.rows) == []
    (none,) = of_case([replace(verdict, error=None)], case.id, case.rows)
    assert none.error is None


def test_each_readable_subject_belongs_to_an_erratum_of_the_papers():
    assert set(SUBJECTS) <= {e.id for paper in papers() for e in paper.errata}
