"""Verdicts on the page, in Markdown, in the PDF's data and in the workbook."""

import io
import json
import zipfile
from dataclasses import replace

import pytest

from reports.html import page
from reports.pdf import content
from reports.verdicts import at_paper, counts_in_markdown, markdown, sides
from reports.xlsx import xlsx
from verify.core.verdicts import Verdict
from verify.verdicts.record import kept


@pytest.fixture(scope="module")
def with_verdicts(report):
    """A report of some cases with the verdicts of record."""
    return replace(report, verdicts=kept())


def test_the_page_begins_with_the_verdicts_and_links_their_rows(with_verdicts):
    html = page(with_verdicts, {})
    section = html.partition('<section id="verdicts">')[2].partition("</section>")[0]
    assert html.index('id="verdicts"') < html.index('id="answer"')
    assert section.count('<th scope="row">Eq. ') == sum(v.name.startswith("Eq.") for v in kept())
    assert "unsafe: up to 325 % above" in section
    known = {row.id for row in with_verdicts.rows}
    linked = sum(row in known for v in kept() for row in (*v.rows, *v.model_rows, v.caution_row))
    assert section.count('href="#row-') == linked > 0


def test_a_report_without_verdicts_has_no_section(report):
    assert 'id="verdicts"' not in page(report, {})


def test_counts_add_up(with_verdicts):
    *_, total = counts_in_markdown(with_verdicts).splitlines()
    numbers = [int(cell) for cell in total.split("|")[2:-1] if cell.strip()]
    assert sum(numbers) == len(kept())
    assert len(markdown(with_verdicts).splitlines()) == len(kept()) + 2


@pytest.mark.parametrize(
    ("error", "U", "shown"),
    [(0.24, 3e-4, "+24 ± 0.03 %"), (-0.344, 1e-6, "−34 %"), (1e-9, 1e-9, "< 0.01 %"),
     (None, None, "–")],
)  # fmt: skip
def test_an_error_is_shown_with_its_bar(error, U, shown):
    assert at_paper(replace(kept()[0], error=error, U=U)) == shown


@pytest.mark.parametrize(
    ("above", "below", "shown"), [(0.05, 0.344, "+5 / −34 %"), (0.0, 0.1, "0 / −10 %")]
)
def test_the_largest_errors_of_both_sides(above, below, shown):
    assert sides(replace(kept()[0], above=above, below=below)) == shown


def test_pdf_and_workbook_have_them_too(with_verdicts):
    data = json.loads(content(with_verdicts, {}))["verdicts"]
    assert sum(len(paper["lines"]) for paper in data["papers"]) == len(kept())
    with zipfile.ZipFile(io.BytesIO(xlsx(with_verdicts))) as book:
        assert 'name="Verdicts"' in book.read("xl/workbook.xml").decode()


def test_no_verdict_is_counted_where_there_is_one(with_verdicts):
    without = replace(kept()[0], verdict=Verdict.NONE)
    assert "no verdict" in counts_in_markdown(replace(with_verdicts, verdicts=(without,)))
    assert "no verdict" not in counts_in_markdown(with_verdicts)
