"""The report of every case: what only the whole of them shows."""

import re
from collections import Counter
from pathlib import Path

import pytest

from reports.frames import frames
from reports.html import page
from reports.in_short import markdown
from reports.pages import FOLDER, pages
from tests.reports.browser import NO_CHROMIUM, assert_links, assert_silent, looked_at, sheets
from tests.test_documents import VERIFIED
from verify.jobs.cache import default_folder

pytestmark = pytest.mark.soak  # every case is judged; `make verify` writes this page
DECADES = 7  # of the overview's scale


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


def test_every_row_is_once_on_a_page_small_enough_to_mail(whole, text):
    ids = Counter(re.findall(r'id="(row-\d+)"', text))
    assert ids == {f"row-{i}": 1 for i in range(len(whole.rows))}
    assert len(text.encode()) < 9e6  # what most mail takes, with room to spare


@NO_CHROMIUM
def test_the_explorer_of_all_cases_is_small_and_opens_in_a_second(tmp_path, whole):
    made = pages(whole, {})[f"{FOLDER}/explorer.html"]
    (tmp_path / "explorer.html").write_text(made, "utf-8")
    assert len(made.encode()) < 400_000
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
    assert width < 1280 or seen["labels"] == len(whole.cases) + DECADES
    assert width < 1280 or seen["overprinted"] == seen["outside"] == []


@NO_CHROMIUM
def test_it_prints_on_fewer_than_eight_sheets_a_case(folder, whole):
    assert 10 < sheets(folder, "report") < 8 * len(whole.cases)


@NO_CHROMIUM
@pytest.mark.parametrize("width", [1400, 400])
def test_every_link_leads_to_a_place_in_sight_below_a_menu_of_one_line(folder, width):
    assert_links(looked_at(folder, "report", width, host="links_host.html"), width, 600)
