"""Pages in headless Chromium without network, looked at from a host page that frames them."""

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
NEEDS_CHROMIUM = [
    pytest.mark.skipif(not CHROMIUM, reason="no chromium: the page is not looked at in a browser"),
    pytest.mark.xdist_group("browser"),
]
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

    `status` is the filter of the rows that a host may set. What was measured once is kept.
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
