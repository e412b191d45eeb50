"""Pages in a browser without network: no errors, no overflow, legible, searchable.

A case of each subject; test_whole looks at the page of every case. The one page of a run is seen
with hostile texts, which have every status, and with shafts in motion.
"""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from reports.formats import spaced
from reports.html import page, styles
from reports.links import FIRST, FOLDER
from reports.overview import overview
from reports.row_lines import lines
from tests.reports.browser import (
    DARK,
    NO_CHROMIUM,
    assert_legible,
    assert_links,
    assert_silent,
    browse,
    looked_at,
)
from tests.reports.conftest import NAME
from tests.reports.paths import walked
from tests.reports.test_rotor_charts import BOTH, CAMPBELL, SETS
from verify.core.figures import Band, Curve, Curves
from verify.core.results import Status

pytestmark = [NO_CHROMIUM, pytest.mark.slow("a browser opens pages")]
TICKS = 5  # of a strip of the overview
N = np.linspace(0.0, 6000.0, 13)
BAND = Band(name="90 %", x=N, lower=5 + N, upper=20 + 2 * N)


@pytest.fixture(scope="module")
def place(tmp_path_factory, hostile, wordy, drawn) -> Path:
    """Pages of other reports, and the host that looks at them in frames."""
    found = tmp_path_factory.mktemp("browser")
    (found / "hostile.html").write_text(page(hostile, drawn), "utf-8")
    (found / "wordy.html").write_text(page(replace(wordy, name=""), {}), "utf-8")
    banded = Curves(title="T", x_label="x", y_label="µm", y_log=True, bands=(BAND,), curves=(
        Curve(name="mean", x=BAND.x, y=BAND.lower + 5),))  # fmt: skip
    wide = replace(SETS, axes=SETS.axes * 3, members=np.tile(SETS.members, 3))
    figures = (replace(BOTH, modes=BOTH.modes * 3), CAMPBELL, wide, banded)
    turning = replace(wordy, cases=(replace(wordy.cases[0], figures=figures),))
    (found / "turning.html").write_text(page(turning, {}), "utf-8")
    return found


@pytest.mark.parametrize(("width", "flags"), [(390, ()), (1280, (DARK,))])
def test_a_page_of_hostile_texts_is_silent_narrow_and_legible_and_a_tile_filters(
    place, width, flags
):
    seen = looked_at(place, "hostile", width, *flags)
    assert_silent(seen)
    assert_legible(seen, flags, 500)
    assert seen["shown"]["all"] > 6
    for status in ("fail", "skip", "note", "calibrated", "shown"):
        assert seen["shown"][status] >= 1
        assert seen["hidden"][status] == 0  # rows of another status that stay visible


@pytest.mark.parametrize("width", [390, 1280])
def test_the_table_of_rows_fits_its_frame(place, width):
    """With the papers' columns, long names and the longest status."""
    seen = looked_at(place, "wordy", width)
    assert seen["wider"] <= 0
    assert seen["covered"] == 0


def test_every_link_leads_to_a_place_in_sight_and_shows_a_row_that_a_filter_hides(place):
    assert_links(looked_at(place, "hostile", 400, host="links_host.html"), 400, 100)
    seen = looked_at(place, "hostile", 400, host="links_host.html", status="skip")
    assert seen["links"] >= 4
    assert seen["problems"] == []


@pytest.mark.parametrize("count", [3, 100])
def test_no_label_of_an_overview_of_few_or_many_cases_lies_on_another(place, report, count):
    """Few cases with long names; twice as many as the suite has."""
    several = -(-count // len(report.cases))
    cases = [replace(case, id=f"{case.id}-{i}") for i in range(several) for case in report.cases]
    if count == 3:
        cases = [replace(case, name=NAME) for case in cases]
    drawn = f"<style>{styles()}</style><main><figure class='all-rows'>{overview(cases[:count])}"
    (place / f"overview-{count}.html").write_text(f"<!doctype html><body>{drawn}", "utf-8")
    seen = looked_at(place, f"overview-{count}", 1320)
    assert seen["labels"] >= count
    assert (seen["labels"] - count) % TICKS == 0
    assert seen["overprinted"] == seen["outside"] == seen["spilled"] == []


@pytest.mark.parametrize(
    ("name", "width", "flags"),
    [
        (FIRST, 390, ()), (FIRST, 1320, (DARK,)), (f"{FOLDER}/spring-accordion.html", 390, ()),
        (f"{FOLDER}/rows.html", 390, ()), (f"{FOLDER}/papers.html", 1320, ()),
        (f"{FOLDER}/explorer.html", 390, ()), (f"{FOLDER}/explorer.html", 1320, (DARK,)),
    ],
)  # fmt: skip
def test_pages_are_silent_and_legible_at_every_width(folder, name, width, flags):
    path = folder / name
    seen = looked_at(path.parent, path.stem, width, *flags)
    assert_silent(seen)
    assert_legible(seen, flags)
    assert seen["covered"] == 0
    assert seen["milliseconds"] < 5000  # other tests run meanwhile


def test_the_search_finds_words_and_symbols_and_leaves_out_a_status(folder, report):
    seen = looked_at(folder / FOLDER, "rows", 390, host="search_host.html", status="peak star")
    assert len(seen["all"]["rows"]) > 200
    assert seen["all"]["found"] == ""
    assert seen["none"] == {"rows": [], "found": "0 rows"}
    found = seen["some"]["rows"]
    assert seen["some"]["found"] == f"{len(found)} row{'s' if len(found) > 1 else ''}"
    assert 0 < len(found) < len(seen["all"]["rows"])
    alone = [line.row for case in report.cases for line in lines(case.rows)]
    quantities = {
        "mu": [r.quantity for r in alone if r.symbol.startswith("μ")],
        "indexed": [r.quantity for r in alone if r.symbol.replace("_", "").lower()[:2] == "ur"],
        "capital": [r.quantity for r in alone if r.symbol.startswith("U")],
        "failed": [r.quantity for r in alone if r.status is not Status.PASS],
    }
    for name, expected in quantities.items():
        assert expected
        assert sorted(seen[name]["rows"]) == sorted(map(spaced, expected)), name


@pytest.mark.parametrize(("width", "flags"), [(390, ()), (1280, (DARK,))])
def test_shafts_in_motion_stay_in_their_frames_and_stand_out(place, width, flags):
    seen = looked_at(place, "turning", width, *flags)
    assert_silent(seen)
    assert_legible(seen, flags)


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
def test_shafts_whirl_unless_motion_is_unwanted(place, flags, offers, phase):
    """The line after 260 ms, beside its data: x + a cos + e sin, y + b cos + f sin."""
    drawn = (place / "turning.html").read_text("utf-8")
    free = re.sub('<meta http-equiv="Content-Security-Policy"[^>]*>', FIVE_FRAMES, drawn)
    (place / "frames.html").write_text(free, "utf-8")
    shown = browse(place, *flags, "--dump-dom", (place / "frames.html").as_uri()).stdout
    assert f'<button type="button">{offers}</button>' in shown
    line, data = re.search(r'd="M([^"]*)" data-line="([^"]*)"', shown).groups()
    x, y, a, b, e, f = np.array([row.split(",") for row in data.split(" ")], float).T
    c, s = np.cos(2 * np.pi * phase), np.sin(2 * np.pi * phase)
    wanted = np.column_stack([x + a * c + e * s, y + b * c + f * s])
    assert corners(line) == pytest.approx(wanted, abs=0.11)
