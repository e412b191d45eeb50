"""The page in a real browser without network: silent, narrow enough, readable, filterable.

A case of each subject; test_whole looks at the page of every case.
"""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from reports.frames import frames
from reports.html import page, styles
from reports.overview import overview
from tests.reports.browser import (
    DARK,
    NEEDS_CHROMIUM,
    assert_legible,
    assert_links,
    assert_silent,
    browse,
    looked_at,
)
from tests.reports.conftest import NAME
from tests.reports.paths import walked
from verify.jobs.cache import default_folder

pytestmark = NEEDS_CHROMIUM
TICKS = 5  # of a strip of the overview


@pytest.fixture(scope="module")
def folder(tmp_path_factory, report, hostile, turning) -> Path:
    """The page, the hostile one, and the host that looks at them in frames."""
    place = tmp_path_factory.mktemp("browser")
    drawn = frames(report.cases, default_folder())
    (place / "report.html").write_text(page(report, drawn), "utf-8")
    (place / "hostile.html").write_text(page(hostile, drawn), "utf-8")
    (place / "turning.html").write_text(page(turning, {}), "utf-8")
    return place


@pytest.mark.slow("pages are written and a browser starts")
@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_scrolls_sideways_and_the_console_is_silent(folder, width):
    assert_silent(looked_at(folder, "hostile", width))


@pytest.mark.parametrize("width", [390, 1280])
def test_the_table_of_rows_fits_its_frame(folder, wordy, width):
    """With the papers' columns, long names and the longest status."""
    (folder / "wordy.html").write_text(page(replace(wordy, name=""), {}), "utf-8")
    seen = looked_at(folder, "wordy", width)
    assert seen["wider"] <= 0
    assert seen["covered"] == 0


@pytest.mark.parametrize("flags", [(), (DARK,)], ids=["light", "dark"])
def test_every_word_stands_out_from_its_ground(folder, flags):
    assert_legible(looked_at(folder, "hostile", 1280, *flags), flags)


def test_a_tile_shows_the_rows_of_its_status(folder):
    seen = looked_at(folder, "hostile", 1280)
    assert seen["shown"]["all"] > 6
    for status in ("fail", "skip", "note", "calibrated", "shown"):
        assert seen["shown"][status] >= 1
        assert seen["hidden"][status] == 0  # rows of another status that stay visible


def test_every_link_leads_to_a_place_in_sight_and_shows_a_row_that_a_filter_hides(folder):
    assert_links(looked_at(folder, "hostile", 400, host="links_host.html"), 400, 100)
    seen = looked_at(folder, "hostile", 400, host="links_host.html", status="skip")
    assert seen["links"] >= 4
    assert seen["problems"] == []


def test_no_label_of_the_overview_lies_on_another(folder, report):
    cases = tuple(replace(case, name=NAME) for case in report.cases[:3])
    few = replace(report, name=NAME, cases=cases, tables=(), validity=(), budgets=())
    (folder / "few.html").write_text(page(few, {}), "utf-8")
    seen = looked_at(folder, "few", 1280)
    assert seen["labels"] == len(cases) + TICKS
    assert seen["overprinted"] == seen["outside"] == []


@pytest.mark.parametrize("count", [46, 100])
def test_any_number_of_cases_has_room_for_its_names(folder, report, count):
    """As many as the suite has, and twice as many."""
    several = -(-count // len(report.cases))
    cases = [replace(case, id=f"{case.id}-{i}") for i in range(several) for case in report.cases]
    drawn = f"<style>{styles()}</style><main><figure class='all-rows'>{overview(cases[:count])}"
    (folder / f"overview-{count}.html").write_text(f"<!doctype html><body>{drawn}", "utf-8")
    seen = looked_at(folder, f"overview-{count}", 1320)
    assert (seen["labels"] - count) % TICKS == 0
    assert seen["overprinted"] == seen["outside"] == seen["spilled"] == []


@pytest.mark.parametrize(("width", "flags"), [(390, ()), (1280, (DARK,))])
def test_shafts_in_motion_stay_in_their_frames_and_stand_out(folder, width, flags):
    seen = looked_at(folder, "turning", width, *flags)
    assert seen["overflow"] <= 0, seen["widest"]
    assert seen["console"] == seen["spilled"] == seen["requests"] == []
    assert seen["contrast"] >= 4.5, seen["faintest"]


FIVE_FRAMES = """<script>
const asked = []
window.requestAnimationFrame = draw => asked.push(draw)
window.IntersectionObserver = class { constructor(f) { this.f = f } observe() { this.f([{ isIntersecting: true }]) } }
performance.now = () => 0
addEventListener("load", () => { for (let k = 1; k < 6; k++) for (const draw of asked.splice(0)) draw(52 * k) })
</script>"""  # noqa: E501 - a tenth of the period of 2600 ms


def corners(path: str) -> np.ndarray:
    """Points of a line as the script draws it, x,yLx,y, or as the page has it, in steps."""
    if "L" in path:
        return np.array([p.split(",") for p in path.split("L")], float)
    return np.array(walked("M" + path)[0]) / 10


@pytest.mark.parametrize(
    ("flags", "offers", "phase"),
    [((), "Pause", 0.1), (("--force-prefers-reduced-motion",), "Play", 0.0)],
)
def test_shafts_whirl_unless_motion_is_unwanted(folder, flags, offers, phase):
    """The line after 260 ms, beside what its data say: x + a cos + e sin, y + b cos + f sin."""
    drawn = (folder / "turning.html").read_text("utf-8")
    free = re.sub('<meta http-equiv="Content-Security-Policy"[^>]*>', FIVE_FRAMES, drawn)
    (folder / "frames.html").write_text(free, "utf-8")
    address = (folder / "frames.html").as_uri()
    shown = browse(folder, *flags, "--dump-dom", address).stdout
    assert f'<button type="button">{offers}</button>' in shown
    line, data = re.search(r'd="M([^"]*)" data-line="([^"]*)"', shown).groups()
    points = corners(line)
    x, y, a, b, e, f = np.array([row.split(",") for row in data.split(" ")], float).T
    c, s = np.cos(2 * np.pi * phase), np.sin(2 * np.pi * phase)
    assert points == pytest.approx(
        np.column_stack([x + a * c + e * s, y + b * c + f * s]), abs=0.11
    )
