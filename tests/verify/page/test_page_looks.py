"""What the page looks like: narrow, dark, printed, and with enough contrast."""

from typing import Any

import pytest

from tests.verify.page.conftest import Server, missing

if reason := missing():
    pytest.skip(reason, allow_module_level=True)

from tests.verify.page.browsing import Browser

LEAST = 4.5  # contrast, WCAG 2.2 AA
CONTRAST = """
const seen = [], ctx = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
const rgb = text => { ctx.clearRect(0, 0, 1, 1); ctx.fillStyle = text; ctx.fillRect(0, 0, 1, 1);
  const [r, g, b, a] = ctx.getImageData(0, 0, 1, 1).data; return [r, g, b, a / 255]; };
const lum = c => c.slice(0, 3).map(v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; })
  .reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
const behind = e => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c[3] > 0.99) return c; }
  return matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18, 1] : [255, 255, 255, 1]; };
for (const e of document.querySelectorAll("body *")) {
  const text = [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim()) || e.tagName === "INPUT";
  if (!text || !e.checkVisibility() || e.disabled || e.closest(":disabled") || e.tagName === "OPTION" || e.tagName === "OPTGROUP") continue;
  const style = getComputedStyle(e), ink = rgb(e.closest("svg") ? style.fill : style.color), paper = behind(e);
  const [a, b] = [lum(ink), lum(paper)].sort((x, y) => y - x);
  seen.push([(a + 0.05) / (b + 0.05), e.tagName + "." + e.className.toString(), e.textContent.slice(0, 40)]);
}
return seen;
"""


@pytest.fixture
def page(driver: Any, server: Server) -> Browser:
    found = Browser(driver, server.address)
    found.open("freewheel-clutch")
    for name in ("tool-fem", "tool-sweep", "tool-compare", "tool-report", "tool-file"):
        found.unfold(name)
    return found


@pytest.mark.parametrize("case", ["freewheel-clutch", "sprag-clutch", "rotor-system", "ring-lame"])
def test_a_narrow_page_does_not_scroll_sideways(page: Browser, case: str) -> None:
    page.size(390)
    page.choose("contact-flat")
    page.choose(case)
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
    assert not page.one("#undo").is_displayed()
    assert not page.one("#fem").is_displayed()
