"""The report of all cases: contents that a report of a part does not have."""

import re
from collections import Counter
from pathlib import Path

import pytest

from reports.frames import frames
from reports.html import anchors, page
from reports.in_short import markdown
from reports.links import FOLDER
from reports.pages import pages
from reports.pdf import pdf
from reports.pdf_record import BYTES, PAGES, record
from reports.slim import MOST
from reports.write import write
from tests.reports.browser import NO_CHROMIUM, assert_links, assert_silent, looked_at, sheets
from tests.reports.conftest import sheets_of
from tests.test_documents import VERIFIED
from verify.jobs.cache import default_folder

pytestmark = pytest.mark.soak  # every case is judged; `make verify` writes this page
TICKS = 5  # of a strip of the overview


@pytest.fixture(scope="module")
def text(whole) -> str:
    return page(whole, frames(whole.cases, default_folder()))


@pytest.fixture(scope="module")
def folder(tmp_path_factory, text) -> Path:
    place = tmp_path_factory.mktemp("whole")
    (place / "report.html").write_text(text, "utf-8")
    return place


def test_the_table_of_cases_is_that_of_this_code(whole):
    printed = VERIFIED.partition("<!-- cases -->\n")[2].partition("\n<!-- /cases -->")[0]
    assert printed == markdown(whole), "run make readme"


def test_every_row_is_once_on_a_page_that_is_small_enough_to_mail(whole, text):
    ids = Counter(re.findall(r'id="(row-[\d-]+)"', text))
    assert ids == dict.fromkeys(anchors(whole.rows).values(), 1)
    assert len(text.encode()) < 9e6  # what most mail takes, with room to spare


def test_each_of_several_pages_is_small_on_disk(tmp_path, whole):
    """As `make verify` writes them: with pictures and verdicts."""
    assert write(whole, tmp_path, cache=default_folder()).remarks == ()
    sizes = {path.name: path.stat().st_size for path in tmp_path.rglob("*.html")}
    assert sizes.keys() >= {f"{case.id}.html" for case in whole.cases}
    assert {name: size for name, size in sizes.items() if size > MOST} == {}


@NO_CHROMIUM
def test_the_explorer_of_all_cases_opens_in_a_second(tmp_path, whole):
    made = pages(whole, {})[f"{FOLDER}/explorer.html"]
    (tmp_path / "explorer.html").write_text(made, "utf-8")
    seen = looked_at(tmp_path, "explorer", 1320)
    assert_silent(seen)
    assert seen["milliseconds"] < 1000


@NO_CHROMIUM
@pytest.mark.parametrize("width", [390, 1280, 1400])
def test_it_opens_in_seconds_is_silent_and_no_label_lies_on_another(folder, whole, width):
    """All cases on one page; other tests run meanwhile."""
    seen = looked_at(folder, "report", width)
    assert_silent(seen)
    assert seen["milliseconds"] < 10_000
    assert width < 1400 or seen["wider"] <= 0
    assert width < 1280 or (seen["labels"] - len(whole.cases)) % TICKS == 0
    assert width < 1280 or seen["overprinted"] == seen["outside"] == []


def test_the_record_has_a_page_for_each_case_and_fits_a_file(whole):
    paper = pdf(whole, frames(whole.cases, default_folder()), record)
    assert len(whole.cases) < sheets_of(paper) <= PAGES
    assert len(paper) <= BYTES


@NO_CHROMIUM
def test_its_links_lead_to_places_in_sight_and_it_prints_on_few_sheets(folder, whole):
    for width in (1400, 400):
        assert_links(looked_at(folder, "report", width, host="links_host.html"), width, 600)
    assert 10 < sheets(folder, "report") < 8 * len(whole.cases)
