"""The report of every case: what only the whole of them shows."""

import re
from collections import Counter
from pathlib import Path

import pytest

from reports.equations import Glyphs
from reports.frames import frames
from reports.html import page
from reports.verdicts import markdown
from tests.reports.browser import (
    DARK,
    NO_CHROMIUM,
    assert_legible,
    assert_links,
    assert_silent,
    looked_at,
    sheets,
)
from tests.test_documents import VERIFIED
from verify.jobs.cache import default_folder

pytestmark = pytest.mark.soak  # every case is judged; `make verify` writes this page
DECADES = 7  # of the overview's scale


@pytest.fixture(scope="module")
def text(whole) -> str:
    return page(whole, frames(whole.cases, default_folder()), Glyphs(default_folder()))


@pytest.fixture(scope="module")
def folder(tmp_path_factory, text) -> Path:
    place = tmp_path_factory.mktemp("whole")
    (place / "report.html").write_text(text, "utf-8")
    return place


def test_the_table_of_verdicts_is_that_of_this_code(whole):
    printed = VERIFIED.partition("<!-- verdicts -->\n")[2].partition("\n<!-- /verdicts -->")[0]
    assert printed == markdown(whole), "run make readme"


def test_the_page_stays_small_enough_to_mail(text):
    assert len(text.encode()) < 9e6  # what most mail takes, with room to spare


def test_every_row_is_on_the_page_once(whole, text):
    ids = Counter(re.findall(r'id="(row-\d+)"', text))
    assert ids == {f"row-{i}": 1 for i in range(len(whole.rows))}


def test_warnings_stand_in_the_head_once_each(whole, text):
    head = text[: text.index("</header>")]
    warnings = {w for case in whole.cases for w in case.warnings}
    assert len(warnings) == 16
    assert head.count("<li>") == len(warnings)


@NO_CHROMIUM
def test_it_opens_in_a_few_seconds(folder):
    """All cases on one page; the other tests run meanwhile."""
    assert looked_at(folder, "report", 1400)["milliseconds"] < 10_000


@NO_CHROMIUM
def test_the_rows_of_all_cases_fit_a_wide_page(folder):
    assert looked_at(folder, "report", 1400)["wider"] <= 0


@NO_CHROMIUM
@pytest.mark.parametrize("width", [1280, 1400])
def test_no_label_of_the_overview_lies_on_another(folder, whole, width):
    seen = looked_at(folder, "report", width)
    assert seen["labels"] == len(whole.cases) + DECADES
    assert seen["overprinted"] == seen["outside"] == []


@pytest.fixture(scope="module")
def hostile_folder(tmp_path_factory, hostile_whole) -> Path:
    place = tmp_path_factory.mktemp("hostile")
    drawn = frames(hostile_whole.cases, default_folder())
    hostile = page(hostile_whole, drawn, Glyphs(default_folder()))
    (place / "hostile.html").write_text(hostile, "utf-8")
    return place


@pytest.fixture(params=["report", "hostile"])
def looked_into(request) -> tuple[Path, str]:
    """The folder and the name of a page."""
    fixture = "folder" if request.param == "report" else "hostile_folder"
    return request.getfixturevalue(fixture), request.param


# The same of a case of each subject: test_browser.
@NO_CHROMIUM
@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_scrolls_sideways_and_the_console_is_silent(looked_into, width):
    assert_silent(looked_at(*looked_into, width))


@NO_CHROMIUM
@pytest.mark.parametrize("flags", [(), (DARK,)], ids=["light", "dark"])
def test_every_word_stands_out_from_its_ground(hostile_folder, flags):
    assert_legible(looked_at(hostile_folder, "hostile", 1280, *flags), flags)


@NO_CHROMIUM
def test_it_prints(folder, whole):
    """On fewer than eight sheets a case."""
    assert 10 < sheets(folder, "report") < 8 * len(whole.cases)


@NO_CHROMIUM
@pytest.mark.parametrize("width", [1400, 400])
def test_every_link_leads_to_a_place_in_sight_below_a_menu_of_one_line(looked_into, width):
    assert_links(looked_at(*looked_into, width, host="links_host.html"), width, 600)


@NO_CHROMIUM
@pytest.mark.parametrize("width", [400, 1400])
def test_a_link_shows_a_row_that_a_filter_hides(folder, width):
    seen = looked_at(folder, "report", width, host="links_host.html", status="skip")
    assert seen["links"] == 20
    assert seen["problems"] == []
