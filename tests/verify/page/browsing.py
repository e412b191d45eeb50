"""Actions of a test in a browser: open, choose, type, wait."""

import time
from collections.abc import Callable
from typing import Any

from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from verify.app.page.link import from_link
from verify.app.page.session import State

LONGEST = 60.0  # s, on a machine that is busy


class Browser:
    """A page of the server in a driver's present tab."""

    def __init__(self, driver: Any, address: str) -> None:
        self.driver, self.address = driver, address
        self.size(1320)
        self.scheme("light")

    def open(self, case: str = "ring-lame") -> None:
        self.driver.get(self.address)
        self.until(lambda: self.state and self.verdict)
        if case:
            self.choose(case)

    def choose(self, case: str) -> None:
        Select(self.one("#case")).select_by_value(case)
        self.until(lambda: self.state and self.state.case == case)

    @property
    def state(self) -> State | None:
        """The state whose answer the page shows, which its address then holds."""
        link = self.driver.current_url.partition("?s=")[2]
        return from_link(link) if link else None

    def drawn(self) -> None:
        """Wait until what was changed before is laid out and painted."""
        frames = (
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))"
        )
        self.driver.execute_async_script(frames)

    def until(self, holds: Callable[[], Any], seconds: float = LONGEST) -> Any:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if found := holds():
                    return found
            except StaleElementReferenceException:
                pass
            time.sleep(0.05)
        raise AssertionError(f"not within {seconds} s; the page shows: {self.text('body')[:600]}")

    def one(self, css: str) -> Any:
        return self.driver.find_element(By.CSS_SELECTOR, css)

    def all(self, css: str) -> list[Any]:
        return list(self.driver.find_elements(By.CSS_SELECTOR, css))

    def text(self, css: str) -> str:
        return " ".join(one.text for one in self.all(css))

    @property
    def verdict(self) -> str:
        return self.text("#answer .verdict")

    def input(self, place: str) -> Any:
        return self.one(f'[data-place="{place}"]')

    def value(self, place: str) -> str:
        return str(self.input(place).get_property("value"))

    def type(self, place: str, text: str) -> None:
        found = self.input(place)
        found.send_keys(Keys.CONTROL, "a")
        found.send_keys(text or Keys.DELETE)

    def message(self, place: str) -> str:
        return str(self.one(f'.field[data-at="{place}"] .message').text)

    def press(self, name: str) -> None:
        button = self.one(f"#{name}")
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()

    def unfold(self, name: str) -> None:
        self.driver.execute_script(f"document.getElementById('{name}').open = true")

    def unfold_all(self) -> None:
        self.driver.execute_script(
            "for (const one of document.querySelectorAll('.answer details')) one.open = true"
        )

    def size(self, width: int, height: int = 900) -> None:
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        self.until(lambda: self.driver.execute_script("return innerWidth") == width)

    def scheme(self, name: str, media: str = "") -> None:
        features = [{"name": "prefers-color-scheme", "value": name}]
        self.driver.execute_cdp_cmd(
            "Emulation.setEmulatedMedia", {"features": features, "media": media}
        )
