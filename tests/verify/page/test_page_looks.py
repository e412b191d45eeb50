"""Appearance of the page: narrow, dark, printed, and with sufficient contrast."""

from pathlib import Path
from typing import Any

import pytest

from tests.verify.page.conftest import Server, missing

if reason := missing():
    pytest.skip(reason, allow_module_level=True)

from tests.verify.page.browsing import Browser

LEAST = 4.5  # contrast, WCAG 2.2 AA
CONTRAST = Path(__file__).with_name("contrast.js").read_text("utf-8")

pytestmark = pytest.mark.slow("a browser opens the page")


@pytest.fixture
def page(driver: Any, server: Server) -> Browser:
    found = Browser(driver, server.address)
    found.open("freewheel-clutch")
    for name in ("fem", "sweep", "compare", "shape", "report", "file"):
        found.unfold(f"tool-{name}")
    return found


@pytest.mark.parametrize("case", ["freewheel-clutch", "sprag-clutch", "rotor-system", "ring-lame"])
def test_a_narrow_page_does_not_scroll_sideways(page: Browser, case: str) -> None:
    page.size(390)
    page.choose("contact-flat")
    page.choose(case)
    page.drawn()
    wide = "return document.documentElement.scrollWidth"
    assert page.driver.execute_script(wide) <= 390
    assert page.all(".brief")[0].is_displayed()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_every_text_has_enough_contrast(page: Browser, scheme: str) -> None:
    page.scheme(scheme)
    page.type("E", "900 GPa")
    page.until(lambda: page.message("E"))
    page.type("r", "x")
    page.until(lambda: page.message("r"))
    _contrast(page)
    page.type("r", "2.5 mm")
    page.until(lambda: "No answer" not in page.verdict)
    _contrast(page)


def _contrast(page: Browser) -> None:
    found = page.driver.execute_script(CONTRAST)
    assert len(found) > 100
    assert [one for one in found if one[0] < LEAST] == []


def test_the_page_is_dark_where_the_system_is(page: Browser) -> None:
    paper = "return getComputedStyle(document.body).backgroundColor"
    light = page.driver.execute_script(paper)
    page.scheme("dark")
    assert page.driver.execute_script(paper) != light == "rgb(255, 255, 255)"


def test_a_print_has_answer_and_inputs_without_buttons(page: Browser) -> None:
    page.scheme("light", "print")
    assert page.one("#answer").is_displayed()
    assert page.input("R").is_displayed()
    for css in ("#undo", ".brief", "#sketch-note"):
        assert not page.one(css).is_displayed()
    assert not page.one("#fem").is_displayed()
