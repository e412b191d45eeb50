"""Pages used with the keyboard alone: order, visible focus below the menu, the explorer's form."""

import time
from typing import Any

import pytest
from selenium.webdriver.common.keys import Keys

from reports.links import FIRST, FOLDER
from tests.verify.page.conftest import driver

__all__ = ["driver"]  # the browser of the app's tests
pytestmark = pytest.mark.slow("a browser opens pages")

FOCUS = """
const e = document.activeElement, style = getComputedStyle(e), box = e.getBoundingClientRect();
const on = document.elementFromPoint(box.left + Math.min(8, box.width / 2), box.top + Math.min(8, box.height / 2));
return {name: e.id || e.textContent.trim().slice(0, 40) || e.tagName, tag: e.tagName,
  outline: style.outlineStyle === "none" ? 0 : parseFloat(style.outlineWidth),
  covered: !(on && (e.contains(on) || on.contains(e)))};
"""  # noqa: E501 - a line of JavaScript
SEVERAL = 40  # places of a page that are visited


def tab(driver: Any) -> dict[str, Any]:
    """What has the focus after one more Tab."""
    driver.switch_to.active_element.send_keys(Keys.TAB)
    found: dict[str, Any] = driver.execute_script(FOCUS)
    return found


@pytest.mark.parametrize("name", [FIRST, f"{FOLDER}/rows.html", f"{FOLDER}/polyhedral-ring.html"])
def test_the_focus_is_seen_below_the_menu_and_begins_with_a_jump_over_it(driver, folder, name):
    driver.set_window_size(1320, 900)
    driver.get((folder / name).as_uri())
    first = tab(driver)
    assert first["name"] == "Skip to the content"
    visited = [first, *(tab(driver) for _ in range(SEVERAL))]
    assert len({one["name"] for one in visited}) > SEVERAL / 2
    assert [one["name"] for one in visited if one["outline"] < 2] == []
    assert [one["name"] for one in visited if one["covered"]] == []
    driver.get((folder / name).as_uri())
    tab(driver)
    driver.switch_to.active_element.send_keys(Keys.ENTER)
    top = "return document.getElementById('content').getBoundingClientRect().top"
    assert -1 <= driver.execute_script(top) < 100
    assert driver.get_log("browser") == []


def test_the_explorer_answers_without_a_pointer(driver, folder):
    driver.get((folder / FOLDER / "explorer.html").as_uri())
    assert "explorer-case" in [tab(driver)["name"] for _ in range(SEVERAL // 2)]
    for _ in range(SEVERAL):
        if driver.execute_script("return document.activeElement.id") == "explorer-case":
            break
        driver.switch_to.active_element.send_keys(Keys.SHIFT, Keys.TAB)
    driver.switch_to.active_element.send_keys("Polyhedral ring under")
    assert tab(driver)["name"] == "explorer-formula"
    driver.switch_to.active_element.send_keys("K of the paper")
    tab(driver)
    assert driver.execute_script("return document.activeElement.dataset.name") == "z"
    driver.switch_to.active_element.send_keys(Keys.CONTROL, "a")
    driver.switch_to.active_element.send_keys("8")
    end = time.monotonic() + 20
    answer = "return document.getElementById('explorer-answer').textContent"
    while "At z = 8" not in driver.execute_script(answer):
        assert time.monotonic() < end, driver.execute_script(answer)
    assert "Beyond 10 %" in driver.execute_script(answer)
    assert driver.get_log("browser") == []
