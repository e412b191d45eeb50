"""Fixtures: server of the local page in a separate process, and a browser without a window."""

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

CHROMIUM, DRIVER = Path("/usr/bin/chromium"), Path("/usr/bin/chromedriver")
ROOT = Path(__file__).parents[3]
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
         "--disable-background-networking", "--no-first-run")  # fmt: skip
STARTED = 90.0  # s, on a machine that is busy


def missing() -> str:
    """Reason why browser tests cannot run; "" if they can."""
    absent = [name for name in ("nicegui", "selenium") if find_spec(name) is None]
    absent += [str(path) for path in (CHROMIUM, DRIVER) if not path.exists()]
    return f"not installed: {', '.join(absent)}" if absent else ""


class Server:
    """A process of `freewheel app` on a folder; `port` 0 selects a free port."""

    def __init__(self, folder: Path, port: int = 0) -> None:
        self.folder, self.log = folder, folder / ".log"
        with self.log.open("w") as log:
            command = [sys.executable, "-m", "verify.app.cli", "app", "--port", str(port)]
            self.process = subprocess.Popen(
                [*command, "--no-browser", "--folder", str(folder)], stdout=log, stderr=log,
                cwd=ROOT, env=os.environ | {"PYTHONPATH": str(ROOT)},
            )  # fmt: skip
        self.address = self._address()
        self.port = int(self.address.split(":")[2].split("/")[0])

    def _address(self) -> str:
        until = time.monotonic() + STARTED
        while time.monotonic() < until and self.process.poll() is None:
            if found := re.search(r"http://\S+", self.text):
                return found[0]
            time.sleep(0.1)
        raise AssertionError(self.text)

    @property
    def text(self) -> str:
        """Text that the server has printed."""
        return self.log.read_text("utf-8")

    def end(self) -> int:
        """Exit status of the server after Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(30)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    if reason := missing():
        pytest.skip(reason)
    found = Server(tmp_path_factory.mktemp("app"))
    yield found
    if found.process.poll() is None:
        found.end()


@pytest.fixture(scope="module")
def driver() -> Iterator[Any]:
    if reason := missing():
        pytest.skip(reason)
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    options.binary_location = str(CHROMIUM)
    for flag in FLAGS:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"performance": "ALL", "browser": "ALL"})
    found = webdriver.Chrome(options=options, service=webdriver.ChromeService(str(DRIVER)))
    found.set_page_load_timeout(60)
    yield found
    found.quit()
