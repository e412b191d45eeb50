"""Pages in headless Chromium without network, evaluated from a host page with frames."""

import html
import json
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), ""
)
NO_CHROMIUM = pytest.mark.skipif(
    not CHROMIUM, reason="no chromium: the page is not looked at in a browser"
)
OFFLINE = ("--host-resolver-rules=MAP * ~NOTFOUND", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--no-first-run")  # fmt: skip
DARK = "--blink-settings=preferredColorScheme=0"


def browse(folder: Path, *flags: str) -> subprocess.CompletedProcess[str]:
    base = (CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
            f"--user-data-dir={folder / 'profile'}", "--allow-file-access-from-files",
            "--enable-logging=stderr", "--window-size=1320,900", *OFFLINE)  # fmt: skip
    return subprocess.run([*base, *flags], capture_output=True, text=True, timeout=400, check=False)


@cache
def looked_at(
    folder: Path,
    name: str,
    width: int,
    *flags: str,
    host: str = "browser_host.html",
    status: str = "all",
) -> dict[str, object]:
    """What the host measured of the page `name` in a frame of `width` pixels.

    `status` is the filter of the rows that a host may set. Measurements are stored.
    """
    framed = folder / f"{Path(host).stem}-{name}-{width}.html"
    text = Path(__file__).with_name(host).read_text("utf-8")
    given = {"PAGE": f"{name}.html", "WIDTH": str(width), "STATUS": status}
    for word, value in given.items():
        text = text.replace(word, value)
    framed.write_text(text, "utf-8")
    fast = ("--virtual-time-budget=20000", "--disable-ipc-flooding-protection")  # for many clicks
    done = browse(folder, *flags, *fast, "--dump-dom", framed.as_uri())
    found = re.search(r'<pre id="result">(.+?)</pre>', done.stdout, re.DOTALL)
    assert found, done.stderr[-2000:]
    result = json.loads(html.unescape(found[1]))
    result["console"] = re.findall(r"CONSOLE.*", done.stderr)
    return result


def sheets(folder: Path, name: str) -> int:
    """Sheets of the page `name` as the browser prints it."""
    target = folder / f"{name}.pdf"
    browse(folder, "--no-pdf-header-footer", f"--print-to-pdf={target}",
           (folder / f"{name}.html").as_uri())  # fmt: skip
    data = target.read_bytes()
    assert data.startswith(b"%PDF")
    return len(re.findall(rb"/Type\s*/Page\b", data))


def assert_silent(seen: dict[str, object]) -> None:
    assert seen["overflow"] <= 0, seen["widest"]
    assert seen["console"] == []
    assert seen["requests"] == []
    assert not seen["alerts"]
    assert seen["canvases"] == seen["painted"]
    assert seen["spilled"] == []


def assert_legible(seen: dict[str, object], flags: tuple[str, ...], least: int = 40) -> None:
    assert bool(seen["dark"]) == bool(flags)
    assert seen["texts"] > least
    assert seen["contrast"] >= 4.5, seen["faintest"]  # WCAG 2, level AA


def assert_links(seen: dict[str, object], width: int, least: int) -> None:
    """Every link leads to a place in sight below a menu of one line; there are `least` at least."""
    assert seen["menu_lines"] == 1
    assert seen["menu_height"] < 50
    assert seen["menu_links"] >= 9
    assert width < 1400 or seen["menu_hidden"] <= 0
    assert seen["links"] > least, seen["links"]
    assert seen["problems"] == []
