"""Where things stand on the pages of report.pdf: nothing squeezed, nothing beyond the margins."""

import re
import shutil
import subprocess
from dataclasses import replace
from typing import NamedTuple

import pytest

from reports.pdf import pdf

pytestmark = pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs poppler-utils")

MM = 72 / 25.4
RIGHT = (210 - 17) * MM  # edge of the text


class Word(NamedTuple):
    """A printed word: left, top, right, bottom [pt], and its letters."""

    left: float
    top: float
    right: float
    bottom: float
    text: str


def words(report, folder) -> list[Word]:
    """All words of the PDF."""
    (folder / "r.pdf").write_bytes(pdf(report, {}))
    run = ["pdftotext", "-bbox", str(folder / "r.pdf"), "-"]
    found = re.findall(
        r'xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">([^<]*)<',
        subprocess.run(run, capture_output=True, text=True, check=True).stdout,
    )
    return [Word(*map(float, numbers), text) for *numbers, text in found]


@pytest.fixture(scope="module")
def printed(wordy, tmp_path_factory):
    return words(wordy, tmp_path_factory.mktemp("pdf"))


def room(printed) -> float:
    """Width [pt] of the names of quantities in the summary."""
    texts = [w.text for w in printed]
    summary = printed[texts.index("Quantity") : texts.index("tolerances")]
    at = [w for w in summary if w.text == "word"]
    assert len(at) >= 18 * 3
    return max(w.right for w in at) - min(w.left for w in at)


def test_names_of_quantities_have_four_centimetres(printed):
    assert room(printed) > 35 * MM  # a word is 5 mm wide


def test_many_printed_values_and_long_reasons_leave_names_their_room(wordy, tmp_path):
    (case,) = wordy.cases
    printed = case.rows[0].published * 10
    rows = tuple(replace(r, published=printed, reason=" ".join(["why"] * 80)) for r in case.rows)
    case = replace(case, rows=rows)
    found = words(replace(wordy, cases=(case,)), tmp_path)
    assert room(found) > 33 * MM
    assert max(w.right for w in found) <= RIGHT + 0.5


def test_no_word_stands_beyond_the_margin(printed):
    assert "CALIBRATED" in {w.text for w in printed}
    assert max(w.right for w in printed) <= RIGHT + 0.5


def test_printed_powers_are_raised(printed):
    assert not any("^" in w.text for w in printed)
